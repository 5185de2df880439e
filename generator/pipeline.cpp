// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline.hpp"

#include <fmt/format.h>

#include <atomic>

#include "generator/enclosures/prove.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/matching/freeze.hpp"
#include "generator/matching/local.hpp"
#include "generator/matching/matching.hpp"
#include "generator/matching/points.hpp"
#include "generator/matching/proof.hpp"
#include "generator/matching/real.hpp"
#include "generator/matching/reason.hpp"
#include "generator/matching/taylor.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/stability/certify.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

std::vector<ExactFunction> over_first(const std::vector<Polynomial>& numerators,
                                      const Polynomial& first) {
    std::vector<ExactFunction> result;
    result.reserve(numerators.size());
    for (const Polynomial& numerator : numerators) {
        result.push_back(reduce(numerator, first));
    }
    return result;
}

/// What can be said before anything is derived.
void require_sense(const Specification& specification) {
    if (specification.order == 1 && specification.time_step != 0 && specification.points.empty()) {
        throw NoSuchBoundary(
            "NMBC1 is the same in time steps of any length: it sees a_1 and a_2 only, which they "
            "leave alone. Use it without a time step, or a higher order.");
    }
    if (!specification.points.empty() && !specification.stabilisation) {
        throw std::invalid_argument("matching points need a fixed G");
    }
    unsigned taken = 0;
    Real last = 0;
    for (const MatchingPoint& point : specification.points) {
        taken += point.multiplicity;
        const Real xi = wave_number(point);
        if (xi <= last || xi >= pi()) {
            throw std::invalid_argument("matching points ascend in (0, pi)");
        }
        last = xi;
    }
    if (taken > specification.order) {
        throw std::invalid_argument("more matching points than the order has equations for");
    }
}

}  // namespace

Table derive(const Specification& specification) {
    require_sense(specification);
    Table table{.specification = specification,
                .model = make_model(specification.family, specification.horizon,
                                    specification.damping, specification.weights),
                .taylor = {},
                .c = {},
                .b = {},
                .source = {},
                .proved = {},
                .certificate = std::nullopt};
    table.source = "Nicely 2018: Taylor coefficients (47), matching (49), ghost layers (60)";

    const GiNaC::symbol G("G");
    Dispersion dispersion;
    dispersion.time_step = thaw(constant(specification.time_step), G);
    for (const Polynomial& coefficient : symbol_of(table)) {
        dispersion.symbol.push_back(thaw(coefficient, G));
    }
    for (const Rational& coefficient : table.model.damping) {
        dispersion.damping.push_back(thaw(constant(coefficient), G));
    }
    const auto taylor = taylor_coefficients(dispersion, 2 * specification.order + 1);
    const auto freeze_all = [&G](const std::vector<GiNaC::ex>& expressions) {
        std::vector<Polynomial> frozen;
        frozen.reserve(expressions.size());
        for (const GiNaC::ex& expression : expressions) {
            frozen.push_back(freeze(expression, G));
        }
        return frozen;
    };
    table.taylor = freeze_all({taylor.begin() + 1, taylor.end()});
    if (specification.points.empty()) {
        const auto matching = match(taylor, specification.stride, specification.order);
        if (const Degeneracy found = degeneracy(matching); found != Degeneracy::none) {
            throw NoSuchBoundary(reason(found, specification, dispersion, taylor));
        }
        const auto C = freeze_all(matching.C);
        table.c = over_first(C, C.front());
        table.b = over_first(freeze_all(matching.B), C.front());
    } else {
        try {
            match_at_points(table);
        } catch (const NotMatched& why) {
            throw NoSuchBoundary(fmt::format("there is no such condition: {}", why.what()));
        }
    }
    table.proved = prove(table);
    return table;
}

void certify_all(std::vector<Table>& tables,
                 const std::function<void(std::size_t, std::size_t)>& progress) {
    std::atomic<std::size_t> done = 0;
    on_all_cores(tables.size(), [&](std::size_t i) {
        // The last tables of a set, of large horizons, take longest: nobody is to wait for them.
        Table& table = tables[tables.size() - 1 - i];
        if (!table.certificate) {
            table.certificate = certify(table);
            prove_certificate(table, *table.certificate);
        }
        if (progress) {
            progress(++done, tables.size());
        }
    });
}

