// SPDX-License-Identifier: MIT
#pragma once

namespace nmbcrun {

/// The part of a source's energy in waves that the lattice does not carry, above which a run warns.
constexpr double most_not_carried = 0.1;

}  // namespace nmbcrun
