// SPDX-License-Identifier: MIT
/// Sweeps over the nodes of a plane lattice whose families are whole. A sum over a family is done
/// column by column: what the columns of a node's family give, its neighbours along x use again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/plane_family.hpp>
#include <type_traits>

namespace nmbc::detail {

/// Calls work(std::integral_constant<int, i>) for i = First .. Last.
template <int First, int Last, class Work>
constexpr void unrolled(const Work& work) {
    if constexpr (First <= Last) {
        work(std::integral_constant<int, First>{});
        unrolled<First + 1, Last>(work);
    }
}

/// A family's column at a distance i from its node has the offsets |j| <= extent(i).
template <int RadiusSquared>
struct PlaneShape {
    static constexpr int extent(int i) {
        int j = 0;
        while ((j + 1) * (j + 1) + i * i <= RadiusSquared) {
            ++j;
        }
        return j;
    }
    static constexpr int reach = extent(0);
    static constexpr int bonds = [] {
        int sum = -1;
        for (int i = -reach; i <= reach; ++i) {
            sum += 2 * extent(i) + 1;
        }
        return sum;
    }();
    /// A: the sum of x^2.
    static constexpr int shape = [] {
        int sum = 0;
        for (int i = -reach; i <= reach; ++i) {
            sum += i * i * (2 * extent(i) + 1);
        }
        return sum;
    }();
    /// Columns of one extent have the same sums; slots of them, by the distance.
    static constexpr int slot(int i) {
        int slot = 0;
        for (int k = 1; k <= i; ++k) {
            slot += static_cast<int>(extent(k) != extent(k - 1));
        }
        return slot;
    }
    static constexpr int slots = slot(reach) + 1;
};

/// Of the sweeps. T = P/A - s g, here from A g; forces are sum_J T_J R + 2 s sum_J (u_J - u_I), R =
/// X_J - X_I.
template <class Real>
struct PlaneCoefficients {
    Real direct = 0;     ///< of g_xx in T_xx
    Real across = 0;     ///< of g_yy in T_xx
    Real shear = 0;      ///< of g_xy in T_xy
    Real turned = 0;     ///< of g_yx in T_xy
    Real laplacian = 0;  ///< 2 s
};

/// Nodes of a block, whose column sums stay in the cache of first level.
inline constexpr std::ptrdiff_t plane_block = 128;

template <class Shape, class Real>
using ColumnSums =
    std::array<std::array<Real, plane_block + 2 * Shape::reach>, std::size_t(Shape::slots)>;

/// Entry 0 of the rows from -reach to reach of a node's row on.
template <class Shape, class Real>
struct PlaneLines {
    std::array<const Real*, 2 * Shape::reach + 1> rows{};

    Real at(std::ptrdiff_t x, int j) const {
        return rows[static_cast<std::size_t>(j + Shape::reach)][x];
    }
};

template <class Shape, class Real>
PlaneLines<Shape, Real> lines_of(const Real* field, std::ptrdiff_t pitch) {
    PlaneLines<Shape, Real> lines;
    for (int j = -Shape::reach; j <= Shape::reach; ++j) {
        lines.rows[static_cast<std::size_t>(j + Shape::reach)] = field + j * pitch;
    }
    return lines;
}

/// Of rows that are wherever they are, from an entry on.
template <class Shape, class Real>
PlaneLines<Shape, Real> lines_of(const Real* const* rows, std::ptrdiff_t entry) {
    PlaneLines<Shape, Real> lines;
    for (std::size_t j = 0; j < lines.rows.size(); ++j) {
        lines.rows[j] = rows[j] + entry;
    }
    return lines;
}

/// For each extent from that of column First on, entry x is sum_of(x, extent).
template <class Shape, int First, class Real, class Sum>
void find_columns(std::ptrdiff_t nodes, ColumnSums<Shape, Real>& sums, const Sum& sum_of) {
    unrolled<First, Shape::reach>([&](auto i) {
        if constexpr (i == First || Shape::slot(i) != Shape::slot(i - 1)) {
            Real* __restrict out = sums[Shape::slot(i)].data();
            for (std::ptrdiff_t x = 0; x < nodes; ++x) {
                out[x] = sum_of(x, std::integral_constant<int, Shape::extent(i)>{});
            }
        }
    });
}

/// sum over |j| <= extent of the field.
template <int Extent, class Shape, class Real>
Real even_sum(const PlaneLines<Shape, Real>& lines, std::ptrdiff_t x) {
    Real sum = lines.at(x, 0);
    unrolled<1, Extent>([&](auto j) { sum += lines.at(x, j) + lines.at(x, -j); });
    return sum;
}

/// sum over |j| <= extent of j times the field.
template <int Extent, class Shape, class Real>
Real odd_sum(const PlaneLines<Shape, Real>& lines, std::ptrdiff_t x) {
    Real sum = 0;
    unrolled<1, Extent>(
        [&](auto j) { sum += static_cast<Real>(j) * (lines.at(x, j) - lines.at(x, -j)); });
    return sum;
}

/// sum i (column(x + i) - column(x - i)); entry 0 of the columns is that of node -reach.
template <class Shape, class Real>
Real odd_across(const ColumnSums<Shape, Real>& columns, std::ptrdiff_t x) {
    Real sum = 0;
    unrolled<1, Shape::reach>([&](auto i) {
        const Real* const column = columns[Shape::slot(i)].data() + Shape::reach + x;
        sum += static_cast<Real>(i) * (column[i] - column[-i]);
    });
    return sum;
}

/// sum over |i| <= reach of column(x + i); of a column that is one node where WithPoints.
template <class Shape, bool WithPoints, class Real>
Real even_across(const ColumnSums<Shape, Real>& columns, std::ptrdiff_t x) {
    Real sum = columns[0][static_cast<std::size_t>(x + Shape::reach)];
    unrolled<1, Shape::reach>([&](auto i) {
        if constexpr (WithPoints || Shape::extent(i) > 0) {
            const Real* const column = columns[Shape::slot(i)].data() + Shape::reach + x;
            sum += column[i] + column[-i];
        }
    });
    return sum;
}

/// The column sums of a block of a row that its gradients are made of.
template <class Shape, class Real>
class SlopeColumns {
  public:
    // The sums are written before they are read; to set them to 0 first would take time.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,modernize-use-equals-default)
    SlopeColumns() {}

