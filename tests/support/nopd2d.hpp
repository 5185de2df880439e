// SPDX-License-Identifier: MIT
/// nopd2d with Poisson's ratio 1/4, in plane stress, as in Nicely 2018.
#pragma once

#include <numbers>

#include "generator/families/vector_family.hpp"
#include "generator/plane/plane_lattice.hpp"

namespace nmbcgen::test {

inline VectorChoice of_paper(unsigned radius_squared) {
    return {.radius_squared = radius_squared, .poisson = Rational(1, 4)};
}

/// g of the paper's G, to the nearest double.
inline Rational g_of(double G) {
    return Rational(G / std::numbers::pi);
}

inline PlaneLattice lattice_of_paper(unsigned radius_squared, double G) {
    return plane_lattice(nopd2d(of_paper(radius_squared)), g_of(G), 0);
}

constexpr double paper_time_unit = 10;  // sqrt(E = 100)

/// Damping of the paper's units, where it acts as stabilisation does at G = 1.
inline PlaneLattice damped_lattice(unsigned radius_squared, double G, double tau) {
    return plane_lattice(nopd2d(of_paper(radius_squared)), g_of(G),
                         Rational(paper_time_unit * tau / std::numbers::pi));
}

inline double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

}  // namespace nmbcgen::test
