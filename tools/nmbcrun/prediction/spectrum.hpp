// SPDX-License-Identifier: MIT
/// How the energy of a field is spread over wave numbers.
#pragma once

#include <nmbc/chain.hpp>
#include <vector>

namespace nmbcrun {

/// The wave number [1/dX] in the middle of one of so many equal parts of 0 .. pi.
double middle_of(std::size_t part, std::size_t parts);

/// Energy of a field in equal parts of 0 .. pi, as shares of 1; all 0 where there is no energy.
class Spectrum {
  public:
    /// Of the whole chain, layers included: |v|^2 + omega^2 |u|^2 of their Fourier sums, in the
    /// middle of each part.
    Spectrum(const nmbc::Chain& chain, std::size_t parts);

    /// Of these energies of equal parts.
    explicit Spectrum(std::vector<double> energies);

    std::size_t parts() const { return shares_.size(); }
    double share(std::size_t part) const { return shares_[part]; }
    double wave_number(std::size_t part) const;  ///< of its middle [1/dX]
    double energy() const { return energy_; }    ///< of all parts, in the units of its source

    /// The wave number below which this share of the energy is, to one part.
    double quantile(double share) const;

  private:
    std::vector<double> shares_;
    double energy_ = 0;
};

}  // namespace nmbcrun
