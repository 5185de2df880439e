// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/wave_grid.hpp"

#include <algorithm>
#include <numbers>

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

bool is_good_length(std::size_t length) {
    if (length % 2 != 0) {
        return false;
    }
    for (const std::size_t factor : {2U, 3U, 5U}) {
        while (length % factor == 0) {
            length /= factor;
        }
    }
    return length == 1;
}

std::size_t good_length(std::size_t least) {
    while (!is_good_length(least)) {
        ++least;
    }
    return least;
}

}  // namespace

WaveGrid::WaveGrid(std::size_t nodes)
    : period_(good_length(std::max<std::size_t>(nodes, 2))),
      fft_(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::Unscaled) {
    half_turns_.reserve(period_);
    for (std::size_t node = 0; node < period_; ++node) {
        half_turns_.push_back(std::polar(1.0, std::numbers::pi * double(node) / double(period_)));
    }
}

double WaveGrid::wave_number(std::size_t band) const {
    return std::numbers::pi * (double(band) + 0.5) / double(bands());
}

std::vector<Complex> WaveGrid::amplitudes(std::span<const double> field) {
    std::vector<Complex> turned(period_);
    for (std::size_t node = 0; node < field.size(); ++node) {
        turned[node] = field[node] * std::conj(half_turns_[node]);
    }
    std::vector<Complex> spectrum(period_);
    fft_.fwd(spectrum.data(), turned.data(), Eigen::Index(period_));
    // The upper half of the spectrum is the lower one's complex conjugate.
    spectrum.resize(bands());
    for (Complex& each : spectrum) {
        each /= double(bands());
    }
    return spectrum;
}

std::vector<double> WaveGrid::field(std::span<const Complex> amplitudes) {
    std::vector<Complex> spectrum(period_);
    std::ranges::copy(amplitudes, spectrum.begin());
    std::vector<Complex> turned(period_);
    fft_.inv(turned.data(), spectrum.data(), Eigen::Index(period_));
    std::vector<double> field;
    field.reserve(period_);
    for (std::size_t node = 0; node < period_; ++node) {
        field.push_back((turned[node] * half_turns_[node]).real());
    }
    return field;
}

}  // namespace nmbcrun
