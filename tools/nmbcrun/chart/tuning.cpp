// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/tuning.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/sides/silent_layer.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

double error_of(const Scene& scene, const Boundary& boundary, const Samples& reference,
                const Advance& advance) {
    return relative_difference(samples_of(with_ends(scene, boundary), advance), reference);
}

}  // namespace

Boundary tuned(const Scene& scene, Boundary layer, const Samples& reference,
               const Advance& advance) {
    constexpr std::array profiles{1.0, 2.0, 3.0, 4.0, 6.0};
    Boundary best = layer;
    double least = std::numeric_limits<double>::infinity();
    double done = 0;
    const auto add = [&](double part) {
        done += part;
        advance(part);
    };
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        layer.profile = profiles[i];
        const auto digits_left = [&](double digits_of_target) {
            layer.target = std::pow(10, -digits_of_target);
            const double error = error_of(scene, layer, reference,
                                          [&](double part) { add(part / double(tuning_runs)); });
            if (error < least) {
                least = error;
                best = layer;
            }
            return std::log10(std::max(error, std::numeric_limits<double>::min()));
        };
        // The error falls with the target until what the graded loss scatters is more. So many bits
        // of its digits: about the least, the error hardly changes.
        constexpr int bits = 5;
        std::uintmax_t most_runs = tuning_runs / profiles.size();
        boost::math::tools::brent_find_minima(digits_left, 0.05, 10.0, bits, most_runs);
        add(double(i + 1) / double(profiles.size()) - done);
    }
    return best;
}

Boundary narrowest_silent(const Scene& scene, const Samples& reference, const Advance& advance) {
    constexpr double silent = 1e-12;
    const double unit = unit_of_time(scene);
    // Above it, something comes back from the narrower one, and nothing from the wider one.
    std::size_t narrow = 0;
    std::size_t wide = silent_layer(lattice_of(scene), scene.step.value() / unit, scene.end / unit);
    while (wide - narrow > 1) {
        const std::size_t layer = narrow + (wide - narrow) / 2;
        const double error =
            error_of(scene, {.kind = BoundaryKind::extended, .layer = layer}, reference, advance);
        (error > silent ? narrow : wide) = layer;
    }
    return {.kind = BoundaryKind::extended, .layer = wide};
}

}  // namespace nmbcrun
