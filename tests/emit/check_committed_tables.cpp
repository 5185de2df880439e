// SPDX-License-Identifier: GPL-2.0-or-later
/// The committed set, as its readers get it: every table proves, headers and tables.json agree.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <nmbc/tables/tables.hpp>
#include <set>
#include <string_view>

#include "generator/emit/emit.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/read_tables.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

Json committed_json() {
    std::ifstream file(NMBC_TABLES_JSON);
    REQUIRE(file);
    return Json::parse(file);
}

}  // namespace

TEST_CASE("every committed header proves") {
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        CAPTURE(table->name);
        CHECK(objection(*table) == "");
    }
}

TEST_CASE("every table of tables.json proves") {
    CHECK(file_objection(committed_json()) == "");
}

TEST_CASE("the registry is the committed set, and holds the same data as tables.json") {
    const auto set = committed_set();
    const Json json = committed_json();
    REQUIRE(std::size(nmbc::generated::tables) == set.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        const nmbc::MatchingTable& header = *nmbc::generated::tables[i];
        CAPTURE(header.name);
        CHECK(header.name == table_name(set[i]));
        // Through exact data and out again, both are the same text. A header has no exact ends of
        // windows; its rounded ones have to be those of the JSON.
        const Json one = with_lattice(json, i);
        const Table other = read_table(one);
        Table table = read_table(header);
        table.certificate = other.certificate;
        const std::string text = emit_json(table);
        CHECK(text == emit_json(other));
        REQUIRE(header.modal.size() == other.certificate->modal.size());
        for (std::size_t k = 0; k < header.modal.size(); ++k) {
            const nmbcgen::StabilityWindow& window = other.certificate->modal[k];
            CHECK(header.modal[k].low == window.low.inner);
            CHECK(header.modal[k].high == (window.high ? window.high->inner : nmbc::unbounded));
        }
        CHECK(header.contractive.size() == other.certificate->contractive.size());
        CHECK(header.reflection.size() == other.certificate->reflection.size());
        CHECK(header.max_cfl.size() == other.certificate->max_cfl.size());
        CHECK(header.max_cfl_contractive.size() == other.certificate->max_cfl_contractive.size());
        CHECK(Json::parse(text) == one);
    }
}

TEST_CASE("tables of one lattice share it, in the registry and in tables.json") {
    const Json json = committed_json();
    std::set<std::string_view> names;
    for (const nmbc::LatticeTable* lattice : nmbc::generated::lattices) {
        CHECK(names.insert(lattice->name).second);
        CHECK(nmbc::find_lattice(nmbc::generated::lattices, lattice->family, lattice->horizon,
                                 lattice->tau) == lattice);
    }
    CHECK(json["lattices"].size() == names.size());
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        CHECK(std::ranges::count(nmbc::generated::lattices, table->lattice) == 1);
        for (const nmbc::LatticeTable* lattice : nmbc::generated::lattices) {
            CHECK(is_same_lattice(*lattice, *table->lattice) == (lattice == table->lattice));
        }
    }
    CHECK(nmbc::find_lattice(nmbc::generated::lattices, "nopd1d", 1, "1/7") == nullptr);
    CHECK(nmbc::find_lattice(nmbc::generated::lattices, "nopd1d", 2, "0", "1,1/2") == nullptr);
}
