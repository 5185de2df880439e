// SPDX-License-Identifier: MIT
/// The factor of a symmetric Laurent polynomial with its roots within the unit circle.
#pragma once

#include <complex>
#include <vector>

namespace nmbcrun {

using LongComplex = std::complex<long double>;

/// Finds f_0 .. f_r of sum_{|m|<=r} a_|m| lambda^m = f(lambda) f(1/lambda),
/// f(1/lambda) = sum_i f_i lambda^-i, all roots of which are within the unit circle, for one list a
/// after another. Where it changes little, Newton's iteration from the last two answers is enough;
/// otherwise it starts from the roots. Either way the residual is down to rounding, and every root
/// is known to be within the circle: two that coalesce there do no harm.
class SpectralFactor {
  public:
    /// a: a_0 .. a_r, not all 0, without a root on the unit circle. Throws std::invalid_argument
    /// where there is one, to rounding.
    const std::vector<LongComplex>& find(const std::vector<LongComplex>& a);

  private:
    std::vector<LongComplex> factor_;
    std::vector<LongComplex> before_;
};

}  // namespace nmbcrun
