// SPDX-License-Identifier: MIT
/// Where a real polynomial has a value, for many values.
#pragma once

#include <complex>
#include <vector>

namespace nmbcgen {

/// The roots x of p(x) = y. Between neighbouring extrema of p, which are found once, p is monotone:
/// there real roots are bracketed, and none is missed. They are divided out of p - y, and the
/// others are the roots of what is left: within roundings of an extremum these may be one more real
/// pair.
///
/// Near an extremum e real roots are found in powers of x - e. So two that are about to meet there
/// are those of one value next to y, which they are not if each has roundings of its own.
///
/// A root of p' beyond 10 comes of leading coefficients near 0. Powers of x - e would lose digits
/// there, so roots are those of a companion matrix, and real where nearly so.
class LevelRoots {
  public:
    /// p: coefficients by ascending powers.
    explicit LevelRoots(std::vector<double> p);

    /// All complex roots, real ones without an imaginary part.
    std::vector<std::complex<double>> at(double y) const;

  private:
    /// Where p is cut, and its coefficients in powers of x from there on.
    struct Cut {
        double x;
        std::vector<double> around;
    };
    std::vector<double> real_roots(double y) const;

    std::vector<double> p_;  ///< the last coefficient is not 0
    std::vector<Cut> cuts_;  ///< ascending: the extrema, or 0 where there are none
    bool is_monotone_ = false;
    bool is_wide_ = false;
};

}  // namespace nmbcgen
