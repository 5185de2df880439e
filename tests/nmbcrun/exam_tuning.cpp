// SPDX-License-Identifier: GPL-2.0-or-later
/// The losses of a layer that err least.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "tools/nmbcrun/chart/tuning.hpp"

namespace nmbcrun::test {
namespace {

TEST_CASE("the target that is found is the one that is printed, to three digits") {
    constexpr std::array profiles{2.0, 3.0};
    for (const double digits : {0.1234567, 3.14159, 8.7654321}) {
        CAPTURE(digits);
        const Losses best = least_erring_losses(profiles, 60, [&](const Losses& losses) {
            const double off = std::log10(losses.target) + digits;
            return (losses.profile == 3 ? 1e-3 : 1e-2) * (1 + off * off);
        });
        CHECK(best.profile == 3);
        CHECK(best.target == std::stod(fmt::format("{:.2e}", best.target)));
        // 5 bits of the search, of up to 10 digits.
        CHECK(std::abs(std::log10(best.target) + digits) < 10 * std::exp2(-5));
    }
}

TEST_CASE("the search for the narrowest silent layer counts as one") {
    Scene scene;
    scene.horizon = 1;
    scene.G = 0.5;
    scene.nodes = 60;
    scene.end = 90;
    scene.initial =
        Initial{.pulse = {.shape = Shape::gaussian, .amplitude = 1, .width = 4, .wave_number = 0},
                .centre = 30,
                .file = {}};
    scene = in_steps_of(scene, 0.4);
    double done = 0;
    const Boundary found = narrowest_silent(scene, samples_without_ends(scene),
                                            [&done](double part) { done += part; });
    CHECK(found.layer > 0);
    CHECK(done > 0.5);
    CHECK(done < 1 + 1e-9);
}

}  // namespace
}  // namespace nmbcrun::test
