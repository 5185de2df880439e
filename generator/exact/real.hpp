// SPDX-License-Identifier: MIT
/// High precision, for what is not rational: waves at a given wave number.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_complex.hpp>

namespace nmbcgen {

/// 120 decimal digits: what cancels, in dispersion relations of long waves and in systems of close
/// matching points, leaves enough of them.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>,
                                           boost::multiprecision::et_off>;
using PreciseComplex = boost::multiprecision::number<
    boost::multiprecision::complex_adaptor<boost::multiprecision::cpp_bin_float<120>>,
    boost::multiprecision::et_off>;

inline Real pi() {
    return boost::math::constants::pi<Real>();
}

}  // namespace nmbcgen
