// SPDX-License-Identifier: MIT
/// What a plane lattice has at its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/coefficients.hpp>
#include <nmbc/node_line.hpp>
#include <nmbc/plane_closure.hpp>
#include <nmbc/plane_model.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

/// More of the same lattice beyond the side, held at u = 0.
struct FixedSide {};

/// No nodes beyond the side: families are cut off there.
struct FreeSide {};

/// The two sides of an axis are neighbours: the body repeats itself.
struct PeriodicSide {};

/// The mirror image, midway between the outermost node and the innermost ghost: the plane is one
/// half of a larger one. Of an even image no displacement is across the mirror and no force along
/// it; of an odd one, turned round in itself, none along it and no force across.
struct MirrorSide {
    bool is_odd = false;
};

/// The body ends there, on its outermost nodes, closed with such gradients: of planes of
/// correspondence of this radius and influence. Other sides may be closed by the same only. Where
/// it meets a free or passive one, nodes have the volumes of both, and gradients of the neighbours
/// that are there. Units E = density = dX = 1.
struct ClosedSide {
    std::shared_ptr<const PlaneClosure> closure{};
};

/// The lattice is cut off, and its outermost layers have weights, masses and dashpots of their own,
/// so that waves leave. Layer 0 is the outermost. Whatever the numbers are, no step raises the
/// energy while weights and masses are positive, C is a sum of squares, and 0 <= beta <= 2 mu.
/// `nmbcgen passive` designs such sides; units E = density = dX = 1.
struct PassiveSide {
    std::vector<double> strain;         ///< V of q layers, factor of the energy of strain
    std::vector<double> stabilisation;  ///< Vs, likewise
    /// M of the displacements normal to the side and along it.
    std::array<std::vector<double>, 2> mass{};
    /// C of these two between the layers of a line of nodes: q times q, row by row.
    std::array<std::vector<double>, 2> dashpots{};
    double null_lagrangian = 0;  ///< beta: of the whole body, and of all its passive sides
    /// The lattice that it was designed for: others are refused. None: numbers of one's own.
    std::optional<PlaneModel> made_for{};
};

/// (60) on the ghost layers of every line of nodes across the side, component by component. It may
/// feed energy in: no certificate covers it.
struct MatchingSide {
    /// Of the displacements normal to the side and along it; b in units of the speed over dX.
    std::array<BoundaryCoefficients, 2> coefficients{};
    std::array<double, 2> speeds{};  ///< where E = density = 1
};

/// Likewise Higdon's product of one-way wave equations (HigdonCondition) with these speeds, where E
/// = density = 1, on both components.
struct HigdonSide {
    std::vector<double> speeds{};
    double decay = 0;  ///< [sqrt(E/density)/dX]
};

/// Layers beyond the side with friction, a = .. - gamma v, held at u = 0 behind.
struct SpongeSide {
    std::vector<double> friction{};  ///< gamma [sqrt(E/density)/dX] of each, from the outermost
};

/// More of the same lattice beyond the side, which the program keeps elsewhere: another block of a
/// larger body. Before start(), after it and after each step the program copies ghosts() layers of
/// displacements from there, along the whole side with its layers and ghosts; of velocities, too,
/// where bonds break, where the lattice is damped, or energies() are asked for. All blocks take the
/// steps of the whole, and a block without passive sides has the null Lagrangian of its model,
/// which is to be that of the whole's passive sides.
struct HaloSide {};

using PlaneSide = std::variant<FixedSide, FreeSide, PeriodicSide, MirrorSide, ClosedSide,
                               PassiveSide, MatchingSide, HigdonSide, SpongeSide, HaloSide>;

/// The sides of a rectangle.
struct PlaneSides {
    PlaneSide left = FixedSide{};    ///< x least
    PlaneSide right = FixedSide{};   ///< x largest
    PlaneSide bottom = FixedSide{};  ///< y least
    PlaneSide top = FixedSide{};     ///< y largest

    /// All four alike.
    static PlaneSides all(const PlaneSide& side) { return {side, side, side, side}; }

    const PlaneSide& at(Side side) const {
        return side.axis == 0 ? (side.end == End::left ? left : right)
                              : (side.end == End::left ? bottom : top);
    }
};

/// Left, right, bottom, top: the order in which sides are listed.
inline constexpr std::array<Side, 4> plane_sides{Side{0, End::left}, Side{0, End::right},
                                                 Side{1, End::left}, Side{1, End::right}};

