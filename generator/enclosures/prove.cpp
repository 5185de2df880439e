// SPDX-License-Identifier: MIT
#include "generator/enclosures/prove.hpp"

#include <cmath>

#include "generator/enclosures/band_grade.hpp"
#include "generator/enclosures/modes_decay.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

Prover::Prover(const Table& table)
    : per_G_(exact_condition(table, Polynomial(std::vector<Rational>{0, 1}))),
      plain_(exact_condition(table, constant(1))) {}

bool Prover::holds(const nmbc::Window& window, double cfl, Grade least) const {
    const EnclosedCondition enclosed =
        enclose(window.low > 0 ? per_G_ : plain_, window.low, window.high);
    const double top = highest_square(enclosed.band).lower();
    if (!(top > 0 && std::isfinite(top))) {
        return false;
    }
    const Interval tau = hull(Interval(0), square(Interval(cfl)) / top);
    return no_mode_grows(enclosed, tau) && waves_have_grade(enclosed, tau, least);
}

std::vector<nmbc::Window> Prover::parts(const nmbc::Window& window, double cfl, Grade least,
                                        double finest,
                                        const std::function<void(double)>& told) const {
    std::vector<nmbc::Window> found;
    const std::function<void(const nmbc::Window&)> collect = [&](const nmbc::Window& piece) {
        told(piece.low);
        const double middle = piece.low + (piece.high - piece.low) / 2;
        if (holds(piece, cfl, least)) {
            if (!found.empty() && found.back().high == piece.low) {
                found.back().high = piece.high;
            } else {
                found.push_back(piece);
            }
        } else if (piece.high - piece.low > 2 * finest && piece.low < middle &&
                   middle < piece.high) {
            collect({piece.low, middle});
            collect({middle, piece.high});
        }
    };
    collect(window);
    return found;
}

double Prover::largest_cfl(const nmbc::Window& window, Grade least) const {
    if (!holds(window, 0, least)) {
        return -1;
    }
    int proved = 0;
    int open = 100;
    while (open - proved > 1) {
        const int middle = (proved + open) / 2;
        (holds(window, middle / 100.0, least) ? proved : open) = middle;
    }
    return proved / 100.0;
}

}  // namespace nmbcgen
