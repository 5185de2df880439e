// SPDX-License-Identifier: MIT
/// The true reflection of a matching boundary on all 2n ghost layers.
///
/// The layers M = 0 .. 2n-1 carry the same (c, b), so the boundary conditions on a sum of outgoing
/// modes form the matrix [Delta(k_m) k_m^-M], a Vandermonde matrix times a diagonal one, and can
/// be solved by Cramer's rule: an incident k_i makes the outgoing k_o with the amplitude
///     A_o = -Delta(k_i)/Delta(k_o) prod_{l != o} (1/k_i - 1/k_l)/(1/k_o - 1/k_l),
/// Delta(k) = sigma C(k) - B(k), sigma = i omega, or boundary_rate() in time steps.
#pragma once

#include <Eigen/Core>

#include "generator/stability/modes.hpp"

namespace nmbcgen {

/// Reflection at one frequency.
struct Reflection {
    std::vector<Mode>
        outgoing;  ///< all; the first `matrix.rows()` travel, or the lattice is damped
    /// R(omega) between travelling waves: rows outgoing, columns incident, entry
    /// A_o sqrt(|v_o| / |v_i|), so that |entry|^2 is a fraction of the incident energy flux.
    /// Column j is the mirror image, 1/k, of row j. In a damped lattice: between all waves, A_o.
    Eigen::MatrixXcd matrix;
    /// A_o for all outgoing modes (rows) and the same columns.
    Eigen::MatrixXcd amplitudes;
};

/// The reflection of the same modes in steps of any length: of an undamped lattice at one
/// frequency, whose modes do not depend on the step.
class ReflectionInSteps {
  public:
    /// outgoing: outgoing_modes() at that frequency.
    ReflectionInSteps(const HalfSpace& half_space, std::vector<Mode> outgoing);

    /// sigma: boundary_rate() of the step. The reference holds until the next call.
    const Reflection& at(std::complex<double> sigma);

  private:
    std::vector<CAndB> sent_;      ///< of the outgoing modes
    std::vector<CAndB> incident_;  ///< of their images that come in
    Eigen::MatrixXcd cauchy_;      ///< the amplitudes but for both Delta
    Eigen::MatrixXd flux_ratios_;  ///< of `Reflection::matrix` to its amplitudes
    Reflection reflection_;
};

/// The reflection at frequency omega > 0.
Reflection reflection(const HalfSpace& half_space, double omega);

/// Likewise, where outgoing_modes() at this frequency are known.
Reflection reflection(const HalfSpace& half_space, double omega, std::vector<Mode> outgoing);

/// The paper's scalar -Delta(xi)/Delta(-xi) at real wave number xi, omega > 0.
std::complex<double> scalar_reflection(const HalfSpace& half_space, double xi);

/// sup over diagonal phase matrices D, D' of rho(R_1 D R_2 D'), the largest amplification of a
/// round trip between two ends of one lattice, both at the same frequency; exact for any number of
/// travelling waves. Like ends: the square of sup over D of rho(R D).
///
/// A factor of row o and one of column i apart, each R is the Cauchy matrix
///     C_oi = 1/(eta_o + eta_i), eta = tan(arg(k)/2),
/// since 1/k_i - 1/k_l = 2 (y_l - y_i)/((1+y_i)(1+y_l)), y = (k-1)/(k+1) = i eta, and the incident
/// wave of column i is the mirror image of row i. So R_1 = g_1 C f_1 and R_2 = g_2 C f_2 with
/// diagonal g, f. Diagonal scalings S, T that make |S g_1| = |f_2 S^-1| = a and
/// |T g_2| = |f_1 T^-1| = b turn R_1 into phases times X = a C b and R_2 into phases times X^T:
/// rho <= sigma_max(X)^2 for every D, D', with equality where they undo the phases. The entries
/// of X are those of C in sign and sqrt(|R_1,oi R_2,io|) in size.
double round_trip_supremum(const Reflection& one, const Reflection& other);

/// Likewise of a damped chain of so many interior nodes, where every wave has faded by |k|^distance
/// when it arrives, distance = nodes + 1 between the innermost ghosts: a bound for any phases, and
/// so more than rho itself. It falls with the number of nodes, since rho is subharmonic in the
/// factors of a way, so that their largest moduli count. Less than 1 at every frequency: nothing
/// grows in a chain so long or longer.
///
/// The same proof, with complex y: X = a C b is complex symmetric but for real factors, and
/// X v = sigma u has X^T conj(u) = sigma conj(v), so phases exist that reach sigma_max(X)^2.
///
/// coarse: a bound as small as that will do, and be up to 2n times as much, Frobenius' norm.
double damped_round_trip_supremum(const Reflection& one, const Reflection& other, std::size_t nodes,
                                  double coarse = 0);

}  // namespace nmbcgen
