// SPDX-License-Identifier: MIT
/// Perfectly matched layers of a plane lattice, beside nmbc::Plane or beside forces and arrays of
/// one's own.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/loss_layer.hpp>
#include <nmbc/node_line.hpp>
#include <nmbc/plane_parameters.hpp>
#include <span>
#include <stdexcept>
#include <vector>

namespace nmbc {

/// In the layers, where the velocity is held at 0 behind them, derivatives along x are divided by
/// 1 + sigma_x/(i omega), those along y likewise, with sigma of the node where they are taken: the
/// two of the gradient, and the two of the stress whose sum is the force. Losses rise with the
/// depth as those of a chain's layer do (LossLayer); in a corner both act. The stabilisation has no
/// derivatives along one axis and stays as it is: of order xi^4.
///
/// Leapfrog, with the trapezoidal rule for what the layer remembers. Where both losses are
/// constant, no wave of the lattice grows, at any loss, radius and G, in every step that is stable
/// in the interior: with p = (2/dt) (z - 1)/(z + 1) and the strain's parts K_x^2, K_y^2 and the
/// stabilisation's S of omega^2, waves z^n have
///     1 + (1 - p^2 dt^2/4) (K_x^2/(p + sigma_x)^2 + K_y^2/(p + sigma_y)^2 + S/p^2) = 0.
/// For |z| > 1, Re p is above 0: off the real axis all terms but the 1 have imaginary parts of one
/// sign, and on it their sum is above -(K_x^2 + K_y^2 + S) dt^2/4 > -1. Where losses vary there is
/// no such proof, and some fields grow: at G = 0 with more than nearest neighbours, with profile 0,
/// in plane strain at Poisson's ratios near 1/2 (tools/scripts/pml-map).
template <class Real>
class BasicPlanePml {
  public:
    /// layers: at the sides in the order of plane_sides, none where they have no nodes. grid: of
    /// the fields: model.reach() ghosts beyond each side, then the layers, then the interior. Of
    /// the parameters it uses spacing, Young's modulus, density and time step. Throws
    /// std::invalid_argument as half_step_losses does, and where the layers do not fit.
    BasicPlanePml(const CorrespondenceModel& model, const std::array<LossLayer, 4>& layers,
                  const Grid& grid, const PlaneParameters& parameters)
        : model_(model),
          kick_(static_cast<Real>(parameters.time_step * parameters.rate() * parameters.rate())),
          grid_(grid),
          horizon_(model.horizon()),
          ghosts_(model.reach()),
          shape_(detail::whole_shape(model)) {
        for (const detail::WeightedBond& bond : detail::weighted_family(model)) {
            if (bond.y > 0 || (bond.y == 0 && bond.x > 0)) {
                half_family_.push_back(bond);
            }
        }
        find_losses(layers, parameters);
        find_segments();
        memory_.resize(8 * remembered_nodes_);
        for (std::size_t part = 0; part < 4; ++part) {
            row_[part].resize(grid.nx);
            taken_[part].resize(grid.nx);
            stress_[part].resize(grid.nx * grid.ny);
            excess_[part].resize(grid.nx * grid.ny);
        }
    }

    using Field = std::array<std::span<Real>, 2>;
    using ConstantField = std::array<std::span<const Real>, 2>;

    /// To be called in every step after the lattice's forces on all nodes, those of layers as those
    /// of the interior, have brought v from t - dt/2 to t + dt/2: adds to v what the layers change.
    /// u: at t, 0 on ghosts beyond layers; components along x and y.
    void kick(const ConstantField& u, const Field& v) {
        for (const Segment& segment : segments_) {
            find_stresses(segment, u);
        }
        for (const Segment& segment : segments_) {
            kick_segment(of_body(segment), v);
        }
    }

    /// What the layers remember; and to go on from it, of such a plane.
    std::span<const Real> memory() const { return memory_; }
    void remember(std::span<const Real> memory) {
        if (memory.size() != memory_.size()) {
            throw std::invalid_argument("the memory of other layers");
        }
        std::ranges::copy(memory, memory_.begin());
    }

