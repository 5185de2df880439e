// SPDX-License-Identifier: GPL-2.0-or-later
/// Mutation test: no number of the committed set can be changed unnoticed. Every number of every
/// table of tables.json is changed by one, in its sign and in each of its digits; each time the
/// verification that passes on the committed set has to fail. The headers hold the same numbers
/// (check_committed_tables).
/// The certificates of stability are not among them: to verify one is to find it again, and that
/// is what the test tables_up_to_date does.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/support/mutations.hpp"
#include "tests/support/read_tables.hpp"

using namespace nmbcgen::test;

namespace {

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
    void report() const {
        MESSAGE(mutants, " mutants, ", disproved, " disproved, ", mutants - disproved - survivors,
                " malformed or of no family, ", survivors, " survived");
        CHECK(survivors == 0);
        CHECK(mutants > 5000);
        CHECK(disproved > mutants / 2);
    }
};

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

TEST_CASE("every mutant of tables.json is caught") {
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
    count.report();
}
