// SPDX-License-Identifier: GPL-2.0-or-later
/// Mutation test: no number of the committed set can be changed unnoticed. Every number of every
/// header's table and of tables.json is changed by one, in its sign and in each of its digits;
/// each time the verification that passes on the committed set has to fail.
/// The certificates of stability are not among them: to verify one is to find it again, and that
/// is what the test tables_up_to_date does.
#include <doctest/doctest.h>

#include <fstream>
#include <nmbc/tables/tables.hpp>

#include "tests/support/mutations.hpp"
#include "tests/support/read_tables.hpp"

using namespace nmbcgen::test;

namespace {

/// A header's table with its own copy of everything, so that it can be changed.
struct Copy {
    explicit Copy(const nmbc::MatchingTable& from) : table(from), lattice(*from.lattice) {
        lattice.symbol = symbol;
        lattice.damping = damping;
        lattice.energy = energy;
        table.lattice = &lattice;
        table.taylor = taylor;
        table.c = c;
        table.b = b;
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;

    std::vector<std::string_view*> texts() {
        std::vector<std::string_view*> all{&table.name,     &table.fixed_G, &table.time_step,
                                           &table.source,   &table.proved,  &lattice.name,
                                           &lattice.family, &lattice.tau,   &lattice.source};
        for (auto* list : {&symbol, &damping, &taylor, &c, &b}) {
            for (nmbc::RationalFunction& function : *list) {
                all.insert(all.end(), {&function.numerator, &function.denominator});
            }
        }
        for (nmbc::EnergySquare& square : energy) {
            all.insert(all.end(), {&square.weight.numerator, &square.weight.denominator,
                                   &square.stencil, &square.divisor});
        }
        return all;
    }

    nmbc::MatchingTable table;
    nmbc::LatticeTable lattice;
    std::vector<nmbc::RationalFunction> symbol{lattice.symbol.begin(), lattice.symbol.end()};
    std::vector<nmbc::RationalFunction> damping{lattice.damping.begin(), lattice.damping.end()};
    std::vector<nmbc::EnergySquare> energy{lattice.energy.begin(), lattice.energy.end()};
    std::vector<nmbc::RationalFunction> taylor{table.taylor.begin(), table.taylor.end()};
    std::vector<nmbc::RationalFunction> c{table.c.begin(), table.c.end()};
    std::vector<nmbc::RationalFunction> b{table.b.begin(), table.b.end()};
};

struct Count {
    int mutants = 0;
    int survivors = 0;
    int disproved = 0;  // by prove() or by nmbcrun's reader, not for their form, name or family

    void add(const std::string& found, const std::string& mutant) {
        ++mutants;
        survivors += int(found.empty());
        disproved += int(found.starts_with("not proved") ||
                         found.find("the symbol of") != std::string::npos);
        CHECK_MESSAGE(!found.empty(), "survived: ", mutant);
    }

    /// Form and names alone catch some mutants; most can be told only by computing.
    void report(const std::string& where) const {
        MESSAGE(mutants, " mutants of ", where, ", ", disproved, " disproved, ",
                mutants - disproved - survivors, " malformed or of no family, ", survivors,
                " survived");
        CHECK(survivors == 0);
        CHECK(mutants > 5000);
        CHECK(disproved > mutants / 2);
    }
};

void try_mutants(const nmbc::MatchingTable& original, Count& count) {
    Copy copy(original);
    REQUIRE(objection(copy.table) == "");
    for (std::string_view* text : copy.texts()) {
        const std::string_view before = *text;
        for (const std::string& mutant : mutations(std::string(before))) {
            *text = mutant;
            count.add(objection(copy.table), std::string(original.name) + ": " + mutant);
        }
        *text = before;
    }
    for (int* number : {&copy.lattice.horizon, &copy.table.order, &copy.table.stride}) {
        const int before = *number;
        for (const std::string& mutant : mutations(std::to_string(before))) {
            *number = std::stoi(mutant);
            count.add(objection(copy.table), std::string(original.name) + ": " + mutant);
        }
        *number = before;
    }
    REQUIRE(objection(copy.table) == "");
}

/// Changes every number below `part`, which lies in `whole`; verify looks at the whole.
template <class Check>
void try_mutants(Json& part, Count& count, const Check& verify) {
    if (part.is_structured()) {
        for (Json& child : part) {
            try_mutants(child, count, verify);
        }
    } else if (part.is_string() || part.is_number()) {
        const Json before = part;
        const auto text = before.is_string() ? before.get<std::string>() : before.dump();
        for (const std::string& mutant : mutations(text)) {
            part = before.is_string() ? Json(mutant) : Json::parse(mutant, nullptr, false);
            count.add(verify(), mutant);
        }
        part = before;
    }
}

}  // namespace

TEST_CASE("the mutations of a text") {
    CHECK(mutations("12 -7") ==
          std::set<std::string>{"13 -7", "11 -7", "-12 -7", "22 -7", "12 -8", "12 -6", "12 7"});
    CHECK(mutations("0") == std::set<std::string>{"1"});
    CHECK(mutations("1/99") ==
          std::set<std::string>{"2/99", "0/99", "-1/99", "1/100", "1/98", "1/-99", "1/09", "1/90"});
    CHECK(mutations("none").empty());
}

TEST_CASE("headers: every mutant is caught") {
    Count count;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        try_mutants(*table, count);
    }
    count.report("the headers' tables");
}

TEST_CASE("tables.json: every mutant is caught") {
    const std::set<std::string> certificate_keys{"windows",    "least_nodes",         "poles",
                                                 "max_cfl",    "max_cfl_contractive", "evidence",
                                                 "certificate"};
    std::ifstream stream(NMBC_TABLES_JSON);
    Json file = Json::parse(stream);
    REQUIRE(file_objection(file) == "");
    Count count;
    for (std::size_t i = 0; i < file["tables"].size(); ++i) {
        // One table at a time: the others are as they were, and have been verified.
        Json table = with_lattice(file, i);
        for (const auto& [key, part] : table.items()) {
            if (!certificate_keys.contains(key)) {
                try_mutants(part, count, [&table] { return objection(table); });
            }
        }
    }
    try_mutants(file["schema"], count, [&file] { return file_objection(file); });
    REQUIRE(file_objection(file) == "");
    count.report("tables.json");
}