  private:
    /// Nodes of a row of the grid, with or near losses.
    struct Segment {
        std::size_t y = 0;
        std::size_t first = 0;
        std::size_t nodes = 0;
        std::size_t place = 0;  ///< of the first one in what is remembered
    };
    /// xx, xy, yx, yy: the second letter is the axis.
    using Parts = std::array<std::vector<Real>, 4>;

    void find_losses(const std::array<LossLayer, 4>& layers, const PlaneParameters& parameters) {
        const double speed = model_.speed_P() * parameters.rate();
        for (const std::size_t axis : {0U, 1U}) {
            std::vector<Real>& losses = losses_[axis];
            losses.resize(axis == 0 ? grid_.nx : grid_.ny);
            if (losses.size() <=
                layers[2 * axis].nodes + layers[2 * axis + 1].nodes + 2 * ghosts_) {
                throw std::invalid_argument(
                    "the fields have no node between the ghosts and layers of two sides");
            }
            for (const bool is_high : {false, true}) {
                const LossLayer& layer = layers[2 * axis + static_cast<std::size_t>(is_high)];
                if (layer.nodes == 0) {
                    continue;
                }
                const std::vector<double> outwards = half_step_losses(
                    layer, 0.5,
                    {.youngs_modulus = speed * speed, .time_step = parameters.time_step});
                for (std::size_t i = 0; i < ghosts_ + layer.nodes; ++i) {
                    const std::size_t node = is_high ? losses.size() - 1 - i : i;
                    losses[node] = static_cast<Real>(
                        outwards[std::min(ghosts_ + layer.nodes - 1 - i, layer.nodes)]);
                }
            }
        }
    }

    /// Of the body and as many of its ghosts as have energy.
    void find_segments() {
        const std::size_t margin = ghosts_ - horizon_;
        const auto is_near = [&](std::size_t axis, std::size_t node) {
            const std::vector<Real>& losses = losses_[axis];
            const std::size_t first = node < horizon_ ? 0 : node - horizon_;
            const std::size_t last = std::min(node + horizon_ + 1, losses.size());
            return std::any_of(losses.begin() + static_cast<std::ptrdiff_t>(first),
                               losses.begin() + static_cast<std::ptrdiff_t>(last),
                               [](Real loss) { return loss > 0; });
        };
        for (std::size_t y = margin; y < grid_.ny - margin; ++y) {
            const bool is_whole = is_near(1, y);
            for (std::size_t x = margin; x < grid_.nx - margin; ++x) {
                if (!is_whole && !is_near(0, x)) {
                    continue;
                }
                const bool goes_on = !segments_.empty() && segments_.back().y == y &&
                                     segments_.back().first + segments_.back().nodes == x;
                if (!goes_on) {
                    segments_.push_back({y, x, 0, remembered_nodes_});
                }
                ++segments_.back().nodes;
                ++remembered_nodes_;
            }
        }
    }

    /// Without ghosts.
    Segment of_body(Segment segment) const {
        const bool is_ghost = segment.y < ghosts_ || segment.y >= grid_.ny - ghosts_;
        const std::size_t first = std::max(segment.first, ghosts_);
        const std::size_t last = std::min(segment.first + segment.nodes, grid_.nx - ghosts_);
        segment.place += first - segment.first;
        segment.first = first;
        segment.nodes = is_ghost || last < first ? 0 : last - first;
        return segment;
    }

    /// sum w R_x f_x and sum w R_y f_y, w the influence, over the family of each node of a segment,
    /// at whose first one f points, into two parts of row_.
    void find_slopes(const Segment& segment, const std::array<const Real*, 2>& f,
                     std::size_t first_part) {
        for (const std::size_t axis : {0U, 1U}) {
            Real* __restrict sum = row_[first_part + axis].data();
            std::fill_n(sum, segment.nodes, Real(0));
            for (const detail::WeightedBond& bond : half_family_) {
                const auto along =
                    static_cast<Real>(bond.influence * (axis == 0 ? bond.x : bond.y));
                const std::ptrdiff_t entry =
                    bond.y * static_cast<std::ptrdiff_t>(grid_.nx) + bond.x;
                for (std::size_t i = 0; i < segment.nodes && along != 0; ++i) {
                    const auto at = static_cast<std::ptrdiff_t>(i);
                    sum[i] += along * (f[axis][at + entry] - f[axis][at - entry]);
                }
            }
        }
    }

