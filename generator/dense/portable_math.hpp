// SPDX-License-Identifier: MIT
/// Functions that have the same values on every machine. Of those of double, glibc takes one of
/// several variants by the processor, and their last bits differ: enough for a search to end
/// elsewhere. Those of long double have one variant; in doubles its last bits are rounded away.
#pragma once

#include <cmath>
#include <complex>
#include <cstdlib>

namespace nmbcgen::portable {

inline double sin(double x) {
    return static_cast<double>(std::sin(static_cast<long double>(x)));
}

inline double cos(double x) {
    return static_cast<double>(std::cos(static_cast<long double>(x)));
}

inline double exp(double x) {
    return static_cast<double>(std::exp(static_cast<long double>(x)));
}

inline double log(double x) {
    return static_cast<double>(std::log(static_cast<long double>(x)));
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
