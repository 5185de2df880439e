// SPDX-License-Identifier: MIT
/// Sweeps over the nodes of a plane lattice whose families are whole. A sum over a family is done
/// column by column: what the columns of a node's family give, its neighbours along x use again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/plane_family.hpp>
#include <nmbc/vector_loops.hpp>
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
    /// Of the columns that are more than one node and not the longest ones; 0 where there are none.
    static constexpr int lesser = [] {
        int lesser = 0;
        for (int i = 1; i <= reach; ++i) {
            lesser = extent(i) < reach ? std::max(lesser, extent(i)) : lesser;
        }
        return lesser;
    }();
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
template <class Real>
inline constexpr std::ptrdiff_t plane_block = 1024 / sizeof(Real);

/// Entries of a vector: what is left over of a loop is done entry by entry.
template <class Real>
inline constexpr std::ptrdiff_t whole_vector = 32 / sizeof(Real);

/// So many entries, and as many more as make whole vectors.
template <class Real>
constexpr std::ptrdiff_t up_to_whole_vectors(std::ptrdiff_t entries) {
    return (entries + whole_vector<Real> - 1) / whole_vector<Real> * whole_vector<Real>;
}

/// Where the block of an entry ends: blocks end at multiples of their length. entry >= 0.
template <class Real>
constexpr std::ptrdiff_t block_end(std::ptrdiff_t entry) {
    return (entry / plane_block<Real> + 1) * plane_block<Real>;
}

/// Sums over columns of these rows, entry by entry; entry 0 is that of node -reach.
template <class Shape, class Real>
using ColumnSum = std::array<Real, plane_block<Real> + 2 * Shape::reach>;

/// Of the longest columns, and of the lesser ones.
template <class Shape, class Real>
struct ColumnSums {
    // The sums are written before they are read; to set them to 0 first would take time.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,modernize-use-equals-default)
    ColumnSums() {}

    ColumnSum<Shape, Real> longest;
    ColumnSum<Shape, Real> lesser;

    /// Of a column at a distance i; of a single node, of which there is no sum: `alone`.
    template <int I>
    const Real* at(const Real* alone) const {
        constexpr int extent = Shape::extent(I);
        static_assert(extent == 0 || extent == Shape::lesser || extent == Shape::reach);
        return extent == 0 ? alone
                           : (extent == Shape::reach ? longest : lesser).data() + Shape::reach;
    }
};

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

/// sum over |j| <= extent of the field, of columns up to `Most`.
template <class Shape, int Most, class Lines, class Real>
NMBC_INLINED void find_even(const Lines& lines, std::ptrdiff_t nodes, Real* __restrict longest,
                            Real* __restrict lesser) {
    if constexpr (Most == 0) {  // single nodes have no sums; GCC warns of sums never written
        longest[0] = 0;
        return;
    }
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < nodes; ++x) {
        Real sum = lines.at(x, 0);
        unrolled<1, Most>([&](auto j) {
            sum += lines.at(x, j) + lines.at(x, -j);
            if constexpr (j == Shape::lesser) {
                lesser[x] = sum;
            }
        });
        if constexpr (Most == Shape::reach) {
            longest[x] = sum;
        }
    }
}

/// sum over |j| <= extent of j times the field.
template <class Shape, class Real>
NMBC_INLINED void find_odd(const PlaneLines<Shape, Real>& lines, std::ptrdiff_t nodes,
                           Real* __restrict longest, Real* __restrict lesser) {
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < nodes; ++x) {
        Real sum = 0;
        unrolled<1, Shape::reach>([&](auto j) {
            const Real difference = static_cast<Real>(j) * (lines.at(x, j) - lines.at(x, -j));
            sum = j == 1 ? difference : sum + difference;
            if constexpr (j == Shape::lesser) {
                lesser[x] = sum;
            }
        });
        longest[x] = sum;
    }
}

/// Of one field both find_even() and find_odd(), whose rows are read once.
template <class Shape, class Real>
NMBC_INLINED void find_both(const PlaneLines<Shape, Real>& lines, std::ptrdiff_t nodes,
                            Real* __restrict even_longest, Real* __restrict even_lesser,
                            Real* __restrict odd_longest, Real* __restrict odd_lesser) {
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < nodes; ++x) {
        Real even = lines.at(x, 0);
        Real odd = 0;
        unrolled<1, Shape::reach>([&](auto j) {
            const Real after = lines.at(x, j);
            const Real before = lines.at(x, -j);
            const Real difference = static_cast<Real>(j) * (after - before);
            even += after + before;
            odd = j == 1 ? difference : odd + difference;
            if constexpr (j == Shape::lesser) {
                even_lesser[x] = even;
                odd_lesser[x] = odd;
            }
        });
        even_longest[x] = even;
        odd_longest[x] = odd;
    }
}

