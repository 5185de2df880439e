// SPDX-License-Identifier: MIT
#include "generator/stability/discrete.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/boundary_modes.hpp"

namespace nmbcgen {
namespace {

/// Interior nodes that an end reads.
Eigen::Index reach_of(const LatticeEnd& end) {
    const HalfSpace& h = end.half_space;
    return end.kind == LatticeEnd::Kind::free ? Eigen::Index(h.reach())
                                              : (Eigen::Index(h.c.size()) - 1) * h.stride;
}

/// One end of a chain of `all` nodes: node number j counts from the outermost ghost inwards.
struct Numbering {
    bool left;
    Eigen::Index all;

    Eigen::Index operator()(Eigen::Index j) const { return left ? j : all - 1 - j; }
};

/// Ghost rows of `velocity` from the innermost layer outwards, where the interior's are known.
void add_ghosts(Eigen::MatrixXd& velocity, const LatticeEnd& end, const Numbering& node,
                double implicit_time) {
    const HalfSpace& h = end.half_space;
    const auto ghosts = Eigen::Index(h.reach());
    for (Eigen::Index layer = ghosts; layer-- > 0;) {
        if (end.kind == LatticeEnd::Kind::free) {
            velocity.row(node(layer)) = velocity.row(node(2 * ghosts - 1 - layer));
            continue;
        }
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(velocity.cols());
        for (std::size_t j = 0; j < h.c.size(); ++j) {
            const Eigen::Index other = node(layer + Eigen::Index(j) * h.stride);
            row(other) += h.b[j];
            if (j > 0) {
                row += (implicit_time * h.b[j] - h.c[j]) * velocity.row(other);
            }
        }
        velocity.row(node(layer)) = row / (h.c[0] - implicit_time * h.b[0]);
    }
}

/// Puts the ghosts' values that a fixed or free end has in the place of the state's own.
void take_ghosts_from_end(Eigen::MatrixXd& map, const LatticeEnd& end, const Numbering& node) {
    const auto ghosts = Eigen::Index(end.half_space.reach());
    for (const Eigen::Index field : {Eigen::Index(0), node.all}) {
        for (Eigen::Index layer = 0; layer < ghosts && end.kind != LatticeEnd::Kind::matching;
             ++layer) {
            if (end.kind == LatticeEnd::Kind::free) {
                map.col(field + node(2 * ghosts - 1 - layer)) += map.col(field + node(layer));
            }
            map.col(field + node(layer)).setZero();
        }
    }
}

/// The map of u and v/unit, where the unit is about omega_max: in a wave of the top of the band
/// both are about as large as each other. It is a similar map, whose double eigenvalues roundings
/// split less where G is large. The unit is a power of 2, which rounds nothing.
Eigen::MatrixXd in_like_units(Eigen::MatrixXd map, const HalfSpace& lattice) {
    const Eigen::Index all = map.rows() / 2;
    double bound = lattice.symbol[0];  // of omega^2
    for (std::size_t m = 1; m < lattice.symbol.size(); ++m) {
        bound += 2 * std::abs(lattice.symbol[m]);
    }
    const double unit = std::exp2(std::round(std::log2(bound) / 2));
    map.topRightCorner(all, all) *= unit;
    map.bottomLeftCorner(all, all) /= unit;
    return map;
}

/// Adds factor (symbol_0 + sum_m symbol_m (k^m + k^-m)) to a row, about the given column.
void add_stencil(Eigen::MatrixXd::RowXpr row, Eigen::Index centre, double factor,
                 const std::vector<double>& symbol) {
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        row(centre + Eigen::Index(m)) += factor * symbol[m];
        if (m > 0) {
            row(centre - Eigen::Index(m)) += factor * symbol[m];
        }
    }
}

/// The map on u on all nodes and v on the interior ones: undamped steps read no other v, so that
/// what is left out has the eigenvalue 0.
Eigen::MatrixXd without_ghost_velocities(const Eigen::MatrixXd& map, Eigen::Index all,
                                         Eigen::Index interior) {
    std::vector<Eigen::Index> kept(std::size_t(all + interior));
    std::iota(kept.begin(), kept.begin() + all, Eigen::Index(0));
    std::iota(kept.begin() + all, kept.end(), all + (all - interior) / 2);
    return map(kept, kept);
}

/// StepRange::from, below a stable cfl. Only boundary modes change their character in short steps:
/// the whole grade is asked for once, at about 0.01, and about the edge. dt = unit * cfl.
double first_without_growth(StepGrades& grades, double unit, double stable, Grade least) {
    constexpr double smallest = 1e-5;
    constexpr double ratio = 1.5;
    constexpr int in_full = 4;
    for (int i = 1; stable > smallest; ++i) {
        double unstable = stable / ratio;
        const bool holds =
            i == in_full ? grades.in(unit * unstable) >= least : !grades.grows_in(unit * unstable);
        if (holds) {
            stable = unstable;
            continue;
        }
        constexpr double resolved = 1.01;
        while (stable > resolved * unstable) {
            const double middle = std::sqrt(stable * unstable);
            (grades.in(unit * middle) >= least ? stable : unstable) = middle;
        }
        return std::ceil(1000 * stable) / 1000;
    }
    return 0;
}

}  // namespace

