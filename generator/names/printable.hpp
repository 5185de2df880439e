// SPDX-License-Identifier: MIT
/// Text of users, as messages quote it.
#pragma once

#include <string>
#include <string_view>

namespace nmbcgen {

/// UTF-8 with its control characters escaped, \x1b or \u009b, so that none of them commands the
/// terminal; and so is what is no UTF-8, \xff.
std::string printable(std::string_view text);

/// Likewise of a message in several lines, none of which a scene broke: line ends stay.
std::string printable_lines(std::string_view text);

/// UTF-8, cut after 60 bytes of whole letters where it is longer.
std::string beginning_of(const std::string& text);

}  // namespace nmbcgen
