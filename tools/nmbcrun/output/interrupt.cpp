// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace nmbcrun {
namespace {

volatile std::sig_atomic_t noted = 0;

}  // namespace

void note_interrupts() {
    std::signal(SIGXFSZ, SIG_IGN);  // then the write that goes beyond the limit fails
    for (const int signal : {SIGINT, SIGTERM}) {
        std::signal(signal, [](int received) {
            noted = 1;
            std::signal(received, SIG_DFL);
        });
    }
}

bool interrupted() {
    return noted != 0;
}

}  // namespace nmbcrun