Eigen::MatrixXd one_step_map(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                             double time_step) {
    const HalfSpace& lattice = left.half_space;
    const auto ghosts = Eigen::Index(lattice.reach());
    const auto interior = Eigen::Index(nodes);
    const Eigen::Index all = interior + 2 * ghosts;
    if (const auto least = std::max(reach_of(left), reach_of(right)); interior < least) {
        throw std::invalid_argument("the conditions of a chain of " + std::to_string(nodes) +
                                    " nodes reach " + std::to_string(least));
    }

    // Rows of `velocity`: v at k+1/2 on all nodes as a linear function of the state.
    Eigen::MatrixXd velocity = Eigen::MatrixXd::Zero(all, 2 * all);
    for (Eigen::Index i = ghosts; i < ghosts + interior; ++i) {
        velocity(i, all + i) = 1;
        add_stencil(velocity.row(i), i, -time_step, lattice.symbol);
        add_stencil(velocity.row(i), all + i, -time_step, lattice.damping);
    }
    add_ghosts(velocity, left, {true, all}, time_step / 2);
    add_ghosts(velocity, right, {false, all}, time_step / 2);
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(2 * all, 2 * all);
    map.topLeftCorner(all, all).setIdentity();
    map.topRows(all) += time_step * velocity;
    map.bottomRows(all) = velocity;
    take_ghosts_from_end(map, left, {true, all});
    take_ghosts_from_end(map, right, {false, all});
    return map;
}

Eigen::VectorXcd eigenvalues_by_parity(const Eigen::MatrixXd& matrix, Eigen::Index all) {
    const auto mirror = [&](Eigen::Index i) {
        return i < all ? all - 1 - i : matrix.rows() + all - 1 - i;
    };
    Eigen::VectorXcd found(matrix.rows());
    Eigen::Index known = 0;
    for (const double sign : {1.0, -1.0}) {
        std::vector<Eigen::Index> kept;
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            if (i < mirror(i) || (i == mirror(i) && sign > 0)) {
                kept.push_back(i);
            }
        }
        Eigen::MatrixXd half = matrix(kept, kept);
        for (std::size_t j = 0; j < kept.size(); ++j) {
            if (mirror(kept[j]) != kept[j]) {
                half.col(Eigen::Index(j)) += sign * matrix(kept, mirror(kept[j]));
            }
        }
        found.segment(known, half.rows()) = eigenvalues(half);
        known += half.rows();
    }
    return found;
}

double spectral_radius(const LatticeEnd& both, std::size_t nodes, double time_step) {
    const auto all = Eigen::Index(nodes + 2 * both.half_space.reach());
    Eigen::MatrixXd map =
        in_like_units(one_step_map(both, both, nodes, time_step), both.half_space);
    if (!both.half_space.is_damped()) {
        map = without_ghost_velocities(map, all, Eigen::Index(nodes));
    }
    return eigenvalues_by_parity(map, all).cwiseAbs().maxCoeff();
}

double spectral_radius(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                       double time_step) {
    const Eigen::MatrixXd map = one_step_map(left, right, nodes, time_step);
    return eigenvalues(in_like_units(map, left.half_space)).cwiseAbs().maxCoeff();
}

double maximum_frequency(const HalfSpace& half_space) {
    return critical_frequencies(half_space).back();
}

double cfl_of(const HalfSpace& half_space, double time_step) {
    return time_step * maximum_frequency(half_space) / 2;
}

StepRange stable_range(const HalfSpace& half_space, Grade least) {
    StepGrades grades(half_space);
    return stable_range(grades, least);
}

StepRange stable_range(StepGrades& grades, Grade least) {
    const double top = grades.maximum_frequency();
    const auto stable_at = [&](int hundredths) {
        return grades.in(off_the_edge * 2 * hundredths / (100 * top)) >= least;
    };
    constexpr int coarse = 5;
    int largest = 0;
    while (largest + coarse < 100 && stable_at(largest + coarse)) {
        largest += coarse;
    }
    while (largest + 1 < 100 && stable_at(largest + 1)) {
        ++largest;
    }
    const double shortest_known = std::min(coarse, largest) / 100.0;
    return {first_without_growth(grades, 2 / top, shortest_known, least), largest / 100.0};
}

}  // namespace nmbcgen
