// SPDX-License-Identifier: GPL-2.0-or-later
/// What does not fit, and what must not reach a terminal.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "generator/names/printable.hpp"
#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"
#include "tools/nmbcrun/simulation/memory.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun::test {
namespace {

TEST_CASE("a chain or a plane has to fit in memory") {
    constexpr std::uintmax_t gigabyte = 1'000'000'000;
    CHECK_NOTHROW(require_memory(10'000'000, 2 * gigabyte));
    CHECK_NOTHROW(require_memory(100'000'000, 12 * gigabyte));
    CHECK_THROWS_WITH_AS(require_memory(100'000'001, 12 * gigabyte),
                         "a chain of 100000001 nodes, layers included, needs 12 GB of memory, and "
                         "there are 12: at most 100000000 nodes are allowed",
                         SceneError);
    CHECK_THROWS_AS(require_memory(1, 0), SceneError);
    CHECK_NOTHROW(require_memory_of_plane({1000, 1000}, gigabyte));
    CHECK_THROWS_WITH_AS(require_memory_of_plane({10000, 9000}, 12 * gigabyte),
                         "a plane of 10000 x 9000 nodes needs 18.9 GB of memory, and there are 12: "
                         "at most 57142857 nodes are allowed",
                         SceneError);
    CHECK(physical_memory() > gigabyte / 10);
    // A layer counts, however it is given: a million times what there is.
    Scene scene = bar(100, 1);
    scene.left = {.kind = BoundaryKind::sponge,
                  .layer = std::size_t(physical_memory() * 1'000'000)};
    scene.initial = {.kind = InitialKind::displacement,
                     .pulse = {.amplitude = 1, .width = 1},
                     .centre = 25,
                     .file = {}};
    scene.right.kind = BoundaryKind::fixed;
    CHECK_THROWS_WITH_AS(Simulation{scene}, doctest::Contains("nodes are allowed"), SceneError);
    scene.left = {.kind = BoundaryKind::fixed};
    CHECK_NOTHROW(Simulation{scene});
    // Layers that find their own width: one of 10422 nodes has room, two have not.
    const nmbc::Lattice lattice = lattice_of(scene);
    scene.end = 5000;
    scene.nodes = std::size_t(physical_memory() / 120) - 15000;
    scene.left = {.kind = BoundaryKind::extended};
    CHECK_NOTHROW(require_memory(scene, lattice, 0.1));
    scene.right = scene.left;
    CHECK_THROWS_AS(require_memory(scene, lattice, 0.1), SceneError);
}

TEST_CASE("control characters are escaped, and letters are not") {
    CHECK(nmbcgen::printable("n = 2, \u00e9\u2192\u65e5 and \"quotes\\\"") ==
          "n = 2, \u00e9\u2192\u65e5 and \"quotes\\\"");
    CHECK(nmbcgen::printable("\x1b[2J\a\r\n\t\x7f") == "\\x1b[2J\\x07\\x0d\\x0a\\x09\\x7f");
    CHECK(nmbcgen::printable("\u0080\u009b31m\u009f\u00a0") == "\\u0080\\u009b31m\\u009f\u00a0");
    CHECK(nmbcgen::printable(std::string(1, '\0')) == "\\x00");
    CHECK(nmbcgen::printable("\xc2") == "\\xc2");  // an end in the middle of a letter
}

TEST_CASE("columns are read of regular files of some length") {
    CHECK_THROWS_WITH_AS(read_columns("/dev/zero", {"time", "force"}),
                         "cannot read /dev/zero: it is not a regular file", FileError);
    const auto path =
        std::filesystem::temp_directory_path() / ("nmbc_exam_limits_" + std::to_string(getpid()));
    std::ofstream(path).put('x');
    std::filesystem::resize_file(path, (1U << 30U) + 1);  // of holes
    CHECK_THROWS_WITH_AS(read_columns(path, {"time", "force"}),
                         doctest::Contains("has 1073741825 bytes; at most 1073741824 are allowed"),
                         SceneError);
    std::filesystem::remove(path);
    CHECK_THROWS_WITH_AS(read_columns(path, {"time", "force"}),
                         doctest::Contains("No such file or directory"), FileError);
}

}  // namespace
}  // namespace nmbcrun::test
