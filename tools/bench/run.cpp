// SPDX-License-Identifier: MIT
/// run_bench SCENE [KEY=VALUE..]: how much longer nmbcrun takes for the steps of a scene than the
/// library for moving its chain, processor times taken turn by turn. The runs' reports are on
/// stdout, the result is on stderr.
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>

#include <boost/math/statistics/univariate_statistics.hpp>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/support/exit_code.hpp"
#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace {

using boost::math::statistics::median;

template <class Work>
double seconds(Work work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

void measure(const nmbcrun::Scene& scene) {
    const auto folder = std::filesystem::temp_directory_path() / "run_bench";
    nmbcrun::Scene one_step = scene;  // the same set-up and files
    one_step.end = scene.end * 1e-9;
    const auto time_of_run = [&](const nmbcrun::Scene& what) {
        return seconds([&] { nmbcrun::run(what, {.folder = folder, .quiet = true}); });
    };
    std::vector<double> library;
    std::vector<double> ratios;
    std::size_t node_steps = 0;
    constexpr int turns = 15;
    for (int turn = 0; turn < turns; ++turn) {
        nmbcrun::Simulation simulation(scene);
        node_steps = simulation.plan().steps * scene.nodes;
        library.push_back(seconds([&] { simulation.advance(simulation.plan().steps); }));
        ratios.push_back((time_of_run(scene) - time_of_run(one_step)) / library.back());
    }
    std::filesystem::remove_all(folder);
    fmt::print(stderr, "{:.2f} times the library's {:.2f} ns a node-step\n", median(ratios),
               1e9 * median(library) / double(node_steps));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: run_bench SCENE [KEY=VALUE..]\n");
        return nmbcgen::bad_input;
    }
    try {
        measure(nmbcrun::read_scene(argv[1], nmbcrun::split_settings({argv + 2, argv + argc})));
    } catch (const std::exception& error) {
        fmt::print(stderr, "run_bench: {}\n", error.what());
        return nmbcgen::bad_input;
    }
    return nmbcgen::done;
}
