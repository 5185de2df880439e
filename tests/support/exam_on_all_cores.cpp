// SPDX-License-Identifier: GPL-2.0-or-later
// The same work on many things at once.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "generator/support/on_all_cores.hpp"

TEST_CASE("all work is done once, each piece by one thread") {
    std::vector<int> times(1000);
    nmbcgen::on_all_cores(times.size(), [&](std::size_t i) { ++times[i]; });
    CHECK(times == std::vector<int>(1000, 1));
    nmbcgen::on_all_cores(0, [](std::size_t) { throw std::logic_error("no work"); });
}

TEST_CASE("after a failure no more is begun") {
    std::atomic<std::size_t> begun = 0;
    const auto work = [&](std::size_t i) {
        ++begun;
        if (i == 0) {
            throw std::runtime_error("the first");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    constexpr std::size_t all = 10'000;  // seconds of it, where only one thread fails
    CHECK_THROWS_WITH(nmbcgen::on_all_cores(all, work), "the first");
    CHECK(begun < all / 2);
}
