// SPDX-License-Identifier: GPL-2.0-or-later
/// Files that a plane scene names, and what is refused of them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/hdf5_file.hpp"
#include "tools/nmbcrun/scene/hdf5_handle.hpp"

namespace nmbcrun::test {
namespace {

/// What is said of the file; empty where it is taken.
std::string refusal_of(const std::filesystem::path& file, const std::string& more = "") {
    try {
        const PlaneSimulation simulation(
            started_from(nopd2d_of_2 + of_lattice + free_sides, file, more));
    } catch (const SceneError& error) {
        return error.what();
    } catch (const FileError& error) {
        return std::string("unreadable: ") + error.what();
    }
    return "";
}

TEST_CASE("csv files that are no field of the scene are refused") {
    const auto file = file_named("exam_plane_initial_bad.csv");
    const std::array<std::array<const char*, 2>, 14> bad{{
        {"", "has no row of numbers"},
        {"x,y,ux,uy\n", "has no row of numbers"},
        {"x,y,ux\n1,1,0\n", ":1: the header has no column 'uy'"},
        {"node,ux,uy\n1,1,0\n", ":1: the header has no column 'x'"},
        {"x,y,ux,uy,vx\n1,1,1,1,1\n", "has only one of the columns 'vx' and 'vy'"},
        {"x,y,ux,uy\n1,1,nan,0\n", ":2: 'nan' is not a finite number"},
        {"x,y,ux,uy\n1,1,1e999,0\n", ":2: '1e999' is not a finite number"},
        {"x,y,ux,uy\n1,1,a,0\n", ":2: 'a' is not a finite number"},
        {"x,y,ux,uy\n1,1,0\n", ":2: column 'uy' is missing"},
        {"x,y,ux,uy\n12.5,1,1,0\n",
         "[12.5, 1] is outside of the plane, whose nodes are at 0.5 to 12 along x"},
        {"x,y,ux,uy\n1,0,1,0\n",
         "[1, 0] is outside of the plane, whose nodes are at 0.5 to 9 along y"},
        {"x,y,ux,uy\n1,1.2,1,0\n",
         "[1, 1.2] is between two nodes, which are at multiples of 0.5 along y"},
        {"x,y,ux,uy\n1,2,1,0\n1,2,1,0\n", "the node at [1, 2] is there twice"},
        {"x,y,ux,uy\n1,2,0,0\n", "moves no node: it has no energy"},
    }};
    for (const auto& one : bad) {
        CAPTURE(one[0]);
        std::ofstream(file) << one[0];
        const std::string refusal = refusal_of(file);
        CAPTURE(refusal);
        CHECK(refusal.find(one[1]) != std::string::npos);
    }
    std::filesystem::remove(file);
    CHECK(refusal_of(file).starts_with("unreadable: cannot read "));
}

/// A file of these datasets, each of zeros but for one value in its middle.
struct Dataset {
    std::string name;
    std::vector<std::size_t> extents;
    double value = 1e-3;
};
void write_hdf5(const std::filesystem::path& path, const std::vector<Dataset>& datasets,
                const Hdf5File::Attributes& attributes = {}) {
    Hdf5File file(path);
    file.describe(attributes);
    for (const auto& [name, extents, value] : datasets) {
        std::size_t size = 1;
        for (const std::size_t extent : extents) {
            size *= extent;
        }
        file.add(name, extents, {});
        std::vector<double> values(size, 0);
        values[std::min<std::size_t>(500, size - 1)] = value;
        file.write(name, values);
    }
    std::vector<nmbcgen::NewFile> files;
    files.push_back(file.whole());
    nmbcgen::publish(files);
}

TEST_CASE("hdf5 files that are no field of the scene are refused") {
    const auto path = file_named("exam_plane_initial_bad.h5");
    const auto says = [&](const std::string& words, const std::string& more = "") {
        const std::string refusal = refusal_of(path, more);
        CAPTURE(refusal);
        CHECK(refusal.find(words) != std::string::npos);
    };
    const std::vector<std::size_t> right{18, 24, 2};
    write_hdf5(path, {{"displacement", right}, {"velocity", {18, 24, 3}, 0}},
               {{"dX", "0.5"}, {"title", "made by hand"}});
    CHECK(refusal_of(path) == "");
    write_hdf5(path, {{"velocity", right}});
    says("has no dataset 'displacement'");
    for (const std::vector<std::size_t>& wrong :
         {std::vector<std::size_t>{18, 24}, {18, 24, 1}, {18, 24, 4}, {2, 18, 24, 3}}) {
        write_hdf5(path, {{"displacement", wrong}});
        says("and must have [ny, nx, 2] or [ny, nx, 3]");
    }
    write_hdf5(path, {{"displacement", right}, {"velocity", {24, 18, 2}}});
    says("'velocity' has the size [24, 18, 2], and must have [ny, nx, 2] or [ny, nx, 3]");
    write_hdf5(path, {{"displacement", {24, 18, 2}}});
    says("has 18 x 24 nodes, the body 24 x 18: initial.origin puts");
    says("initial.origin has 0.7, which is no place of a node: they are 0.5 apart",
         "origin = [0.5, 0.7]\n");
    says("initial.origin puts all 18 x 24 nodes of ", "origin = [-9, 0.5]\n");
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        write_hdf5(path, {{"displacement", right, value}});
        says(fmt::format("'displacement'[10, 10, 0] is {}, which is not finite", value));
    }
    write_hdf5(path, {{"displacement", {18, 24, 3}}});
    says("'displacement'[6, 22, 2] is 0.001: nodes of a plane do not move along z");
    write_hdf5(path, {{"displacement", right}}, {{"dX", "1"}});
    says("is of a lattice with dX = 1, the scene of one with 0.5");
    write_hdf5(path, {{"displacement", right, 0}});
    says("moves no node: it has no energy");
    // The file that opens the snapshots of a run.
    {
        Hdf5File file(path);
        file.link("displacement/000000000", "nowhere.h5", "/displacement");
        std::vector<nmbcgen::NewFile> files;
        files.push_back(file.whole());
        nmbcgen::publish(files);
    }
    says("'displacement' is a group of datasets, where one dataset is needed");
    {
        const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                              H5Fclose);
        const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        const Hdf5Handle text(H5Dcreate2(*file, "displacement", H5T_C_S1, *space, H5P_DEFAULT,
                                         H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose);
    }
    says("'displacement' does not hold numbers");
    write_hdf5(path, {{"displacement", right}});
    std::filesystem::resize_file(path, 4000);
    says("unreadable: cannot read ");
    says("the file is damaged, or a program is writing it");
    std::ofstream(path) << "x,y,ux,uy\n1,1,1,1\n";
    says("is no HDF5 file");
    std::filesystem::remove(path);
    says("unreadable: cannot read ");
}

TEST_CASE("a force from the datasets of a file is that of a csv") {
    const auto csv = file_named("exam_plane_force.csv");
    const auto hdf5 = file_named("exam_plane_force.h5");
    std::ofstream(csv) << "time,force\n0,0\n1,0\n2,5\n";
    write_hdf5(hdf5, {{"time", {3}, 1}, {"force", {3}, 0}});
    const std::string text = nopd2d_of_2 + of_lattice + free_sides;
    const auto driven_by = [&](const std::filesystem::path& file) {
        return plane_scene_of(text +
                              fmt::format("[force]\nhistory = '{}'\nfile = '{}'\ncomponent = 'x'\n"
                                          "centre = [3, 3]\n",
                                          file.extension() == ".csv" ? "csv" : "hdf5",
                                          file.filename().string()));
    };
    const auto refusal = [&] {
        try {
            const PlaneSimulation simulation(driven_by(hdf5));
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal().find("its times must ascend") != std::string::npos);
    write_hdf5(hdf5, {{"time", {3}, 1}, {"force", {2}}});
    CHECK(refusal().find("'force' has the size [2], and must be a list of 1 to 100000000 numbers, "
                         "as many as 'time'") != std::string::npos);
    write_hdf5(hdf5, {{"time", {3, 1}}, {"force", {3}}});
    CHECK(refusal().find("'time' has the size [3, 1]") != std::string::npos);
    write_hdf5(hdf5, {{"time", {3}}});
    CHECK(refusal().find("has no dataset 'force'") != std::string::npos);
    {
        Hdf5File file(hdf5);
        file.add("time", {3}, {});
        file.add("force", {3}, {});
        file.write("time", std::vector{0.0, 1.0, 2.0});
        file.write("force", std::vector{0.0, 0.0, 5.0});
        std::vector<nmbcgen::NewFile> files;
        files.push_back(file.whole());
        nmbcgen::publish(files);
    }
    PlaneSimulation by_csv(driven_by(csv));
    PlaneSimulation by_hdf5(driven_by(hdf5));
    by_csv.advance(40);
    by_hdf5.advance(40);
    CHECK(by_csv.energies().total() > 0);
    CHECK(differences(by_hdf5, by_csv) == 0);
}

}  // namespace
}  // namespace nmbcrun::test
