// SPDX-License-Identifier: MIT
/// Sweeps over the nodes of a row for the bonds (+-x, +-y), made for compilers to vectorise.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/vector_loops.hpp>
#include <type_traits>

namespace nmbc::detail {

/// What a sweep reads, from its first node on. Size: 4, or 2 where x or y is 0.
template <class Real, class Word, std::size_t Size>
struct BondLines {
    std::array<const Real*, Size> there_x{};  ///< u of the other ends
    std::array<const Real*, Size> there_y{};
    const Real* here_x = nullptr;
    const Real* here_y = nullptr;
    std::array<Real, Size> x{};
    std::array<Real, Size> y{};
    std::array<Word, Size> bits{};
    Real weight_x = 0;  ///< w times x of the first of them
    Real weight_y = 0;
    std::array<const Real*, Size> column_weights{};  ///< of each node; and of the row
    std::array<Real, Size> row_weights{};
};

/// R.(u_J - u_I) of bond m. The sum begins with a 0 that compilers may not drop: all sweeps round
/// alike where products are contracted with additions.
template <class Lines>
NMBC_INLINED auto bond_extension(const Lines& lines, std::size_t m, std::ptrdiff_t i) {
    std::remove_const_t<std::remove_reference_t<decltype(lines.x[m])>> e = 0;
    e += lines.x[m] * (lines.there_x[m][i] - lines.here_x[i]);
    e += lines.y[m] * (lines.there_y[m][i] - lines.here_y[i]);
    return e;
}

/// Adds the forces of a node's bonds, in an order that no mirror along an axis changes.
/// extension_of(m): of a bond that holds, otherwise 0.
template <bool IsWeighted, class Real, class Word, std::size_t Size, class Extension>
NMBC_INLINED void add_bond_forces(const BondLines<Real, Word, Size>& lines, std::ptrdiff_t i,
                                  const Extension& extension_of, Real& force_x, Real& force_y) {
    const auto pull = [&](std::size_t m) {
        const Real e = extension_of(m);
        if constexpr (IsWeighted) {
            Real weighted = 0;  // as in bond_extension()
            weighted += e * (lines.column_weights[m][i] * lines.row_weights[m]);
            return weighted;
        }
        return e;
    };
    const Real first = pull(0);
    const Real second = pull(1);
    if constexpr (Size == 4) {
        const Real third = pull(2);
        const Real fourth = pull(3);
        force_x += lines.weight_x * ((first + second) - (third + fourth));
        force_y += lines.weight_y * ((first + third) - (second + fourth));
    } else {
        force_x += lines.weight_x * (first - second);
        force_y += lines.weight_y * (first - second);
    }
}

/// Adds the forces of the bonds that hold.
template <bool IsWeighted, class Real, class Word, std::size_t Size>
void pull_bonds(const BondLines<Real, Word, Size>& by_reference, std::ptrdiff_t count,
                const Word* __restrict held, Real* __restrict force_x, Real* __restrict force_y) {
    const BondLines<Real, Word, Size> lines = by_reference;  // that no store can change
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Word bits = held[i];
        add_bond_forces<IsWeighted>(
            lines, i,
            [&](std::size_t m) {
                const Real e = bond_extension(lines, m, i);
                return (bits & lines.bits[m]) != 0 ? e : Real(0);
            },
            force_x[i], force_y[i]);
    }
}

/// Likewise. Returns bits of those that are longer than the limit and may break.
template <bool IsWeighted, class Real, class Word, std::size_t Size>
Word pull_and_watch_bonds(const BondLines<Real, Word, Size>& by_reference, Real limit,
                          std::ptrdiff_t count, const Word* __restrict breakable,
                          const Word* __restrict held, Real* __restrict force_x,
                          Real* __restrict force_y) {
    const BondLines<Real, Word, Size> lines = by_reference;
    Word breaking = 0;
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Word bits = held[i];
        const Word may_break = bits & breakable[i];
        Word too_long = 0;
        add_bond_forces<IsWeighted>(
            lines, i,
            [&](std::size_t m) {
                const Real e = bond_extension(lines, m, i);
                too_long |= e > limit ? lines.bits[m] : Word{0};
                return (bits & lines.bits[m]) != 0 ? e : Real(0);
            },
            force_x[i], force_y[i]);
        breaking |= too_long & may_break;
    }
    return breaking;
}

/// Adds the squares of the extensions of the bonds that hold, each times its weight over w.
template <class Real, class Word, std::size_t Size>
void square_bonds(const BondLines<Real, Word, Size>& by_reference, std::ptrdiff_t count,
                  const Word* __restrict held, double* __restrict squares) {
    const BondLines<Real, Word, Size> lines = by_reference;
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        for (std::size_t m = 0; m < Size; ++m) {
            const auto between = [&](const Real* there, const Real* here) {
                return static_cast<double>(there[i]) - static_cast<double>(here[i]);
            };
            const double e =
                static_cast<double>(lines.x[m]) * between(lines.there_x[m], lines.here_x) +
                static_cast<double>(lines.y[m]) * between(lines.there_y[m], lines.here_y);
            const auto weight =
                static_cast<double>(lines.column_weights[m][i] * lines.row_weights[m]);
            squares[i] += (held[i] & lines.bits[m]) != 0 ? weight * (e * e) : 0;
        }
    }
}

/// Breaks the bonds whose extensions are above the limit, if they may, and adds the forces of the
/// others. `broke`: the bits of each node that have gone. Returns all of them.
template <bool IsWeighted, class Real, class Word, std::size_t Size>
Word break_bonds(const BondLines<Real, Word, Size>& by_reference, Real limit, std::ptrdiff_t count,
                 const Word* __restrict breakable, Word* __restrict held, Real* __restrict force_x,
                 Real* __restrict force_y, Word* __restrict broke) {
    const BondLines<Real, Word, Size> lines = by_reference;
    Word any = 0;
    NMBC_NO_ENTRY_NEEDS_ANOTHER
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Word old = held[i];
        const Word may_break = breakable[i] & old;
        Word now = old;
        add_bond_forces<IsWeighted>(
            lines, i,
            [&](std::size_t m) {
                const Real e = bond_extension(lines, m, i);
                now &= e > limit ? ~(may_break & lines.bits[m]) : ~Word{0};
                return (now & lines.bits[m]) != 0 ? e : Real(0);
            },
            force_x[i], force_y[i]);
        held[i] = now;
        broke[i] = old ^ now;
        any |= old ^ now;
    }
    return any;
}

}  // namespace nmbc::detail
