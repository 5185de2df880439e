// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <utility>

#include "tools/nmbcrun/output/duration.hpp"

namespace {

TEST_CASE("durations are written as one says them") {
    for (const auto& [seconds, words] : {std::pair(0.0123, "0.012 s"),
                                         {0.38, "0.38 s"},
                                         {9.94, "9.9 s"},
                                         {9.96, "10 s"},
                                         {110.4, "110 s"},
                                         {130.0, "2 min"},
                                         {7100.0, "118 min"},
                                         {9000.0, "2.5 h"}}) {
        CHECK(nmbcrun::duration(seconds) == words);
    }
}

}  // namespace