namespace detail {

/// Whether its ghosts move by a condition of their own.
inline bool has_condition(const PlaneSide& side) {
    return std::holds_alternative<MatchingSide>(side) || std::holds_alternative<HigdonSide>(side);
}

/// Whether its ghosts are images of nodes of the body.
inline bool has_images(const PlaneSide& side) {
    return std::holds_alternative<PeriodicSide>(side) || std::holds_alternative<MirrorSide>(side);
}

inline bool is_cut(const PlaneSide& side) {
    return std::holds_alternative<FreeSide>(side) || std::holds_alternative<PassiveSide>(side) ||
           std::holds_alternative<ClosedSide>(side);
}

/// Layers with numbers of their own.
inline std::size_t own_layers(const PlaneSide& side) {
    const auto* const passive = std::get_if<PassiveSide>(&side);
    const auto* const closed = std::get_if<ClosedSide>(&side);
    return passive != nullptr                                ? passive->strain.size()
           : closed != nullptr && closed->closure != nullptr ? closed->closure->layers
                                                             : 0;
}

/// Throws std::invalid_argument where a matrix is not symmetric, or has an eigenvalue below 0 by
/// more than roundings: eliminating its rows then finds a pivot below 0.
inline void require_semidefinite(std::vector<double> matrix, std::size_t size) {
    double largest = 0;
    for (std::size_t i = 0; i < size; ++i) {
        largest = std::max(largest, std::abs(matrix[i * (size + 1)]));
    }
    const double roundings = 1e-9 * largest;
    for (std::size_t pivot = 0; pivot < size; ++pivot) {
        const double diagonal = matrix[pivot * (size + 1)];
        for (std::size_t row = pivot + 1; row < size; ++row) {
            const double below = matrix[row * size + pivot];
            const bool is_symmetric = std::abs(below - matrix[pivot * size + row]) <= roundings;
            // Beside a pivot of 0 there can be nothing else.
            const double left_over = diagonal > roundings ? 0 : std::abs(below);
            if (!is_symmetric || diagonal < -roundings ||
                left_over > std::sqrt(largest * roundings)) {
                throw std::invalid_argument(
                    "the dashpots of a passive side must be a symmetric matrix without eigenvalues "
                    "below 0");
            }
            if (diagonal > roundings) {
                for (std::size_t column = pivot + 1; column < size; ++column) {
                    matrix[row * size + column] -= below / diagonal * matrix[pivot * size + column];
                }
            }
        }
        if (diagonal < -roundings) {
            throw std::invalid_argument("the dashpots of a passive side must not be below 0");
        }
    }
}

/// Throws std::invalid_argument where the numbers of a passive side do not fit each other or are
/// not positive.
inline void require_valid(const PassiveSide& side) {
    const std::size_t layers = side.strain.size();
    const auto all_positive = [&](const std::vector<double>& numbers) {
        return numbers.size() == layers && std::ranges::all_of(numbers, [](double one) {
                   return one > 0 && std::isfinite(one);
               });
    };
    if (layers == 0 || !all_positive(side.strain) || !all_positive(side.stabilisation) ||
        !std::ranges::all_of(side.mass, all_positive)) {
        throw std::invalid_argument(
            "a passive side needs weights and masses of as many layers, all positive");
    }
    for (const std::vector<double>& dashpots : side.dashpots) {
        if (dashpots.size() != layers * layers ||
            !std::ranges::all_of(dashpots, [](double one) { return std::isfinite(one); })) {
            throw std::invalid_argument("a passive side of q layers needs q * q finite dashpots");
        }
        require_semidefinite(dashpots, layers);
    }
}

/// Whether two laws are equal up to the roundings of numbers that were printed.
struct IsAlike {
    static bool is_near(double one, double other) {
        constexpr double roundings = 1e-9;
        return std::abs(one - other) <= roundings * std::max(std::abs(one), std::abs(other));
    }
    bool operator()(const CorrespondenceModel& one, const CorrespondenceModel& other) const {
        return one.radius_squared == other.radius_squared && is_near(one.bulk, other.bulk) &&
               is_near(one.shear, other.shear) && is_near(one.stabilisation, other.stabilisation) &&
               std::ranges::equal(one.influence, other.influence, is_near);
    }
    bool operator()(const BondModel& one, const BondModel& other) const {
        return std::ranges::equal(one.bonds(), other.bonds(),
                                  [](const BondModel::Bond& bond, const BondModel::Bond& alike) {
                                      return bond.offset == alike.offset &&
                                             is_near(bond.weight, alike.weight);
                                  });
    }
    bool operator()(const CorrespondenceModel& /*one*/, const BondModel& /*other*/) const {
        return false;
    }
    bool operator()(const BondModel& /*one*/, const CorrespondenceModel& /*other*/) const {
        return false;
    }
};

/// Throws std::invalid_argument where a passive side was designed for another lattice.
inline void require_made_for(const PlaneSides& sides, const PlaneModel& model) {
    for (const Side place : plane_sides) {
        const auto* const passive = std::get_if<PassiveSide>(&sides.at(place));
        if (passive != nullptr && passive->made_for &&
            !std::visit(IsAlike{}, passive->made_for->law(), model.law())) {
            throw std::invalid_argument(
                "this passive side was designed for another lattice: radius, Poisson's ratio, "
                "plane stress or strain, G (nmbcgen's g is G/pi), influence or weights are not "
                "those of the plane");
        }
    }
}

inline void require_valid(const HigdonSide& side) {
    if (side.speeds.empty() ||
        !std::ranges::all_of(side.speeds,
                             [](double one) { return one > 0 && std::isfinite(one); }) ||
        !(side.decay >= 0 && std::isfinite(side.decay))) {
        throw std::invalid_argument(
            "a Higdon side needs speeds, all positive, and a decay not below 0");
    }
}

inline void require_valid(const SpongeSide& side) {
    if (side.friction.empty() || !std::ranges::all_of(side.friction, [](double one) {
            return one >= 0 && std::isfinite(one);
        })) {
        throw std::invalid_argument("a sponge needs layers, whose friction is not below 0");
    }
}

inline void require_valid(const ClosedSide& side) {
    const PlaneClosure* const closure = side.closure.get();
    if (closure == nullptr || closure->layers == 0 ||
        closure->nodes.size() != (closure->layers + 1) * (closure->layers + 1)) {
        throw std::invalid_argument("a closed side needs a closure with all its nodes");
    }
    const auto is_neighbour = [square = static_cast<int>(closure->radius_squared)](int x, int y) {
        const int distance = x * x + y * y;
        return distance > 0 && distance <= square;
    };
    for (const PlaneClosure::Node& node : closure->nodes) {
        if (!(node.volume > 0 && std::isfinite(node.volume)) ||
            !std::ranges::all_of(node.gradient, [&](const PlaneClosure::Entry& entry) {
                return is_neighbour(entry.x, entry.y) && std::isfinite(entry.along_x) &&
                       std::isfinite(entry.along_y);
            })) {
            throw std::invalid_argument(
                "a closure needs volumes above 0, and finite gradients of neighbours");
        }
    }
}

/// The closure of the sides of a body of this model, nullptr: of bonds; nullptr where none is
/// closed. Throws std::invalid_argument where they do not go together.
inline std::shared_ptr<const PlaneClosure> closure_of(const PlaneSides& sides,
                                                      const CorrespondenceModel* model) {
    std::shared_ptr<const PlaneClosure> closure;
    for (const Side place : plane_sides) {
        const auto* const closed = std::get_if<ClosedSide>(&sides.at(place));
        if (closed != nullptr && closure != nullptr && closed->closure != closure) {
            throw std::invalid_argument("the closed sides of a body must share one closure");
        }
        closure = closed != nullptr ? closed->closure : closure;
    }
    if (closure != nullptr &&
        (model == nullptr || closure->radius_squared != model->radius_squared ||
         !std::ranges::equal(closure->influence, model->influence, IsAlike::is_near))) {
        throw std::invalid_argument(
            "a closed side is of planes of correspondence, of one family radius and one influence");
    }
    return closure;
}

inline void require_valid(const auto& /*side*/) {}  // a matching side is checked by its conditions

/// Throws std::invalid_argument for sides that cannot be those of one body. Returns its beta: that
/// of its passive sides; without such, in a block of a larger body, that of the model.
inline double checked_null_lagrangian(const PlaneSides& sides, double of_model, double largest) {
    double beta = 0;
    bool is_first = true;
    bool has_free = false;
    bool has_halo = false;
    for (const Side place : plane_sides) {
        const PlaneSide& side = sides.at(place);
        has_free = has_free || std::holds_alternative<FreeSide>(side) ||
                   std::holds_alternative<ClosedSide>(side);
        has_halo = has_halo || std::holds_alternative<HaloSide>(side);
        std::visit([](const auto& one) { require_valid(one); }, side);
        if (const auto* const passive = std::get_if<PassiveSide>(&side)) {
            if (!(passive->null_lagrangian >= 0 && passive->null_lagrangian <= largest)) {
                throw std::invalid_argument(
                    largest > 0 ? "the null Lagrangian of a passive side must be from 0 to twice "
                                  "the shear modulus"
                                : "the passive sides of a bond-based plane have no null "
                                  "Lagrangian");
            }
            if (!is_first && passive->null_lagrangian != beta) {
                throw std::invalid_argument(
                    "the passive sides of a body must have the same null Lagrangian");
            }
            beta = passive->null_lagrangian;
            is_first = false;
        }
        const PlaneSide& opposite =
            sides.at({place.axis, place.end == End::left ? End::right : End::left});
        if (std::holds_alternative<PeriodicSide>(side) !=
            std::holds_alternative<PeriodicSide>(opposite)) {
            throw std::invalid_argument("a periodic side must be opposite a periodic one");
        }
    }
    if (is_first && has_halo && of_model >= 0 && of_model <= largest) {
        beta = of_model;
    }
    if (has_free && beta != 0) {
        throw std::invalid_argument(
            "beside a free side passive ones must have no null Lagrangian, which would act on it");
    }
    return beta;
}

}  // namespace detail

}  // namespace nmbc
