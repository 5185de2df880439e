// SPDX-License-Identifier: MIT
/// The design of passive edges that reflect little. What they do in a step is the runtime's:
/// nmbc/passive.hpp, and in a plane nmbc/plane_dashpots.hpp.
#pragma once

#include <functional>
#include <vector>

#include "generator/passive/edge.hpp"

namespace nmbcgen {

/// What there is to design. Node energies are linear in beta, 0 <= beta <= largest_beta.
struct EdgeTask {
    EdgeSquares squares;
    std::size_t dimensions = 2;
    EdgeReach reach;
    bool has_stabilisation = true;  ///< g > 0
    Rational largest_beta;  ///< up to it the energy is a sum of squares; 0: no null Lagrangian
    /// Scales are |L^T 1|^2, so that nothing comes back of long waves head-on; or 1, where wider
    /// angles count.
    bool is_exact_head_on = false;
    /// Of what parameters are from the lattice's, in the sum of squares.
    double near_the_lattice = 0.03;
    /// Of the part beyond log 3 of what logarithms of weights and masses are from the lattice's. A
    /// heavy edge is a resonator: it lets out more of the waves of the search and keeps longer
    /// ones.
    double light = 0;
    /// Of what the highest eigenvalue is above most_stiff().
    double long_steps = 0.3;
    std::size_t stiff_steps = 2;     ///< of wave numbers from 0 to pi where it is looked at
    Eigen::Index evaluations = 400;  ///< the most there may be
    long denominator = 1000;         ///< of the numbers of the design
    double highest_eigenvalue = 0;   ///< the largest omega^2 of the interior
    double time_step = 0;            ///< of the steps it is made for; 0: continuous time

    /// What the highest eigenvalue of the edge is kept near or below, times the interior's: by
    /// 1/1.3 the square of steps is shorter, unless those that it is made for are longer.
    double most_stiff() const;

    EdgeEnergies at(double wave_number) const {
        return squares.energies(dimensions, reach, wave_number);
    }
};

/// The numbers of an edge. With weights, masses and scales positive and 0 <= beta <= largest_beta
/// energy is a sum of squares, and C = c L L^T/scale is one, too: the edge is passive.
template <class Number>
struct EdgeNumbers {
    std::vector<Number> strain;             ///< V, from the edge inwards
    std::vector<Number> stabilisation;      ///< Vs
    std::vector<std::vector<Number>> mass;  ///< of each component
    /// L of each component, the rows of a lower triangle; its c is the speed of the component's
    /// own long waves along x.
    std::vector<std::vector<std::vector<Number>>> factor;
    std::vector<Number> scale;  ///< of each component; |L^T 1|^2 lets long waves out head-on
    Number null_lagrangian{};   ///< beta
};

/// Exact, as short decimals.
using PassiveDesign = EdgeNumbers<Rational>;

/// speeds are c of each component.
PassiveEdge edge_of(const PassiveDesign& design, const std::vector<double>& speeds);

/// Throws std::logic_error where one of the conditions above does not hold.
void require_passive(const PassiveDesign& design, const Rational& largest_beta);

/// Called with the evaluations done and the most there may be.
using DesignProgress = std::function<void(std::size_t done, std::size_t all)>;

/// A wave that is to leave, and the weight of its reflected amplitudes.
struct WeightedWave {
    ArrivingWave wave;
    double weight = 1;
};

/// Least squares of the waves' reflected amplitudes, from the lattice as it is; of what the numbers
/// are from the lattice's, too, which keeps the edge near it, and of what its highest eigenvalue is
/// above most_stiff(), which keeps steps long. Stops at a minimum or when its evaluations are
/// spent. Throws std::domain_error where it leaves the numbers that there are.
PassiveDesign design_edge(const EdgeTask& task, const std::vector<WeightedWave>& waves,
                          const std::vector<double>& speeds, const DesignProgress& progress = {});

/// Of the eigenvalue that steps allow: two sides next to each other are stiffer than one.
inline constexpr double stable_margin = 0.99;

/// A designed side, or an end of a chain, and what it is worth.
struct DesignedSide {
    EdgeTask task;
    PassiveDesign design;
    PassiveEdge edge;
    /// Of M^-1 K, in the interior or beside the edge, whichever is larger, of the wave numbers that
    /// were looked at.
    double highest_eigenvalue = 0;

    /// Higher than that of others between them, too.
    double eigenvalue_bound() const { return highest_eigenvalue / stable_margin; }
};

/// With the highest eigenvalue of so many wave numbers along the side. Throws as design_edge(), and
/// std::domain_error where its own steps are too long for the lattice or the design.
DesignedSide designed_side(EdgeTask task, const std::vector<WeightedWave>& waves,
                           const std::vector<double>& speeds, std::size_t wave_numbers,
                           const DesignProgress& progress = {});

/// The part of a wave's energy that comes back, in any polarisation.
double reflected_by_edge(const EdgeTask& task, const PassiveEdge& edge, const ArrivingWave& wave);

/// The largest eigenvalue of M^-1 K beside the edge, over so many wave numbers along it. Leapfrog
/// steps with midpoint dashpots are stable while dt^2 times the largest one of the whole body is
/// below 4.
double highest_eigenvalue_of_edge(EdgeTask task, const PassiveEdge& edge, std::size_t wave_numbers);

}  // namespace nmbcgen
