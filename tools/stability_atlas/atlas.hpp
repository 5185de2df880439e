// SPDX-License-Identifier: GPL-2.0-or-later
/// Where each boundary condition of the 1D NOPD is stable: as predicted for every length, and as
/// measured on finite chains, over a range of G. Units dX = c = 1.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "generator/stability/modal.hpp"
#include "generator/stability/modal_windows.hpp"
#include "generator/table/table.hpp"

namespace stability_atlas {

/// One boundary condition at one G.
struct Point {
    double G = 0;
    nmbcgen::Failure failure = nmbcgen::Failure::none;  ///< none: stable at every length
    nmbcgen::Grade grade = nmbcgen::Grade::none;
    std::optional<double> supremum;  ///< of rho(R D); none where failure is not an amplified wave
    double growing_mode_rate = 0;    ///< Re s [c/dX] of the fastest growing boundary mode, or 0
    bool in_scalar_window = false;
    bool in_modal_window = false;
    std::optional<double> measured_growth;  ///< see growth(); none at a pole or a Jordan block
};

struct Method {
    nmbcgen::Specification specification;
    std::vector<nmbcgen::ExactWindow> scalar;  ///< the paper's criterion
    nmbcgen::ModalWindows windows;
    std::vector<Point> points;
};

/// The rate [c/dX] at which a chain between two such ends grows: ln|z|/dt of the largest
/// eigenvalue z of its one-step map (midpoint ghosts, cfl 0.05), the larger one of two lengths of
/// different parity. 0 below 1e-7: within the modal windows roundings make up to 2e-12 and, next to
/// an edge, the length of the step up to 1e-8.
double growth(const nmbcgen::HalfSpace& half_space);

/// All conditions of these horizons with orders 1 to 4 and strides 1 and n, at `points` values of
/// G from 0 to 6, on all cores; `done(k)` is called when k points are, by one thread at a time.
std::vector<Method> atlas(const std::vector<unsigned>& horizons, unsigned points,
                          const std::function<void(std::size_t)>& done);

/// The number of points that atlas() will draw.
std::size_t total_points(const std::vector<unsigned>& horizons, unsigned points);

}  // namespace stability_atlas
