// SPDX-License-Identifier: MIT
/// Sums of polynomials of one parameter times numbers that are known to within an interval.
#pragma once

#include <vector>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

/// factor_0 p_0 + factor_1 p_1 + .., of polynomials expanded about one and the same middle. The
/// polynomials have to outlive it.
class WeightedSum {
  public:
    struct Term {
        const Expansion& polynomial;
        Interval factor;
    };

    /// Throws std::invalid_argument where their offsets differ.
    explicit WeightedSum(const std::vector<Term>& terms);

    /// For every value of the parameter and of the factors.
    const EnclosedPolynomial& enclosed() const { return enclosed_; }

    /// At one point; narrower than the enclosed coefficients give it.
    ComplexInterval at(const ComplexInterval& z) const;

  private:
    /// What a factor differs by from its middle, and what it is a factor of.
    struct Deviation {
        const EnclosedPolynomial& polynomial;
        Interval by;
    };

    Expansion about_middle_{};
    std::vector<Deviation> deviations_{};
    EnclosedPolynomial enclosed_{};
};

}  // namespace nmbcgen
