// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/orders_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/exact/rational.hpp"

namespace stability_atlas {
namespace {

using nmbcgen::add_parsed;
using nmbcgen::Rational;

constexpr int most_time_step = 100;
constexpr double least_half_width = 2;  // below, the grid does not resolve the pulse
constexpr double most_half_width = 20;  // above, its tails reach an end when it is measured

double parse_half_width(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end ||
        !(least_half_width <= value && value <= most_half_width)) {
        throw std::invalid_argument(fmt::format("'{}' is not a number from {:g} to {:g}",
                                                text.substr(0, 60), least_half_width,
                                                most_half_width));
    }
    return value;
}

std::vector<double> parse_half_widths(const std::string& text) {
    return nmbcgen::parse_list(text, parse_half_width);
}

/// An exact number from 0 to `most`.
auto rational_up_to(int most) {
    return [most](const std::string& text) {
        Rational value = nmbcgen::parse_rational(text);
        if (value > most) {
            throw std::invalid_argument(
                fmt::format("'{}' is more than {}, the most that is allowed", text, most));
        }
        return value;
    };
}

Rational parse_time_step(const std::string& text) {
    Rational value = nmbcgen::parse_rational(text);
    if (value < Rational(1, 100) || value > most_time_step) {
        throw std::invalid_argument(
            fmt::format("'{}' is not an exact number from 1/100 to {}", text, most_time_step));
    }
    return value;
}

}  // namespace

CLI::App* add_orders(CLI::App& app, OrdersQuestion& question) {
    auto* const orders = app.add_subcommand(
        "orders",
        "print what orders 1 to 8 leave of the energy of Gaussian pulses, in a run and as the "
        "modal analysis predicts it, as Markdown: docs/orders.md");
    orders->add_option("--horizon", question.horizon, "horizon n, 1 to 4")
        ->check(CLI::Range(1, 4))
        ->required();
    add_parsed(*orders, "--G", question.G, rational_up_to(1000), "stabilisation G, such as 1/2")
        ->required();
    orders->add_option("--highest", question.highest, "highest order, 1 to 8 (default 8)")
        ->check(CLI::Range(1, 8));
    add_parsed(*orders, "--half-width", question.half_widths, parse_half_widths,
               "w of u = exp(-(x/w)^2) in dX, 2 to 20 (default 3,6,12)");
    add_parsed(*orders, "--time-step", question.time_step, parse_time_step,
               "dt of leapfrog in dX/c, which orders above 1 are matched in (default n/2)");
    orders
        ->add_option("--stride", question.stride, "this stride only (default: the least certified)")
        ->check(CLI::Range(1, 8));
    add_parsed(*orders, "--damping", question.damping, rational_up_to(1000),
               "this tau only, in c/dX (default: the least certified of a few)");
    return orders;
}

}  // namespace stability_atlas
