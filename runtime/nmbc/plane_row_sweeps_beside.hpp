// SPDX-License-Identifier: MIT
/// As plane_row_sweeps.hpp, of nodes beside sides that are cut off.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/plane_row_sweeps.hpp>
#include <nmbc/vector_loops.hpp>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// What the nodes of a row near sides that are cut off have, entry by entry.
template <class Real>
struct PlaneRowNumbers {
    std::array<std::vector<Real>, 3> inverse_shape{};  ///< xx, xy, yy
    std::array<std::vector<Real>, 2> moment{};         ///< sum of R over the neighbours there are
    std::vector<Real> strain{};                        ///< V
    std::vector<Real> stabilisation{};                 ///< w = Vs s
    std::vector<Real> own{};  ///< m w_I + sum_J w_J + 2 w_I, m the neighbours there are
    std::array<std::vector<Real>, 2> inverse_mass{};
};

/// The moduli that make P of the gradient.
template <class Real>
struct PlaneModuli {
    Real direct = 0;  ///< k' + mu
    Real across = 0;  ///< k' - mu + beta
    Real shear = 0;   ///< mu
    Real turned = 0;  ///< mu - beta
};

/// As stress_row(), near sides: what is beyond them is 0. Size: the nodes; 0: any number.
template <class Shape, class Real, std::ptrdiff_t Size>
void stress_row_beside(const PlaneModuli<Real>& k, const PlaneRowNumbers<Real>& numbers,
                       const PlaneRange& nodes, const std::array<const Real*, 2>& u,
                       std::ptrdiff_t pitch, const std::array<Real*, 6>& T) {
    std::array<FamilyColumns<Shape, Real>, 2> columns;
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first += plane_block<Real>) {
        const std::ptrdiff_t size =
            Size > 0 ? Size : std::min(plane_block<Real>, nodes.last - first);
        const std::array<const Real*, 2> own{u[0] + first, u[1] + first};
        columns[0].find(own[0], pitch, size);
        columns[1].find(own[1], pitch, size);
        const auto entry = static_cast<std::size_t>(first + Shape::reach);
        const Real* const xx = &numbers.inverse_shape[0][entry];
        const Real* const xy = &numbers.inverse_shape[1][entry];
        const Real* const yy = &numbers.inverse_shape[2][entry];
        const Real* const moment_x = &numbers.moment[0][entry];
        const Real* const moment_y = &numbers.moment[1][entry];
        const Real* const V = &numbers.strain[entry];
        const Real* const w = &numbers.stabilisation[entry];
        Real* __restrict T_xx = T[0] + first;
        Real* __restrict T_xy = T[1] + first;
        Real* __restrict T_yx = T[2] + first;
        Real* __restrict T_yy = T[3] + first;
        NMBC_NO_ENTRY_NEEDS_ANOTHER
        for (std::ptrdiff_t x = 0; x < size; ++x) {
            const auto slope = [&](std::size_t a) {
                const FamilySums<Real> sums = columns[a].of(x, own[a]);
                const Real by_x = sums.along_x - moment_x[x] * own[a][x];
                const Real by_y = sums.along_y - moment_y[x] * own[a][x];
                return std::pair(xx[x] * by_x + xy[x] * by_y, xy[x] * by_x + yy[x] * by_y);
            };
            const auto [g_xx, g_xy] = slope(0);
            const auto [g_yx, g_yy] = slope(1);
            const Real P_xx = V[x] * (k.direct * g_xx + k.across * g_yy);
            const Real P_xy = V[x] * (k.shear * g_xy + k.turned * g_yx);
            const Real P_yx = V[x] * (k.shear * g_yx + k.turned * g_xy);
            const Real P_yy = V[x] * (k.direct * g_yy + k.across * g_xx);
            T_xx[x] = P_xx * xx[x] + P_xy * xy[x] - w[x] * g_xx;
            T_xy[x] = P_xx * xy[x] + P_xy * yy[x] - w[x] * g_xy;
            T_yx[x] = P_yx * xx[x] + P_yy * xy[x] - w[x] * g_yx;
            T_yy[x] = P_yx * xy[x] + P_yy * yy[x] - w[x] * g_yy;
        }
    }
}

/// Rows times factors of theirs.
template <class Shape, class Real>
struct WeightedLines {
    PlaneLines<Shape, Real> lines;
    std::array<Real, 2 * Shape::reach + 1> weights;

    Real at(std::ptrdiff_t x, int j) const {
        return weights[static_cast<std::size_t>(j + Shape::reach)] * lines.at(x, j);
    }
};

