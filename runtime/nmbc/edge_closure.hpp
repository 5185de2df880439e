// SPDX-License-Identifier: MIT
/// The energy of an edge whose families end where the nodes do: as it is left by the plain cut, and
/// by summation by parts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/mirror_images.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbc {

namespace detail {

/// A lattice of correspondence, such as nopd1d: one strain a node and, for each of its bonds, the
/// square of what the strain leaves of it.
struct Correspondence {
    std::vector<double> strain;         ///< sum_k strain[k-1] (u_{I+k} - u_{I-k}), k = 1 .. n
    std::vector<double> stabilisation;  ///< weights of bonds I+k and I-k, k = 1 .. n; empty: none
};

/// sum_i of a stencil about its node: u_{I+k} - u_I - k strain, or the strain itself for k = 0.
inline std::vector<double> bond_stencil(const std::vector<double>& strain, int k) {
    const auto n = static_cast<int>(strain.size());
    std::vector<double> stencil(2 * strain.size() + 1);
    for (int j = 1; j <= n; ++j) {
        const double entry = strain[static_cast<std::size_t>(j - 1)] * (k == 0 ? 1 : -k);
        stencil[static_cast<std::size_t>(n + j)] = entry;
        stencil[static_cast<std::size_t>(n - j)] = -entry;
    }
    if (k != 0) {
        stencil[static_cast<std::size_t>(n + k)] += 1;
        stencil[static_cast<std::size_t>(n)] -= 1;
    }
    return stencil;
}

inline bool is_near(const std::vector<double>& one, const std::vector<double>& other) {
    constexpr double roundings = 1e-12;
    bool near = one.size() == other.size();
    for (std::size_t i = 0; near && i < one.size(); ++i) {
        near = std::abs(one[i] - other[i]) <= roundings;
    }
    return near;
}

/// A square has no sign: that of an even strain of 1 is taken for positive.
inline void turn_to_even_strain(std::vector<double>& strain) {
    double of_even = 0;
    for (std::size_t k = 1; k <= strain.size(); ++k) {
        of_even += 2 * static_cast<double>(k) * strain[k - 1];
    }
    for (double& entry : strain) {
        entry = of_even < 0 ? -entry : entry;
    }
}

/// Throws std::invalid_argument for another kind of lattice.
inline Correspondence correspondence_of(const Lattice& any) {
    const Lattice lattice = with_mirror_images(any);
    const std::size_t n = lattice.reach() / 2;
    Correspondence found;
    bool is_known = n > 0 && lattice.reach() == 2 * n;
    for (const auto& [part, weight, stencil] : lattice.energy) {
        is_known = is_known && stencil.size() == 2 * n + 1;
        if (is_known && part == EnergyPart::strain) {
            is_known = found.strain.empty() && weight == 1;
            found.strain.assign(stencil.begin() + static_cast<std::ptrdiff_t>(n) + 1,
                                stencil.end());
            is_known = is_known && is_near(stencil, bond_stencil(found.strain, 0));
        }
    }
    is_known = is_known && !found.strain.empty();
    turn_to_even_strain(found.strain);
    std::vector<int> ends(n);  // of the bonds I+k and I-k: both weigh the same
    for (const auto& [part, weight, stencil] : lattice.energy) {
        if (!is_known || part == EnergyPart::strain) {
            continue;
        }
        found.stabilisation.resize(n);
        is_known = false;
        for (int k = -static_cast<int>(n); !is_known && k <= static_cast<int>(n); ++k) {
            if (k != 0 && is_near(stencil, bond_stencil(found.strain, k))) {
                const auto bond = static_cast<std::size_t>(std::abs(k) - 1);
                is_known = ends[bond] == 0 || found.stabilisation[bond] == weight;
                found.stabilisation[bond] = weight;
                ++ends[bond];
            }
        }
    }
    is_known =
        is_known && std::ranges::all_of(ends, [](int count) { return count == 0 || count == 2; });
    if (!is_known) {
        throw std::invalid_argument(
            "this end is for lattices of one strain a node, such as nopd1d; sbp and cut are for "
            "bonds, too");
    }
    return found;
}

/// The strain of a node near the edge and the part of dX that is its own.
struct EdgeNode {
    std::vector<double> strain;  ///< factors of u_0, u_1, ..
    double volume = 1;
};

/// The energy of the lattice with these strains of the outermost nodes: bonds that end outside are
/// not there.
inline EdgeEnergy edge_of(const Correspondence& lattice, const std::vector<EdgeNode>& nodes) {
    const auto n = static_cast<int>(lattice.strain.size());
    EdgeEnergy edge;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const auto& [strain, volume] = nodes[node];
        const auto own = static_cast<int>(node);
        edge.mass.push_back(volume);
        edge.squares.push_back({node, EnergyPart::strain, volume, strain});
        for (int k = std::max(-n, -own); k <= n && !lattice.stabilisation.empty(); ++k) {
            if (k == 0) {
                continue;
            }
            std::vector<double> left(
                std::max(strain.size(), node + static_cast<std::size_t>(n) + 1));
            for (std::size_t j = 0; j < strain.size(); ++j) {
                left[j] = -k * strain[j];
            }
            left[static_cast<std::size_t>(own + k)] += 1;
            left[node] -= 1;
            const double weight =
                volume * lattice.stabilisation[static_cast<std::size_t>(std::abs(k) - 1)];
            edge.squares.push_back({node, EnergyPart::stabilisation, weight, std::move(left)});
        }
    }
    return edge;
}

