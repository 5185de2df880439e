// SPDX-License-Identifier: GPL-2.0-or-later
/// The atlas as text.
#pragma once

#include <string>
#include <vector>

#include "tools/stability_atlas/atlas.hpp"

namespace stability_atlas {

/// A row for each condition and G, below the names of the columns.
/// from, to: what a picture colours as it is at this G.
std::string points_csv(const std::vector<Method>& methods);

/// A row for each window; a window without an end has no `high`.
std::string windows_csv(const std::vector<Method>& methods);

}  // namespace stability_atlas
