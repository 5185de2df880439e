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

/// The column sums of w u, w a factor of the column times one of the row.
template <class Shape, class Real>
struct WeightedColumns {
    // As those of ColumnSums, these are written before they are read.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,modernize-use-equals-default)
    WeightedColumns() {}

    ColumnSums<Shape, Real> sums;
    ColumnSum<Shape, Real> single;  ///< of columns of a single node

    /// As FamilyColumns::find(). across: w's factors of the columns, at that of the first node;
    /// along: of the rows from -reach to reach. Unlike in find_even() of weighted rows, a column's
    /// factor is in a sum once.
    NMBC_INLINED void find(const Real* u, std::ptrdiff_t pitch, std::ptrdiff_t nodes,
                           const Real* across,
                           const std::array<Real, 2 * Shape::reach + 1>& along) {
        const std::ptrdiff_t wide = nodes + 2 * Shape::reach;
        const auto lines = lines_of<Shape>(u - Shape::reach, pitch);
        across -= Shape::reach;
        NMBC_NO_ENTRY_NEEDS_ANOTHER
        for (std::ptrdiff_t x = 0; x < wide; ++x) {
            const auto at = static_cast<std::size_t>(x);
            const auto weighted = [&](int j) {
                return along[static_cast<std::size_t>(j + Shape::reach)] * lines.at(x, j);
            };
            Real sum = weighted(0);
            if constexpr (Shape::extent(Shape::reach) == 0) {
                single[at] = across[x] * sum;
            }
            unrolled<1, Shape::reach>([&](auto j) {
                sum += weighted(j) + weighted(-j);
                if constexpr (j == Shape::lesser) {
                    sums.lesser[at] = across[x] * sum;
                }
            });
            sums.longest[at] = across[x] * sum;
        }
    }

    /// Over the family of a node, its own included.
    NMBC_INLINED Real of(std::ptrdiff_t x) const {
        const Real* const alone = single.data() + Shape::reach;
        Real sum = sums.template at<0>(alone)[x];
        unrolled<1, Shape::reach>([&](auto i) {
            const Real* const column = sums.template at<i>(alone) + x;
            sum += column[i] + column[-i];
        });
        return sum;
    }
};

/// As stress_row(), near sides: what is beyond them is 0, and the pull is
///     sum_J (w_I + w_J) (u_J - u_I) + T_I sum_J R.
/// across: w's factors of the columns, at that of node 0; along: of the rows, at row -reach. Size:
/// the nodes; 0: any number.
template <class Shape, class Real, std::ptrdiff_t Size>
void stress_row_beside(const PlaneModuli<Real>& k, const PlaneRowNumbers<Real>& numbers,
                       const Real* across, const Real* along, const PlaneRange& nodes,
                       const std::array<const Real*, 2>& u, std::ptrdiff_t pitch,
                       const std::array<Real*, 6>& T) {
    std::array<FamilyColumns<Shape, Real>, 2> columns;
    std::array<WeightedColumns<Shape, Real>, 2> weighted;
    std::array<Real, 2 * Shape::reach + 1> row_weights{};
    std::copy_n(along, row_weights.size(), row_weights.begin());
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first += plane_block<Real>) {
        const std::ptrdiff_t size =
            Size > 0 ? Size : std::min(plane_block<Real>, nodes.last - first);
        const std::array<const Real*, 2> own{u[0] + first, u[1] + first};
        for (std::size_t a = 0; a < 2; ++a) {
            columns[a].find(own[a], pitch, size);
            weighted[a].find(own[a], pitch, size, across + first, row_weights);
        }
        const auto entry = static_cast<std::size_t>(first + Shape::reach);
        const Real* const xx = &numbers.inverse_shape[0][entry];
        const Real* const xy = &numbers.inverse_shape[1][entry];
        const Real* const yy = &numbers.inverse_shape[2][entry];
        const Real* const moment_x = &numbers.moment[0][entry];
        const Real* const moment_y = &numbers.moment[1][entry];
        const Real* const V = &numbers.strain[entry];
        const Real* const w = &numbers.stabilisation[entry];
        const Real* const lost = &numbers.own[entry];
        Real* __restrict T_xx = T[0] + first;
        Real* __restrict T_xy = T[1] + first;
        Real* __restrict T_yx = T[2] + first;
        Real* __restrict T_yy = T[3] + first;
        Real* __restrict pull_x = T[4] + first;
        Real* __restrict pull_y = T[5] + first;
        NMBC_NO_ENTRY_NEEDS_ANOTHER
        for (std::ptrdiff_t x = 0; x < size; ++x) {
            const FamilySums<Real> of_x = columns[0].of(x, own[0]);
            const FamilySums<Real> of_y = columns[1].of(x, own[1]);
            const auto slope = [&](const FamilySums<Real>& sums, Real u_of_node) {
                const Real by_x = sums.along_x - moment_x[x] * u_of_node;
                const Real by_y = sums.along_y - moment_y[x] * u_of_node;
                return std::pair(xx[x] * by_x + xy[x] * by_y, xy[x] * by_x + yy[x] * by_y);
            };
            const auto [g_xx, g_xy] = slope(of_x, own[0][x]);
            const auto [g_yx, g_yy] = slope(of_y, own[1][x]);
            const Real P_xx = V[x] * (k.direct * g_xx + k.across * g_yy);
            const Real P_xy = V[x] * (k.shear * g_xy + k.turned * g_yx);
            const Real P_yx = V[x] * (k.shear * g_yx + k.turned * g_xy);
            const Real P_yy = V[x] * (k.direct * g_yy + k.across * g_xx);
            const Real own_xx = P_xx * xx[x] + P_xy * xy[x] - w[x] * g_xx;
            const Real own_xy = P_xx * xy[x] + P_xy * yy[x] - w[x] * g_xy;
            const Real own_yx = P_yx * xx[x] + P_yy * xy[x] - w[x] * g_yx;
            const Real own_yy = P_yx * xy[x] + P_yy * yy[x] - w[x] * g_yy;
            T_xx[x] = own_xx;
            T_xy[x] = own_xy;
            T_yx[x] = own_yx;
            T_yy[x] = own_yy;
            pull_x[x] = w[x] * of_x.all + weighted[0].of(x) - lost[x] * own[0][x] +
                        own_xx * moment_x[x] + own_xy * moment_y[x];
            pull_y[x] = w[x] * of_y.all + weighted[1].of(x) - lost[x] * own[1][x] +
                        own_yx * moment_x[x] + own_yy * moment_y[x];
        }
    }
}

/// Nodes at a left or right side that are swept in loops of known length: of a side of 2n layers,
/// those with numbers of their own and those whose families these are in, in whole vectors.
template <class Shape, class Real>
inline constexpr std::ptrdiff_t stress_strip = up_to_whole_vectors<Real>(3 * Shape::reach);

}  // namespace nmbc::detail
