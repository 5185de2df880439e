// SPDX-License-Identifier: MIT
#include "generator/enclosures/prove.hpp"

#include <algorithm>
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
    : condition_(table.model.damping.empty()
                     ? decltype(condition_)(
                           Undamped{exact_condition(table, Polynomial(std::vector<Rational>{0, 1})),
                                    exact_condition(table, constant(1))})
                     : damped_condition(table)) {}

EnclosedCondition Prover::Undamped::enclosed(const nmbc::Window& window) const {
    return enclose(window.low > 0 ? per_G : plain, window.low, window.high);
}

Undecided Prover::undecided(const nmbc::Window& window, double cfl, Grade least,
                            double from) const {
    if (from > cfl) {
        throw std::invalid_argument("Prover: steps from a longer one to a shorter one");
    }
    const auto is_usable = [](const Interval& square) {
        return square.lower() > 0 && std::isfinite(square.upper());
    };
    try {
        if (const auto* damped = std::get_if<DampedCondition>(&condition_)) {
            const Interval top = highest_square(*damped, window);
            return least > Grade::paired ? Undecided::waves
                   : is_usable(top) &&
                           no_mode_grows(*damped, window, Interval(from, cfl) / sqrt(top))
                       ? Undecided::nothing
                       : Undecided::modes;
        }
        const EnclosedCondition enclosed = std::get<Undamped>(condition_).enclosed(window);
        const Interval top = highest_square(enclosed.band);
        const Interval tau = square(Interval(from, cfl)) / top;
        if (!is_usable(top) || !no_mode_grows(enclosed, tau)) {
            return Undecided::modes;
        }
        return waves_have_grade(enclosed, tau, least, boxes_of_every_step) ? Undecided::nothing
                                                                           : Undecided::waves;
    } catch (const std::overflow_error&) {  // a coefficient has no double
        return Undecided::modes;
    }
}

bool Prover::holds_in_step(const nmbc::Window& window, double time_step, Grade least) const {
    constexpr double roundings = 1e-12;
    const Interval step = time_step * Interval(1 - roundings, 1 + roundings);
    try {
        if (const auto* damped = std::get_if<DampedCondition>(&condition_)) {
            return least == Grade::paired && no_mode_grows(*damped, window, step / 2.0);
        }
        const EnclosedCondition enclosed = std::get<Undamped>(condition_).enclosed(window);
        const Interval tau = enclosed.scale * square(step) / 4.0;
        return no_mode_grows(enclosed, tau) &&
               waves_have_grade(enclosed, tau, least, boxes_of_one_step);
    } catch (const std::overflow_error&) {  // a coefficient has no double
        return false;
    }
}

ProvedSteps Prover::proved_steps(const nmbc::Window& window, Grade least, double from,
                                 const std::function<void(double)>& told) const {
    ProvedSteps proved{.beyond = undecided(window, from, least, from)};
    if (proved.beyond != Undecided::nothing) {
        return proved;
    }
    proved.cfl = from;
    for (int hundredths = 16; hundredths > 0;) {
        told(proved.cfl);
        const double next = std::floor(100 * proved.cfl + 1e-9 + hundredths) / 100;
        const Undecided open =
            next < 1 ? undecided(window, next, least, proved.cfl) : Undecided::modes;
        if (open == Undecided::nothing) {
            proved.cfl = next;
        } else {
            proved.beyond = open;
            hundredths /= 2;
        }
    }
    return proved;
}

std::vector<nmbc::Window> parts_where(const std::function<bool(const nmbc::Window&)>& holds,
                                      const nmbc::Window& window, double finest,
                                      const std::function<void(double)>& told) {
    constexpr double growth = 1.5;  // most pieces hold then, and a failure costs more than a proof
    constexpr double widest_gap = 1.0 / 200;  // of the window: what fails everywhere ends soon
    const double whole = window.high - window.low;
    const double narrowest = std::max(finest, 1e-12 * std::abs(window.high));  // of two doubles
    std::vector<nmbc::Window> found;
    double low = window.low;
    double width = whole;
    double gap = narrowest;
    do {
        told(low);
        const double rest = window.high - low;
        width = std::min(width, rest);
        const nmbc::Window piece{low, width < rest ? low + width : window.high};
        if (holds(piece)) {
            if (!found.empty() && found.back().high == piece.low) {
                found.back().high = piece.high;
            } else {
                found.push_back(piece);
            }
            low = piece.high;
            width *= growth;
            gap = narrowest;
        } else if (width > narrowest) {
            width = std::max(narrowest, width / 2);
        } else {
            low += gap;
            gap = std::min(2 * gap, std::max(narrowest, widest_gap * whole));
        }
    } while (low < window.high);
    return found;
}

nmbc::Window window_about(const Rational& G) {
    const double nearest = nearest_double(G);
    return Rational(nearest) == G
               ? nmbc::Window{nearest, nearest}
               : nmbc::Window{std::nextafter(nearest, 0), std::nextafter(nearest, HUGE_VAL)};
}

namespace {

/// Proves the steps, or shortens them by up to 0.02, which a proof is worth, to what is proved.
/// False where it can do neither.
bool shorten_to_proof(const Prover& prover, const nmbc::Window& window,
                      std::vector<StableStep>& steps, Grade grade) {
    if (steps.size() != 1) {
        return false;
    }
    StableStep& only = steps.front();
    if (prover.holds(window, only.cfl, grade, only.from)) {  // soonest
        return true;
    }
    constexpr double worth = 0.02 + 1e-9;  // a hundredth is no double
    const double proved = prover.proved_steps(window, grade, only.from, [](double) {}).cfl;
    if (proved <= only.from || proved < only.cfl - worth) {
        return false;
    }
    only.cfl = std::min(only.cfl, proved);
    return true;
}

}  // namespace

void prove_certificate(const Table& table, Certificate& certificate) {
    const Specification& what = table.specification;
    const bool at_one_G = what.stabilisation || !has_stabilisation(table.model);
    const double own_step = nearest_double(what.time_step);
    constexpr unsigned highest_horizon = 6;  // above, waves of one frequency are many
    if (!at_one_G || (own_step == 0 && what.horizon > highest_horizon)) {
        return;
    }
    try {
        const Prover prover(table);
        const nmbc::Window window = window_about(what.stabilisation.value_or(0));
        const auto evidence = [&](std::vector<StableStep>& steps, Grade grade) {
            const bool proved =
                own_step > 0 ? !steps.empty() && prover.holds_in_step(window, own_step, grade)
                             : shorten_to_proof(prover, window, steps, grade);
            return proved ? Evidence::proved : Evidence::sampled;
        };
        certificate.paired = evidence(certificate.max_cfl, Grade::paired);
        certificate.with_any = evidence(certificate.max_cfl_contractive, Grade::contractive);
    } catch (const std::invalid_argument&) {
        // of another kind than there are proofs for
    }
}

}  // namespace nmbcgen
