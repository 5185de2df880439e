// SPDX-License-Identifier: GPL-2.0-or-later
/// A plane that is started with the fields of another run.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"
#include "tools/nmbcrun/plane/plane_fields.hpp"
#include "tools/nmbcrun/plane/plane_spectrum.hpp"

namespace nmbcrun::test {
namespace {

void write_csv(const PlaneSimulation& simulation, const std::filesystem::path& file) {
    std::ofstream stream(file);
    stream << "x,y,ux,uy,vx,vy\n";
    const auto [before, nodes] = simulation.body();
    for (std::size_t y = 0; y < nodes[1]; ++y) {
        for (std::size_t x = 0; x < nodes[0]; ++x) {
            const std::size_t entry = simulation.entry_of_body(x, y);
            const double X = (double(x + 1) - double(before[0])) * simulation.scene().spacing;
            const double Y = (double(y + 1) - double(before[1])) * simulation.scene().spacing;
            stream << fmt::format(
                "{:.6g},{:.6g},{},{},{},{}\n", X, Y, simulation.plane().displacement(0)[entry],
                simulation.plane().displacement(1)[entry], simulation.plane().velocity(0)[entry],
                simulation.plane().velocity(1)[entry]);
        }
    }
}

TEST_CASE("the field of a run goes on in another, bit for bit") {
    const std::string bonds = "model = { family = 'bond2d', radius2 = 2, weights = [0.4, 0.2] }\n";
    const std::string damped =
        "model = { family = 'nopd2d', radius2 = 1, nu = 0.3, G = 0.5, damping = '1/10' }\n";
    const std::string mixed =
        "[boundary]\nleft.kind = 'periodic'\nright.kind = 'periodic'\ntop.kind = 'fixed'\n"
        "bottom.kind = 'mirror'\n";
    const std::string closed = "[boundary]\nkind = 'sbp'\nleft.kind = 'free'\ntop.kind = 'fixed'\n";
    const std::string higdon = "[boundary]\nkind = 'higdon'\nallow_unstable = true\n";
    const auto hdf5 = file_named("exam_plane_initial.h5");
    const auto csv = file_named("exam_plane_initial.csv");
    const std::vector<std::pair<std::string, std::string>> cases{
        {nopd2d_of_2, free_sides}, {nopd2d_of_2, mixed}, {damped, free_sides},
        {nopd2d_of_2, closed},     {bonds, mixed},       {nopd2d_of_2, higdon}};
    for (const auto& [law, sides] : cases) {
        std::string text = law;
        text += of_lattice;
        text += sides;
        CAPTURE(text);
        PlaneSimulation whole(plane_scene_of(text + packet));
        whole.advance(37);
        write_fields(whole, hdf5);
        write_csv(whole, csv);
        PlaneSimulation by_hdf5(started_from(text, hdf5));
        PlaneSimulation by_csv(started_from(text, csv));
        CHECK(by_hdf5.plan().time_step == whole.plan().time_step);
        CHECK(differences(by_hdf5, whole) == 0);
        // Higdon's condition remembers more than the fields have: not its later steps.
        const std::size_t more = text.find("higdon") == std::string::npos ? 150 : 0;
        whole.advance(more);
        by_hdf5.advance(more);
        by_csv.advance(more);
        CHECK(differences(by_hdf5, whole) == 0);
        CHECK(differences(by_csv, whole) == 0);
    }
}

TEST_CASE("a piece that is cut out of a field, layers of its sides included") {
    const auto file = file_named("exam_plane_initial.h5");
    const std::string text = nopd2d_of_2 + of_lattice;
    PlaneSimulation whole(plane_scene_of(text + free_sides + packet));
    whole.advance(20);
    write_fields(whole, file);
    // The piece's node (0, 0) is the file's (6, 5).
    PlaneScene piece = started_from(text + "[boundary]\nkind = 'extended'\nlayer = 3\n", file,
                                    "origin = [-2.5, -2]\n");
    piece.nodes = {8, 7};
    PlaneSimulation simulation(piece);
    CHECK(differences(simulation, whole, {6, 5}) == 0);
    const std::size_t layer = simulation.entry(0, 0) - 2 * simulation.plane().grid().nx - 3;
    CHECK(simulation.plane().displacement(0)[layer] ==
          whole.plane().displacement(0)[whole.entry(3, 3)]);
    // And one that reaches further than the field has zeros there.
    piece = started_from(text + free_sides, file, "origin = [10, 0.5]\n");
    PlaneSimulation beyond(piece);
    CHECK(beyond.plane().displacement(0)[beyond.entry(18, 17)] == 0);
    CHECK(beyond.plane().displacement(0)[beyond.entry(19, 4)] ==
          whole.plane().displacement(0)[whole.entry(0, 4)]);
}

TEST_CASE("a field without velocities is at rest at t = 0") {
    const auto file = file_named("exam_plane_initial.csv");
    const std::string text = nopd2d_of_2 + of_lattice + free_sides;
    const std::string gaussian =
        "[initial]\nshape = 'gaussian'\ncomponent = 'x'\namplitude = 0.01\ncentre = [6, 4]\n"
        "width = 2\n";
    PlaneSimulation simulation(plane_scene_of(text + gaussian));
    {
        std::ofstream stream(file);
        stream << "uy, ux, y, x\n";
        for (std::size_t y = 0; y < 18; ++y) {
            for (std::size_t x = 0; x < 24; ++x) {
                const auto [X, Y] = position_of(simulation.scene(), x, y);
                stream << fmt::format("0,{},{},{}\n",
                                      simulation.plane().displacement(0)[simulation.entry(x, y)], Y,
                                      X);
            }
        }
    }
    PlaneSimulation by_csv(started_from(text, file));
    simulation.advance(50);
    by_csv.advance(50);
    CHECK(differences(by_csv, simulation) == 0);
}

/// What is said of this initial field's waves, on a lattice with dX = 1/2.
std::string short_waves_of(const std::string& initial, const Overrides& overrides = {}) {
    const auto warnings = warnings_of_short_waves(PlaneSimulation(
        plane_scene_of(nopd2d_of_2 + of_lattice + free_sides + initial, overrides)));
    CHECK(warnings.size() < 2);
    return warnings.empty() ? "" : warnings.front();
}

TEST_CASE("an initial field that the lattice does not resolve is told, with one that it does" *
          doctest::test_suite("long")) {
    const auto hump = [](const char* shape, const char* of, double width) {
        return fmt::format(
            "[initial]\nshape = '{}'\nof = '{}'\namplitude = 0.01\ncentre = [5, 4]\n"
            "width = {}\ncomponent = 'y'\n",
            shape, of, width);
    };
    for (const char* const shape : {"gaussian", "cosine"}) {
        for (const char* const of : {"displacement", "velocity"}) {
            CAPTURE(shape);
            CAPTURE(of);
            CHECK(short_waves_of(hump(shape, of, 6)) == "");
            CHECK(short_waves_of(hump(shape, of, 1e6)) == "");
            const std::string told = short_waves_of(hump(shape, of, 0.1));  // one node
            CHECK(told.find(" % of what initial sends out is in waves so short that the lattice "
                            "disperses them or turns them back; initial.width = ") !=
                  std::string::npos);
            const double would_do = std::stod(told.substr(told.rfind("= ") + 2));
            CHECK(short_waves_of(hump(shape, of, would_do)) == "");
            CHECK(short_waves_of(hump(shape, of, would_do / 1.6)) != "");
        }
    }
    // Of a packet it is the wave that counts: at 0.7 S waves have 0.63 of their speed, at 0.4 0.86.
    const auto of_wave = [](const char* wave_number, const char* width) {
        return short_waves_of(packet,
                              {{"initial.wave_number", wave_number}, {"initial.width", width}});
    };
    CHECK(of_wave("0.4", "9") == "");
    const std::string told = of_wave("2.5", "9");
    CHECK(told.starts_with("100 % of what initial sends out"));
    CHECK(told.find("; initial.wave_number = ") != std::string::npos);
    const std::string would_do = told.substr(told.rfind("= ") + 2, 3);
    CHECK(of_wave(would_do.c_str(), "9") == "");
    CHECK(of_wave("0.4", "0.1")
              .ends_with("; no initial.wave_number within a factor of 1000 cures it"));
}

TEST_CASE("a field from a file is told of its short waves, whatever its size" *
          doctest::test_suite("long")) {
    const auto file = file_named("exam_plane_initial.h5");
    const std::string text = nopd2d_of_2 + of_lattice + free_sides;
    for (const char* const nodes : {"[24, 18]", "[150, 70]", "[3, 90]"}) {
        CAPTURE(nodes);
        const auto told = [&](double width, std::size_t steps) {
            const Overrides overrides{{"domain.nodes", nodes}};
            PlaneSimulation whole(plane_scene_of(
                text + fmt::format("[initial]\nshape = 'gaussian'\namplitude = 0.01\n"
                                   "centre = [1, 4]\nwidth = {}\ncomponent = 'y'\n",
                                   width),
                overrides));
            write_fields(whole, file);
            PlaneScene scene = started_from(text, file, "origin = [0.5, 0.5]\n");
            scene.nodes = whole.scene().nodes;
            PlaneSimulation read(scene);
            read.advance(steps);
            return warnings_of_short_waves(read);
        };
        CHECK(told(5, 0).empty());
        REQUIRE(told(0.3, 0).size() == 1);
        CHECK(told(0.3, 0)[0].ends_with("; a smoother field or a finer lattice has less"));
        CHECK(told(0.3, 1).empty());  // of a run that goes on it has been said
    }
}

}  // namespace
}  // namespace nmbcrun::test
