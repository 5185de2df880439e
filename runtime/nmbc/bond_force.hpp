// SPDX-License-Identifier: MIT
/// The forces of a bond-based plane lattice between its sides, whose bonds may break.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <nmbc/bond_states.hpp>
#include <nmbc/bond_sweeps.hpp>
#include <nmbc/plane_nodes.hpp>
#include <nmbc/plane_pieces.hpp>
#include <nmbc/plane_potential.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// With E = density = dX = 1. The force on a node is sum w R (R.(u_J - u_I)) over the bonds R that
/// hold. Both ends of a bond find its extension alike to the last bit, so that each may decide by
/// itself whether it breaks: nothing depends on the order of nodes or on the number of threads. The
/// sums of (+-x, +-y) come first, in an order that no mirror along an axis changes: what is
/// symmetric so stays so.
template <class Real>
class BondForce {
  public:
    using Word = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;

    BondForce(const BondModel& model, std::array<PlaneAxis, 2> axes, std::ptrdiff_t pitch)
        : states_(model, std::move(axes)),
          horizon_(static_cast<std::ptrdiff_t>(model.horizon())),
          pitch_(pitch),
          pieces_(axis(0), axis(1).nodes(), pitch, horizon_) {
        for (const BondGroup& group : states_.groups()) {
            limits_.push_back(std::numeric_limits<Real>::infinity());
            std::array<std::ptrdiff_t, 4> entries{};
            for (std::size_t m = 0; m < group.size; ++m) {
                entries[m] = group.members[m].y * pitch + group.members[m].x;
            }
            entries_.push_back(entries);
        }
        for (std::ptrdiff_t step = 0; step <= horizon_; ++step) {
            std::vector<Real> weights;
            for (std::ptrdiff_t low = -horizon_; low < axis(0).nodes(); ++low) {
                weights.push_back(static_cast<Real>(axis(0).strain_of_bond(low, step)));
            }
            column_weights_.push_back(std::move(weights));
        }
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::ptrdiff_t x = 0; x < axis(0).nodes(); ++x) {
                inverse_mass_[a].push_back(static_cast<Real>(1 / axis(0).mass(a, x)));
            }
        }
    }

    const PlaneAxis& axis(std::size_t number) const { return states_.axes()[number]; }
    BondStates<Word>& states() { return states_; }
    const BondStates<Word>& states() const { return states_; }

    /// Bonds that may break do so, in break_and_kick(), where R.(u_J - u_I) is above stretch |R|^2.
    void break_above(double stretch) {
        for (std::size_t g = 0; g < limits_.size(); ++g) {
            const auto [x, y] = states_.groups()[g].first();
            limits_[g] = static_cast<Real>(stretch * (x * x + y * y));
        }
        may_break_ = true;
    }

    const PlanePieces& pieces() const { return pieces_; }

    /// v += scale M^-1 times the force, on the nodes of the body.
    void kick(double scale, PlaneField<const Real> u, PlaneField<Real> v) {
        kick_pieces(pieces_.count(), {.scale = scale, .u = u, .v = v, .breaks = false},
                    [](const PlaneRange&, std::ptrdiff_t) {});
    }
    /// Likewise, once the bonds that are too long have broken.
    void break_and_kick(double scale, PlaneField<const Real> u, PlaneField<Real> v) {
        kick_pieces(pieces_.count(), {.scale = scale, .u = u, .v = v, .breaks = may_break_},
                    [](const PlaneRange&, std::ptrdiff_t) {});
    }
    /// Once drift_ends() of so many pieces is done, the drift of the other rows, and
    /// break_and_kick().
    void drift_and_kick(std::size_t pieces, const PlaneDrift<Real>& drift, double scale,
                        PlaneField<Real> u, PlaneField<Real> v) {
        kick_pieces(pieces, {.scale = scale, .u = {u[0], u[1]}, .v = v, .breaks = may_break_},
                    [&](const PlaneRange& rows, std::ptrdiff_t y) {
                        pieces_.drift_inner(rows, y, drift, u, v);
                    });
    }

    /// Of the nodes of the body among first .. last-1 of a row: half of each of their bonds, and
    /// all of one to a ghost.
    PlanePotential potential_of_row(std::ptrdiff_t y, std::ptrdiff_t first, std::ptrdiff_t last,
                                    PlaneField<const Real> u) const {
        PlanePotential sum;
        if (y < 0 || y >= axis(1).nodes()) {
            return sum;
        }
        const std::ptrdiff_t nodes = axis(0).nodes();
        const bool is_beside_ghosts =
            axis(1).is_ghost(y - horizon_) || axis(1).is_ghost(y + horizon_);
        const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(first, 0);
        const std::ptrdiff_t end = std::min(last, nodes);
        const std::ptrdiff_t plain_begin = axis(0).is_ghost(-1) ? horizon_ : 0;
        const std::ptrdiff_t plain_end = axis(0).is_ghost(nodes) ? nodes - horizon_ : nodes;
        for (std::ptrdiff_t x = begin; x < end;) {
            if (is_beside_ghosts || x < plain_begin || x >= plain_end) {
                sum.strain += energy_of_node(x, y, u);
                ++x;
            } else {
                const std::ptrdiff_t count = std::min({block, end - x, plain_end - x});
                sum.strain += energy_of_block(x, y, count, u);
                x += count;
            }
        }
        return sum;
    }

    /// A bond that broke in the last kick, as seen from a node of the body.
    struct Broken {
        std::ptrdiff_t x = 0;
        std::ptrdiff_t y = 0;
        std::size_t group = 0;
        unsigned member = 0;
    };

    /// Calls see(broken) for each of them and each of their ends in the body, in an order that
    /// does not depend on the number of threads; then forgets them.
    template <class See>
    void take_broken(const See& see) {
        for (std::vector<Broken>& row : broken_) {
            for (const Broken& one : row) {
                see(one);
            }
            row.clear();
        }
    }

    /// R.(u_J - u_I).
    double extension(std::ptrdiff_t x, std::ptrdiff_t y, std::size_t group, unsigned member,
                     PlaneField<const Real> u) const {
        const auto [i, j] = states_.groups()[group].members[member];
        const std::ptrdiff_t at = y * pitch_ + x;
        const std::ptrdiff_t there = at + entries_[group][member];
        return i * (static_cast<double>(u[0][there]) - static_cast<double>(u[0][at])) +
               j * (static_cast<double>(u[1][there]) - static_cast<double>(u[1][at]));
    }

    /// w.
    double weight(std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group,
                  unsigned member) const {
        const auto [i, j] = group.members[member];
        return group.weight * axis(0).strain_of_bond(std::min(x, x + i), std::abs(i)) *
               axis(1).strain_of_bond(std::min(y, y + j), std::abs(j));
    }

    /// M^-1 times the force on a node of the body.
    std::array<double, 2> acceleration(std::ptrdiff_t x, std::ptrdiff_t y,
                                       PlaneField<const Real> u) const {
        std::array<double, 2> force{};
        for_each_held(x, y, u, [&](const PlaneOffset& bond, double weight, double e) {
            force[0] += weight * e * bond.x;
            force[1] += weight * e * bond.y;
        });
        return {force[0] / (axis(0).mass(0, x) * axis(1).mass(0, y)),
                force[1] / (axis(0).mass(1, x) * axis(1).mass(1, y))};
    }

  private:
    static constexpr std::ptrdiff_t block = 256;  ///< nodes whose sums stay in the first cache
    using Sums = std::array<Real, static_cast<std::size_t>(block)>;

    struct Kick {
        double scale = 0;
        PlaneField<const Real> u{};
        PlaneField<Real> v{};
        bool breaks = false;
    };
    /// Nodes x .. x + count - 1 of a row.
    struct Block {
        std::ptrdiff_t x = 0;
        std::ptrdiff_t y = 0;
        std::ptrdiff_t count = 0;
        PlaneField<const Real> u{};  ///< of node (x, y)
    };

    /// Calls work(R, weight, R.(u_J - u_I)) for the bonds of a node that hold.
    template <class Work>
    void for_each_held(std::ptrdiff_t x, std::ptrdiff_t y, PlaneField<const Real> u,
                       const Work& work) const {
        for (std::size_t g = 0; g < states_.groups().size(); ++g) {
            const BondGroup& group = states_.groups()[g];
            for (unsigned m = 0; m < group.size; ++m) {
                if (states_.holds(x, y, group, m)) {
                    work(group.members[m], weight(x, y, group, m), extension(x, y, g, m, u));
                }
            }
        }
    }

    double energy_of_node(std::ptrdiff_t x, std::ptrdiff_t y, PlaneField<const Real> u) const {
        double sum = 0;
        for_each_held(x, y, u, [&](const PlaneOffset& bond, double weight, double e) {
            const bool is_shared = !axis(0).is_ghost(x + bond.x) && !axis(1).is_ghost(y + bond.y);
            sum += weight * e * e / (is_shared ? 4 : 2);
        });
        return sum;
    }

    /// Of nodes of the body whose neighbours are no ghosts.
    double energy_of_block(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t count,
                           PlaneField<const Real> u) const {
        const std::ptrdiff_t at = y * pitch_ + x;
        const Block nodes{x, y, count, {u[0] + at, u[1] + at}};
        double sum = 0;
        for (std::size_t g = 0; g < states_.groups().size(); ++g) {
            const BondGroup& group = states_.groups()[g];
            const Word* const held = &states_.held(group.word)[states_.index(x, y)];
            std::array<double, static_cast<std::size_t>(block)> squares{};
            if (group.size == 4) {
                square_bonds(lines_of<4>(g, nodes), count, held, squares.data());
            } else {
                square_bonds(lines_of<2>(g, nodes), count, held, squares.data());
            }
            for (std::ptrdiff_t i = 0; i < count; ++i) {
                sum += group.weight * squares[static_cast<std::size_t>(i)] / 4;
            }
        }
        return sum;
    }

    /// Before row y of u is read for the first time, before_row(rows of its piece, y).
    template <class BeforeRow>
    void kick_pieces(std::size_t pieces, const Kick& kick, const BeforeRow& before_row) {
        broken_.resize(static_cast<std::size_t>(axis(1).nodes()));
        pieces_.for_each(pieces, [&](std::size_t /*piece*/, const PlaneRange& rows) {
            for (std::ptrdiff_t y = rows.first; y < rows.last; ++y) {
                before_row(rows, y + horizon_);
                kick_row(kick, y);
            }
        });
    }

    void kick_row(const Kick& kick, std::ptrdiff_t y) {
        const std::ptrdiff_t nodes = axis(0).nodes();
        const PlaneAxis::Range xs = axis(0).in_body(axis(0).plain_force());
        const PlaneAxis::Range ys = axis(1).plain_force();
        const bool is_plain = y >= ys.first && y < ys.last && xs.first < xs.last;
        const PlaneAxis::Range plain = is_plain ? xs : PlaneAxis::Range{nodes, nodes};
        const auto kick_part = [&](std::ptrdiff_t first, std::ptrdiff_t last, auto is_weighted) {
            for (std::ptrdiff_t x = first; x < last; x += block) {
                const std::ptrdiff_t at = y * pitch_ + x;
                kick_block<is_weighted>(
                    kick, {x, y, std::min(block, last - x), {kick.u[0] + at, kick.u[1] + at}});
            }
        };
        kick_part(0, plain.first, std::true_type{});
        kick_part(plain.first, plain.last, std::false_type{});
        kick_part(plain.last, nodes, std::true_type{});
    }

    template <bool IsWeighted>
    void kick_block(const Kick& kick, const Block& nodes) {
        std::array<Sums, 2> forces{};
        bool breaks = false;
        for_each_group([&](std::size_t g, auto size) {
            breaks |= pull_group<IsWeighted, size>(g, nodes, kick.breaks, forces);
        });
        if (breaks) {
            forces = {};
            for_each_group(
                [&](std::size_t g, auto size) { break_group<IsWeighted, size>(g, nodes, forces); });
        }
        for (std::size_t a = 0; a < 2; ++a) {
            const Real* const force = forces[a].data();
            Real* const out = kick.v[a] + nodes.y * pitch_ + nodes.x;
            if constexpr (IsWeighted) {
                const Real* const inverse = inverse_mass_[a].data() + nodes.x;
                const auto factor = static_cast<Real>(kick.scale / axis(1).mass(a, nodes.y));
                for (std::ptrdiff_t i = 0; i < nodes.count; ++i) {
                    out[i] += factor * (inverse[i] * force[i]);
                }
            } else {
                const auto factor = static_cast<Real>(kick.scale);
                for (std::ptrdiff_t i = 0; i < nodes.count; ++i) {
                    out[i] += factor * force[i];
                }
            }
        }
    }

    /// Calls work(its number, its size as a constant) for each group of bonds.
    template <class Work>
    void for_each_group(const Work& work) const {
        for (std::size_t g = 0; g < states_.groups().size(); ++g) {
            if (states_.groups()[g].size == 4) {
                work(g, std::integral_constant<std::size_t, 4>{});
            } else {
                work(g, std::integral_constant<std::size_t, 2>{});
            }
        }
    }

    /// Adds the forces of a group's bonds that hold. Returns whether one of them breaks, if any
    /// may.
    template <bool IsWeighted, std::size_t Size>
    bool pull_group(std::size_t number, const Block& nodes, bool may_break,
                    std::array<Sums, 2>& forces) const {
        const BondLines<Real, Word, Size> lines = lines_of<Size>(number, nodes);
        const std::size_t word = states_.groups()[number].word;
        const std::size_t index = states_.index(nodes.x, nodes.y);
        const Word* const held = &states_.held(word)[index];
        if (!may_break) {
            pull_bonds<IsWeighted>(lines, nodes.count, held, forces[0].data(), forces[1].data());
            return false;
        }
        return pull_and_watch_bonds<IsWeighted>(lines, limits_[number], nodes.count,
                                                &states_.breakable(word)[index], held,
                                                forces[0].data(), forces[1].data()) != 0;
    }

    /// Adds the forces of a group's bonds, once those that are too long have broken.
    template <bool IsWeighted, std::size_t Size>
    void break_group(std::size_t number, const Block& nodes, std::array<Sums, 2>& forces) {
        const std::size_t word = states_.groups()[number].word;
        const std::size_t index = states_.index(nodes.x, nodes.y);
        const BondLines<Real, Word, Size> lines = lines_of<Size>(number, nodes);
        std::array<Word, static_cast<std::size_t>(block)> broke{};
        if (break_bonds<IsWeighted>(lines, limits_[number], nodes.count,
                                    &states_.breakable(word)[index], &states_.held(word)[index],
                                    forces[0].data(), forces[1].data(), broke.data()) == 0) {
            return;
        }
        std::vector<Broken>& broken = broken_[static_cast<std::size_t>(nodes.y)];
        for (std::ptrdiff_t i = 0; i < nodes.count; ++i) {
            for (unsigned m = 0; m < Size; ++m) {
                if ((broke[static_cast<std::size_t>(i)] & lines.bits[m]) != 0) {
                    broken.push_back({nodes.x + i, nodes.y, number, m});
                }
            }
        }
    }

    template <std::size_t Size>
    BondLines<Real, Word, Size> lines_of(std::size_t number, const Block& nodes) const {
        const BondGroup& group = states_.groups()[number];
        BondLines<Real, Word, Size> lines;
        lines.here_x = nodes.u[0];
        lines.here_y = nodes.u[1];
        lines.weight_x = static_cast<Real>(group.weight * group.first().x);
        lines.weight_y = static_cast<Real>(group.weight * group.first().y);
        for (std::size_t m = 0; m < Size; ++m) {
            const auto [x, y] = group.members[m];
            lines.there_x[m] = nodes.u[0] + entries_[number][m];
            lines.there_y[m] = nodes.u[1] + entries_[number][m];
            lines.x[m] = static_cast<Real>(x);
            lines.y[m] = static_cast<Real>(y);
            lines.bits[m] = BondStates<Word>::bit(group, static_cast<unsigned>(m));
            lines.column_weights[m] =
                column_weights_[static_cast<std::size_t>(group.first().x)].data() + horizon_ +
                std::min(nodes.x, nodes.x + x);
            lines.row_weights[m] = static_cast<Real>(
                axis(1).strain_of_bond(std::min(nodes.y, nodes.y + y), group.first().y));
        }
        return lines;
    }

    BondStates<Word> states_;
    std::ptrdiff_t horizon_;
    std::ptrdiff_t pitch_;
    PlanePieces pieces_;
    std::vector<std::array<std::ptrdiff_t, 4>> entries_{};  // of the members of each group
    std::vector<Real> limits_{};                            // of R.(u_J - u_I), likewise
    bool may_break_ = false;
    std::vector<std::vector<Real>> column_weights_{};  // by |x| of a bond, of low nodes
    std::array<std::vector<Real>, 2> inverse_mass_{};  // along x
    std::vector<std::vector<Broken>> broken_{};        // of the last kick, row by row
};

}  // namespace nmbc::detail
