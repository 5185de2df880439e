// SPDX-License-Identifier: MIT
/// Values of TOML as text.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace nmbcrun {

/// The whole value, but for what is nested deeper than `levels`, more than any value of a scene
/// has. toml++ 3.3 formats lists and tables itself, but not with an infinity in them (a conversion
/// that is undefined).
std::string text_of(const toml::node& node, int levels = 16);

}  // namespace nmbcrun
