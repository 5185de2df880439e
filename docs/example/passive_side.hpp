// SPDX-License-Identifier: MIT
// Made by nmbcgen passive --family nopd2d --radius2 1 --nu 3/10 --state stress --G 1/4 --header
// clang-format off
#pragma once

#include <nmbc/plane_sides.hpp>

namespace nmbc::generated {

/// A passive side of the lattice that it was made for.
inline const PassiveSide passive_nopd2d_r1_nu3o10_g1o4{
    .strain = {1.3220000000000001, 0.010999999999999999},
    .stabilisation = {0.47499999999999998, 1.9410000000000001},
    .mass = {std::vector<double>{3.794, 1.175},
             {1.637, 1.0740000000000001}},
    .dashpots = {std::vector<double>
    {5.2176920631910439, -2.9117107210546171,
     -2.9117107210546171, 1.6248677040398918},
    {1.967166703811601, -1.1166791339435871,
     -1.1166791339435871, 0.80875732376282061}},
    .null_lagrangian = 0.13900000000000001,
    .made_for = nopd2d(1, 0.29999999999999999, 0.78539816339744828, StressState::plane_stress)};

}  // namespace nmbc::generated
