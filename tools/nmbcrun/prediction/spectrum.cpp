// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/prediction/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <nmbc/lattice.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

namespace nmbcrun {

double middle_of(std::size_t part, std::size_t parts) {
    return std::numbers::pi * (double(part) + 0.5) / double(parts);
}

namespace {

/// sum_j field_j exp(-i xi j), j counted from 0.
std::complex<double> fourier_sum(std::span<const double> field, double xi) {
    const std::complex<double> factor = std::polar(1.0, -xi);
    std::complex<double> sum = 0;
    for (std::size_t j = field.size(); j-- > 0;) {  // Horner
        sum = sum * factor + field[j];
    }
    return sum;
}

std::vector<double> energies_of(const nmbc::Chain& chain, std::size_t parts) {
    const nmbc::ChainParameters& p = chain.parameters();
    const double rate = p.wave_speed() / p.spacing;
    std::vector<double> energies;
    energies.reserve(parts);
    for (std::size_t part = 0; part < parts; ++part) {
        const double xi = middle_of(part, parts);
        const double squared =
            rate * rate * std::max(nmbc::omega_squared(chain.lattice(), xi), 0.0);
        energies.push_back(std::norm(fourier_sum(chain.velocity(), xi)) +
                           squared * std::norm(fourier_sum(chain.displacement(), xi)));
    }
    return energies;
}

}  // namespace

Spectrum::Spectrum(const nmbc::Chain& chain, std::size_t parts)
    : Spectrum(energies_of(chain, parts)) {}

Spectrum::Spectrum(std::vector<double> energies)
    : shares_(std::move(energies)), energy_(std::accumulate(shares_.begin(), shares_.end(), 0.0)) {
    for (double& share : shares_) {
        share = energy_ > 0 ? share / energy_ : 0;
    }
}

double Spectrum::wave_number(std::size_t part) const {
    return middle_of(part, parts());
}

double Spectrum::quantile(double share) const {
    double sum = 0;
    std::size_t part = 0;
    while (part + 1 < parts() && sum + shares_[part] < share) {
        sum += shares_[part++];
    }
    return wave_number(part);
}

}  // namespace nmbcrun