/// Whether all squares are those of bonds, weight (u_{I+k} - u_I)^2. The strain of nopd1d at n = 1,
/// of I-1 and I+1, is none.
inline bool has_bonds_alone(const Lattice& lattice) {
    return !lattice.energy.empty() &&
           std::ranges::all_of(lattice.energy, [](const Lattice::Square& square) {
               const double own = square.stencil[square.stencil.size() / 2];
               return square.part == EnergyPart::strain && own != 0 &&
                      std::ranges::count_if(square.stencil,
                                            [](double entry) { return entry != 0; }) == 2 &&
                      std::ranges::count(square.stencil, -own) == 1;
           });
}

/// The bonds of nodes next to an edge that stay inside of the body.
inline EdgeEnergy cut_bonds(const Lattice& lattice) {
    EdgeEnergy edge{.mass = std::vector<double>(lattice.reach(), 1.0)};
    for (const auto& [part, weight, stencil] : with_mirror_images(lattice).energy) {
        if (!(weight >= 0)) {
            throw std::invalid_argument(
                "this end is for bonds none of which weighs less than 0: its energy is a sum of "
                "squares");
        }
        const std::size_t middle = stencil.size() / 2;
        const auto there = std::ranges::find_if(stencil, [](double entry) { return entry != 0; });
        const auto first = static_cast<std::size_t>(there - stencil.begin());
        for (std::size_t node = 0; node < edge.mass.size(); ++node) {
            if (node + first < middle) {
                continue;  // it ends outside
            }
            std::vector<double> own(node + middle + 1);
            for (std::size_t i = first; i < stencil.size(); ++i) {
                own[node + i - middle] = stencil[i];
            }
            edge.squares.push_back({node, part, weight, std::move(own)});
        }
    }
    return edge;
}

/// What bonds that an edge cuts off would bear of an even strain of 1 between nodes I and I+1, by
/// I.
inline std::vector<double> lost_stresses(const Lattice& lattice) {
    std::vector<double> lost(lattice.reach());
    for (const auto& [part, weight, stencil] : lattice.energy) {
        const auto is_there = [](double entry) { return entry != 0; };
        const auto first = std::ranges::find_if(stencil, is_there);
        const auto last = std::find_if(stencil.rbegin(), stencil.rend(), is_there).base() - 1;
        const auto length = static_cast<std::size_t>(last - first);
        const double stress = weight * *first * *first * static_cast<double>(length);
        // Of `length` bonds across the gap, I + 1 have both ends in the body.
        for (std::size_t gap = 0; gap + 1 < length; ++gap) {
            lost[gap] += stress * static_cast<double>(length - gap - 1);
        }
    }
    return lost;
}

/// The strain of a node so far from the edge, of the neighbours that are there.
inline std::vector<double> cut_strain(const Correspondence& own, std::size_t node) {
    std::vector<double> strain(node + own.strain.size() + 1);
    double shape = 0;
    for (std::size_t other = 0; other < strain.size(); ++other) {
        if (other == node) {
            continue;
        }
        const double distance = static_cast<double>(other) - static_cast<double>(node);
        // The influence times the distance is the strain's own, up to a factor.
        const auto k = static_cast<std::size_t>(std::abs(distance));
        const double force = distance > 0 ? own.strain[k - 1] : -own.strain[k - 1];
        strain[other] += force;
        strain[node] -= force;
        shape += force * distance;
    }
    for (double& entry : strain) {
        entry /= shape;
    }
    return strain;
}