    /// u points at the first node.
    void find(const std::array<const Real*, 2>& u, std::ptrdiff_t pitch, std::ptrdiff_t nodes) {
        const std::ptrdiff_t wide = nodes + 2 * Shape::reach;
        for (std::size_t a = 0; a < 2; ++a) {
            const auto lines = lines_of<Shape>(u[a] - Shape::reach, pitch);
            find_columns<Shape, 1>(wide, even_[a], [=](std::ptrdiff_t x, auto extent) {
                return even_sum<extent>(lines, x);
            });
            find_columns<Shape, 0>(wide, odd_[a], [=](std::ptrdiff_t x, auto extent) {
                return odd_sum<extent>(lines, x);
            });
        }
    }

    /// sum R_x u_a and sum R_y u_a over the family of node x.
    Real along_x(std::size_t a, std::ptrdiff_t x) const { return odd_across<Shape>(even_[a], x); }
    Real along_y(std::size_t a, std::ptrdiff_t x) const {
        return even_across<Shape, false>(odd_[a], x);
    }

  private:
    std::array<ColumnSums<Shape, Real>, 2> even_;
    std::array<ColumnSums<Shape, Real>, 2> odd_;
};

/// T on these nodes of a row, at whose node 0 u and T point.
template <class Shape, class Real>
void stress_row(const PlaneCoefficients<Real>& k, const PlaneRange& nodes,
                const std::array<const Real*, 2>& u, std::ptrdiff_t pitch,
                const std::array<Real*, 4>& T) {
    SlopeColumns<Shape, Real> columns;
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first += plane_block) {
        const std::ptrdiff_t size = std::min(plane_block, nodes.last - first);
        columns.find({u[0] + first, u[1] + first}, pitch, size);
        Real* __restrict T_xx = T[0] + first;
        Real* __restrict T_xy = T[1] + first;
        Real* __restrict T_yx = T[2] + first;
        Real* __restrict T_yy = T[3] + first;
        for (std::ptrdiff_t x = 0; x < size; ++x) {
            const Real g_xx = columns.along_x(0, x);
            const Real g_yx = columns.along_x(1, x);
            const Real g_xy = columns.along_y(0, x);
            const Real g_yy = columns.along_y(1, x);
            T_xx[x] = k.direct * g_xx + k.across * g_yy;
            T_yy[x] = k.direct * g_yy + k.across * g_xx;
            T_xy[x] = k.shear * g_xy + k.turned * g_yx;
            T_yx[x] = k.shear * g_yx + k.turned * g_xy;
        }
    }
}

/// v += scale times the forces, on these nodes of a row, at whose node 0 u, v and T's rows xx, xy,
/// yx, yy point, each of them those from -reach to reach.
template <class Shape, class Real>
void kick_row(const PlaneCoefficients<Real>& k, Real scale, const PlaneRange& nodes,
              const std::array<const Real*, 2>& u, std::ptrdiff_t pitch,
              const std::array<const Real* const*, 4>& T, const std::array<Real*, 2>& v) {
    ColumnSums<Shape, Real> even;
    ColumnSums<Shape, Real> others;
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first += plane_block) {
        const std::ptrdiff_t size = std::min(plane_block, nodes.last - first);
        const std::ptrdiff_t wide = size + 2 * Shape::reach;
        for (std::size_t a = 0; a < 2; ++a) {
            const auto along = lines_of<Shape>(T[2 * a], first - Shape::reach);
            const auto across = lines_of<Shape>(T[2 * a + 1], first - Shape::reach);
            const auto moved = lines_of<Shape>(u[a] + first - Shape::reach, pitch);
            const Real laplacian = k.laplacian;
            find_columns<Shape, 1>(wide, even, [=](std::ptrdiff_t x, auto extent) {
                return even_sum<extent>(along, x);
            });
            find_columns<Shape, 0>(wide, others, [=](std::ptrdiff_t x, auto extent) {
                return odd_sum<extent>(across, x) + laplacian * even_sum<extent>(moved, x);
            });
            const Real* __restrict at = u[a] + first;
            Real* __restrict velocity = v[a] + first;
            const Real own = laplacian * (Shape::bonds + 1);
            for (std::ptrdiff_t x = 0; x < size; ++x) {
                velocity[x] += scale * (odd_across<Shape>(even, x) +
                                        even_across<Shape, true>(others, x) - own * at[x]);
            }
        }
    }
}

}  // namespace nmbc::detail
