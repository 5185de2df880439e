// SPDX-License-Identifier: MIT
/// The forces of a plane lattice between its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/cache_line.hpp>
#include <nmbc/plane_closed_rows.hpp>
#include <nmbc/plane_nodes.hpp>
#include <nmbc/plane_pieces.hpp>
#include <nmbc/plane_potential.hpp>
#include <nmbc/plane_row_numbers.hpp>
#include <nmbc/plane_row_sweeps.hpp>
#include <nmbc/plane_sweeps.hpp>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// With E = density = dX = 1. A node has T = P K^-1 - w g, with P the stress that belongs to its
/// gradient g, K its shape tensor and w = Vs s; the force on node I is then the sum over J of the
/// influence times
///     (T_I + T_J) R + (w_I + w_J) (u_J - u_I),   R = X_J - X_I,
/// whatever neighbours are missing. In the interior the sum of T_I R vanishes, and w is s.
template <class Real>
class PlaneForce {
  public:
    explicit PlaneForce(PlaneNodes nodes)
        : nodes_(std::move(nodes)),
          horizon_(nodes_.horizon()),
          pitch_(nodes_.pitch()),
          pieces_(nodes_.x(), nodes_.y().nodes(), pitch_, 2 * horizon_),
          stress_pitch_(stress_pitch(nodes_.x().nodes() + 2 * horizon_)),
          sweeps_(sweeps_of<Real>(nodes_.model())) {
        const CorrespondenceModel& model = nodes_.model();
        const double A = whole_shape(model);
        const double k = model.bulk;
        const double mu = model.shear;
        const double beta = model.null_lagrangian;
        const double s = model.stabilisation;
        coefficients_ = {.direct = static_cast<Real>(((k + mu) / A - s) / A),
                         .across = static_cast<Real>((k - mu + beta) / (A * A)),
                         .shear = static_cast<Real>((mu / A - s) / A),
                         .turned = static_cast<Real>((mu - beta) / (A * A)),
                         .laplacian = static_cast<Real>(2 * s)};
        moduli_ = {.direct = static_cast<Real>(k + mu),
                   .across = static_cast<Real>(k - mu + beta),
                   .shear = static_cast<Real>(mu),
                   .turned = static_cast<Real>(mu - beta)};
        if (sweeps_.exist()) {
            rows_ = PlaneRows<Real>(nodes_);
        }
        if (nodes_.closed_layers() > 0) {
            closed_rows_ = ClosedRows(nodes_);
        }
    }

    const PlaneAxis& axis(std::size_t number) const {
        return number == 0 ? nodes_.x() : nodes_.y();
    }

    double mass(std::size_t component, std::ptrdiff_t x, std::ptrdiff_t y) const {
        return nodes_.weights(x, y).mass[component];
    }
    /// That closed sides give a node.
    double volume(std::ptrdiff_t x, std::ptrdiff_t y) const { return nodes_.volume(x, y); }

    /// Of the nodes first .. last-1 of a row.
    PlanePotential potential_of_row(std::ptrdiff_t y, std::ptrdiff_t first, std::ptrdiff_t last,
                                    PlaneField<const Real> u) const {
        return detail::potential_of_row(nodes_, y, first, last, u);
    }

    const PlanePieces& pieces() const { return pieces_; }

    /// v += scale M^-1 times the force, on the nodes of the body.
    void kick(double scale, PlaneField<const Real> u, PlaneField<Real> v) {
        kick_pieces(pieces_.count(), scale, u, v, [](const PlaneRange&, std::ptrdiff_t) {});
    }
    /// Once drift_ends() of so many pieces is done, the drift of the other rows, and kick().
    void drift_and_kick(std::size_t pieces, const PlaneDrift<Real>& drift, double scale,
                        PlaneField<Real> u, PlaneField<Real> v) {
        kick_pieces(pieces, scale, {u[0], u[1]}, v, [&](const PlaneRange& rows, std::ptrdiff_t y) {
            pieces_.drift_inner(rows, y, drift, u, v);
        });
    }

