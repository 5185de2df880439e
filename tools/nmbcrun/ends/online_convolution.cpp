// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/online_convolution.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace nmbcrun {
namespace {

constexpr std::size_t shortest = 32;  // below that, plain sums are faster

/// The first half of the transform of the values, 0 from there to `length`.
std::vector<std::complex<double>> transformed(Eigen::FFT<double>& fft,
                                              std::span<const double> values, std::size_t length) {
    std::vector<double> padded(length, 0.0);
    std::ranges::copy(values.first(std::min(values.size(), length)), padded.begin());
    std::vector<std::complex<double>> spectrum(length / 2 + 1);
    fft.fwd(spectrum.data(), padded.data(), Eigen::Index(length));
    return spectrum;
}

}  // namespace

OnlineConvolution::OnlineConvolution(std::vector<std::vector<double>> kernel)
    : kernel_(std::move(kernel)),
      fft_(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::HalfSpectrum),
      memory_(1 + (inputs() + reach()) * steps(), 0.0) {
    for (std::size_t length = shortest; length <= steps(); length *= 2) {
        std::vector<Spectrum>& spectra = spectra_.emplace_back();
        for (const std::vector<double>& values : kernel_) {
            spectra.push_back(transformed(fft_, values, 2 * length));
        }
    }
}

void OnlineConvolution::clear() {
    std::ranges::fill(memory_, 0.0);
}

void OnlineConvolution::remember(std::span<const double> memory) {
    std::ranges::copy(memory, memory_.begin());
}

void OnlineConvolution::add_block(std::size_t level, std::size_t length) {
    std::vector<Spectrum> blocks;
    blocks.reserve(inputs());
    for (std::size_t i = 0; i < inputs(); ++i) {
        blocks.push_back(transformed(fft_, input(i).subspan(level - length, length), 2 * length));
    }
    const std::vector<Spectrum>& kernels =
        spectra_[std::size_t(std::countr_zero(length) - std::countr_zero(shortest))];
    const std::size_t last = std::min(level + length - 1, steps());
    Spectrum product(length + 1);
    std::vector<double> sums(2 * length);
    for (std::size_t e = 0; e < reach(); ++e) {
        std::ranges::fill(product, 0.0);
        for (std::size_t i = 0; i < reach(); ++i) {
            for (std::size_t j = 0; j <= length; ++j) {
                product[j] += kernels[i][j] * blocks[e + i][j];
            }
        }
        fft_.inv(sums.data(), product.data(), Eigen::Index(2 * length));
        const auto result = from_blocks(e);
        for (std::size_t k = level; k <= last; ++k) {
            result[k - 1] += sums[k - level + length];
        }
    }
}

void OnlineConvolution::advance(std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < inputs(); ++i) {
        input(i)[levels()] = x[i];
    }
    memory_[0] += 1;
    const std::size_t level = levels();
    const std::size_t length = std::size_t(1) << std::size_t(std::countr_zero(level));
    if (length >= shortest) {
        add_block(level, length);
    }
    const std::size_t first = level / shortest * shortest;
    for (std::size_t e = 0; e < reach(); ++e) {
        double sum = from_blocks(e)[level - 1];
        for (std::size_t i = 0; i < reach(); ++i) {
            const auto values = input(e + i);
            for (std::size_t past = first; past < level; ++past) {
                sum += kernel_[i][level - past] * values[past];
            }
        }
        y[e] = sum;
    }
}

}  // namespace nmbcrun
