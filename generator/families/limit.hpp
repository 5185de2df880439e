// SPDX-License-Identifier: GPL-2.0-or-later
/// What the continuum limit of a family is stated in.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace nmbcgen {

/// 50 digits. Dispersion relations of long waves are what is left of terms that cancel: a double
/// would keep none of its digits where delta xi is 1e-4.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

/// A dispersion relation at one wave number xi: omega^2 [(c/dX)^2] and its derivative by xi.
struct SquaredFrequency {
    Real value;
    Real slope;
};

}  // namespace nmbcgen
