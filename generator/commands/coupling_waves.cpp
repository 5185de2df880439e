// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/coupling_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/reflection.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr CouplingForm forms[] = {CouplingForm::pairs, CouplingForm::rows};

Scattering parts_at(const Junction& junction, double xi) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    try {
        return junction.from_left(xi);
    } catch (const std::domain_error&) {
        return {unknown, unknown};
    }
}

/// NMBC2 of nearest neighbours, dX = c = 1.
HalfSpace absorbing_end() {
    Specification chain;
    chain.family = "chain1d";
    chain.order = 2;
    chain.stabilisation = 0;
    return make_half_space(derive(chain), 0);
}

/// Of the energy that comes from the left, what crosses the junction, comes back of the end behind
/// a local bar and crosses it again.
class FromEnd {
  public:
    FromEnd(const Halves& halves, CouplingForm form)
        : over_(halves, form),
          back_({halves.right_length, halves.left_length, halves.right, halves.left}, form),
          left_(bar_chain(halves.left_length, halves.left)),
          unit_(nearest_double(halves.right_length) /
                std::sqrt(nearest_double(halves.right.stiffness))),
          end_(stepped(absorbing_end(), packet_time_step(halves, form) / unit_)) {}

    double operator()(double xi) const {
        const double transmitted = parts_at(over_, xi).transmitted;
        if (transmitted == 0) {
            return 0;
        }
        const double omega = std::sqrt(omega_squared(left_, xi)) * unit_;
        return transmitted * std::norm(reflection(end_, omega).matrix(0, 0)) *
               parts_at(back_, 2 * std::asin(omega / 2)).transmitted;
    }

  private:
    Junction over_;
    Junction back_;
    LateralChain left_;
    double unit_;  ///< h/c of the right bar
    HalfSpace end_;
};

JunctionWaves::InTime in_time(const Halves& halves, const Packet& packet, const Junction& junction,
                              CouplingForm form) {
    JunctionWaves::InTime both;
    both.predicted.reflected =
        packet.mean([&](double xi) { return parts_at(junction, xi).reflected; });
    both.predicted.transmitted =
        packet.mean([&](double xi) { return parts_at(junction, xi).transmitted; });
    if (halves.right.horizon > 0) {
        both.measured = run_packet(halves, form, packet, nullptr);
        return both;
    }
    const HalfSpace end = absorbing_end();
    const nmbc::BoundaryCoefficients coefficients{.c = end.c, .b = end.b, .stride = end.stride};
    both.measured = run_packet(halves, form, packet, &coefficients);
    both.predicted.from_end = packet.mean(FromEnd(halves, form));
    return both;
}

std::string name_of(const Medium& medium, const Rational& length) {
    const std::string elements = fmt::format("elements of {} h", to_string(length));
    return medium.horizon == 0
               ? "local, " + elements
               : fmt::format("horizon {} h, {}", to_string(medium.horizon), elements);
}

std::string row_text(double xi, const Scattering& pairs, const Scattering& rows) {
    return fmt::format("{:<8.4g}{:<14.6g}{:<14.6g}{:<14.6g}{:.6g}\n", xi, pairs.reflected,
                       pairs.transmitted, rows.reflected, rows.transmitted);
}

Json json_of(const PacketResult& result, bool has_end) {
    Json all{{"reflected", result.reflected}, {"transmitted", result.transmitted}};
    if (has_end) {
        all["from_end"] = result.from_end;
    }
    return all;
}

}  // namespace

JunctionWaves waves_over(const Halves& halves) {
    const Junction junctions[] = {{halves, forms[0]}, {halves, forms[1]}};
    JunctionWaves waves{.halves = halves, .rows = {}, .packet = {}, .in_time = {}};
    // Waves much shorter than a horizon hardly move.
    const double widest =
        std::max(nearest_double(halves.left.horizon), nearest_double(halves.right.horizon));
    const double unit = 3 / std::max(widest, 3.0);
    for (const double xi : {0.1, 0.2, 0.3, 0.5, 0.8, 1.2}) {
        waves.rows.push_back(
            {xi * unit, {parts_at(junctions[0], xi * unit), parts_at(junctions[1], xi * unit)}});
    }
    waves.packet = {.middle = 0.5 * unit, .width = 24 / unit};
    for (std::size_t form = 0; form < 2; ++form) {
        waves.in_time[form] = in_time(halves, waves.packet, junctions[form], forms[form]);
    }
    return waves;
}

std::string waves_text(const JunctionWaves& waves) {
    std::string text = fmt::format(
        "waves       of a bar (horizon h as given; k = density = 1) over the junction with "
        "another\n"
        "left        {}\nright       {}\n\n"
        "energy      that comes from the left: parts of it\n"
        "        pairs                       rows\n"
        "xi h    reflected     transmitted   reflected     transmitted\n",
        name_of(waves.halves.left, waves.halves.left_length),
        name_of(waves.halves.right, waves.halves.right_length));
    for (const JunctionWaves::Row& row : waves.rows) {
        text += row_text(row.xi, row.parts[0], row.parts[1]);
    }
    text += fmt::format(
        "\npacket      exp(-(X/{})^2/2) around xi h = {}, in leapfrog steps: sum of h u^2\n"
        "                    measured      predicted\n",
        waves.packet.width, waves.packet.middle);
    for (std::size_t form = 0; form < 2; ++form) {
        const auto& [measured, predicted] = waves.in_time[form];
        const char* const name = form == 0 ? "pairs" : "rows";
        text += fmt::format("{:<6}{:<14}{:<14.5g}{:.5g}\n", name, "reflected", measured.reflected,
                            predicted.reflected);
        text += fmt::format("{:<6}{:<14}{:<14.5g}{:.5g}\n", name, "transmitted",
                            measured.transmitted, predicted.transmitted);
        if (waves.halves.right.horizon == 0) {
            text += fmt::format("{:<6}{:<14}{:<14.3g}{:.3g}\n", name, "NMBC2 behind",
                                measured.from_end, predicted.from_end);
        }
    }
    return text;
}

std::string waves_json(const JunctionWaves& waves) {
    const bool has_end = waves.halves.right.horizon == 0;
    Json rows = Json::array();
    for (const JunctionWaves::Row& row : waves.rows) {
        rows.push_back(
            {{"xi", row.xi},
             {"pairs", json_of({row.parts[0].reflected, row.parts[0].transmitted, 0}, false)},
             {"rows", json_of({row.parts[1].reflected, row.parts[1].transmitted, 0}, false)}});
    }
    Json packet{{"xi", waves.packet.middle}, {"width", waves.packet.width}};
    for (std::size_t form = 0; form < 2; ++form) {
        packet[form == 0 ? "pairs" : "rows"] = {
            {"measured", json_of(waves.in_time[form].measured, has_end)},
            {"predicted", json_of(waves.in_time[form].predicted, has_end)}};
    }
    const Halves& bars = waves.halves;
    const Json all{{"coupling", "waves"},
                   {"horizons", {to_string(bars.left.horizon), to_string(bars.right.horizon)}},
                   {"lengths", {to_string(bars.left_length), to_string(bars.right_length)}},
                   {"waves", rows},
                   {"packet", packet}};
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