  private:
    using Ring = std::vector<Real, CacheLineAllocator<Real>>;

    /// Rows of T begin at cache lines, of which each has an odd number: so rows do not all begin in
    /// the same set of the cache.
    static std::ptrdiff_t stress_pitch(std::ptrdiff_t entries) {
        constexpr auto line = static_cast<std::ptrdiff_t>(cache_line / sizeof(Real));
        return ((entries + line - 1) / line | 1) * line;
    }

    /// Before row y of u is read for the first time, before_row(rows of its piece, y).
    template <class BeforeRow>
    void kick_pieces(std::size_t pieces, double scale, PlaneField<const Real> u, PlaneField<Real> v,
                     const BeforeRow& before_row) {
        while (rings_.size() < pieces) {
            rings_.emplace_back(static_cast<std::size_t>(6 * ring_rows() * stress_pitch_), Real(0));
        }
        pieces_.for_each(pieces, [&](std::size_t piece, const PlaneRange& rows) {
            kick_rows(scale, rows, u, v, rings_[piece], before_row);
        });
    }

    std::ptrdiff_t ring_rows() const { return 2 * horizon_ + 1; }

    /// T of a node, where there are no sweeps.
    std::array<Real, 4> stress(std::ptrdiff_t x, std::ptrdiff_t y, PlaneField<const Real> u) const {
        const PlaneNeighbours& near = nodes_.neighbours(x, y);
        const auto [g_xx, g_xy, g_yx, g_yy] = nodes_.gradient(near, y * pitch_ + x, u);
        const PlaneWeights own = nodes_.weights(x, y);
        const double k = nodes_.model().bulk;
        const double mu = nodes_.model().shear;
        const double beta = nodes_.model().null_lagrangian;
        const std::array<double, 4> P{own.strain * ((k + mu) * g_xx + (k - mu + beta) * g_yy),
                                      own.strain * (mu * g_xy + (mu - beta) * g_yx),
                                      own.strain * (mu * g_yx + (mu - beta) * g_xy),
                                      own.strain * ((k + mu) * g_yy + (k - mu + beta) * g_xx)};
        const double w = own.stabilisation * nodes_.model().stabilisation;
        const auto& [xx, xy, yy] = near.inverse_shape;
        return {static_cast<Real>(P[0] * xx + P[1] * xy - w * g_xx),
                static_cast<Real>(P[0] * xy + P[1] * yy - w * g_xy),
                static_cast<Real>(P[2] * xx + P[3] * xy - w * g_yx),
                static_cast<Real>(P[2] * xy + P[3] * yy - w * g_yy)};
    }

    void kick_node(double scale, std::ptrdiff_t x, std::ptrdiff_t y, PlaneField<const Real> u,
                   PlaneField<Real> v, const Ring& ring) const {
        const std::ptrdiff_t at = y * pitch_ + x;
        if (const ClosedRow* const force = closed_row(x, y)) {
            kick_closed(scale, *force, at, u, v);
            return;
        }
        const PlaneWeights own = nodes_.weights(x, y);
        std::array<double, 2> force{};
        for (const auto& bond : nodes_.neighbours(x, y).bonds) {
            const double w = nodes_.model().stabilisation *
                             (own.stabilisation + nodes_.x().stabilisation(x + bond.x) *
                                                      nodes_.y().stabilisation(y + bond.y));
            for (std::size_t a = 0; a < 2; ++a) {
                const auto T = [&](std::size_t b) {
                    return static_cast<double>(row(ring, 2 * a + b, y)[x]) +
                           static_cast<double>(row(ring, 2 * a + b, y + bond.y)[x + bond.x]);
                };
                force[a] += bond.influence * (T(0) * bond.x + T(1) * bond.y +
                                              w * (static_cast<double>(u[a][at + bond.entry]) -
                                                   static_cast<double>(u[a][at])));
            }
        }
        for (std::size_t a = 0; a < 2; ++a) {
            v[a][at] += static_cast<Real>(scale * force[a] / own.mass[a]);
        }
    }

