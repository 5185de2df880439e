// SPDX-License-Identifier: MIT
/// runtime_bench: how fast a chain is stepped, as ratios of times taken turn by turn in one run.
/// tools/bench/runtime makes a table of it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using boost::math::statistics::median;

constexpr double G = 0.9;
constexpr std::size_t memory_nodes = 10'000'000;

const nmbc::MatchingTable& table_of(int horizon, int order) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, order);
    if (table == nullptr) {
        throw std::runtime_error("no table of this horizon and order");
    }
    return *table;
}

/// A chain that is nowhere at rest: numbers so small that they have few digits are slow.
template <class Real>
nmbc::BasicChain<Real> moving_chain(int horizon, std::size_t nodes,
                                    const nmbc::BasicChainEnd<Real>& end) {
    const nmbc::Lattice lattice = nmbc::make_lattice(table_of(horizon, 1), G);
    const double time_step = 0.5 / nmbc::maximum_frequency(lattice);
    nmbc::BasicChain<Real> chain(lattice, end, {.nodes = nodes, .time_step = time_step});
    std::vector<Real> u(chain.nodes());
    for (std::size_t node = 0; node < u.size(); ++node) {
        u[node] = static_cast<Real>(1 + static_cast<double>(node * 7919 % 1000) / 1000);
    }
    chain.start(u, std::vector<Real>(u.size()));
    return chain;
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Clock, class Work>
double seconds(const Clock& clock, const Work& work) {
    const double start = clock();
    work();
    return clock() - start;
}

/// Times one work and another turn by turn; the medians of the first one's times and of the
/// quotients first/second of neighbours.
template <class Clock, class First, class Second>
std::pair<double, double> compare(benchmark::State& state, const Clock& clock, const First& first,
                                  const Second& second) {
    first();
    second();
    std::vector<double> times;
    std::vector<double> quotients;
    for ([[maybe_unused]] auto _ : state) {
        const double one = seconds(clock, first);
        const double other = seconds(clock, second);
        times.push_back(one);
        quotients.push_back(one / other);
        state.SetIterationTime(one);
    }
    return {median(times), median(quotients)};
}

/// A chain too large for any cache beside STREAM's triad on as many elements. Both read two arrays
/// and write as many bytes to memory as the other: the triad fetches what it overwrites, too.
template <class Real>
void memory(benchmark::State& state, int horizon) {
    constexpr std::size_t steps = 4;
    auto chain = moving_chain<Real>(horizon, memory_nodes, nmbc::IdleEnd{});
    std::vector<Real> a(memory_nodes);
    std::vector<Real> b(memory_nodes, 1);
    std::vector<Real> c(memory_nodes, 2);
    const auto triad = [&] {
        for (std::size_t pass = 0; pass < steps; ++pass) {
            for (std::size_t i = 0; i < memory_nodes; ++i) {
                a[i] = b[i] + Real{3} * c[i];
            }
            benchmark::ClobberMemory();
        }
    };
    const auto [time, quotient] = compare(
        state, processor_seconds, [&] { chain.advance(steps); }, triad);
    state.counters["gnodes"] = 1e-9 * memory_nodes * steps / time;
    state.counters["roofline"] = 1 / quotient;
}

/// A chain in cache, and how much longer its steps take one by one.
template <class Real>
void cache(benchmark::State& state, int horizon, std::size_t nodes) {
    const std::size_t steps = 2'000'000 / nodes;
    auto chain = moving_chain<Real>(horizon, nodes, nmbc::IdleEnd{});
    const auto [time, quotient] = compare(
        state, processor_seconds, [&] { chain.advance(steps); },
        [&] {
            for (std::size_t step = 0; step < steps; ++step) {
                chain.step();
            }
        });
    state.counters["gnodes"] = 1e-9 * static_cast<double>(nodes * steps) / time;
    state.counters["one_by_one"] = 1 / quotient;
}

/// Matching ends beside the cheapest ones; the share of a step that the matching takes on top.
/// Where the arrays lie in memory changes a step by a tenth and more, so each turn has them
/// elsewhere.
template <class Real>
void boundary(benchmark::State& state, int horizon, int order) {
    constexpr std::size_t nodes = 500;
    constexpr std::size_t steps = 1000;
    const nmbc::MatchingTable& table = table_of(horizon, order);
    const nmbc::MatchingEnd matching{nmbc::boundary_coefficients(table, G, nmbc::allow_unstable)};
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> up_to_a_page(0, 4096);
    const auto time_of = [&](const nmbc::BasicChainEnd<Real>& end) {
        const std::vector<char> gap(up_to_a_page(random));
        auto chain = moving_chain<Real>(horizon, nodes, end);
        const std::vector<char> other_gap(up_to_a_page(random));
        chain.advance(10);
        return seconds(processor_seconds, [&] { chain.advance(steps); });
    };
    std::vector<double> with;
    std::vector<double> without;
    for ([[maybe_unused]] auto _ : state) {
        with.push_back(time_of(matching));
        without.push_back(time_of(nmbc::IdleEnd{}));
        state.SetIterationTime(with.back());
    }
    state.counters["step_ns"] = 1e9 * median(with) / steps;
    state.counters["share"] = 1 - median(without) / median(with);
}

#ifdef _OPENMP
double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// As many threads as there are beside one.
void threads(benchmark::State& state, std::size_t nodes) {
    const std::size_t steps = std::max<std::size_t>(20'000'000 / nodes, 2);
    auto chain = moving_chain<double>(1, nodes, nmbc::IdleEnd{});
    const auto advance_threaded_from = [&](std::size_t least) {
        nmbc::detail::threaded_nodes = least;
        chain.advance(steps);
    };
    const auto [time, quotient] = compare(
        state, wall_seconds, [&] { advance_threaded_from(0); },
        [&] { advance_threaded_from(std::numeric_limits<std::size_t>::max()); });
    state.counters["gnodes"] = 1e-9 * static_cast<double>(nodes * steps) / time;
    state.counters["speedup"] = 1 / quotient;
}
#endif

template <class Run>
void add(const std::string& name, benchmark::IterationCount turns, const Run& run) {
    benchmark::RegisterBenchmark(name.c_str(), run)
        ->Iterations(turns)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

void add_all() {
    for (int horizon = 1; horizon <= 3; ++horizon) {
        const std::string n = "/" + std::to_string(horizon);
        add("memory" + n + "/double", 15, [=](auto& state) { memory<double>(state, horizon); });
        add("memory" + n + "/float", 15, [=](auto& state) { memory<float>(state, horizon); });
        for (const std::size_t nodes : {500U, 4000U}) {
            const std::string size = n + "/" + std::to_string(nodes);
            add("cache" + size + "/double", 101,
                [=](auto& state) { cache<double>(state, horizon, nodes); });
            add("cache" + size + "/float", 101,
                [=](auto& state) { cache<float>(state, horizon, nodes); });
        }
        for (int order = 1; order <= 3; ++order) {
            add("boundary" + n + "/" + std::to_string(order), 1001,
                [=](auto& state) { boundary<double>(state, horizon, order); });
        }
    }
#ifdef _OPENMP
    for (const std::size_t nodes :
         {8192U, 16384U, 32768U, 65536U, 131072U, 262144U, 1048576U, 10'000'000U}) {
        add("threads/" + std::to_string(nodes), 31, [=](auto& state) { threads(state, nodes); });
    }
#endif
}

}  // namespace

int main(int argc, char** argv) {
    add_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
}
