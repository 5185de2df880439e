// SPDX-License-Identifier: MIT
// Made by nmbcgen passive --family nopd2d --radius2 1 --nu 3/10 --state stress --G 1/4 --header
// clang-format off
#pragma once

#include <nmbc/plane_sides.hpp>

namespace nmbc::generated {

/// A passive side of the lattice that it was made for.
inline const PassiveSide passive_nopd2d_r1_nu3o10_g1o4{
    .strain = {1.161, 0.28000000000000003},
    .stabilisation = {0.58999999999999997, 1.383},
    .mass = {std::vector<double>{1.819, 1.3979999999999999},
             {1.5529999999999999, 1.149}},
    .dashpots = {std::vector<double>
    {3.1337856705748086, -1.3629883309845321,
     -1.3629883309845321, 0.59281031659042849},
    {1.8625607700484468, -0.95976155086743387,
     -0.95976155086743387, 0.622384592090095}},
    .null_lagrangian = 0.16200000000000001,
    .made_for = nopd2d(1, 0.29999999999999999, 0.78539816339744828, StressState::plane_stress)};

}  // namespace nmbc::generated
