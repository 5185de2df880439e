// SPDX-License-Identifier: GPL-2.0-or-later
/// Emitted text: the layout of the JSON, and what no emitted line may contain.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "generator/emit/emit.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/read_tables.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

Table nopd1d_table(unsigned horizon, unsigned order, unsigned stride = 1,
                   std::optional<Rational> G = {}) {
    return derive({.family = "nopd1d",
                   .horizon = horizon,
                   .order = order,
                   .stride = stride,
                   .stabilisation = std::move(G)});
}

/// n = 1: sigma = 2 (1 - cos xi)^2 = 3 - 2 (z + 1/z) + (z^2 + z^-2)/2.
Table damped_table() {
    return derive({.family = "nopd1d",
                   .horizon = 1,
                   .order = 1,
                   .stride = 1,
                   .stabilisation = {},
                   .damping = Rational(1, 4)});
}

Certificate certificate_from_0_to_2() {
    const auto edge = [](int at) {
        return Edge{.where = Bracket{double(at), double(at)}, .inner = double(at)};
    };
    Certificate certificate;
    certificate.modal = {{edge(0), edge(2)}};
    certificate.max_cfl = {{{0, 2}, 0.5, 0.125}};
    certificate.least_nodes = 100;
    return certificate;
}

/// With a space between.
std::string keys(const Json& object) {
    std::string result;
    for (const auto& item : object.items()) {
        result += (result.empty() ? "" : " ") + item.key();
    }
    return result;
}

Json fraction(const std::vector<std::string>& num, const std::vector<std::string>& den) {
    return {{"num", num}, {"den", den}};
}

std::vector<Table> some_tables() {
    std::vector<Table> tables;
    for (const Specification& specification : committed_set()) {
        tables.push_back(derive(specification));
    }
    tables.push_back(nopd1d_table(3, 5, 2, Rational(7, 3)));
    tables.push_back(nopd1d_table(2, 3, 1, Rational(0)));
    return tables;
}

}  // namespace

TEST_CASE("JSON: the keys of schema 4 in order") {
    const std::string schema_4 =
        "schema lattice order stride G time_step taylor c b source proved windows least_nodes "
        "poles max_cfl max_cfl_contractive evidence certificate";
    for (const Table& table : some_tables()) {
        const Json json = Json::parse(emit_json(table));
        CHECK(keys(json) == schema_4);
        CHECK(keys(json["lattice"]) == "name family horizon tau symbol damping energy source");
        CHECK(json["schema"] == 4);
        CHECK(json["lattice"]["energy"].is_array());
        for (const Json& square : json["lattice"]["energy"]) {
            CHECK(keys(square) == "part weight stencil");
        }
    }
}

TEST_CASE("JSON with G left open: rational functions as lists of strings") {
    // n = 1: omega^2 = (1 - cos 2 xi)/2 + 2G(1 - cos)^2, so that s_0 = 1/2 + 3G, s_1 = -2G,
    // s_2 = -1/4 + G/2; a_3 = 1/6 - G/4; NMBC1 is c = (1, 1), b = (-2, 2).
    const Json json = Json::parse(emit_json(nopd1d_table(1, 1)));
    CHECK(json["G"].is_null());
    CHECK(json["order"] == 1);
    CHECK(json["stride"] == 1);
    const Json& lattice = json["lattice"];
    CHECK(lattice["name"] == "nopd1d_n1");
    CHECK(lattice["family"] == "nopd1d");
    CHECK(lattice["horizon"] == 1);
    CHECK(lattice["symbol"] == Json{fraction({"1", "6"}, {"2"}), fraction({"0", "-2"}, {"1"}),
                                    fraction({"-1", "2"}, {"4"})});
    CHECK(json["taylor"] ==
          Json{fraction({"1"}, {"1"}), fraction({"0"}, {"1"}), fraction({"2", "-3"}, {"12"})});
    CHECK(json["c"] == Json{fraction({"1"}, {"1"}), fraction({"1"}, {"1"})});
    CHECK(json["b"] == Json{fraction({"-2"}, {"1"}), fraction({"2"}, {"1"})});
    const Json bond{{"part", "stabilisation"},
                    {"weight", fraction({"0", "1"}, {"1"})},
                    {"stencil", {"1/2", "-1", "1/2"}}};
    CHECK(lattice["energy"] == Json{{{"part", "strain"},
                                     {"weight", fraction({"1"}, {"1"})},
                                     {"stencil", {"-1/2", "0", "1/2"}}},
                                    bond,
                                    bond});
}

