// SPDX-License-Identifier: GPL-2.0-or-later
/// High precision, where a wave number's cosine is no rational number.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_complex.hpp>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// 120 decimal digits; what is computed with them is rounded to 40.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>,
                                           boost::multiprecision::et_off>;
using Complex = boost::multiprecision::number<
    boost::multiprecision::complex_adaptor<boost::multiprecision::cpp_bin_float<120>>,
    boost::multiprecision::et_off>;

/// What counts as zero: far above the roundings, far below what means anything.
inline const Real negligible("1e-60");

/// xi [1/dX]
Real wave_number(const MatchingPoint& point);

}  // namespace nmbcgen
