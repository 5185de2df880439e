// SPDX-License-Identifier: MIT
#include "generator/support/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace nmbcgen {
namespace {

thread_local bool works_for_others = false;  // this thread is one of several at such work

}  // namespace

std::size_t cores() {
    return std::max(1U, std::thread::hardware_concurrency());
}

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
    const std::size_t threads = std::min(cores(), count);
    if (works_for_others || threads == 1) {
        take();
        return;
    }
    std::vector<std::future<void>> workers;
    for (std::size_t i = 0; i < threads; ++i) {
        workers.push_back(std::async(std::launch::async, [&take] {
            works_for_others = true;
            take();
        }));
    }
    for (std::future<void>& worker : workers) {
        worker.get();  // throws what the worker threw
    }
}

}  // namespace nmbcgen