TEST_CASE("JSON of a damped table") {
    Table table = damped_table();
    Json json = Json::parse(emit_json(table));
    CHECK(objection(json) == "");
    CHECK(json["lattice"]["name"] == "nopd1d_n1_tau1o4");
    CHECK(json["lattice"]["tau"] == "1/4");
    CHECK(json["lattice"]["damping"] ==
          Json{fraction({"3"}, {"4"}), fraction({"-1"}, {"2"}), fraction({"1"}, {"8"})});
    for (const char* key : {"windows", "least_nodes", "poles", "max_cfl", "max_cfl_contractive",
                            "evidence", "certificate"}) {
        CHECK_MESSAGE(json[key].is_null(), key, " of an uncertified table");
    }
    CHECK(emit_json(read_table(json)) == emit_json(table));
    // What was found of it comes back, and nothing where nothing was sought.
    table.certificate = certificate_from_0_to_2();
    table.certificate->paired = nmbcgen::Evidence::proved;
    json = Json::parse(emit_json(table));
    CHECK(json["windows"]["contractive"].is_null());
    CHECK(json["least_nodes"] == 100);
    CHECK(json["evidence"].dump() ==
          R"({"modal":"proved","contractive":"not sought","max_cfl":"proved",)"
          R"("max_cfl_contractive":"not sought","least_nodes":"sampled"})");
    const auto found = read_table(json).certificate;
    REQUIRE(found);
    CHECK(found->modal.size() == 1);
    CHECK(found->contractive.empty());
    CHECK(found->least_nodes == 100);
    CHECK(found->paired == nmbcgen::Evidence::proved);
    CHECK(found->with_any == nmbcgen::Evidence::sampled);
    REQUIRE(found->max_cfl.size() == 1);
    CHECK(found->max_cfl[0].cfl == 0.5);
    CHECK(found->max_cfl[0].from == 0.125);
    CHECK(json["certificate"].get<std::string>().find("chains of 100 interior nodes and more") !=
          std::string::npos);
    // No reader may take it for an undamped one, or for one of another damping.
    const Json undamped = Json::parse(emit_json(nopd1d_table(1, 1)));
    for (const char* key : {"name", "tau", "damping"}) {
        Json other = json;
        other["lattice"][key] = undamped["lattice"][key];
        CAPTURE(key);
        CHECK(objection(other) != "");
    }
    Json other = json;
    other["lattice"] = undamped["lattice"];
    CHECK(objection(other) != "");
}

TEST_CASE("the header of a damped table") {
    Table table = damped_table();
    table.certificate = certificate_from_0_to_2();
    const std::string header = emit_header_with_lattice(table);
    const std::string damping =
        "inline constexpr RationalFunction damping[]{\n"
        "    {\"3\", \"4\"},\n    {\"-1\", \"2\"},\n    {\"1\", \"8\"},\n};\n";
    for (const std::string& line : std::vector<std::string>{
             "omega, tau and b_j in c/dX", "horizon 1 dX, stride 1, tau = 1/4.\n", damping,
             "    .tau = \"1/4\",\n", "_data::damping,\n", "    .least_nodes = 100,\n",
             "    .reflection = {},  // not sought of a damped lattice\n", "_data::modal,\n",
             "    {{0, 2}, 0.5, 0.125},\n",
             "    .contractive = {},  // not sought of a damped lattice\n",
             "    .max_cfl_contractive = {},  // not sought of a damped lattice\n"}) {
        CAPTURE(line);
        CHECK(header.find(line) != std::string::npos);
    }
    const std::string undamped = emit_header_with_lattice(nopd1d_table(1, 1));
    for (const std::string line :
         {"    .tau = \"0\",\n", "    .damping = {},\n", "    .least_nodes = 0,\n"}) {
        CAPTURE(line);
        CHECK(undamped.find(line) != std::string::npos);
    }
    CHECK(undamped.find("damp") == undamped.find("damping = {}"));
}

TEST_CASE("JSON at a fixed G: every exact number of the condition is one string p/q") {
    // n = 2, N = 2, G = 1: c_1 = -2(85 - 288)/(85 - 128) = -406/43, b_0 = 160/43.
    const Json json = Json::parse(emit_json(nopd1d_table(2, 2, 1, Rational(1))));
    CHECK(json["G"] == "1");
    CHECK(json["c"] == Json{"1", "-406/43", "1"});
    CHECK(json["b"] == Json{"160/43", "0", "-160/43"});
    CHECK(json["taylor"][2] == "289/960");  // (544 - 255)/960
    for (const char* key : {"taylor", "c", "b"}) {
        for (const Json& item : json[key]) {
            CHECK(item.is_string());
        }
    }
    CHECK(json["lattice"] == Json::parse(emit_json(nopd1d_table(2, 2)))["lattice"]);
    CHECK(objection(json).empty());
}

