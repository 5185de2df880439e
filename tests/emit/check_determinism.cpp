// SPDX-License-Identifier: GPL-2.0-or-later
/// The same bytes, whatever the algebra system was used for before. GiNaC orders terms by the
/// serial numbers and hashes of symbols, which depend on how many symbols there have been.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <random>
#include <set>
#include <sstream>

#include "generator/emit/emit.hpp"
#include "generator/pipeline.hpp"

using namespace nmbcgen;

namespace {

/// Creates symbols in random number, keeps some and lets some go, and computes with them.
void disturb(std::mt19937_64& random, std::vector<GiNaC::symbol>& kept) {
    const auto below = [&random](std::size_t bound) { return std::size_t(random()) % bound; };
    GiNaC::ex sum = 0;
    for (std::size_t count = below(300); count > 0; --count) {
        const GiNaC::symbol symbol(below(2) == 0 ? "G" : "x" + std::to_string(below(1000)));
        sum += GiNaC::pow(symbol, int(below(5))) * int(below(100));
        if (below(3) == 0) {
            kept.insert(kept.begin() + std::ptrdiff_t(below(kept.size() + 1)), symbol);
        }
    }
    CHECK_FALSE(((sum + 1) * (GiNaC::symbol("y") + 1)).expand().is_zero());
}

/// How GiNaC itself prints one and the same sum at this moment.
std::string ginac_order() {
    GiNaC::ex sum = 0;
    for (const char* name : {"a", "b", "c", "d", "e"}) {
        sum += GiNaC::symbol(name);
    }
    std::ostringstream text;
    text << sum;
    return text.str();
}

std::string committed_set_as_text(std::mt19937_64& random, std::vector<GiNaC::symbol>& kept) {
    std::vector<Table> tables;
    std::string text;
    for (const Specification& specification : committed_set()) {
        disturb(random, kept);
        tables.push_back(derive(specification));
        text += emit_header_with_lattice(tables.back());
    }
    return text + emit_registry(tables) + emit_json(tables);
}

}  // namespace

TEST_CASE("the committed set, many times with scrambled symbols, is the same text") {
#ifdef __SANITIZE_ADDRESS__
    constexpr int runs = 4;  // what sanitizers look for is the same in all
#else
    constexpr int runs = 20;
#endif
    std::mt19937_64 random(20180417);
    std::vector<GiNaC::symbol> kept;
    const std::string first = committed_set_as_text(random, kept);
    CHECK(first.size() > 50000);
    std::set<std::string> orders;
    for (int run = 1; run < runs; ++run) {
        orders.insert(ginac_order());
        REQUIRE(committed_set_as_text(random, kept) == first);
    }
    CHECK(kept.size() > 1000);
    CHECK(orders.size() > 1);  // the disturbance does disturb
}
