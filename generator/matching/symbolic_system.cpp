// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/symbolic_system.hpp"

#include <string>

#include "generator/exact/rational_function.hpp"
#include "generator/matching/freeze.hpp"
#include "generator/matching/matching.hpp"

namespace nmbcgen {

struct SymbolicSystem::Symbols {
    unsigned order;
    std::vector<GiNaC::ex> taylor{};
    GiNaC::ex dX = GiNaC::symbol("dX");
    GiNaC::exmap numbers{};
    MatchingPolynomials found{};
};

SymbolicSystem::SymbolicSystem(unsigned order) : symbols_(new Symbols{.order = order}) {
    for (unsigned k = 0; k <= 2 * order; ++k) {
        if (k % 2 == 0) {
            symbols_->taylor.emplace_back(0);
            continue;
        }
        symbols_->taylor.emplace_back(GiNaC::symbol("a" + std::to_string(k)));
        symbols_->numbers[symbols_->taylor.back()] =
            GiNaC::numeric(long(k * k % 11) + 1, long(k) + 2);
    }
    symbols_->numbers[symbols_->dX] = GiNaC::numeric(3, 7);
}

SymbolicSystem::~SymbolicSystem() = default;

void SymbolicSystem::solve() {
    symbols_->found = match(symbols_->taylor, symbols_->dX, symbols_->order);
}

std::vector<Rational> SymbolicSystem::values() const {
    const GiNaC::symbol none("none");
    const auto& [C, B] = symbols_->found;
    const GiNaC::ex first = C.at(0).subs(symbols_->numbers);
    std::vector<Rational> values;
    for (const auto* list : {&C, &B}) {
        for (const GiNaC::ex& coefficient : *list) {
            const GiNaC::ex value = coefficient.subs(symbols_->numbers) / first;
            values.push_back(evaluate(freeze(value, none), 0));
        }
    }
    return values;
}

}  // namespace nmbcgen
