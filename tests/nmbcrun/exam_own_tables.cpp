// SPDX-License-Identifier: GPL-2.0-or-later
/// Tables of the user's own: which of them a scene takes.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun::test {
namespace {

/// A table that nmbcgen made for the tests.
std::string made(const std::string& name) {
    return std::string(NMBC_MADE_TABLES) + "/" + name + ".json";
}

constexpr const char* conical = "nopd1d_n2_w_1o1_1o2_order1_G1o1";
constexpr const char* matched = "nopd1d_n1_order2_at1o2x1_G1o2";
constexpr const char* uncertified = "nopd1d_n2_w_1o1_1o2_order2_s2_G1o1";

Scene scene_with(std::initializer_list<const char*> names) {
    Scene scene;
    scene.horizon = 2;
    scene.G = 1;
    for (const char* name : names) {
        scene.own_tables.push_back(
            std::make_shared<const TableFile>(std::filesystem::path(made(name))));
    }
    return scene;
}

TEST_CASE("the scene's own come first, and those of its lattice alone are looked at") {
    Scene scene = scene_with({uncertified, conical, matched});
    const auto names = [&] {
        std::vector<std::string> list;
        for (const auto* table : tables_of(scene)) {
            list.emplace_back(table->name);
        }
        return list;
    };
    CHECK(std::ranges::count(names(), conical) == 0);  // of another influence
    CHECK(names().front() == "nopd1d_n2_order1");
    scene.weights = {"1", "1/2"};
    CHECK(names() == std::vector<std::string>{uncertified, conical});
    CHECK(table_of(scene, {.order = 1}).name == conical);
    CHECK(uncertified_file(scene, table_of(scene, {.order = 1})) == nullptr);
    CHECK(uncertified_file(scene, table_of(scene, {.order = 2, .stride = 2})) ==
          scene.own_tables.front().get());
    std::string all;
    for (const NamedBoundary& one : boundaries_of(scene)) {
        all += one.name + ", ";
    }
    CHECK_MESSAGE(all.starts_with("fixed, free, NMBC2 s2, NMBC1 s1, higdon 1"), all);
    CHECK_MESSAGE(all.find("truncated") == std::string::npos,
                  all);  // knows constant influence alone
    scene.G = 0.9;       // they are for G = 1
    CHECK(names().empty());
    CHECK_THROWS_WITH_AS(
        table_of(scene, {.order = 3}),
        doctest::Contains(
            "To make it beside the scene: nmbcgen --family nopd1d --order 3 --horizon "
            "2 --weights 1,1/2 --G 9/10 --format json --out FOLDER, and model.tables "
            "= [\"nopd1d_n2_w_1o1_1o2_order3_G9o10.json\"]"),
        SceneError);

    scene = scene_with({matched});
    scene.horizon = 1;
    scene.G = 0.5;
    const std::string of_points = std::string("nopd1d_n1_order2_G1o2, matched at 0:3,1/2:1");
    CHECK(names().front() == of_points);
    CHECK(std::ranges::count(names(), "nopd1d_n1_order2") == 0);  // which it stands for
    CHECK(std::ranges::count(names(), "nopd1d_n1_order3") == 1);
}

TEST_CASE("two tables with the same name for different lattices are refused") {
    Scene scene = scene_with({conical});
    std::ifstream file(made(conical));
    auto json = nlohmann::ordered_json::parse(file);
    json["lattice"].erase("weights");
    json["lattice"]["name"] = "nopd1d_n2";
    scene.own_tables = {std::make_shared<const TableFile>(json.dump(), "forged.json")};
    CHECK_THROWS_WITH_AS(tables_of(scene), doctest::Contains("are of different lattices"),
                         SceneError);
}

}  // namespace
}  // namespace nmbcrun::test