/// V and D of a node so far from the edge. missing: of the sums of the n first rows of Q.
inline EdgeNode sbp_node(const Correspondence& own, const std::vector<double>& missing,
                         std::size_t node) {
    const std::size_t n = own.strain.size();
    EdgeNode result{std::vector<double>(node + n + 1), 0};
    for (std::size_t other = 0; other <= node + n; ++other) {
        if (other == node) {
            result.strain[node] = node == 0 ? -0.5 : 0;
            continue;
        }
        const double distance = static_cast<double>(other) - static_cast<double>(node);
        const auto k = static_cast<std::size_t>(std::abs(distance));
        double entry = distance > 0 ? own.strain[k - 1] : -own.strain[k - 1];
        entry += other < n ? (missing[node] - missing[other]) / static_cast<double>(n) : 0;
        result.strain[other] = entry;
        result.volume += entry * distance;
    }
    if (!(result.volume > 0)) {
        throw std::invalid_argument(
            "summation by parts leaves a node near the edge no volume with this influence");
    }
    for (double& entry : result.strain) {
        entry /= result.volume;
    }
    return result;
}

}  // namespace detail

/// The plain cut: families end where the nodes do, and strains are of the neighbours that are left;
/// of bonds, those inside of the body stay. Too soft: a bar that is strained evenly does not rest.
/// The squares that it replaces are those of with_mirror_images(lattice), as of the other edges.
/// Throws std::invalid_argument for bonds of negative weight, and for squares that are neither
/// those of bonds, weight (u_{I+k} - u_I)^2, nor of correspondence.
inline EdgeEnergy cut_edge(const Lattice& lattice) {
    if (detail::has_bonds_alone(lattice)) {
        return detail::cut_bonds(lattice);
    }
    const detail::Correspondence own = detail::correspondence_of(lattice);
    std::vector<detail::EdgeNode> nodes;
    for (std::size_t node = 0; node < own.strain.size(); ++node) {
        nodes.push_back({detail::cut_strain(own, node)});
    }
    return detail::edge_of(own, nodes);
}

/// Summation by parts (docs/explanation/true-ends.md): V D = Q, Q + Q^T = diag(-1, 0, .., 0, 1), Q
/// 1 = 0, Q x = V 1, with the lattice's own strain further in, and of all such Q the one whose
/// entries between the n outermost nodes differ least from the lattice's, by the sum of squares.
/// `nmbcgen closure sbp` has it in exact numbers. Of bonds, those between nearest neighbours bear
/// what the ones that are cut off would, and the outermost node has half a mass. Throws
/// std::invalid_argument for bonds of negative weight, for squares that are neither those of bonds
/// nor of correspondence, and where a V is not positive.
inline EdgeEnergy sbp_edge(const Lattice& lattice) {
    if (detail::has_bonds_alone(lattice)) {
        EdgeEnergy edge = detail::cut_bonds(lattice);
        edge.mass.front() = 0.5;
        const std::vector<double> lost = detail::lost_stresses(lattice);
        for (std::size_t node = 0; node + 1 < lost.size(); ++node) {
            std::vector<double> bond(node + 2);
            bond[node] = -1;
            bond[node + 1] = 1;
            edge.squares.push_back({node, EnergyPart::strain, lost[node], std::move(bond)});
        }
        return edge;
    }
    const detail::Correspondence own = detail::correspondence_of(lattice);
    const std::size_t n = own.strain.size();
    std::vector<double> missing(n);  // of the sum of a row of Q that is cut off
    for (std::size_t i = 0; i < n; ++i) {
        missing[i] = i == 0 ? 0.5 : 0;
        for (std::size_t k = i + 1; k <= n; ++k) {
            missing[i] -= own.strain[k - 1];
        }
    }
    std::vector<detail::EdgeNode> nodes;
    for (std::size_t node = 0; node < n; ++node) {
        nodes.push_back(detail::sbp_node(own, missing, node));
    }
    return detail::edge_of(own, nodes);
}

}  // namespace nmbc
