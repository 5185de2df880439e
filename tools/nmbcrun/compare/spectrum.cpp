// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <nmbc/lattice.hpp>
#include <numbers>

namespace nmbcrun {

std::complex<double> fourier_sum(std::span<const double> field, double xi) {
    const std::complex<double> factor = std::polar(1.0, -xi);
    std::complex<double> sum = 0;
    for (std::size_t j = field.size(); j-- > 0;) {  // Horner
        sum = sum * factor + field[j];
    }
    return sum;
}

Spectrum::Spectrum(const nmbc::Chain& chain, std::size_t parts) : shares_(parts) {
    const nmbc::ChainParameters& p = chain.parameters();
    const double rate = p.wave_speed() / p.spacing;
    double sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        const double xi = wave_number(part);
        const double squared =
            rate * rate * std::max(nmbc::omega_squared(chain.lattice(), xi), 0.0);
        shares_[part] = std::norm(fourier_sum(chain.velocity(), xi)) +
                        squared * std::norm(fourier_sum(chain.displacement(), xi));
        sum += shares_[part];
    }
    for (double& share : shares_) {
        share = sum > 0 ? share / sum : 0;
    }
}

double Spectrum::wave_number(std::size_t part) const {
    return std::numbers::pi * (double(part) + 0.5) / double(parts());
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
