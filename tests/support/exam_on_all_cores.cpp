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

TEST_CASE("work that has work of its own for all cores does it itself") {
    std::vector<int> times(64);
    std::atomic<bool> itself = true;
    nmbcgen::on_all_cores(8, [&](std::size_t i) {
        const auto outer = std::this_thread::get_id();
        nmbcgen::on_all_cores(8, [&](std::size_t k) {
            ++times[8 * i + k];
            itself = itself && std::this_thread::get_id() == outer;
        });
    });
    CHECK(times == std::vector<int>(64, 1));
    CHECK(itself);
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
