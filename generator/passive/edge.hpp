// SPDX-License-Identifier: MIT
/// The edge of a half space that is cut off there: families truncated, and on the outermost layers
/// weights, masses and dashpots of their own, so that waves leave. Whatever these are, the energy
///     E = sum_I (V_I W_I + Vs_I Ws_I) + v.Mv/2,   dE/dt = -v.Cv
/// does not grow while the weights V, Vs and the masses M are positive and C is a sum of squares:
/// such a boundary is passive, by construction.
///
/// Layers are counted from the edge. The outermost I = 0 .. q-1 have numbers of their own; all
/// others have V = Vs = M = 1 and no dashpots.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "generator/plane/plane_modes.hpp"
#include "generator/plane/strip.hpp"

namespace nmbcgen {

/// The numbers of a passive edge.
struct PassiveEdge {
    Eigen::VectorXd strain;         ///< V, of q layers
    Eigen::VectorXd stabilisation;  ///< Vs
    Eigen::MatrixXd mass;           ///< q rows, one column a component
    /// C, component by component, of q layers.
    std::vector<Eigen::MatrixXd> dashpots;
    double null_lagrangian = 0;  ///< beta: it changes tractions, and no force of the interior
};

/// How far an edge reaches, in layers.
struct EdgeReach {
    Eigen::Index node = 1;    ///< n, of the energy of a node
    Eigen::Index forces = 2;  ///< r, of the forces: from n to 2n
    Eigen::Index layers = 2;  ///< q, with numbers of their own, at least r - n

    /// Layers from here on have the forces of the interior.
    Eigen::Index interior() const { return layers + node; }
    /// Layers from here on can have a sum of the interior's waves.
    Eigen::Index waves() const { return interior() - forces; }
};

/// Quadratic forms (1/2) u.K u of the displacements of the outermost layers at one wave number
/// along the edge, components of layer 0 first: of the nodes of each of the q outermost layers, and
/// of those further inwards together. Forces are whole on layers below interior().
struct EdgeEnergies {
    struct Node {
        Eigen::MatrixXd strain;           ///< at beta = 0
        Eigen::MatrixXd null_lagrangian;  ///< what beta = 1 adds
        Eigen::MatrixXd stabilisation;    ///< at this G
    };
    std::vector<Node> outermost;
    Node further;
    Eigen::Index components = 0;
    EdgeReach reach;

    /// K of the edge as a whole.
    Eigen::MatrixXd stiffness(const PassiveEdge& edge) const;
};

/// The squares of the energy of a node so many layers from an edge at x = 0, at a value of beta.
using NodeEnergy = std::function<std::vector<VectorSquare>(unsigned layer, const Rational& beta)>;

/// The squares of an edge's nodes at one g, rounded to doubles.
class EdgeSquares {
  public:
    /// The squares of a node are linear in beta, and asked for at 0 and at some_beta; where that is
    /// 0 there is no null Lagrangian. Layers from `node`, the reach of a node's energy, on have
    /// whole families.
    EdgeSquares(const NodeEnergy& node_energy, Eigen::Index node, const Rational& g,
                const Rational& some_beta);

    EdgeEnergies energies(std::size_t dimensions, const EdgeReach& reach, double wave_number) const;

  private:
    struct Square {
        struct Term {
            Eigen::Index layer;  ///< from that of the node inwards
            int along;           ///< the edge, from the node
            std::array<double, 2> factors;
        };
        double weight;
        std::vector<Term> terms;
    };
    struct OfLayer {
        std::vector<Square> strain;
        std::vector<Square> null_lagrangian;  ///< weights may be negative
        std::vector<Square> stabilisation;
    };

    static Square in_doubles(const VectorSquare& square, double weight);
    static void add(Eigen::MatrixXd& stiffness, const std::vector<Square>& squares,
                    Eigen::Index layer, Eigen::Index components, double wave_number);

    std::vector<OfLayer> by_layer_;
};

/// A free side of a plane at one wave number along it: the lattice is cut off, and that is all.
/// Strips with one have 2 forces layers or more.
CutSide free_side(const EdgeSquares& squares, Eigen::Index node, Eigen::Index forces,
                  double wave_number);

/// Amplitudes of all outgoing modes (rows) that the mirror images of those that travel (columns)
/// make, all of them 1 on layer reach.waves(). In leapfrog steps with midpoint dashpots a
/// wave has the frequency theta/dt with omega = (2/dt) sin(theta/2), and the dashpots act times
/// cos(theta/2); in continuous time, time_step = 0, by themselves.
Eigen::MatrixXcd edge_amplitudes(const EdgeEnergies& energies, const PassiveEdge& edge,
                                 const std::vector<PlaneMode>& outgoing, double omega,
                                 double time_step = 0);

/// R between travelling waves, as in side_reflection().
Eigen::MatrixXcd edge_reflection(const EdgeEnergies& energies, const PassiveEdge& edge,
                                 const std::vector<PlaneMode>& outgoing, double omega,
                                 double time_step = 0);

/// What an edge makes of one arriving wave, and how that follows the edge: where its dynamic
/// stiffness D = K - omega^2 M + i damping C changes by dD, `amplitudes` change by -adjoint dD
/// field.
struct EdgeResponse {
    Eigen::VectorXcd amplitudes;  ///< of the waves that travel away, in the flux metric
    Eigen::MatrixXcd adjoint;     ///< rows: these waves; columns: the equations of motion
    Eigen::VectorXcd field;       ///< displacements of all layers
    double damping = 0;           ///< omega, or what of it acts in steps
};
EdgeResponse edge_response(const EdgeEnergies& energies, const PassiveEdge& edge,
                           const ArrivingWave& wave, double time_step);

/// Row by row.
std::vector<double> entries_of(const Eigen::MatrixXd& matrix);

}  // namespace nmbcgen
