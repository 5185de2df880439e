// SPDX-License-Identifier: MIT
/// Where a real polynomial has a value, for many values.
#pragma once

#include <complex>
#include <vector>

namespace nmbcgen {

/// The roots x of p(x) = y. Between neighbouring extrema of p, which are found once, p is monotone:
/// there real roots are bracketed, so that their number is right wherever p - y is told from 0 at
/// each extremum. They are divided out of p - y; the others are those of what is left.
///
/// Near an extremum e roots are found in powers of x - e. So two that are about to meet there are
/// those of one value next to y, which they are not if each has roundings of its own. Where p' has
/// a root beyond 10, as p has whose leading coefficients are nearly 0, that would cost digits:
/// there roots are those of a companion matrix, and real where nearly so.
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