/// Sums over the family of a node.
template <class Real>
struct FamilySums {
    Real along_x = 0;  ///< sum R_x u_J
    Real along_y = 0;  ///< sum R_y u_J
    Real all = 0;      ///< sum u_J, its own included
};

/// The column sums of one component in a block of a row.
template <class Shape, class Real>
struct FamilyColumns {
    ColumnSums<Shape, Real> even;
    ColumnSums<Shape, Real> odd;

    /// u points at the first node.
    NMBC_INLINED void find(const Real* u, std::ptrdiff_t pitch, std::ptrdiff_t nodes) {
        const std::ptrdiff_t wide = nodes + 2 * Shape::reach;
        const auto lines = lines_of<Shape>(u - Shape::reach, pitch);
        find_both<Shape>(lines, wide, even.longest.data(), even.lesser.data(), odd.longest.data(),
                         odd.lesser.data());
    }

    /// own: entry 0 of u.
    NMBC_INLINED FamilySums<Real> of(std::ptrdiff_t x, const Real* own) const {
        Real along_x = 0;
        Real along_y = odd.template at<0>(own)[x];
        Real all = even.template at<0>(own)[x];
        unrolled<1, Shape::reach>([&](auto i) {
            const Real* const column = even.template at<i>(own) + x;
            const Real right = column[i];
            const Real left = column[-i];
            along_x += static_cast<Real>(i) * (right - left);
            all += right + left;
            if constexpr (Shape::extent(i) > 0) {
                const Real* const uneven = odd.template at<i>(own) + x;
                along_y += uneven[i] + uneven[-i];
            }
        });
        return {along_x, along_y, all};
    }
};

/// What a block of a row has of T, and of 2 s sum_J (u_J - u_I). Each row is a parameter: so
/// compilers know them apart.
template <class Shape, class Real>
void find_stresses(PlaneCoefficients<Real> k, std::ptrdiff_t nodes,
                   const FamilyColumns<Shape, Real>& columns_x,
                   const FamilyColumns<Shape, Real>& columns_y, const Real* u_x, const Real* u_y,
                   Real* __restrict T_xx, Real* __restrict T_xy, Real* __restrict T_yx,
                   Real* __restrict T_yy, Real* __restrict pull_x, Real* __restrict pull_y) {
    const Real family = Shape::bonds + 1;
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < nodes; ++x) {
        const FamilySums<Real> of_x = columns_x.of(x, u_x);
        const FamilySums<Real> of_y = columns_y.of(x, u_y);
        T_xx[x] = k.direct * of_x.along_x + k.across * of_y.along_y;
        T_yy[x] = k.direct * of_y.along_y + k.across * of_x.along_x;
        T_xy[x] = k.shear * of_x.along_y + k.turned * of_y.along_x;
        T_yx[x] = k.shear * of_y.along_x + k.turned * of_x.along_y;
        pull_x[x] = k.laplacian * (of_x.all - family * u_x[x]);
        pull_y[x] = k.laplacian * (of_y.all - family * u_y[x]);
    }
}

/// T and the pull of the stabilisation on these nodes of a row, at whose node 0 u and T point.
/// Where node -reach of T's rows begins a cache line, what later blocks store does, too: a store
/// that two lines share takes longer. nodes.first is not below -reach.
template <class Shape, class Real>
void stress_row(const PlaneCoefficients<Real>& k, const PlaneRange& nodes,
                const std::array<const Real*, 2>& u, std::ptrdiff_t pitch,
                const std::array<Real*, 6>& T) {
    FamilyColumns<Shape, Real> of_x;
    FamilyColumns<Shape, Real> of_y;
    std::ptrdiff_t last = nodes.first;
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first = last) {
        last = std::min(block_end<Real>(first + Shape::reach) - Shape::reach, nodes.last);
        const std::ptrdiff_t size = last - first;
        const std::array<const Real*, 2> block{u[0] + first, u[1] + first};
        of_x.find(block[0], pitch, size);
        of_y.find(block[1], pitch, size);
        find_stresses<Shape>(k, size, of_x, of_y, block[0], block[1], T[0] + first, T[1] + first,
                             T[2] + first, T[3] + first, T[4] + first, T[5] + first);
    }
}

