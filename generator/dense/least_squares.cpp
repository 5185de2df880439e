// SPDX-License-Identifier: MIT
#include "generator/dense/least_squares.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <unsupported/Eigen/NumericalDiff>

namespace nmbcgen {
namespace {

using Eigen::VectorXd;
using Residuals = std::function<VectorXd(const VectorXd&)>;

class Functor : public Eigen::DenseFunctor<double> {
  public:
    Functor(const Residuals& residuals, const VectorXd& start)
        : DenseFunctor(int(start.size()), int(residuals(start).size())), residuals_(residuals) {}

    int operator()(const VectorXd& parameters, VectorXd& values) const {
        values = residuals_(parameters);
        return 0;
    }

  private:
    const Residuals& residuals_;
};

}  // namespace

VectorXd least_squares(const Residuals& residuals, const VectorXd& start) {
    Functor functor(residuals, start);
    // Central differences: of one-sided ones the gradient vanishes a digit away from the minimum.
    Eigen::NumericalDiff<Functor, Eigen::Central> with_differences(functor);
    Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Functor, Eigen::Central>> search(
        with_differences);
    constexpr double nine_digits = 1e-9;
    search.setXtol(nine_digits);
    search.setFtol(nine_digits);
    constexpr Eigen::Index enough = 8000;
    search.setMaxfev(enough);
    VectorXd parameters = start;
    search.minimize(parameters);
    if (!parameters.allFinite() || !std::isfinite(search.fnorm())) {
        throw std::domain_error("the search for a least sum of squares left the finite numbers");
    }
    return parameters;
}

}  // namespace nmbcgen
