// SPDX-License-Identifier: MIT
/// Numbers as the command line and the tables have them.
#pragma once

#include <optional>
#include <string_view>

namespace pulses {

/// The value of "p/q" or "p", p a decimal number, q a positive one; none where the text is anything
/// else or the value is not finite.
std::optional<double> fraction(std::string_view text);

}  // namespace pulses
