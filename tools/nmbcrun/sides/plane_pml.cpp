// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sides/plane_pml.hpp"

#include <algorithm>
#include <iterator>
#include <nmbc/plane_family.hpp>

namespace nmbcrun {
namespace {

/// Of each pair +R, -R one.
std::vector<nmbc::PlaneOffset> half_of(const std::vector<nmbc::PlaneOffset>& family) {
    std::vector<nmbc::PlaneOffset> half;
    std::ranges::copy_if(family, std::back_inserter(half), [](const nmbc::PlaneOffset& bond) {
        return bond.y > 0 || (bond.y == 0 && bond.x > 0);
    });
    return half;
}

double shape_of(const std::vector<nmbc::PlaneOffset>& family) {
    double sum = 0;
    for (const nmbc::PlaneOffset& bond : family) {
        sum += bond.x * bond.x;
    }
    return sum;
}

/// sum R_x f_x and sum R_y f_y over the family of each of so many nodes of a row, at whose first
/// one f points.
void find_slopes(const std::vector<nmbc::PlaneOffset>& half_family, std::size_t pitch,
                 std::size_t nodes, const std::array<const double*, 2>& f,
                 const std::array<double*, 2>& slopes) {
    for (const std::size_t axis : {0U, 1U}) {
        double* __restrict sum = slopes[axis];
        std::fill_n(sum, nodes, 0);
        for (const nmbc::PlaneOffset& bond : half_family) {
            const int along = axis == 0 ? bond.x : bond.y;
            const std::ptrdiff_t entry = bond.y * std::ptrdiff_t(pitch) + bond.x;
            for (std::size_t i = 0; i < nodes && along != 0; ++i) {
                const auto at = std::ptrdiff_t(i);
                sum[i] += along * (f[axis][at + entry] - f[axis][at - entry]);
            }
        }
    }
}

}  // namespace

PlanePml::PlanePml(const nmbc::CorrespondenceModel& model, const std::array<LossLayer, 4>& layers,
                   const nmbc::Plane& plane)
    : model_(model),
      half_family_(half_of(nmbc::plane_family(model.radius_squared))),
      shape_(shape_of(nmbc::plane_family(model.radius_squared))),
      kick_(plane.parameters().time_step * plane.parameters().rate() * plane.parameters().rate()),
      grid_(plane.grid()),
      horizon_(model.horizon()),
      ghosts_(plane.ghosts()) {
    find_losses(layers, plane);
    find_segments();
    memory_.resize(8 * remembered_nodes_);
    for (std::size_t part = 0; part < 4; ++part) {
        row_[part].resize(grid_.nx);
        taken_[part].resize(grid_.nx);
        stress_[part].resize(grid_.nx * grid_.ny);
        excess_[part].resize(grid_.nx * grid_.ny);
    }
}

void PlanePml::find_losses(const std::array<LossLayer, 4>& layers, const nmbc::Plane& plane) {
    const double speed = model_.speed_P() * plane.parameters().rate();
    for (const std::size_t axis : {0U, 1U}) {
        std::vector<double>& losses = losses_[axis];
        losses.resize(axis == 0 ? grid_.nx : grid_.ny);
        for (const bool is_high : {false, true}) {
            const LossLayer& layer = layers[2 * axis + std::size_t(is_high)];
            if (layer.nodes == 0) {
                continue;
            }
            const std::vector<double> outwards = half_step_losses(
                layer, 0.5,
                {.youngs_modulus = speed * speed, .time_step = plane.parameters().time_step});
            for (std::size_t i = 0; i < ghosts_ + layer.nodes; ++i) {
                const std::size_t node = is_high ? losses.size() - 1 - i : i;
                losses[node] = outwards[std::min(ghosts_ + layer.nodes - 1 - i, layer.nodes)];
            }
        }
    }
}

/// Of the body and as many of its ghosts as have energy.
void PlanePml::find_segments() {
    const std::size_t margin = ghosts_ - horizon_;
    const auto is_near = [&](std::size_t axis, std::size_t node) {
        const std::vector<double>& losses = losses_[axis];
        const std::size_t first = node < horizon_ ? 0 : node - horizon_;
        const std::size_t last = std::min(node + horizon_ + 1, losses.size());
        return std::any_of(losses.begin() + std::ptrdiff_t(first),
                           losses.begin() + std::ptrdiff_t(last),
                           [](double loss) { return loss > 0; });
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

void PlanePml::operator()(nmbc::Plane& plane) {
    for (const Segment& segment : segments_) {
        find_stresses(segment, plane);
    }
    for (const Segment& segment : segments_) {
        kick(of_body(segment), plane);
    }
}

PlanePml::Segment PlanePml::of_body(Segment segment) const {
    const bool is_ghost = segment.y < ghosts_ || segment.y >= grid_.ny - ghosts_;
    const std::size_t first = std::max(segment.first, ghosts_);
    const std::size_t last = std::min(segment.first + segment.nodes, grid_.nx - ghosts_);
    segment.place += first - segment.first;
    segment.first = first;
    segment.nodes = is_ghost || last < first ? 0 : last - first;
    return segment;
}

void PlanePml::remember(std::span<const double> memory) {
    std::ranges::copy(memory, memory_.begin());
}

/// Of q' + sigma q = sigma f. With h = sigma dt/2 and m = (1 - h) q + h f of the step before, q is
/// (m + h f)/(1 + h).
void PlanePml::find_taken(const Segment& segment, std::size_t first_part) {
    for (std::size_t part = 0; part < 4; ++part) {
        double* const memory =
            memory_.data() + (first_part + part) * remembered_nodes_ + segment.place;
        const bool is_along_x = part % 2 == 0;
        for (std::size_t i = 0; i < segment.nodes; ++i) {
            const double h = is_along_x ? losses_[0][segment.first + i] : losses_[1][segment.y];
            const double f = row_[part][i];
            const double taken = (memory[i] + h * f) / (1 + h);
            memory[i] = (1 - h) * taken + h * f;
            taken_[part][i] = taken;
        }
    }
}

void PlanePml::find_stresses(const Segment& segment, const nmbc::Plane& plane) {
    const std::size_t at = segment.y * grid_.nx + segment.first;
    for (const std::size_t a : {0U, 1U}) {
        find_slopes(half_family_, grid_.nx, segment.nodes,
                    {plane.displacement(a).data() + at, plane.displacement(a).data() + at},
                    {row_[2 * a].data(), row_[2 * a + 1].data()});
    }
    find_taken(segment, 0);
    const double direct = (model_.bulk + model_.shear) / (shape_ * shape_);
    const double across = (model_.bulk - model_.shear) / (shape_ * shape_);
    const double shear = model_.shear / (shape_ * shape_);
    const auto store = [&](Parts& stress, std::size_t i, const std::array<double, 4>& g) {
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

void PlanePml::kick(const Segment& segment, nmbc::Plane& plane) {
    const std::size_t at = segment.y * grid_.nx + segment.first;
    const auto slopes_of = [&](const Parts& stress) {
        for (const std::size_t a : {0U, 1U}) {
            find_slopes(half_family_, grid_.nx, segment.nodes,
                        {stress[2 * a].data() + at, stress[2 * a + 1].data() + at},
                        {row_[2 * a].data(), row_[2 * a + 1].data()});
        }
    };
    slopes_of(stress_);
    find_taken(segment, 4);
    slopes_of(excess_);
    for (const std::size_t a : {0U, 1U}) {
        double* const v = plane.velocity(a).data() + at;
        for (std::size_t i = 0; i < segment.nodes; ++i) {
            v[i] += kick_ *
                    (row_[2 * a][i] + row_[2 * a + 1][i] - taken_[2 * a][i] - taken_[2 * a + 1][i]);
        }
    }
}

}  // namespace nmbcrun
