// SPDX-License-Identifier: MIT
#include "generator/dense/least_squares.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace nmbcgen {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Residuals = std::function<Linearised(const VectorXd&)>;

class Functor : public Eigen::DenseFunctor<double> {
  public:
    Functor(const Residuals& residuals, const VectorXd& start)
        : DenseFunctor(int(start.size()), int(residuals(start).values.size())),
          residuals_(residuals) {}

    int operator()(const VectorXd& parameters, VectorXd& values) {
        values = at(parameters).values;
        return 0;
    }
    int df(const VectorXd& parameters, MatrixXd& slopes) {
        slopes = at(parameters).slopes;
        return 0;
    }

  private:
    /// The search asks for the slopes where it has asked for the values.
    const Linearised& at(const VectorXd& parameters) {
        if (parameters.size() != last_.size() || parameters != last_) {
            found_ = residuals_(parameters);
            last_ = parameters;
        }
        return found_;
    }

    const Residuals& residuals_;
    VectorXd last_{};
    Linearised found_{};
};

}  // namespace

VectorXd least_norm_solution(const MatrixXd& matrix, const VectorXd& right_side, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(threshold);
    decomposition.compute(matrix);
    return decomposition.solve(right_side);
}

VectorXd least_squares(const VectorXd& start, const Residuals& residuals,
                       Eigen::Index evaluations) {
    Functor functor(residuals, start);
    Eigen::LevenbergMarquardt<Functor> search(functor);
    constexpr double nine_digits = 1e-9;
    search.setXtol(nine_digits);
    search.setFtol(nine_digits);
    search.setMaxfev(evaluations);
    VectorXd parameters = start;
    search.minimize(parameters);
    if (!parameters.allFinite() || !std::isfinite(search.fnorm())) {
        throw std::domain_error("the search for a least sum of squares left the finite numbers");
    }
    return parameters;
}

}  // namespace nmbcgen
