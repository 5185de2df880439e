// SPDX-License-Identifier: MIT
/// So many steps of a plane of 500 x 500 nodes, for run_instructions.sh to count what they take.
/// Usage: steps_of_a_plane double|float RADIUS_SQUARED fixed|passive STEPS
#include <cstdlib>
#include <iostream>
#include <nmbc/plane.hpp>
#include <string>

namespace {

/// As many layers, and as full dashpots, as a design has; what they are makes no difference here.
nmbc::PassiveSide passive(std::size_t layers) {
    const std::vector<double> ones(layers, 1);
    std::vector<double> dashpots(layers * layers, 0.1);
    for (std::size_t i = 0; i < layers; ++i) {
        dashpots[i * (layers + 1)] = 1;
    }
    return {ones, ones, {ones, ones}, {dashpots, dashpots}};
}

template <class Real>
void run(unsigned radius_squared, const std::string& kind, std::size_t steps) {
    constexpr std::size_t nodes = 500;
    const nmbc::PlaneModel model = nmbc::nopd2d(radius_squared, 0.25, 0.5);
    nmbc::PlaneSide side = nmbc::FixedSide{};
    if (kind == "passive") {
        side = passive(2 * model.horizon());
    }
    nmbc::BasicPlane<Real> plane(model, nmbc::PlaneSides::all(side),
                                 {.nx = nodes, .ny = nodes, .time_step = 0.1});
    plane.start();
    plane.advance(steps);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: steps_of_a_plane double|float RADIUS_SQUARED fixed|passive STEPS\n";
        return 2;
    }
    const auto radius_squared = unsigned(std::atoi(argv[2]));
    const auto steps = std::size_t(std::atoi(argv[4]));
    if (std::string(argv[1]) == "float") {
        run<float>(radius_squared, argv[3], steps);
    } else {
        run<double>(radius_squared, argv[3], steps);
    }
}
