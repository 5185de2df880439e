// SPDX-License-Identifier: MIT
/// The same work on many things at once.
#pragma once

#include <cstddef>
#include <functional>

namespace nmbcgen {

/// Cores that on_all_cores() shares work among.
std::size_t cores();

/// work(0), work(1), .. work(count - 1), begun in this order, on all cores; on one, where it is
/// called by such work itself, which has them all. Throws what one threw, and then begins no more.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace nmbcgen
