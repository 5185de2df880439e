// SPDX-License-Identifier: MIT
/// plane_bench: how fast a plane is stepped, beside STREAM's triad on the bytes that a step moves
/// and fused multiply-adds of as many operations, in one run. tools/bench/plane makes a table of
/// it.
#include <benchmark/benchmark.h>

#include <array>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <string>
#include <variant>
#include <vector>

namespace {

constexpr std::size_t in_memory = 1000;
constexpr std::size_t in_cache = 120;

/// Of the clock where there are threads, else of the processor: others may be at work beside.
double now() {
#ifdef _OPENMP
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
#else
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
}

/// What a node's step costs at the least.
struct Work {
    std::size_t numbers = 0;     ///< read or written
    std::size_t operations = 0;  ///< additions, subtractions and multiplications
};

/// Of nopd2d one sweep reads and writes u and v of two components: 8 numbers. Operations are those
/// of runtime/nmbc/plane_row_sweeps.hpp, products with 1 left out.
Work work_of(unsigned radius_squared) {
    switch (radius_squared) {
        case 1:
            return {8, 46};
        case 4:
            return {8, 90};
        default:
            return {8, 134};
    }
}

/// Of bonds a sweep reads which of them hold, too. Operations are not counted.
constexpr Work work_of_bonds{9, 0};

/// Seconds for so many operations in fused multiply-adds.
template <class Real>
double multiply_adds(double operations) {
    constexpr std::size_t chunks = 16;
    constexpr std::size_t numbers = 512;
    constexpr std::size_t length = 32;  // of a chain; a dozen of them are on the way at once
    static std::array<std::array<Real, numbers>, chunks> data{};
    const auto repeats = static_cast<std::size_t>(operations / (2 * chunks * numbers * length)) + 1;
    const double start = now();
#ifdef _OPENMP
#pragma omp parallel for schedule(static)
#endif
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
            for (Real& number : data[chunk]) {
                Real value = number;
#pragma GCC unroll 32
                for (std::size_t i = 0; i < length; ++i) {
                    value = std::fma(value, Real(0.5), Real(0.25));
                }
                number = value;
            }
            benchmark::ClobberMemory();
        }
    }
    return (now() - start) * operations /
           static_cast<double>(repeats * 2 * chunks * numbers * length);
}

template <class Real>
void step(benchmark::State& state, const nmbc::PlaneModel& model, const Work& work, bool may_break,
          std::size_t side = in_memory) {
    const std::size_t steps = 4 * (in_memory / side) * (in_memory / side);
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
    const std::size_t numbers = work.numbers * side * side / 3;
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
    multiply_adds<Real>(1e6);
    std::vector<double> times;
    std::vector<double> of_triad;
    std::vector<double> of_multiply_adds;
    for ([[maybe_unused]] auto _ : state) {
        const double start = now();
        plane.advance(steps);
        const double between = now();
        triad();
        const double end = now();
        times.push_back((between - start) / static_cast<double>(steps));
        of_triad.push_back((end - between) / times.back());
        of_multiply_adds.push_back(
            multiply_adds<Real>(static_cast<double>(work.operations * side * side)) / times.back());
        state.SetIterationTime(times.back());
    }
    const auto nodes = static_cast<double>(side * side);
    const double time = boost::math::statistics::median(times);
    state.counters["mnodes"] = 1e-6 * nodes / time;
    if (side == in_memory) {
        state.counters["of_triad"] = boost::math::statistics::median(of_triad);
    }
    if (work.operations > 0) {
        state.counters["of_fma"] = boost::math::statistics::median(of_multiply_adds);
    }
    if (const auto* const bonds = std::get_if<nmbc::BondModel>(&model.law())) {
        // Each of them once.
        const auto per_node = static_cast<double>(bonds->bonds().size()) / 2;
        state.counters["mbonds"] = 1e-6 * nodes * per_node / time;
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
        for (const bool is_cached : {false, true}) {
            add((is_cached ? "cached/" : "nopd2d/") + std::to_string(radius_squared) + real,
                [=](auto& state) {
                    step<Real>(state, nmbc::nopd2d(radius_squared, 0.25, 0.5),
                               work_of(radius_squared), false, is_cached ? in_cache : in_memory);
                });
        }
    }
    const nmbc::BondModel bonds = nmbc::bond2d(9, nmbc::bond_weights(9, {1, 1, 1, 1, 1, 1}));
    add("bond2d/9" + real, [=](auto& state) { step<Real>(state, bonds, work_of_bonds, false); });
    add("breaking/9" + real, [=](auto& state) { step<Real>(state, bonds, work_of_bonds, true); });
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
