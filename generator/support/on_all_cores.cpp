// SPDX-License-Identifier: MIT
#include "generator/support/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace nmbcgen {

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> taken = 0;
    const auto take = [&] {
        try {
            for (std::size_t i = taken++; i < count; i = taken++) {
                work(i);
            }
        } catch (...) {
            taken = count;  // nothing more is begun
            throw;
        }
    };
    std::vector<std::future<void>> workers;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < std::min(cores, count); ++i) {
        workers.push_back(std::async(std::launch::async, take));
    }
    for (std::future<void>& worker : workers) {
        worker.get();  // throws what the worker threw
    }
}

}  // namespace nmbcgen
