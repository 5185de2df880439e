// SPDX-License-Identifier: MIT
/// Functions that have the same values on every x86-64 machine. Of those of double, glibc takes one
/// of several variants by the processor, whose last bits differ: enough for a search to end
/// elsewhere. sin and cos of long double have one variant. Its exp and log are the processor's own:
/// here they are sums and products.
#pragma once

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace nmbcgen::portable {

inline double sin(double x) {
    return static_cast<double>(std::sin(static_cast<long double>(x)));
}

inline double cos(double x) {
    return static_cast<double>(std::cos(static_cast<long double>(x)));
}

inline long double precise_exp(long double x) {
    constexpr long double ln_2 = std::numbers::ln2_v<long double>;
    const auto halvings = static_cast<int>(std::lround(static_cast<double>(x / ln_2)));
    const long double rest = x - static_cast<long double>(halvings) * ln_2;  // up to 0.35
    long double sum = 1;
    for (int k = 22; k > 0; --k) {  // 0.35^23/23! is below 1e-32
        sum = 1 + rest * sum / static_cast<long double>(k);
    }
    return std::ldexp(sum, halvings);
}

/// Of |x| < 1000.
inline double exp(double x) {
    return static_cast<double>(precise_exp(x));
}

/// Halley's step leaves the cube of an error.
inline double log(double x) {
    const long double near = std::log(x);
    const long double power = precise_exp(near);
    return static_cast<double>(near + 2 * (x - power) / (x + power));
}

/// exp(i phase)
inline std::complex<double> unit(double phase) {
    return {cos(phase), sin(phase)};
}

/// z^n, by |n| products.
inline std::complex<double> power(const std::complex<double>& z, int n) {
    std::complex<double> product = 1;
    for (int i = 0; i < std::abs(n); ++i) {
        product *= z;
    }
    return n < 0 ? 1.0 / product : product;
}

}  // namespace nmbcgen::portable
