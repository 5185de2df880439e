// SPDX-License-Identifier: MIT
/// A table's lists of coefficients in one shape, for formats that write them all alike.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

struct CoefficientList {
    std::string_view name;  ///< symbol, damping, taylor, c or b
    std::size_t first;      ///< index of the first one: a_1 of taylor, else 0
    std::vector<ExactFunction> functions;
    unsigned digits = 0;  ///< they are rounded to; 0: exact
};

CoefficientList c_list(const Table& table);
CoefficientList b_list(const Table& table);

/// symbol, damping (which may be empty), taylor, c and b.
std::vector<CoefficientList> coefficient_lists(const Table& table);

/// The coefficients as decimal integers, by ascending powers; "0" for the zero polynomial.
std::vector<std::string> texts_of(const IntegerPolynomial& polynomial);

}  // namespace nmbcgen
