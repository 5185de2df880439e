// SPDX-License-Identifier: GPL-2.0-or-later
/// What is proved against what knows nothing of the proof: chains as matrices, and reflections.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>

#include "generator/enclosures/prove.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "tests/support/generators.hpp"

namespace {

using nmbcgen::Grade;
using nmbcgen::HalfSpace;
using nmbcgen::LatticeEnd;
using nmbcgen::Prover;
using nmbcgen::Rational;

struct Instance {
    nmbcgen::Table table;
    Prover prover;
};

const std::vector<Instance>& instances() {
    static const std::vector<Instance> all = [] {
        std::vector<Instance> made;
        for (const auto& [horizon, order, stride] :
             {std::tuple(1U, 1U, 1U), std::tuple(1U, 2U, 1U), std::tuple(1U, 3U, 1U),
              std::tuple(1U, 4U, 1U), std::tuple(2U, 1U, 1U), std::tuple(2U, 2U, 2U),
              std::tuple(2U, 3U, 2U), std::tuple(2U, 1U, 2U), std::tuple(2U, 2U, 4U),
              std::tuple(3U, 1U, 1U), std::tuple(3U, 2U, 3U), std::tuple(3U, 3U, 3U),
              std::tuple(4U, 1U, 1U)}) {
            const auto table = nmbcgen::derive(
                {.horizon = horizon, .order = order, .stride = stride, .stabilisation = {}});
            made.push_back({table, Prover(table)});
        }
        return made;
    }();
    return all;
}

/// Of an interval of G.
double width_of_interval() {
    return std::array{0.0, 1e-5, 1e-3, 1e-2}[std::size_t(nmbcgen::test::whole_number(0, 4))];
}

double inside(double G, double width) {
    return G + width * nmbcgen::test::whole_number(0, 1001) / 1000;
}

/// The largest factor of a step; like ends, or a fixed one opposite.
double largest_factor(const HalfSpace& h, double cfl, std::size_t nodes, bool like) {
    const LatticeEnd end{LatticeEnd::Kind::matching, h};
    const double dt = 2 * cfl / maximum_frequency(h);
    return like ? spectral_radius(end, nodes, dt) : spectral_radius(end, fixed_end(h), nodes, dt);
}

TEST_CASE("no chain grows in a step that is proved") {
    CHECK(rc::check([] {
        const Instance& each =
            instances()[std::size_t(nmbcgen::test::whole_number(0, int(instances().size())))];
        const double G = nmbcgen::test::whole_number(1, 4000) / 1024.0;
        const double most = nmbcgen::test::whole_number(1, 100) / 100.0;
        const bool like = nmbcgen::test::whole_number(0, 2) == 0;
        const Grade grade = like ? Grade::paired : Grade::contractive;
        const double width = width_of_interval();
        RC_PRE(each.prover.holds({G, G + width}, most, grade));
        const double stepped = inside(G, width);
        // all orders of magnitude from 1e-5 on alike
        const double cfl =
            1e-5 * std::pow(most / 1e-5, nmbcgen::test::whole_number(0, 1001) / 1000.0);
        const auto nodes = std::size_t(nmbcgen::test::whole_number(60, 100));
        RC_LOG() << each.table.specification.horizon << " " << each.table.specification.order << " "
                 << each.table.specification.stride << " G " << stepped << " cfl " << cfl
                 << " nodes " << nodes << (like ? " like" : " fixed") << '\n';
        // In short steps the double factor 1 of a constant and of a uniform velocity splits by the
        // square root of roundings.
        constexpr double root_of_roundings = 1e-7;
        RC_ASSERT(largest_factor(make_half_space(each.table, Rational(stepped)), cfl, nodes, like) <
                  1 + root_of_roundings);
    }));
}

TEST_CASE("no long chain of a damped lattice grows in a step that is proved") {
    static const std::vector<Instance> damped = [] {
        std::vector<Instance> made;
        for (const auto& [horizon, order, stride] :
             {std::tuple(1U, 1U, 1U), std::tuple(1U, 2U, 1U), std::tuple(2U, 2U, 2U)}) {
            for (const int inverse_tau : {5, 20}) {
                const auto table = nmbcgen::derive({.horizon = horizon,
                                                    .order = order,
                                                    .stride = stride,
                                                    .stabilisation = {},
                                                    .damping = Rational(1, inverse_tau)});
                made.push_back({table, Prover(table)});
            }
        }
        return made;
    }();
    CHECK(rc::check([] {
        const Instance& each =
            damped[std::size_t(nmbcgen::test::whole_number(0, int(damped.size())))];
        const double G = nmbcgen::test::whole_number(256, 3000) / 1024.0;
        const double most = nmbcgen::test::whole_number(1, 100) / 100.0;
        RC_PRE(each.prover.holds({G, G}, most, Grade::paired));
        const double cfl =
            1e-3 * std::pow(most / 1e-3, nmbcgen::test::whole_number(0, 1001) / 1000.0);
        RC_LOG() << each.table.specification.horizon << " " << each.table.specification.order
                 << " G " << G << " cfl " << cfl << '\n';
        // As above. What a chain gains by round trips fades with its length: 120 nodes are mostly
        // enough, not so at n = 1, N = 2, tau = 1/20, G = 365/128, cfl = 0.679 (1e-5 a step).
        constexpr double root_of_roundings = 1e-7;
        const HalfSpace half_space = make_half_space(each.table, Rational(G));
        const bool is_fixed = nmbcgen::test::whole_number(0, 2) == 0;
        const auto decays = [&](std::size_t nodes) {
            return largest_factor(half_space, cfl, nodes, is_fixed) < 1 + root_of_roundings;
        };
        RC_ASSERT(decays(120) || decays(240));
    }));
}

TEST_CASE("in continuous time the sampled grade is what is proved, away from edges") {
    CHECK(rc::check([] {
        const Instance& each =
            instances()[std::size_t(nmbcgen::test::whole_number(0, int(instances().size())))];
        const double G = nmbcgen::test::whole_number(1, 4000) / 1024.0 + 1.0 / 3000;
        const double width = width_of_interval();
        const nmbc::Window all{G, G + width};
        const Grade proved = each.prover.holds(all, 0, Grade::contractive) ? Grade::contractive
                             : each.prover.holds(all, 0, Grade::paired)    ? Grade::paired
                                                                           : Grade::none;
        const Grade sampled =
            stability_grade(make_half_space(each.table, Rational(inside(G, width))));
        RC_LOG() << each.table.specification.horizon << " " << each.table.specification.order << " "
                 << each.table.specification.stride << " G " << G << '\n';
        RC_ASSERT(proved <= sampled);
        RC_CLASSIFY(proved == sampled, "as sampled");
    }));
}

}  // namespace