    /// Finds what the losses take from the parts of row_, given those of the steps before: of q' +
    /// sigma q = sigma f. With h = sigma dt/2 and m = (1 - h) q + h f of the step before, q is (m +
    /// h f)/(1 + h).
    void find_taken(const Segment& segment, std::size_t first_part) {
        for (std::size_t part = 0; part < 4; ++part) {
            Real* const memory =
                memory_.data() + (first_part + part) * remembered_nodes_ + segment.place;
            const bool is_along_x = part % 2 == 0;
            for (std::size_t i = 0; i < segment.nodes; ++i) {
                const Real h = is_along_x ? losses_[0][segment.first + i] : losses_[1][segment.y];
                const Real f = row_[part][i];
                const Real taken = (memory[i] + h * f) / (1 + h);
                memory[i] = (1 - h) * taken + h * f;
                taken_[part][i] = taken;
            }
        }
    }

    void find_stresses(const Segment& segment, const ConstantField& u) {
        const std::size_t at = segment.y * grid_.nx + segment.first;
        for (const std::size_t a : {0U, 1U}) {
            find_slopes(segment, {u[a].data() + at, u[a].data() + at}, 2 * a);
        }
        find_taken(segment, 0);
        const auto over_squared_shape = [&](double modulus) {
            return static_cast<Real>(modulus / (shape_ * shape_));
        };
        const Real direct = over_squared_shape(model_.bulk + model_.shear);
        const Real across = over_squared_shape(model_.bulk - model_.shear);
        const Real shear = over_squared_shape(model_.shear);
        const auto store = [&](Parts& stress, std::size_t i, const std::array<Real, 4>& g) {
            stress[0][at + i] = direct * g[0] + across * g[3];
            stress[1][at + i] = stress[2][at + i] = shear * (g[1] + g[2]);
            stress[3][at + i] = direct * g[3] + across * g[0];
        };
        for (std::size_t i = 0; i < segment.nodes; ++i) {
            const auto& q = taken_;
            store(excess_, i, {-q[0][i], -q[1][i], -q[2][i], -q[3][i]});
            store(stress_, i,
                  {row_[0][i] - q[0][i], row_[1][i] - q[1][i], row_[2][i] - q[2][i],
                   row_[3][i] - q[3][i]});
        }
    }

    void kick_segment(const Segment& segment, const Field& v) {
        const std::size_t at = segment.y * grid_.nx + segment.first;
        const auto slopes_of = [&](const Parts& stress) {
            for (const std::size_t a : {0U, 1U}) {
                find_slopes(segment, {stress[2 * a].data() + at, stress[2 * a + 1].data() + at},
                            2 * a);
            }
        };
        slopes_of(stress_);
        find_taken(segment, 4);
        slopes_of(excess_);
        for (const std::size_t a : {0U, 1U}) {
            Real* const own = v[a].data() + at;
            for (std::size_t i = 0; i < segment.nodes; ++i) {
                own[i] += kick_ * (row_[2 * a][i] + row_[2 * a + 1][i] - taken_[2 * a][i] -
                                   taken_[2 * a + 1][i]);
            }
        }
    }

    CorrespondenceModel model_;
    std::vector<detail::WeightedBond> half_family_{};  // one of each pair +R, -R
    Real kick_;                                        // dt E/(density dX^2)
    Grid grid_;
    std::size_t horizon_;
    std::size_t ghosts_;
    double shape_;
    std::array<std::vector<Real>, 2> losses_{};  // sigma dt/2 along x and y, of the grid
    std::vector<Segment> segments_{};
    std::size_t remembered_nodes_ = 0;
    std::vector<Real> memory_{};  // of the gradients, then of the forces
    Parts row_{};                 // of a segment
    Parts taken_{};               // likewise
    // On the grid, where there are segments:
    Parts stress_{};  // P/A of the stretched gradients
    Parts excess_{};  // what it has over P/A of the gradients
};

using PlanePml = BasicPlanePml<double>;

}  // namespace nmbc