TEST_CASE("the example in docs/reference/json.md is what is emitted, but for long texts") {
    std::ifstream file(NMBC_JSON_PAGE);
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::string fence = "```json\n";
    const std::size_t begin = page.find(fence) + fence.size();
    const Json example = Json::parse(page.substr(begin, page.find("```", begin) - begin));
    std::vector<Table> certified{nopd1d_table(1, 1)};
    certify_all(certified);
    const Json emitted = Json::parse(emit_json(certified.front()));
    Json shown = emitted;
    for (const char* text : {"source", "proved", "evidence", "certificate"}) {
        shown.erase(text);
    }
    CHECK(example.dump() == shown.dump());  // order of keys included
    for (const Json& object : {emitted, emitted["lattice"]}) {
        for (const auto& item : object.items()) {
            CHECK(page.find("`" + item.key() + "`") != std::string::npos);
        }
    }
    // At G = 1/2, a_3 = 1/6 - G/4 = 1/24.
    const Json fixed = Json::parse(emit_json(nopd1d_table(1, 1, 1, Rational(1, 2))));
    CHECK(fixed["G"] == "1/2");
    CHECK(fixed["taylor"] == Json{"1", "0", "1/24"});
}

TEST_CASE("JSON of tables outside the committed set reads back and proves") {
    for (const Table& table : some_tables()) {
        const Json json = Json::parse(emit_json(table));
        CHECK(objection(json) == "");
        CHECK(emit_json(read_table(json)) == emit_json(table));
    }
}

TEST_CASE("the banner of a header: version, command, source, units, proof") {
    const Table table = nopd1d_table(2, 3, 2, Rational(1, 3));
    std::istringstream lines(emit_header(table));
    std::string line;
    std::getline(lines, line);
    CHECK(line == "// SPDX-License-Identifier: MIT");
    std::getline(lines, line);
    CHECK(std::regex_match(line,
                           std::regex(R"(// GENERATED by nmbcgen \d+\.\d+\.\d+\. Do not edit\. )"
                                      R"(Regenerate: nmbcgen --family nopd1d --order 3 )"
                                      R"(--horizon 2 --stride 2 --G 1/3 --uncertified)")));
    std::getline(lines, line);
    CHECK(line.find("here G = 1/3") != std::string::npos);
    std::getline(lines, line);
    CHECK(line == "// source  " + table.model.source + "; " + table.source);
    std::getline(lines, line);
    CHECK(line.starts_with("// units"));
    std::getline(lines, line);
    CHECK(line.starts_with("// sign"));
    std::getline(lines, line);
    CHECK(line == "// proved  " + table.proved);
    std::getline(lines, line);
    CHECK(line == "// stable  not examined");
    std::getline(lines, line);
    CHECK(line == "#pragma once");
}

TEST_CASE("no emitted line contains a date, a time or a path") {
    const std::vector<Table> tables = some_tables();
    std::string text = emit_registry(tables) + emit_json(tables);
    for (const Table& table : tables) {
        text += emit_header(table) + emit_lattice_header(table);
    }
    const std::regex forbidden(
        R"((^|[^\w<])[/~]\w)"            // an absolute path; "//" comments and "p/q" are not
        R"(|\.\./|\w:\\)"                // a relative one
        R"(|\d{4}-\d\d-\d\d|\d\d:\d\d)"  // an ISO date, a time
        R"(|(Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)[a-z]* +\d)");
    std::istringstream lines(text);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        CAPTURE(line);
        REQUIRE_FALSE(std::regex_search(line, forbidden));
    }
    CHECK(count > 1000);
    CHECK(text.find(std::filesystem::current_path().string()) == std::string::npos);
    // The pattern does find what it is meant to find.
    for (const char* line : {"// made in /home/someone", "see ../generated", "// 2018-04-27",
                             "at 12:30", "Apr 27 2018", "\"~me\""}) {
        CHECK(std::regex_search(line, forbidden));
    }
}

TEST_CASE("the windows of a certified table, and of one that is not") {
    std::vector<Table> tables{nopd1d_table(1, 2)};
    CHECK(emit_header(tables[0]).find("not examined") != std::string::npos);
    CHECK(emit_header(tables[0]).find(".modal = {},") != std::string::npos);
    CHECK(Json::parse(emit_json(tables[0]))["certificate"].is_null());
    certify_all(tables);
    const std::string header = emit_header(tables[0]);
    // (54) and theory: the modal window is [1/4, 1], the paper's (0, 1].
    for (const std::string line :
         {"    // 0 .. 1\n    {0, 1},\n",
          "    // low: 1/4, beyond it: backward band at xi = 3.09\n"
          "    // high: 1, beyond it: resonance at xi = 3.14\n    {0.25, 1},\n",
          "    .modal = nopd1d_n1_order2_data::modal,\n"}) {
        CHECK(header.find(line) != std::string::npos);
    }
    const Json windows = Json::parse(emit_json(tables[0]))["windows"];
    CHECK(windows["modal"][0][0]["exact"] == "1/4");
    CHECK(windows["modal"][0][0]["beyond"] == "backward band");
    CHECK(windows["reflection"][0][1]["value"] == 1.0);
}
