// SPDX-License-Identifier: MIT
/// How the energy of a field is spread over wave numbers.
#pragma once

#include <complex>
#include <nmbc/chain.hpp>
#include <span>
#include <vector>

namespace nmbcrun {

/// sum_j field_j exp(-i xi j), j counted from 0.
std::complex<double> fourier_sum(std::span<const double> field, double xi);

/// Energy of a field in equal parts of 0 .. pi, as shares of 1; all 0 where there is no energy.
class Spectrum {
  public:
    /// Of the whole chain, layers included: |v|^2 + omega^2 |u|^2 of their Fourier sums, in the
    /// middle of each part.
    Spectrum(const nmbc::Chain& chain, std::size_t parts);

    std::size_t parts() const { return shares_.size(); }
    double share(std::size_t part) const { return shares_[part]; }
    double wave_number(std::size_t part) const;  ///< of its middle [1/dX]

    /// The wave number below which this share of the energy is, to one part.
    double quantile(double share) const;

  private:
    std::vector<double> shares_;
};

}  // namespace nmbcrun
