// SPDX-License-Identifier: MIT
#include "generator/enclosures/prove.hpp"

#include <cmath>
#include <stdexcept>

#include "generator/enclosures/band_grade.hpp"
#include "generator/enclosures/modes_decay.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

// A box takes 0.02 ms at n = 1, 0.3 ms at n = 6. Most proofs take a tenth of these numbers.
constexpr int boxes_of_every_step = 65536;
constexpr int boxes_of_one_step = 4096;  // every run proves its own step

}  // namespace

Prover::Prover(const Table& table)
    : per_G_(exact_condition(table, Polynomial(std::vector<Rational>{0, 1}))),
      plain_(exact_condition(table, constant(1))) {}

std::optional<EnclosedCondition> Prover::enclosed(const nmbc::Window& window) const {
    try {
        return enclose(window.low > 0 ? per_G_ : plain_, window.low, window.high);
    } catch (const std::overflow_error&) {  // a coefficient has no double
        return std::nullopt;
    }
}

bool Prover::holds(const nmbc::Window& window, double cfl, Grade least) const {
    const std::optional<EnclosedCondition> enclosed = this->enclosed(window);
    if (!enclosed) {
        return false;
    }
    const double top = highest_square(enclosed->band).lower();
    if (!(top > 0 && std::isfinite(top))) {
        return false;
    }
    const Interval tau = hull(Interval(0), square(Interval(cfl)) / top);
    return no_mode_grows(*enclosed, tau) &&
           waves_have_grade(*enclosed, tau, least, boxes_of_every_step);
}

bool Prover::holds_in_step(const nmbc::Window& window, double time_step, Grade least) const {
    const std::optional<EnclosedCondition> enclosed = this->enclosed(window);
    if (!enclosed) {
        return false;
    }
    constexpr double roundings = 1e-12;
    const Interval step = time_step * Interval(1 - roundings, 1 + roundings);
    const Interval tau = enclosed->scale * square(step) / 4.0;
    return no_mode_grows(*enclosed, tau) &&
           waves_have_grade(*enclosed, tau, least, boxes_of_one_step);
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

std::vector<nmbc::Window> parts_where(const std::function<bool(const nmbc::Window&)>& holds,
                                      const nmbc::Window& window, double finest,
                                      const std::function<void(double)>& told) {
    std::vector<nmbc::Window> found;
    const std::function<void(const nmbc::Window&)> collect = [&](const nmbc::Window& piece) {
        told(piece.low);
        const double middle = piece.low + (piece.high - piece.low) / 2;
        if (holds(piece)) {
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

nmbc::Window window_about(const Rational& G) {
    const double nearest = nearest_double(G);
    return Rational(nearest) == G
               ? nmbc::Window{nearest, nearest}
               : nmbc::Window{std::nextafter(nearest, 0), std::nextafter(nearest, HUGE_VAL)};
}

namespace {

/// A proof is worth up to two hundredths of the cfl: whether one of them is proved, which the steps
/// have then.
bool shortened_to_proof(const Prover& prover, const nmbc::Window& window,
                        std::vector<StableStep>& steps, Grade grade) {
    const double sampled = steps.front().cfl;
    const auto less = [&](int hundredths) { return std::round(100 * sampled - hundredths) / 100; };
    const auto holds = [&](double cfl) {
        return cfl > steps.front().from && prover.holds(window, cfl, grade);
    };
    if (holds(sampled)) {
        return true;
    }
    if (steps.size() > 1 || !holds(less(2))) {
        return false;
    }
    steps.front().cfl = holds(less(1)) ? less(1) : less(2);
    return true;
}

}  // namespace

void prove_certificate(const Table& table, Certificate& certificate) {
    const Specification& what = table.specification;
    constexpr unsigned highest_horizon = 3;
    const bool at_one_G = what.stabilisation || !has_stabilisation(table.model);
    const double own_step = nearest_double(what.time_step);
    if (!at_one_G || what.damping > 0 || (own_step == 0 && what.horizon > highest_horizon)) {
        return;
    }
    try {
        const Prover prover(table);
        const nmbc::Window window = window_about(what.stabilisation.value_or(0));
        const auto evidence = [&](std::vector<StableStep>& steps, Grade grade) {
            const bool proved =
                !steps.empty() && (own_step > 0 ? prover.holds_in_step(window, own_step, grade)
                                                : shortened_to_proof(prover, window, steps, grade));
            return proved ? Evidence::proved : Evidence::sampled;
        };
        certificate.paired = evidence(certificate.max_cfl, Grade::paired);
        certificate.with_any = evidence(certificate.max_cfl_contractive, Grade::contractive);
    } catch (const std::invalid_argument&) {
        // of another kind than there are proofs for
    }
}

}  // namespace nmbcgen
