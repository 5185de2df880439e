// SPDX-License-Identifier: MIT
/// Where a long search lets the user stop it.
#pragma once

#include <functional>

namespace nmbcrun {

/// Called every few milliseconds or so; throws where the search is to end.
using Pause = std::function<void()>;

}  // namespace nmbcrun
