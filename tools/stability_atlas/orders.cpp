// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/orders.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <numeric>
#include <string_view>

#include "generator/commands/candidates.hpp"
#include "generator/commands/time_step.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "tools/pulses/pulse.hpp"
#include "tools/stability_atlas/rays.hpp"
#include "tools/stability_atlas/runtime_side.hpp"

namespace stability_atlas {

using nmbcgen::Certified;
using nmbcgen::HalfSpace;
using nmbcgen::nearest_double;
using nmbcgen::Rational;
using nmbcgen::Specification;
using nmbcgen::to_string;

namespace {

/// Long waves have met one end by then, and are midway to the other.
constexpr Course course{.length = pulses::counted_nodes, .duration = 600};
constexpr int samples = 2000;  // of the spectrum

/// Orders above 1 are matched in the step; NMBC1 does not see it.
Specification specification(const OrdersQuestion& question, unsigned order, unsigned stride,
                            const Rational& damping) {
    return {.family = "nopd1d",
            .horizon = question.horizon,
            .order = order,
            .stride = stride,
            .stabilisation = question.G,
            .damping = damping,
            .time_step = order > 1 ? question.time_step : Rational(0)};
}

bool is_certified(const Certified& one, double time_step) {
    return one.half_space && one.cfl > 0 && cfl_of(*one.half_space, time_step) <= one.cfl;
}

std::vector<Rational> dampings(const OrdersQuestion& question) {
    return question.damping ? std::vector{*question.damping} : nmbcgen::damping_ladder("nopd1d");
}

std::vector<unsigned> strides(const OrdersQuestion& question) {
    if (question.stride) {
        return {*question.stride};
    }
    std::vector<unsigned> all(question.horizon + 2);
    std::iota(all.begin(), all.end(), 1U);
    return all;
}

/// Of this order, with the least damping and then the least stride that is certified in the step.
std::optional<Certified> choose(const OrdersQuestion& question, unsigned order) {
    for (const Rational& damping : dampings(question)) {
        for (const unsigned stride : strides(question)) {
            Certified one = certified(specification(question, order, stride, damping));
            if (is_certified(one, nearest_double(question.time_step))) {
                return one;
            }
        }
    }
    return std::nullopt;
}

std::string_view text_of(const nmbcgen::ModalVerdict& verdict) {
    switch (verdict.failure) {
        case nmbcgen::ModalFailure::growing_mode:
            return "a growing mode";
        case nmbcgen::ModalFailure::resonance:
            return "a resonance";
        case nmbcgen::ModalFailure::amplified_wave:
            return "an amplified wave";
        case nmbcgen::ModalFailure::none:
            break;
    }
    return "";
}

/// Of one that is not certified.
std::string why_not(const Certified& one, double time_step) {
    if (!one.half_space) {
        return "no such condition";
    }
    const std::string_view continuous = text_of(modal_verdict(*one.half_space));
    if (!continuous.empty()) {
        return std::string(continuous);
    }
    const std::string_view own = text_of(modal_verdict(stepped(*one.half_space, time_step)));
    return own.empty() ? "unstable in shorter steps" : fmt::format("{} in these steps", own);
}

/// Why none of this order is certified: each stride, with the least damping that was tried.
std::string why_none(const OrdersQuestion& question, unsigned order) {
    const Rational least = dampings(question).front();
    const Rational most = dampings(question).back();
    std::map<std::string, std::string> strides_of;
    for (const unsigned stride : strides(question)) {
        const Certified one = certified(specification(question, order, stride, least));
        std::string& list = strides_of[why_not(one, nearest_double(question.time_step))];
        list += fmt::format("{}{}", list.empty() ? "s = " : ", ", stride);
    }
    std::string text = fmt::format(
        "NMBC{}: none certified{}. With tau = {}: ", order,
        most > least ? " with any tau tried, up to " + to_string(most) : "", to_string(least));
    for (const auto& [reason, list] : strides_of) {
        text +=
            fmt::format("{}{} ({})", reason == strides_of.begin()->first ? "" : "; ", reason, list);
    }
    return text + ".\n";
}

double measure(const Certified& one, double time_step, double half_width) {
    const Specification& what = one.what;
    nmbc::Chain chain(
        make_lattice(nmbcgen::make_model(what.family, what.horizon, what.damping, what.weights),
                     what.stabilisation.value()),
        nmbc::MatchingEnd{
            make_coefficients(one.half_space.value(), nearest_double(what.time_step))},
        {.nodes = pulses::counted_nodes, .time_step = time_step});
    return pulses::energy_left(chain, half_width, course.duration);
}

/// Energies below the floor are no more than roundings.
std::string energy(double part, double floor) {
    return part < floor ? fmt::format("< {:.0e}", floor) : fmt::format("{:.2e}", part);
}

/// Of the prediction: of R, some units of the last place, squared.
constexpr double predicted_floor = 1e-30;

/// Of a run: each step rounds displacements of 1 by 2^-53 at most, here and there at random, and
/// the pulse's own energy goes with 1/w. At n = 1, G = 1/2 half of that was found.
double measured_floor(double time_step, double half_width) {
    constexpr double rounding = std::numeric_limits<double>::epsilon() / 2;
    return rounding * rounding * (course.duration / time_step) * half_width;
}

std::string row(const Certified& one, const OrdersQuestion& question) {
    const double time_step = nearest_double(question.time_step);
    const HalfSpace half_space = stepped(one.half_space.value(), time_step);
    const std::vector<Ray> rays = trace(half_space, course, samples);
    std::string text = fmt::format("| {} | {} | {} |", one.what.order, one.what.stride,
                                   to_string(one.what.damping));
    for (const double half_width : question.half_widths) {
        text += fmt::format(
            " {} | {} |",
            energy(measure(one, time_step, half_width), measured_floor(time_step, half_width)),
            energy(predict(half_space, rays, half_width).left, predicted_floor));
    }
    return text + "\n";
}

std::string heading(const OrdersQuestion& question, const HalfSpace& lattice) {
    std::string names = "| N | s | tau |";
    std::string rule = "|--:|--:|--:|";
    for (const double half_width : question.half_widths) {
        names += fmt::format(" w = {:g} | predicted |", half_width);
        rule += "--:|--:|";
    }
    const double time_step = lattice.time_step;
    return fmt::format("n = {}, G = {}, steps of {} dX/c (cfl {:.2f}):\n\n{}\n{}\n",
                       question.horizon, to_string(question.G), to_string(question.time_step),
                       cfl_of(lattice, time_step), names, rule);
}

/// What no end can do anything about.
std::string not_yet_there(const OrdersQuestion& question, const HalfSpace& lattice) {
    const std::vector<Ray> rays = trace(lattice, course, samples);
    std::string text;
    for (const double half_width : question.half_widths) {
        text += fmt::format(
            "{}{} (w = {:g})", text.empty() ? "" : ", ",
            energy(predict(lattice, rays, half_width).not_yet_there, predicted_floor), half_width);
    }
    return "Undamped, too slow to have met an end: " + text + ".\n";
}

}  // namespace

std::string orders(OrdersQuestion question) {
    if (question.time_step == 0) {
        question.time_step = Rational(question.horizon, 2);
    }
    Specification leapfrog = specification(question, 1, 1, question.damping.value_or(Rational(0)));
    leapfrog.time_step = question.time_step;
    nmbcgen::require_leapfrog(leapfrog);
    const nmbcgen::Table undamped = nmbcgen::derive(specification(question, 1, 1, 0));
    const HalfSpace lattice =
        stepped(make_half_space(undamped, question.G), nearest_double(question.time_step));

    std::string text = heading(question, lattice);
    std::string reasons;
    for (unsigned order = 1; order <= question.highest; ++order) {
        if (const auto chosen = choose(question, order)) {
            text += row(*chosen, question);
        } else {
            reasons += "\n" + why_none(question, order);
        }
    }
    return text + reasons + "\n" + not_yet_there(question, lattice);
}

}  // namespace stability_atlas
