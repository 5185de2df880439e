// SPDX-License-Identifier: GPL-2.0-or-later
/// A run that is stored and taken up again goes on bit for bit.
#include "tests/nmbcrun/chains.hpp"
#include "tools/nmbcrun/ends/higdon.hpp"
#include "tools/nmbcrun/ends/pml.hpp"
#include "tools/nmbcrun/ends/sponge.hpp"
#include "tools/nmbcrun/ends/truncated.hpp"

namespace {

TEST_CASE("runs with nmbcrun's ends are resumed bit for bit") {
    const auto coefficients = nmbc::boundary_coefficients(table_of(2), 1, nmbc::allow_unstable);
    const std::vector<nmbc::ChainEnd> ends{nmbcrun::SpongeEnd{{7, 2, 1e-2}},
                                           nmbcrun::PmlEnd{{7, 2, 1e-4}},
                                           nmbcrun::HigdonEnd{1},
                                           nmbcrun::HigdonEnd{2},
                                           nmbcrun::HigdonEnd{4},
                                           nmbcrun::TruncatedEnd{coefficients}};
    for (const auto& left : ends) {
        for (const auto& right : ends) {
            const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.2};
            nmbc::Chain chain(lattice_of(2, 1), left, right, parameters);
            nmbc::Chain other(lattice_of(2, 1), left, right, parameters);
            start_at_random(chain);
            for (int step = 0; step < 50; ++step) {
                chain.step();
            }
            start_at_random(other);  // with memories of its own, to be replaced
            other.step();
            other.resume(chain.state());
            for (int step = 0; step < 50; ++step) {
                chain.step();
                other.step();
            }
            CHECK(chain.is_finite());
            CHECK(std::ranges::equal(chain.displacement(), other.displacement()));
            CHECK(std::ranges::equal(chain.velocity(), other.velocity()));
        }
    }
}

}  // namespace
