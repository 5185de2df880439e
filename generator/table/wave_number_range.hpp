// SPDX-License-Identifier: MIT
/// A range of wave numbers, as commands are asked for.
#pragma once

namespace nmbcgen {

/// Both included [1/dX].
struct WaveNumberRange {
    double low;
    double high;
};

}  // namespace nmbcgen
