// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nmbc/lattice.hpp>
#include <string>

#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/ends/silent_layer.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

double error_of(const Scene& scene, const Boundary& boundary, const Samples& reference,
                const Advance& advance) {
    return relative_difference(samples_of(with_ends(scene, boundary), advance), reference);
}

/// So few that the one that is printed is the one that is run.
double to_three_digits(double value) {
    return std::stod(fmt::format("{:.2e}", value));
}

}  // namespace

Losses least_erring_losses(std::span<const double> profiles, std::size_t runs,
                           const std::function<double(const Losses&)>& error_of) {
    Losses best;
    double least = std::numeric_limits<double>::infinity();
    for (const double profile : profiles) {
        const auto digits_left = [&](double digits_of_target) {
            const Losses losses{profile, std::pow(10, -digits_of_target)};
            const double error = error_of(losses);
            if (error < least) {
                least = error;
                best = losses;
            }
            return std::log10(std::max(error, std::numeric_limits<double>::min()));
        };
        // The error falls with the target until what the graded loss scatters is more. So many bits
        // of its digits: about the least, the error hardly changes.
        constexpr int bits = 5;
        std::uintmax_t most_runs = runs / profiles.size();
        boost::math::tools::brent_find_minima(digits_left, 0.05, 10.0, bits, most_runs);
    }
    best.target = to_three_digits(best.target);
    return best;
}

Boundary tuned(const Scene& scene, Boundary layer, const Samples& reference,
               const Advance& advance) {
    constexpr std::array profiles{1.0, 2.0, 3.0, 4.0, 6.0};
    const auto error_with = [&](const Losses& losses) {
        layer.profile = losses.profile;
        layer.target = losses.target;
        return error_of(scene, layer, reference,
                        [&](double part) { advance(part / double(tuning_runs)); });
    };
    const Losses best = least_erring_losses(profiles, tuning_runs, error_with);
    layer.profile = best.profile;
    layer.target = best.target;
    return layer;
}

Boundary narrowest_silent(const Scene& scene, const Samples& reference, const Advance& advance) {
    constexpr double silent = 1e-12;
    const double unit = unit_of_time(scene);
    // Above it, something comes back from the narrower one, and nothing from the wider one.
    std::size_t narrow = 0;
    std::size_t wide = silent_layer(lattice_of(scene), scene.step.value() / unit, scene.end / unit);
    const auto most_runs = double(std::bit_width(wide));  // each halves what is left
    while (wide - narrow > 1) {
        const std::size_t layer = narrow + (wide - narrow) / 2;
        const double error = error_of(scene, {.kind = BoundaryKind::extended, .layer = layer},
                                      reference, [&](double part) { advance(part / most_runs); });
        (error > silent ? narrow : wide) = layer;
    }
    return {.kind = BoundaryKind::extended, .layer = wide};
}

}  // namespace nmbcrun