    /// The force of a node near a closed side; nullptr: others, which know T of nodes that have the
    /// lattice's own gradient only.
    const ClosedRow* closed_row(std::ptrdiff_t x, std::ptrdiff_t y) const {
        return closed_rows_.empty() ? nullptr : closed_rows_.at(nodes_, x, y);
    }

    void kick_closed(double scale, const ClosedRow& force, std::ptrdiff_t at,
                     PlaneField<const Real> u, PlaneField<Real> v) const {
        std::array<double, 2> sum{};
        for (const ClosedRow::Entry& entry : force.entries) {
            const std::array<double, 2> difference{
                static_cast<double>(u[0][at + entry.entry]) - static_cast<double>(u[0][at]),
                static_cast<double>(u[1][at + entry.entry]) - static_cast<double>(u[1][at])};
            for (std::size_t a = 0; a < 2; ++a) {
                sum[a] +=
                    entry.factors[2 * a] * difference[0] + entry.factors[2 * a + 1] * difference[1];
            }
        }
        for (std::size_t a = 0; a < 2; ++a) {
            v[a][at] += static_cast<Real>(scale * sum[a]);
        }
    }

    /// Entry 0 of a row of T: rows come round in the ring.
    template <class AnyRing>
    auto* row(AnyRing& ring, std::size_t part, std::ptrdiff_t y) const {
        const std::ptrdiff_t place = (y + horizon_) % ring_rows();
        return ring.data() +
               (static_cast<std::ptrdiff_t>(part) * ring_rows() + place) * stress_pitch_ + horizon_;
    }

    void find_stress(std::ptrdiff_t y, PlaneField<const Real> u, Ring& ring) const;
    template <class BeforeRow>
    void kick_rows(double scale, const PlaneRange& rows, PlaneField<const Real> u,
                   PlaneField<Real> v, Ring& ring, const BeforeRow& before_row) const;

    /// Of a row, the nodes whose T and pull are those of the interior; an empty part at its end
    /// where there are none. Where nodes are left at an end, they are a strip, or more, but in thin
    /// bodies.
    PlaneRange interior(std::ptrdiff_t y) const {
        const PlaneRange columns = nodes_.x().with_energy();
        const PlaneRange rows = nodes_.y().plain_force();
        const PlaneRange x = nodes_.x().plain_force();
        if (!sweeps_.exist() || y < rows.first || y >= rows.last || x.first >= x.last) {
            return {columns.last, columns.last};
        }
        const std::ptrdiff_t strip = sweeps_.strip_nodes;
        const PlaneRange inner{
            x.first > columns.first ? std::max(x.first, columns.first + strip) : x.first,
            x.last < columns.last ? std::min(x.last, columns.last - strip) : x.last};
        return inner.first < inner.last ? inner : x;
    }

    /// These nodes of a row, and as many more of `columns` as make whole vectors from the entry at
    /// which rows of T begin.
    PlaneRange in_whole_vectors(const PlaneRange& nodes, const PlaneRange& columns) const {
        const std::ptrdiff_t first =
            (nodes.first + horizon_) / whole_vector<Real> * whole_vector<Real> - horizon_;
        const std::ptrdiff_t last = up_to_whole_vectors<Real>(nodes.last + horizon_) - horizon_;
        return {std::max(first, columns.first), std::min(last, columns.last)};
    }

    /// Of a row, the nodes that kick_row() may take: all of them, but beside closed sides.
    PlaneRange swept_kick(std::ptrdiff_t y) const {
        const std::ptrdiff_t nodes = nodes_.x().nodes();
        if (!sweeps_.exist()) {
            return {nodes, nodes};
        }
        if (closed_rows_.empty()) {
            return {0, nodes};
        }
        const PlaneRange body = nodes_.x().in_body(interior(y));
        return body.first < body.last ? body : PlaneRange{nodes, nodes};
    }

