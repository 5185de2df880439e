// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/real.hpp"

namespace nmbcgen {

Real wave_number(const MatchingPoint& point) {
    const Real unit = point.of_pi ? pi() : Real(1);
    return Real(point.wave_number) * unit;
}

}  // namespace nmbcgen