/// The sum over a whole family, the node included. own: u of the first node.
template <class Shape, class Real>
NMBC_INLINED Real whole_sum(const ColumnSums<Shape, Real>& even, const Real* own,
                            std::ptrdiff_t x) {
    Real sum = even.template at<0>(own)[x];
    unrolled<1, Shape::reach>([&](auto i) {
        const Real* const column = even.template at<i>(own) + x;
        sum += column[i] + column[-i];
    });
    return sum;
}

/// Adds sums of w u, in which w = across along x: they are summed over the family as the odd ones
/// are, but for the columns of a single node, which are `alone`.
template <class Shape, class Real>
NMBC_INLINED void add_weighted(const WeightedLines<Shape, Real>& lines, const Real* across,
                               std::ptrdiff_t wide, ColumnSums<Shape, Real>& odd,
                               ColumnSum<Shape, Real>& alone) {
    ColumnSums<Shape, Real> sums;
    find_even<Shape, Shape::reach>(lines, wide, sums.longest.data(), sums.lesser.data());
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < wide; ++x) {
        const auto at = static_cast<std::size_t>(x);
        odd.longest[at] += across[x] * sums.longest[at];
        if constexpr (Shape::lesser > 0) {
            odd.lesser[at] += across[x] * sums.lesser[at];
        }
        if constexpr (Shape::extent(Shape::reach) == 0) {
            alone[at] = across[x] * lines.at(x, 0);
        }
    }
}

/// As kick_row(), near sides. across: w's factor along x, of node 0's column; along: w's factor of
/// the rows from -reach to reach. Size: as of stress_row_beside().
template <class Shape, class Real, std::ptrdiff_t Size>
void kick_row_beside(const PlaneRowNumbers<Real>& numbers, Real scale, const Real* across,
                     const Real* along, const PlaneRange& nodes,
                     const std::array<const Real*, 2>& u, std::ptrdiff_t pitch,
                     const std::array<const Real* const*, 6>& T, const std::array<Real*, 2>& v) {
    ColumnSums<Shape, Real> even;
    ColumnSums<Shape, Real> odd;
    ColumnSums<Shape, Real> plain;
    ColumnSum<Shape, Real> alone;
    std::array<Real, 2 * Shape::reach + 1> row_weights{};
    std::copy_n(along, row_weights.size(), row_weights.begin());
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first += plane_block<Real>) {
        const std::ptrdiff_t size =
            Size > 0 ? Size : std::min(plane_block<Real>, nodes.last - first);
        const std::ptrdiff_t wide = size + 2 * Shape::reach;
        const auto entry = static_cast<std::size_t>(first + Shape::reach);
        const Real* const moment_x = &numbers.moment[0][entry];
        const Real* const moment_y = &numbers.moment[1][entry];
        const Real* const w = &numbers.stabilisation[entry];
        const Real* const lost = &numbers.own[entry];
        for (std::size_t a = 0; a < 2; ++a) {
            find_divergence_columns({T[2 * a], T[2 * a + 1]}, first, size, even, odd);
            const auto moved = lines_of<Shape>(u[a] + first - Shape::reach, pitch);
            find_even<Shape, Shape::reach>(moved, wide, plain.longest.data(), plain.lesser.data());
            add_weighted(WeightedLines<Shape, Real>{moved, row_weights},
                         across + first - Shape::reach, wide, odd, alone);
            const Real* const own = u[a] + first;
            const Real* const own_x = T[2 * a][Shape::reach] + first;
            const Real* const own_y = T[2 * a + 1][Shape::reach] + first;
            const Real* const inverse_mass = &numbers.inverse_mass[a][entry];
            Real* __restrict velocity = v[a] + first;
            NMBC_NO_ENTRY_NEEDS_ANOTHER
            for (std::ptrdiff_t x = 0; x < size; ++x) {
                Real force = divergence<Shape>(even, odd, own_x, x) +
                             w[x] * whole_sum<Shape>(plain, own, x) + own_x[x] * moment_x[x] +
                             own_y[x] * moment_y[x] - lost[x] * own[x];
                if constexpr (Shape::extent(Shape::reach) == 0) {
                    force += alone[static_cast<std::size_t>(x)] +
                             alone[static_cast<std::size_t>(x + 2 * Shape::reach)];
                }
                velocity[x] += scale * inverse_mass[x] * force;
            }
        }
    }
}

/// Nodes at a left or right side that are swept in loops of known length: those whose families are
/// cut or that have numbers of their own, and those that these act on; of whole vectors.
template <class Shape>
inline constexpr std::ptrdiff_t stress_strip = (2 * Shape::reach + 3) / 4 * 4;
template <class Shape>
inline constexpr std::ptrdiff_t kick_strip = (3 * Shape::reach + 3) / 4 * 4;

}  // namespace nmbc::detail
