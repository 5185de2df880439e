// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/terminal/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <string_view>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t code = 0;
volatile std::sig_atomic_t noted_at = 0;  // [s]

/// async-signal-safe, as handlers have to be
std::sig_atomic_t seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::sig_atomic_t(now.tv_sec);
}

void handle_interrupts(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (std::signal(signal, handler) == SIG_IGN) {
            std::signal(signal, SIG_IGN);
        }
    }
}

}  // namespace

void end_at_interrupts(int exit_code) {
    code = exit_code;
    for (const int signal :
         {SIGXFSZ, SIGPIPE}) {  // not ignored, as programs we start would inherit
        std::signal(signal, [](int /*signal*/) {});
    }
    handle_interrupts([](int /*signal*/) {
        constexpr std::string_view words = "nmbcrun: stopped; nothing was written\n";
        [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, words.data(), words.size());
        ::_exit(code);
    });
}

void note_interrupts() {
    handle_interrupts([](int received) {
        if (noted == 0) {
            noted_at = seconds();
            noted = 1;
        } else if (seconds() - noted_at >= 2) {
            constexpr std::string_view words =
                "nmbcrun: ended by a second signal: no checkpoint of this moment was stored\n";
            [[maybe_unused]] const auto ignored =
                ::write(STDERR_FILENO, words.data(), words.size());
            std::signal(received, SIG_DFL);
            std::raise(received);
        }
    });
}

bool interrupted() {
    return noted != 0;
}

void stop_if_interrupted() {
    if (interrupted()) {
        throw Interrupted("stopped; nothing was written");
    }
}

}  // namespace nmbcrun
