// SPDX-License-Identifier: MIT
/// Fields of nodes as sums of waves, by Fourier transforms.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace nmbcrun {

/// The wave numbers xi_b = pi (b + 1/2)/M, b = 0 .. M-1, in the middle of equal parts of 0 .. pi:
/// none is 0, where a wave does not swing. A sum of them repeats, up to its sign, after 2M nodes.
class WaveGrid {
  public:
    /// 2M: the next even product of 2, 3 and 5 from this number of nodes on.
    explicit WaveGrid(std::size_t nodes);

    std::size_t bands() const { return period_ / 2; }
    double wave_number(std::size_t band) const;

    /// The a_b of field_j = Re sum_b a_b exp(i xi_b j), j = 0, 1, ..; at most 2M entries.
    std::vector<std::complex<double>> amplitudes(std::span<const double> field);

    /// Re sum_b a_b exp(i xi_b j), j = 0 .. 2M-1. amplitudes: M of them.
    std::vector<double> field(std::span<const std::complex<double>> amplitudes);

  private:
    std::size_t period_;
    std::vector<std::complex<double>> half_turns_;  // exp(i pi j/(2M))
    Eigen::FFT<double> fft_;
};

}  // namespace nmbcrun
