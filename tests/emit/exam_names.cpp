// SPDX-License-Identifier: GPL-2.0-or-later
/// Names of tables, and the command in their banner.
#include <doctest/doctest.h>

#include <set>

#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"

using namespace nmbcgen;

namespace {

Specification specification(unsigned horizon, unsigned order, unsigned stride,
                            std::optional<Rational> G, const Rational& damping = 0,
                            const Rational& time_step = 0) {
    return {.family = "nopd1d",
            .horizon = horizon,
            .order = order,
            .stride = stride,
            .stabilisation = std::move(G),
            .damping = damping,
            .time_step = time_step};
}

}  // namespace

TEST_CASE("the name leaves out what is usual") {
    CHECK(table_name(specification(2, 3, 1, {})) == "nopd1d_n2_order3");
    CHECK(table_name(specification(2, 3, 2, {})) == "nopd1d_n2_order3_s2");
    CHECK(table_name(specification(12, 1, 1, Rational(1, 2))) == "nopd1d_n12_order1_G1o2");
    CHECK(table_name(specification(1, 2, 3, Rational(6, 4))) == "nopd1d_n1_order2_s3_G3o2");
    CHECK(table_name(specification(1, 1, 1, Rational(2))) == "nopd1d_n1_order1_G2o1");
    CHECK(table_name(specification(1, 1, 1, Rational(0))) == "nopd1d_n1_order1_G0o1");
    CHECK(table_name(specification(2, 2, 1, {}, Rational(2, 20))) == "nopd1d_n2_order2_tau1o10");
    CHECK(table_name(specification(2, 2, 2, Rational(1, 2), 3)) ==
          "nopd1d_n2_order2_s2_tau3o1_G1o2");
    CHECK(table_name(specification(1, 2, 1, {}, 0, Rational(2, 4))) == "nopd1d_n1_order2_dt1o2");
    CHECK(table_name(specification(1, 2, 1, Rational(3), Rational(1, 50), 2)) ==
          "nopd1d_n1_order2_tau1o50_dt2o1_G3o1");
}

TEST_CASE("weights in name and command, and the name of the lattice") {
    Specification what = specification(3, 2, 3, {}, Rational(1, 10));
    what.weights = {1, Rational(2, 3), Rational(1, 3)};
    CHECK(table_name(what) == "nopd1d_n3_w_1o1_2o3_1o3_order2_s3_tau1o10");
    CHECK(regenerating_command(what) ==
          "nmbcgen --family nopd1d --order 2 --horizon 3 --weights 1,2/3,1/3 --stride 3 "
          "--damping 1/10");
    what.points = {{.wave_number = Rational(1, 3), .of_pi = true, .multiplicity = 12},
                   {.wave_number = Rational(12, 10), .of_pi = false, .multiplicity = 2}};
    what.order = 14;
    what.stabilisation = Rational(7, 2);
    what.time_step = Rational(1, 4);
    CHECK(table_name(what) ==
          "nopd1d_n3_w_1o1_2o3_1o3_order14_s3_tau1o10_dt1o4_atpi1o3x12_at6o5x2_G7o2");
    CHECK(lattice_name(what) == "nopd1d_n3_w_1o1_2o3_1o3_tau1o10");
}

TEST_CASE("matching points in name and command") {
    Specification what = specification(1, 4, 1, Rational(1, 2));
    what.points = {{.wave_number = Rational(1, 3), .of_pi = true, .multiplicity = 1},
                   {.wave_number = Rational(12, 10), .of_pi = false, .multiplicity = 2}};
    CHECK(table_name(what) == "nopd1d_n1_order4_atpi1o3x1_at6o5x2_G1o2");
    CHECK(regenerating_command(what) ==
          "nmbcgen --family nopd1d --match 0:3,pi/3:1,6/5:2 --horizon 1 --G 1/2");
    what.points[0].wave_number = Rational(2, 3);
    what.points.pop_back();
    CHECK(matching_text(what) == "0:7,2pi/3:1");
    CHECK(to_string(MatchingPoint{.wave_number = 1, .of_pi = true, .multiplicity = 1}) == "pi");
}