    PlaneNodes nodes_;
    std::ptrdiff_t horizon_;
    std::ptrdiff_t pitch_;
    PlanePieces pieces_;
    std::ptrdiff_t stress_pitch_;
    PlaneCoefficients<Real> coefficients_;
    PlaneSweeps<Real> sweeps_;
    PlaneModuli<Real> moduli_{};
    PlaneRows<Real> rows_{};    // of the sweeps
    ClosedRows closed_rows_{};  // none where no side is closed
    /// T and the pull of some rows, one ring for each piece.
    std::vector<Ring> rings_;
};

template <class Real>
void PlaneForce<Real>::find_stress(std::ptrdiff_t y, PlaneField<const Real> u, Ring& ring) const {
    const auto columns = nodes_.x().with_energy();
    const auto rows = nodes_.y().with_energy();
    std::array<Real*, 6> T{};
    for (std::size_t part = 0; part < T.size(); ++part) {
        T[part] = row(ring, part, y);
    }
    if (y < rows.first || y >= rows.last) {
        for (Real* const part : T) {
            std::fill_n(part - horizon_, stress_pitch_, Real(0));
        }
        return;
    }
    const std::array<const Real*, 2> row_of_u{u[0] + y * pitch_, u[1] + y * pitch_};
    const auto beside = [&](const PlaneRange& nodes) {
        if (sweeps_.exist() && nodes.first < nodes.last) {
            const auto& sweep = nodes.last - nodes.first == sweeps_.strip_nodes
                                    ? sweeps_.stress_strip
                                    : sweeps_.stress_beside;
            sweep(moduli_, rows_.numbers(y), rows_.across(), rows_.along(y), nodes, row_of_u,
                  pitch_, T);
            return;
        }
        for (std::ptrdiff_t x = nodes.first; x < nodes.last; ++x) {
            const std::array<Real, 4> own = stress(x, y, u);
            for (std::size_t part = 0; part < 4; ++part) {
                T[part][x] = own[part];
            }
        }
    };
    const PlaneRange plain = interior(y);
    if (plain.first < plain.last) {
        // Whole vectors reach beyond the interior, where beside() then writes what is right.
        sweeps_.stress_row(coefficients_, in_whole_vectors(plain, columns), row_of_u, pitch_, T);
    }
    beside({columns.first, plain.first});
    beside({plain.last, columns.last});
}

template <class Real>
template <class BeforeRow>
void PlaneForce<Real>::kick_rows(double scale, const PlaneRange& rows, PlaneField<const Real> u,
                                 PlaneField<Real> v, Ring& ring,
                                 const BeforeRow& before_row) const {
    for (std::ptrdiff_t y = rows.first - horizon_; y < rows.first + horizon_; ++y) {
        find_stress(y, u, ring);
    }
    std::array<std::array<const Real*, 2 * PlaneSweeps<Real>::largest_reach + 1>, 6> stresses{};
    std::array<const Real* const*, 6> T{};
    std::ranges::transform(stresses, T.begin(), [](const auto& part) { return part.data(); });
    for (std::ptrdiff_t y = rows.first; y < rows.last; ++y) {
        before_row(rows, y + 2 * horizon_);
        find_stress(y + horizon_, u, ring);
        for (std::ptrdiff_t j = -horizon_; j <= horizon_ && sweeps_.exist(); ++j) {
            for (std::size_t part = 0; part < T.size(); ++part) {
                stresses[part][static_cast<std::size_t>(j + horizon_)] =
                    row(std::as_const(ring), part, y + j);
            }
        }
        const auto node_by_node = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
            for (std::ptrdiff_t x = first; x < last; ++x) {
                kick_node(scale, x, y, u, v, ring);
            }
        };
        const PlaneRange swept = swept_kick(y);
        node_by_node(0, swept.first);
        if (swept.first < swept.last) {
            sweeps_.kick_row(static_cast<Real>(scale), rows_.masses(nodes_, y), swept, T,
                             {v[0] + y * pitch_, v[1] + y * pitch_});
        }
        node_by_node(swept.last, nodes_.x().nodes());
    }
}

}  // namespace nmbc::detail
