// SPDX-License-Identifier: MIT
/// Convolutions in time of the nodes at an end, while a run goes on.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace nmbcrun {

/// y_e^k = sum_{i=1}^r sum_{m=1}^k kernel[i-1][m] x_{e+i-1}^{k-m} for e = 0 .. r-1: r sums of 2r-1
/// inputs, each level's inputs given when all sums up to it are known.
///
/// By blocks, after Hairer, Lubich, Schlichte 1985: the levels k-L .. k-1, L the largest power of 2
/// that divides k, act on those of k .. k+L-1 by Fourier transforms of length 2L as soon as they
/// are known; less than 32 levels act one by one. So each level acts on each later one once, and a
/// step costs O(r^2 log steps + r log^2 steps) on average, one at a multiple of a large L more.
class OnlineConvolution {
  public:
    /// kernel: r lists of steps + 1 entries, entry 0 is not used.
    explicit OnlineConvolution(std::vector<std::vector<double>> kernel);

    std::size_t reach() const { return kernel_.size(); }
    std::size_t inputs() const { return 2 * reach() - 1; }
    std::size_t steps() const { return kernel_.front().size() - 1; }

    /// Levels given so far.
    std::size_t levels() const { return std::size_t(memory_[0]); }

    /// Gives the inputs of level levels(), and finds the sums of the next one. levels() < steps();
    /// x: 2r-1 entries, y: r.
    void advance(std::span<const double> x, std::span<double> y);

    /// Forgets every level.
    void clear();

    /// What is known so far, always as many numbers, and the same put back.
    std::span<const double> memory() const { return memory_; }
    void remember(std::span<const double> memory);

  private:
    using Spectrum = std::vector<std::complex<double>>;

    std::span<double> input(std::size_t i) {
        return std::span(memory_).subspan(1 + i * steps(), steps());
    }
    /// Of the levels 1 .. steps: what whole blocks have added to a sum.
    std::span<double> from_blocks(std::size_t e) {
        return std::span(memory_).subspan(1 + (inputs() + e) * steps(), steps());
    }
    void add_block(std::size_t level, std::size_t length);

    std::vector<std::vector<double>> kernel_;
    std::vector<std::vector<Spectrum>> spectra_;  // by log2 of the block over `shortest`, then i
    Eigen::FFT<double> fft_;                      // holds the tables of every length
    std::vector<double> memory_;  // the number of levels, the inputs, the sums of blocks
};

}  // namespace nmbcrun
