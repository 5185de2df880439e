// SPDX-License-Identifier: MIT
/// What the search for a passive edge makes small, as a function of free parameters.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "generator/dense/least_squares.hpp"
#include "generator/passive/design.hpp"

namespace nmbcgen {

/// |L^T 1|^2: the sum of all entries of L L^T.
template <class Number>
Number sum_of_square(const std::vector<std::vector<Number>>& factor) {
    Number total = 0;
    for (std::size_t column = 0; column < factor.size(); ++column) {
        Number sum = 0;
        for (std::size_t row = column; row < factor.size(); ++row) {
            sum += factor[row][column];
        }
        total += sum * sum;
    }
    return total;
}

template <class Number>
void set_scales(EdgeNumbers<Number>& numbers, bool is_exact_head_on) {
    numbers.scale.clear();
    for (const auto& factor : numbers.factor) {
        numbers.scale.push_back(is_exact_head_on ? sum_of_square(factor) : Number(1));
    }
}

PassiveEdge edge_in_doubles(const EdgeNumbers<double>& numbers, const std::vector<double>& speeds);

/// The highest eigenvalue of M^-1 K of the layers whose forces are whole, the others held, and how
/// it follows the edge.
struct EdgeEigenvalue {
    double value = 0;
    Eigen::VectorXd mode;  ///< with mode.M mode = 1
};
EdgeEigenvalue highest_eigenvalue_beside(const EdgeEnergies& energies, const PassiveEdge& edge);

/// Parameters: logarithms of V, of Vs where there is stabilisation, of the masses component by
/// component; the rows of the triangles L; where there is a null Lagrangian, what beta is the sine
/// of. Residuals: reflected amplitudes with their weights, what eigenvalues are too high, and what
/// the parameters are from the lattice's, and of logarithms what that is beyond log 3.
class EdgeResiduals {
  public:
    EdgeResiduals(const EdgeTask& task, const std::vector<WeightedWave>& waves,
                  const std::vector<double>& speeds);

    /// The lattice as it is, half a cell on its outermost layer, dashpots there alone; next to none
    /// on the others, since at none the derivatives vanish.
    Eigen::VectorXd start() const;

    EdgeNumbers<double> numbers(const Eigen::VectorXd& parameters) const;

    /// Values and derivatives by the parameters.
    Linearised at(const Eigen::VectorXd& parameters) const;

  private:
    /// So many parameters, the first ones, are logarithms.
    Eigen::Index logarithms() const;

    struct Edge {
        EdgeNumbers<double> numbers;
        PassiveEdge edge;
        double beta_slope = 0;  ///< of beta by its parameter
    };

    /// left.(dD/dp) right for each parameter p, D the dynamic stiffness K - omega^2 M + i damping
    /// C.
    template <class Vector>
    Vector slopes(const Edge& at, const EdgeEnergies& energies, const Vector& left,
                  const Vector& right, double omega_squared, typename Vector::Scalar damping) const;

    const EdgeTask& task_;
    const std::vector<WeightedWave>& waves_;
    const std::vector<double>& speeds_;
    Eigen::Index layers_;
    Eigen::VectorXd lattice_;               // start()
    std::vector<EdgeEnergies> energies_{};  // at the wave numbers of the waves
    std::vector<EdgeEnergies> stiff_{};     // at those whose eigenvalues are kept low
    Eigen::Index entries_ = 0;
};

}  // namespace nmbcgen
