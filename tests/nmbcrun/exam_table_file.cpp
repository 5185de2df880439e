// SPDX-License-Identifier: GPL-2.0-or-later
/// Tables of the user's own: what is read is what nmbcgen wrote, and nonsense is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <nmbc/tables/tables.hpp>
#include <sstream>
#include <string>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace nmbcrun::test {
namespace {

using Json = nlohmann::ordered_json;

Json committed() {
    std::ifstream file(NMBC_TABLES_JSON);
    REQUIRE(file);
    return Json::parse(file);
}

bool same(const nmbc::EnergySquare& one, const nmbc::EnergySquare& other) {
    return one.part == other.part && one.weight == other.weight && one.stencil == other.stencil &&
           one.divisor == other.divisor;
}

bool same(const nmbc::Window& one, const nmbc::Window& other) {
    return one.low == other.low && one.high == other.high;
}

bool same(const nmbc::StableStep& one, const nmbc::StableStep& other) {
    return same(one.window, other.window) && one.cfl == other.cfl && one.from == other.from;
}

template <class Item>
bool same(std::span<const Item> one, std::span<const Item> other) {
    return std::ranges::equal(one, other, [](const Item& a, const Item& b) { return same(a, b); });
}

TEST_CASE("every committed table is read from tables.json as it is compiled") {
    const TableFile file{std::filesystem::path(NMBC_TABLES_JSON)};
    REQUIRE(file.tables().size() == std::size(nmbc::generated::tables));
    for (std::size_t i = 0; i < file.tables().size(); ++i) {
        const OwnTable& own = file.tables()[i];
        const nmbc::MatchingTable& read = own.table;
        const nmbc::MatchingTable& compiled = *nmbc::generated::tables[i];
        CAPTURE(compiled.name);
        CHECK(own.is_certified);
        CHECK(read.name == compiled.name);
        CHECK(read.lattice->name == compiled.lattice->name);
        CHECK(read.lattice->family == compiled.lattice->family);
        CHECK(read.lattice->horizon == compiled.lattice->horizon);
        CHECK(read.lattice->weights == compiled.lattice->weights);
        CHECK(read.lattice->tau == compiled.lattice->tau);
        CHECK(read.lattice->source == compiled.lattice->source);
        CHECK(is_same_lattice(*read.lattice, *compiled.lattice));
        CHECK(same(read.lattice->energy, compiled.lattice->energy));
        CHECK(read.order == compiled.order);
        CHECK(read.stride == compiled.stride);
        CHECK(read.fixed_G == compiled.fixed_G);
        CHECK(read.time_step == compiled.time_step);
        CHECK(read.source == compiled.source);
        CHECK(read.proved == compiled.proved);
        CHECK(std::ranges::equal(read.taylor, compiled.taylor));
        CHECK(std::ranges::equal(read.c, compiled.c));
        CHECK(std::ranges::equal(read.b, compiled.b));
        CHECK(same(read.reflection, compiled.reflection));
        CHECK(same(read.modal, compiled.modal));
        CHECK(same(read.contractive, compiled.contractive));
        CHECK(same(read.max_cfl, compiled.max_cfl));
        CHECK(same(read.max_cfl_contractive, compiled.max_cfl_contractive));
        CHECK(read.least_nodes == compiled.least_nodes);
    }
}

/// What is wrong with a text; empty where nothing is.
std::string refusal(const std::string& text) {
    try {
        const TableFile file(text, "mine.json");
        return "";
    } catch (const SceneError& error) {
        return error.what();
    }
}

Json named(const Json& list, const char* key, const char* value) {
    const auto found =
        std::ranges::find_if(list, [&](const Json& each) { return each[key] == value; });
    REQUIRE(found != list.end());
    return *found;
}

/// A table with all kinds of entries: tau > 0, windows with and without an end.
Json damped() {
    const Json all = committed();
    Json table = named(all["tables"], "lattice", "nopd1d_n2_tau1o100");
    table["lattice"] = named(all["lattices"], "name", "nopd1d_n2_tau1o100");
    table.erase("evidence");  // which is not read: a run finds its own
    return table;
}

TEST_CASE("a key that is missing, of another type or another length") {
    const Json table = damped();
    REQUIRE(refusal(table.dump()) == "");
    // Changes a key of the table, or of its lattice.
    const auto try_key = [&](const std::string& key, const auto& object_of) {
        CAPTURE(key);
        const auto changed = [&](const auto& change) {
            Json wrong = table;
            change(object_of(wrong));
            return refusal(wrong.dump());
        };
        CHECK(changed([&](Json& object) {
                  object.erase(key);
              }).ends_with(" has no key \"" + key + "\""));
        for (const Json& other : {Json(true), Json(-1), Json(1.5), Json("?"), Json({{"x", 1}})}) {
            const bool is_free_text =
                other == "?" && (key == "source" || key == "proved" || key == "certificate");
            CHECK(changed([&](Json& object) { object[key] = other; }).empty() == is_free_text);
        }
        Json whole = table;
        const Json value = object_of(whole)[key];
        if (value.is_array() && !value.empty() && !key.starts_with("max_cfl")) {
            CHECK(changed([&](Json& object) { object[key].erase(value.size() - 1); }) != "");
            CHECK(changed([&](Json& object) { object[key].push_back(value[0]); }) != "");
        }
    };
    for (const auto& item : table.items()) {
        if (item.key() != "poles") {  // which runs do not need
            try_key(item.key(), [](Json& whole) -> Json& { return whole; });
        }
    }
    for (const auto& item : table["lattice"].items()) {
        try_key(item.key(), [](Json& whole) -> Json& { return whole["lattice"]; });
    }
}

TEST_CASE("what is wrong is said, with its place and what is allowed") {
    using Change = std::function<void(Json&)>;
    const auto refuses = [table = damped()](const Change& change, const std::string& message) {
        Json wrong = table;
        change(wrong);
        CHECK(refusal(wrong.dump()) == message);
    };
    refuses([](Json& t) { t["schema"] = 3; }, "mine.json: schema must be 4, not 3");
    refuses([](Json& t) { t["order"] = 0; },
            "mine.json: order must be a whole number from 1 to 100, not 0");
    refuses([](Json& t) { t["order"] = 18446744073709551615U; },
            "mine.json: order must be a whole number from 1 to 100, not 18446744073709551615");
    refuses([](Json& t) { t["lattice"]["horizon"] = 1e300; },
            "mine.json: lattice.horizon must be a whole number from 1 to 100, not 1e+300");
    const std::string exact = " must be an exact number \"p/q\" in lowest terms, not below 0, not ";
    refuses([](Json& t) { t["lattice"]["tau"] = "2/200"; },
            "mine.json: lattice.tau" + exact + "\"2/200\"");
    refuses([](Json& t) { t["lattice"]["tau"] = "1/0"; },
            "mine.json: lattice.tau" + exact + "\"1/0\"");
    refuses([](Json& t) { t["lattice"]["tau"] = "-1"; },
            "mine.json: lattice.tau" + exact + "\"-1\"");
    const std::string integer = " must be an integer in a string, not ";
    refuses([](Json& t) { t["c"][1]["num"][0] = "1x"; },
            "mine.json: c[1].num[0]" + integer + "\"1x\"");
    refuses([](Json& t) { t["c"][1]["num"][0] = "-0"; },
            "mine.json: c[1].num[0]" + integer + "\"-0\"");
    refuses([](Json& t) { t["c"][1]["num"][0] = "007"; },
            "mine.json: c[1].num[0]" + integer + "\"007\"");
    refuses([](Json& t) { t["c"][1]["num"][0] = std::string(10'001, '7'); },
            "mine.json: c[1].num[0]" + integer + "\"" + std::string(59, '7') + "..");
    refuses([](Json& t) { t["c"][1]["num"][0] = 7; },
            "mine.json: c[1].num[0] must be a string, "
            "not 7");
    refuses([](Json& t) { t["b"][0]["den"] = Json::array(); },
            "mine.json: b[0].den must be a list of one integer or more, not a list of 0");
    refuses(
        [](Json& t) {
            t["b"][0]["den"] = {"1", "0"};
        },
        "mine.json: b[0].den must be a list of integers of which the last is positive, not a "
        "list of 2");
    refuses([](Json& t) { t["c"][0]["num"][0] = "2"; },
            "mine.json: c must be a list that begins with 1, not a list of 3");
    refuses([](Json& t) { t["c"].erase(0); }, "mine.json: c must be a list of 3, not a list of 2");
    refuses([](Json& t) { t["lattice"]["symbol"][1]["num"][0] = "5"; },
            "mine.json: lattice.symbol must be the symbol of \"energy\", not a list of 5");
    refuses(
        [](Json& t) {
            t["lattice"]["symbol"][1]["den"] = {"1", "1"};
        },
        "mine.json: lattice.symbol[1] must be a polynomial in G: \"den\" a list of one, not an "
        "object");
    refuses(
        [](Json& t) {
            t["lattice"]["damping"][1]["num"] = {"1", "1"};
        },
        "mine.json: lattice.damping must be a list of numbers, the same at every G, not a list of "
        "5");
    refuses([](Json& t) { t["lattice"]["energy"][0]["weight"]["num"][0] = "-1"; },
            "mine.json: lattice.energy[0].weight must be not below 0, not an object");
    refuses(
        [](Json& t) {
            t["lattice"]["energy"].erase(t["lattice"]["energy"].begin(),
                                         t["lattice"]["energy"].end());
            t["lattice"]["energy"].push_back({{"part", "strain"},
                                              {"weight", {{"num", {"1"}}, {"den", {"1"}}}},
                                              {"stencil", {"0", "2", "-2"}}});
            t["lattice"]["symbol"] = {{{"num", {"8"}}, {"den", {"1"}}},
                                      {{"num", {"-4"}}, {"den", {"1"}}}};
            t["lattice"]["damping"].erase(t["lattice"]["damping"].begin() + 2,
                                          t["lattice"]["damping"].end());
        },
        "mine.json: lattice.symbol must be that of omega^2 = xi^2 + .., not a list of 2");
    refuses([](Json& t) { t["lattice"]["energy"][0]["part"] = "heat"; },
            R"(mine.json: lattice.energy[0].part must be "strain" or "stabilisation", not "heat")");
    refuses([](Json& t) { t["lattice"]["energy"][0]["stencil"][0] = "1/-2"; },
            "mine.json: lattice.energy[0].stencil[0] must be an exact number \"p/q\" or \"p\", not "
            "\"1/-2\"");
    refuses([](Json& t) { t["lattice"]["energy"][0]["stencil"].erase(0); },
            "mine.json: lattice.energy[0].stencil must be a list of an odd number of entries, up "
            "to 9, not "
            "a list of 4");
    refuses(
        [](Json& t) {
            t["windows"]["modal"][0] = {nullptr, nullptr};
        },
        "mine.json: windows.modal[0][0] must be an object, not null");
    refuses([](Json& t) { t["max_cfl"][0]["cfl"] = 1.5; },
            "mine.json: max_cfl[0].cfl must be a number from 0 to 1, not 1.5");
    refuses([](Json& t) { t["certificate"] = nullptr; },
            "mine.json: certificate must be a string where there are windows and steps, not null");
    refuses([](Json& t) { t["lattice"]["name"] = "nopd1d_n2"; },
            R"(mine.json: lattice.name must be "nopd1d_n2_tau1o100", not "nopd1d_n2")");
    refuses(
        [](Json& t) {
            t["lattice"]["weights"] = {"1", "0"};
        },
        "mine.json: lattice.weights[1] must be another number than 0, not \"0\"");
    for (const Json& weights : {Json({"1"}), Json({"1", "1"}), Json({"2", "1"})}) {
        Json wrong = damped();
        wrong["lattice"]["weights"] = weights;
        CHECK(refusal(wrong.dump())
                  .starts_with("mine.json: lattice.weights must be a list of 2, the first "
                               "of them \"1\" or \"-1\", and left out where all of them "
                               "are \"1\", not a list of "));
    }
    Json two = committed();
    CHECK(refusal(two.dump()) == "");
    two["tables"][0]["lattice"] = "nopd1d_n9";
    CHECK(refusal(two.dump()) ==
          "mine.json: tables[0].lattice must be the name of one of the "
          "lattices, not \"nopd1d_n9\"");
    two = committed();
    two["tables"][1]["b"][2]["num"] = nullptr;
    CHECK(refusal(two.dump()) == "mine.json: tables[1].b[2].num must be a list, not null");
}

TEST_CASE("a text that is no table") {
    const std::string table = damped().dump();
    for (std::size_t size = 0; size < table.size(); size += 97) {
        CHECK(refusal(table.substr(0, size)).starts_with("mine.json is no JSON: parse error"));
    }
    CHECK(refusal("[]") == "mine.json must be an object, not a list of 0");
    CHECK(refusal("null") == "mine.json must be an object, not null");
    CHECK(refusal("{}") == "mine.json has no key \"schema\"");
    CHECK(refusal(table + "x").starts_with("mine.json is no JSON"));
    CHECK(refusal("\xff\xfe").starts_with("mine.json is no JSON"));
    const std::string deep = "mine.json is no table of nmbcgen: it is nested too deeply";
    std::string lists;
    lists.resize(15'000'000, '[');
    CHECK(refusal(lists) == deep);
    std::string objects;
    for (int i = 0; i < 1'000'000; ++i) {
        objects += R"({"a":)";
    }
    CHECK(refusal(objects) == deep);
}

}  // namespace
}  // namespace nmbcrun::test
