// SPDX-License-Identifier: MIT
/// plane_bench: how fast a plane is stepped, beside STREAM's triad on the bytes that a step moves,
/// in one run. tools/bench/plane makes a table of it.
#include <benchmark/benchmark.h>

#include <boost/math/statistics/univariate_statistics.hpp>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <string>
#include <variant>
#include <vector>

namespace {

constexpr std::size_t side = 1000;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A sweep reads u and v and writes v, the next one reads v and u and writes u: in two components,
/// 12 numbers a node.
template <class Real>
void step(benchmark::State& state, const nmbc::PlaneModel& model, bool may_break) {
    constexpr std::size_t steps = 4;
    nmbc::PlaneParameters p{.nx = side, .ny = side};
    p.time_step = 1 / std::sqrt(nmbc::highest_eigenvalue(model));
    nmbc::BasicPlane<Real> plane(model, nmbc::PlaneSides::all(nmbc::FixedSide{}), p);
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t i = 0; i < plane.displacement(a).size(); ++i) {
            plane.displacement(a)[i] = static_cast<Real>(i * (7919 + a) % 1000) / 1000;
        }
    }
    plane.start();
    if (may_break) {  // every bond is looked at; none is so long
        plane.break_above(100, [](auto, auto) { return false; });
    }
    const std::size_t numbers = 12 * side * side / 3;
    std::vector<Real> a(numbers);
    std::vector<Real> b(numbers, 1);
    std::vector<Real> c(numbers, 2);
    const auto triad = [&] {
#ifdef _OPENMP
#pragma omp parallel for schedule(static)
#endif
        for (std::size_t i = 0; i < numbers; ++i) {
            a[i] = b[i] + Real{3} * c[i];
        }
        benchmark::ClobberMemory();
    };
    plane.advance(2);
    triad();
    std::vector<double> times;
    std::vector<double> quotients;
    for ([[maybe_unused]] auto _ : state) {
        const double start = now();
        plane.advance(steps);
        const double between = now();
        triad();
        times.push_back((between - start) / steps);
        quotients.push_back(times.back() / (now() - between));
        state.SetIterationTime(times.back());
    }
    const double time = boost::math::statistics::median(times);
    state.counters["mnodes"] = 1e-6 * side * side / time;
    state.counters["of_triad"] = 1 / boost::math::statistics::median(quotients);
    if (const auto* const bonds = std::get_if<nmbc::BondModel>(&model.law())) {
        // Each of them once.
        const auto per_node = static_cast<double>(bonds->bonds().size()) / 2;
        state.counters["mbonds"] = 1e-6 * side * side * per_node / time;
    }
}

template <class Run>
void add(const std::string& name, const Run& run) {
    benchmark::RegisterBenchmark(name.c_str(), run)
        ->Iterations(15)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

template <class Real>
void add_all(const std::string& real) {
    for (const unsigned radius_squared : {1U, 4U, 9U}) {
        add("nopd2d/" + std::to_string(radius_squared) + real, [=](auto& state) {
            step<Real>(state, nmbc::nopd2d(radius_squared, 0.25, 0.5), false);
        });
    }
    const nmbc::BondModel bonds = nmbc::bond2d(9, nmbc::bond_weights(9, {1, 1, 1, 1, 1, 1}));
    add("bond2d/9" + real, [=](auto& state) { step<Real>(state, bonds, false); });
    add("breaking/9" + real, [=](auto& state) { step<Real>(state, bonds, true); });
}

}  // namespace

int main(int argc, char** argv) {
    add_all<double>("/double");
    add_all<float>("/float");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