TEST_CASE("the command says all that the name says") {
    CHECK(regenerating_command(specification(2, 3, 1, {})) ==
          "nmbcgen --family nopd1d --order 3 --horizon 2");
    CHECK(regenerating_command(specification(1, 2, 3, Rational(6, 4))) ==
          "nmbcgen --family nopd1d --order 2 --horizon 1 --stride 3 --G 3/2");
    CHECK(regenerating_command(specification(1, 1, 1, Rational(0))) ==
          "nmbcgen --family nopd1d --order 1 --horizon 1 --G 0");
    CHECK(regenerating_command(specification(2, 2, 2, Rational(1, 2), Rational(2, 20))) ==
          "nmbcgen --family nopd1d --order 2 --horizon 2 --stride 2 --damping 1/10 --G 1/2");
    CHECK(regenerating_command(specification(1, 2, 1, Rational(3), Rational(1, 50), 2)) ==
          "nmbcgen --family nopd1d --order 2 --horizon 1 --damping 1/50 --time-step 2 --G 3");
}

TEST_CASE("different requests have different names and commands") {
    std::set<std::string> names;
    std::set<std::string> commands;
    std::size_t requests = 0;
    for (const unsigned horizon : {1U, 2U, 12U}) {
        for (const unsigned order : {1U, 2U, 11U}) {
            for (const unsigned stride : {1U, 2U, 12U}) {
                for (const std::optional<Rational>& G :
                     {std::optional<Rational>{}, std::optional<Rational>{0},
                      std::optional<Rational>{Rational(1, 2)}, std::optional<Rational>{12}}) {
                    for (const Rational& tau : {Rational(0), Rational(1, 2), Rational(12)}) {
                        for (const Rational& dt : {Rational(0), Rational(1, 2), Rational(12)}) {
                            const auto what = specification(horizon, order, stride, G, tau, dt);
                            names.insert(table_name(what));
                            commands.insert(regenerating_command(what));
                            ++requests;
                        }
                    }
                }
            }
        }
    }
    CHECK(requests == 3 * 3 * 3 * 4 * 3 * 3);
    CHECK(names.size() == requests);
    CHECK(commands.size() == requests);
}

TEST_CASE("a projected family's name says all of it, and is read back") {
    const ProjectedFamily P{.family = "nopd2d",
                            .model = {.radius_squared = 4, .poisson = Rational(1, 4)},
                            .polarisation = Polarisation::P};
    CHECK(name_of(P) == "nopd2d_r4_nu1o4_P");
    CHECK(options_of(P) == "--family nopd2d --radius2 4 --nu 1/4 --polarisation P");
    ProjectedFamily S = P;
    S.model.poisson = Rational(-1, 3);
    S.model.plane_strain = true;
    S.polarisation = Polarisation::S;
    CHECK(name_of(S) == "nopd2d_r4_num1o3_strain_S");
    CHECK(options_of(S) == "--family nopd2d --radius2 4 --nu -1/3 --state strain --polarisation S");
    const ProjectedFamily bonds{.family = "bond2d",
                                .model = {.radius_squared = 2, .weights = {1, Rational(1, 2)}}};
    CHECK(name_of(bonds) == "bond2d_r2_w_1o1_1o2_P");
    CHECK(options_of(bonds) == "--family bond2d --radius2 2 --weights 1,1/2 --polarisation P");
    for (const ProjectedFamily& each : {P, S, bonds}) {
        const auto read = projected_family(name_of(each));
        REQUIRE(read);
        CHECK(name_of(*read) == name_of(each));
        CHECK(options_of(*read) == options_of(each));
    }
    for (const char* name : {"nopd1d", "", "nopd2d_r4", "nopd2d_r4_nu1o4_X", "nopd2d_r04_nu1o4_P",
                             "nopd2d_r4_nu2o8_P", "nopd2d_r4_nu1_P", "nopd2d_r4_w_P", "_r1_P_"}) {
        CHECK_FALSE(projected_family(name));
    }
}