/// sum_J (T_J,x R_x + T_J,y R_y) of one component: `even` are columns of T_x from the first one on,
/// `odd` those of T_y; own: T_x of the first node.
template <class Shape, class Real>
NMBC_INLINED Real divergence(const ColumnSums<Shape, Real>& even,
                             const ColumnSums<Shape, Real>& odd, const Real* own,
                             std::ptrdiff_t x) {
    Real sum = odd.template at<0>(own)[x];
    unrolled<1, Shape::reach>([&](auto i) {
        const Real* const column = even.template at<i>(own) + x;
        sum += static_cast<Real>(i) * (column[i] - column[-i]);
        if constexpr (Shape::extent(i) > 0) {
            const Real* const uneven = odd.template at<i>(own) + x;
            sum += uneven[i] + uneven[-i];
        }
    });
    return sum;
}

/// scale: of a node, by its entry.
template <class Shape, class Real, class Scale>
NMBC_INLINED void kick_block(const Scale& scale, std::ptrdiff_t nodes,
                             const ColumnSums<Shape, Real>& even,
                             const ColumnSums<Shape, Real>& odd, const Real* own, const Real* pull,
                             Real* __restrict v) {
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t x = 0; x < nodes; ++x) {
        v[x] += scale(x) * (divergence<Shape>(even, odd, own, x) + pull[x]);
    }
}

/// The column sums of T_x and T_y that a divergence is made of, whose rows from -reach to reach are
/// these.
template <class Shape, class Real>
NMBC_INLINED void find_divergence_columns(const std::array<const Real* const*, 2>& T,
                                          std::ptrdiff_t first, std::ptrdiff_t nodes,
                                          ColumnSums<Shape, Real>& even,
                                          ColumnSums<Shape, Real>& odd) {
    const std::ptrdiff_t wide = nodes + 2 * Shape::reach;
    find_even<Shape, Shape::extent(1)>(lines_of<Shape>(T[0], first - Shape::reach), wide,
                                       even.longest.data(), even.lesser.data());
    find_odd<Shape>(lines_of<Shape>(T[1], first - Shape::reach), wide, odd.longest.data(),
                    odd.lesser.data());
}

/// One over the masses of a row.
template <class Real>
struct PlaneMasses {
    std::array<const Real*, 2> inverse{};  ///< of a component, from node 0 on
    PlaneRange plain{};                    ///< where they are 1
};

/// v += scale times the forces over the masses, on these nodes of a row, at whose node 0 v and T's
/// rows xx, xy, yx, yy and those of the pull point, each of them those from -reach to reach. Blocks
/// end at multiples of their length, counted from node 0; nodes.first is not below 0. Where node
/// -reach of T's rows begins a cache line, what the column sums of later blocks read first does,
/// too.
template <class Shape, class Real>
void kick_row(Real scale, const PlaneMasses<Real>& masses, const PlaneRange& nodes,
              const std::array<const Real* const*, 6>& T, const std::array<Real*, 2>& v) {
    ColumnSums<Shape, Real> even;
    ColumnSums<Shape, Real> odd;
    std::ptrdiff_t last = nodes.first;
    for (std::ptrdiff_t first = nodes.first; first < nodes.last; first = last) {
        last = std::min(block_end<Real>(first), nodes.last);
        const std::ptrdiff_t size = last - first;
        const bool is_plain = first >= masses.plain.first && last <= masses.plain.last;
        for (std::size_t a = 0; a < 2; ++a) {
            find_divergence_columns({T[2 * a], T[2 * a + 1]}, first, size, even, odd);
            const auto kick = [&](const auto& scales) {
                kick_block(scales, size, even, odd, T[2 * a][Shape::reach] + first,
                           T[4 + a][Shape::reach] + first, v[a] + first);
            };
            if (is_plain) {
                kick([scale](std::ptrdiff_t) { return scale; });
            } else {
                const Real* const inverse = masses.inverse[a] + first;
                kick([scale, inverse](std::ptrdiff_t x) { return scale * inverse[x]; });
            }
        }
    }
}

}  // namespace nmbc::detail
