// SPDX-License-Identifier: MIT
/// Exact numbers as the tables of nmbcgen have them in JSON (docs/reference/json.md).
#pragma once

#include <nmbc/table.hpp>
#include <string>

#include "generator/table/exact.hpp"
#include "tools/nmbcrun/scene/json_value.hpp"

namespace nmbcrun {

// Each throws SceneError where the value is written in another way.

struct Fraction {
    std::string numerator;
    std::string denominator;

    nmbcgen::Rational value() const;
};

/// "p/q" or "p".
Fraction fraction_of(const JsonValue& json);

/// {"num": [..], "den": [..]}; each list as one text, a space between two integers.
Fraction rational_function_of(const JsonValue& json);

/// A number in lowest terms; parameters are not below 0.
nmbcgen::Rational number_of(const JsonValue& json);
nmbcgen::Rational parameter_of(const JsonValue& json);

}  // namespace nmbcrun