std::vector<Specification> committed_set() {
    std::vector<Specification> set;
    for (const unsigned horizon : {1U, 2U, 3U, 4U, 5U}) {
        const unsigned highest_order = horizon <= 3 ? 4 : 1;
        for (unsigned order = 1; order <= highest_order; ++order) {
            set.push_back({.family = "nopd1d",
                           .horizon = horizon,
                           .order = order,
                           .stride = 1,
                           .stabilisation = {}});
        }
    }
    // A stride of n makes orders 2 and 3 stable at G of order 1, where stride 1 is not, and a
    // little damping does below: what `nmbcgen recommend` finds for G = 0, 1/4, 1/2, 1, 3/2 and 2.
    struct Choice {
        unsigned horizon;
        unsigned order;
        unsigned stride;
        Rational damping;
        Rational time_step = 0;
    };
    for (const Choice& choice : {
             Choice{1, 1, 2, 0},
             Choice{1, 2, 2, 0},
             Choice{2, 1, 2, 0},
             Choice{2, 2, 2, 0},
             Choice{2, 3, 2, 0},
             Choice{2, 2, 4, 0},
             Choice{2, 2, 2, Rational(1, 100)},
             Choice{2, 2, 4, Rational(1, 20)},
             Choice{3, 1, 2, 0},
             Choice{3, 1, 3, 0},
             Choice{3, 2, 3, 0},
             Choice{3, 3, 3, 0},
             Choice{3, 2, 3, Rational(1, 100)},
             Choice{3, 2, 3, Rational(1, 50)},
             Choice{3, 2, 3, Rational(1, 20)},
             Choice{3, 2, 4, Rational(1, 10)},
             Choice{4, 1, 2, 0},
             Choice{4, 2, 4, 0},
             Choice{4, 3, 4, 0},
             Choice{4, 2, 4, Rational(1, 50)},
             Choice{4, 2, 4, Rational(1, 10)},
             Choice{4, 2, 6, Rational(1, 5)},
             // Matched in steps of n/2 dX/c, which are certified at some of these G.
             Choice{1, 2, 1, 0, Rational(1, 2)},
             Choice{1, 3, 1, 0, Rational(1, 2)},
             Choice{1, 2, 2, 0, Rational(1, 2)},
             Choice{2, 2, 2, 0, 1},
             Choice{2, 3, 2, 0, 1},
             Choice{2, 2, 4, 0, 1},
             Choice{2, 2, 2, Rational(1, 100), 1},
             Choice{2, 2, 4, Rational(1, 20), 1},
             Choice{3, 2, 3, 0, Rational(3, 2)},
             Choice{3, 2, 3, Rational(1, 100), Rational(3, 2)},
             Choice{3, 2, 4, Rational(1, 10), Rational(3, 2)},
             Choice{4, 2, 4, 0, 2},
             Choice{4, 2, 4, Rational(1, 50), 2},
             Choice{4, 2, 6, Rational(1, 5), 2},
         }) {
        set.push_back({.family = "nopd1d",
                       .horizon = choice.horizon,
                       .order = choice.order,
                       .stride = choice.stride,
                       .stabilisation = {},
                       .damping = choice.damping,
                       .time_step = choice.time_step});
    }
    // What the paper compares with in Fig. 6.
    for (const unsigned order : {1U, 2U, 3U}) {
        set.push_back(
            {.family = "chain1d", .horizon = 1, .order = order, .stride = 1, .stabilisation = {}});
    }
    // P and S waves that meet the side of the paper's plane lattices head-on.
    for (const unsigned horizon : {1U, 2U, 3U}) {
        for (const Polarisation polarisation : {Polarisation::P, Polarisation::S}) {
            const ProjectedFamily projected{
                .family = "nopd2d",
                .model = {.radius_squared = horizon * horizon, .poisson = Rational(1, 4)},
                .polarisation = polarisation};
            for (const auto& [order, stride] : {std::pair(1U, 1U), std::pair(2U, horizon)}) {
                set.push_back({.family = name_of(projected),
                               .horizon = horizon,
                               .order = order,
                               .stride = stride,
                               .stabilisation = {}});
            }
        }
    }
    return set;
}

}  // namespace nmbcgen
