// SPDX-License-Identifier: MIT
/// What a table's certificate says at a G, and what is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>

namespace {

using nmbc::generated::nopd1d_n1_order1;
using nmbc::generated::nopd1d_n2_order2;
using nmbc::generated::nopd1d_n2_order2_s2;
using nmbc::generated::nopd1d_n3_order2_s3;

TEST_CASE("grades") {
    CHECK(nmbc::certified_grade(nopd1d_n1_order1, 0) == nmbc::Grade::paired);
    CHECK(nmbc::certified_grade(nopd1d_n1_order1, 0.25) == nmbc::Grade::contractive);
    CHECK(nmbc::certified_grade(nopd1d_n1_order1, 1e6) == nmbc::Grade::contractive);
    CHECK(nmbc::certified_grade(nopd1d_n2_order2, 1) == nmbc::Grade::none);
    CHECK(nmbc::certified_grade(nopd1d_n2_order2_s2, 1) == nmbc::Grade::contractive);
    // Between the ends of its two windows, 2.93 and 2.97: NMBC2 with stride 2 is stable with its
    // like only.
    CHECK(nmbc::certified_grade(nopd1d_n2_order2_s2, 2.95) == nmbc::Grade::paired);
    CHECK(nmbc::certified_grade(nopd1d_n2_order2_s2, std::nan("")) == nmbc::Grade::none);
}

TEST_CASE("an uncertified pair of table and G is refused, with what would do") {
    const auto refused = [](const std::string& text) {
        CHECK_THROWS_WITH_AS(
            nmbc::boundary_coefficients(nopd1d_n2_order2, 1, nmbc::generated::tables),
            doctest::Contains(text.c_str()), nmbc::NotCertified);
    };
    refused("NMBC2 with stride 1 (nopd1d_n2_order2) is not certified to be stable at G = 1");
    refused("certified for G from 2.4470588");
    refused(
        "at this G: NMBC1 with stride 1, NMBC1 with stride 2, NMBC2 with stride 2, "
        "NMBC3 with stride 2");
    CHECK_NOTHROW(nmbc::boundary_coefficients(nopd1d_n2_order2, 1, nmbc::allow_unstable));
    CHECK_NOTHROW(nmbc::boundary_coefficients(nopd1d_n2_order2_s2, 1));
    // A table without a window at all.
    const auto* none = nmbc::find_table(nmbc::generated::tables, "nopd1d", 3, 2);
    REQUIRE(none != nullptr);
    CHECK_THROWS_WITH_AS(nmbc::boundary_coefficients(*none, 1),
                         doctest::Contains("is certified for no G"), nmbc::NotCertified);
    // Made for one G.
    nmbc::MatchingTable at_one_G = nopd1d_n2_order2;
    const nmbc::StableStep step{{1, 1}, 0.5};
    at_one_G.max_cfl = {};
    at_one_G.fixed_G = "1";
    CHECK(nmbc::certified_choices(at_one_G, 1) ==
          "NMBC2 with stride 1 is not certified at its G, 1");
    at_one_G.max_cfl = {&step, 1};
    CHECK(nmbc::certified_choices(at_one_G, 1) == "NMBC2 with stride 1 is certified at its G, 1");
    at_one_G.fixed_G = "";
    CHECK(nmbc::certified_choices(at_one_G, 1) == "NMBC2 with stride 1 is certified for G = 1");
    // A pole is a pole, certified or not.
    CHECK_THROWS_AS(nmbc::boundary_coefficients(nmbc::generated::nopd1d_n1_order2, 0),
                    nmbc::CoefficientError);
}

TEST_CASE("the largest certified time step") {
    // Theory: n = 1, N = 1, G = 1/2: cfl 0.98; omega_max = 2 c/dX there, the atom chain.
    CHECK(nmbc::certified_cfl(nopd1d_n1_order1, 0.5) == 0.98);
    CHECK(nmbc::stable_time_step(nopd1d_n1_order1, 0.5, 3, 0.1) ==
          doctest::Approx(0.98 * 0.1 / 3).epsilon(1e-12));
    for (const double bad : {0.0, -1.0, std::nan("")}) {
        CHECK_THROWS_AS(nmbc::stable_time_step(nopd1d_n1_order1, 0.5, bad, 1),
                        std::invalid_argument);
        CHECK_THROWS_AS(nmbc::stable_time_step(nopd1d_n1_order1, 0.5, 1, bad),
                        std::invalid_argument);
    }
    CHECK_THROWS_WITH_AS(nmbc::stable_time_step(nopd1d_n1_order1, -1, 1, 1),
                         "the stabilisation G must be finite and not negative, not -1",
                         std::invalid_argument);
    // Where two pieces meet both hold.
    const auto steps = nopd1d_n1_order1.max_cfl;
    REQUIRE(steps.size() > 1);
    CHECK(nmbc::certified_cfl(nopd1d_n1_order1, steps[0].window.high) ==
          std::max(steps[0].cfl, steps[1].cfl));
    CHECK(nmbc::certified_cfl(nopd1d_n2_order2, 1) == 0);
    // At the very edge of the window, 3.7742, no step is certified, and that is what is said.
    CHECK(nmbc::certified_grade(nopd1d_n2_order2, 3.774) != nmbc::Grade::none);
    CHECK(nmbc::certified_choices(nopd1d_n2_order2, 3.774).find("at this G") == std::string::npos);
    CHECK(nmbc::certified_choices(nopd1d_n2_order2, 3.774, nmbc::generated::tables)
              .ends_with("at this G: NMBC1 with stride 2"));
    CHECK_THROWS_WITH_AS(nmbc::stable_time_step(nopd1d_n2_order2, 1, 1, 1),
                         doctest::Contains("no time step at G = 1"), nmbc::NotCertified);
}

TEST_CASE("certified steps may begin above 0, and where two pieces meet the longer ones hold") {
    constexpr nmbc::StableStep steps[]{{{0, 1}, 0.5, 0.125}, {{1, 2}, 0.75}};
    nmbc::MatchingTable table = nopd1d_n1_order1;
    table.max_cfl = steps;
    table.max_cfl_contractive = {};
    const nmbc::StableStep found = nmbc::certified_steps(table, 0.5);
    CHECK(found.cfl == 0.5);
    CHECK(found.from == 0.125);
    CHECK(found.allows(0.125));
    CHECK(found.allows(0.5));
    CHECK_FALSE(found.allows(0.1249));
    CHECK_FALSE(found.allows(0.5001));
    CHECK(nmbc::certified_steps(table, 1).cfl == 0.75);
    CHECK(nmbc::certified_steps(table, 1).from == 0);
    CHECK(nmbc::certified_steps(table, 3).cfl == 0);
    CHECK(nmbc::certified_steps(table, 0.5, nmbc::Opposite::any).cfl == 0);
    // At n = 1, G = 1/2 omega_max is 2 c/dX, so that dt c/dX is cfl.
    const auto coefficients = nmbc::boundary_coefficients(table, 0.5);
    const auto boundary_in = [&](double time_step) {
        return nmbc::MatchingBoundary(
            coefficients,
            {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = time_step});
    };
    CHECK_NOTHROW(boundary_in(0.125));
    CHECK_NOTHROW(boundary_in(0.5));
    CHECK_THROWS_WITH_AS(boundary_in(0.12), doctest::Contains("it may be 0.125 at least and 0.5"),
                         nmbc::NotCertified);
    CHECK_THROWS_AS(boundary_in(0.51), nmbc::NotCertified);
}

TEST_CASE("an end of another kind needs a smaller time step, or has none") {
    using nmbc::Opposite;
    // A contractive window is one of continuous time: against a fixed end this grows by 9 % per
    // round trip at cfl 0.55, which is certified for like ends.
    constexpr double G = 4;
    REQUIRE(nmbc::certified_grade(nopd1d_n3_order2_s3, G) == nmbc::Grade::contractive);
    const double like = nmbc::certified_cfl(nopd1d_n3_order2_s3, G);
    const double any = nmbc::certified_cfl(nopd1d_n3_order2_s3, G, Opposite::any);
    CHECK(any > 0);
    CHECK(any < 0.5 * like);
    CHECK(nmbc::stable_time_step(nopd1d_n3_order2_s3, G, 1, 1, Opposite::any) ==
          doctest::Approx(any / like * nmbc::stable_time_step(nopd1d_n3_order2_s3, G, 1, 1))
              .epsilon(1e-14));
    // Paired only: none.
    REQUIRE(nmbc::certified_cfl(nopd1d_n1_order1, 0.1) > 0);
    CHECK(nmbc::certified_cfl(nopd1d_n1_order1, 0.1, Opposite::any) == 0);
    CHECK_THROWS_WITH_AS(
        nmbc::stable_time_step(nopd1d_n1_order1, 0.1, 1, 1, Opposite::any),
        doctest::Contains("opposite any end; NMBC1 with stride 1 is certified for G from 0.25"),
        nmbc::NotCertified);
}

}  // namespace
