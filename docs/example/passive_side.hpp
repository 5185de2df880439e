// SPDX-License-Identifier: MIT
// Made by nmbcgen passive --family nopd2d --radius2 1 --nu 3/10 --state stress --G 1/4 --header
// clang-format off
#pragma once

#include <nmbc/plane_sides.hpp>

namespace nmbc::generated {

/// A passive side of the lattice that it was made for.
inline const PassiveSide passive_nopd2d_r1_nu3o10_g1o4{
    .strain = {1.149, 0.27700000000000002},
    .stabilisation = {0.47099999999999997, 1.3899999999999999},
    .mass = {std::vector<double>{1.966, 1.353},
             {1.5, 1.125}},
    .dashpots = {std::vector<double>
    {3.2915976147494366, -1.4823334630756493,
     -1.4823334630756493, 0.66755197716386461},
    {1.8092103298332631, -0.93638286391838677,
     -0.93638286391838677, 0.62221838554574549}},
    .null_lagrangian = 0.16200000000000001,
    .made_for = nopd2d(1, 0.29999999999999999, 0.78539816339744828, StressState::plane_stress)};

}  // namespace nmbc::generated
