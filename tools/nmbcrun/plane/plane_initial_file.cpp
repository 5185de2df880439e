// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_initial_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"
#include "tools/nmbcrun/scene/hdf5_input.hpp"

namespace nmbcrun {
namespace {

/// The nodes of the body: those of the scene and of its closed sides, along an axis.
nmbc::detail::PlaneRange body_of(const PlaneScene& scene, const StartOfNodes& nodes,
                                 std::size_t axis) {
    return {is_closed(scene.sides[2 * axis].kind) ? nodes.first(axis) : 0,
            is_closed(scene.sides[2 * axis + 1].kind) ? nodes.last(axis)
                                                      : std::ptrdiff_t(scene.nodes[axis])};
}

/// The node that a row of a csv is of.
std::array<std::ptrdiff_t, 2> node_of(const PlaneScene& scene, const StartOfNodes& nodes,
                                      const std::array<double, 2>& X) {
    constexpr double digits = 1e-3;  // [dX], of what is written in a few
    std::array<std::ptrdiff_t, 2> node{};
    for (const std::size_t axis : {0U, 1U}) {
        const auto [first, last] = body_of(scene, nodes, axis);
        const double place = X[axis] / scene.spacing;
        const double nearest = std::round(place);
        const char name = axis == 0 ? 'x' : 'y';
        if (!(nearest >= double(first + 1) && nearest <= double(last))) {
            throw SceneError(
                fmt::format("{}: [{}, {}] is outside of the plane, whose nodes are at "
                            "{:g} to {:g} along {}",
                            scene.initial->file.string(), X[0], X[1],
                            double(first + 1) * scene.spacing, double(last) * scene.spacing, name));
        }
        if (std::abs(place - nearest) > digits) {
            throw SceneError(fmt::format(
                "{}: [{}, {}] is between two nodes, which are at multiples of {:g} along {}",
                scene.initial->file.string(), X[0], X[1], scene.spacing, name));
        }
        node[axis] = std::ptrdiff_t(nearest) - 1;
    }
    return node;
}

bool read_csv(const PlaneScene& scene, StartOfNodes& nodes) {
    const std::filesystem::path& file = scene.initial->file;
    const auto columns = read_columns(file, {"x", "y", "ux", "uy"}, {"vx", "vy"});
    const bool has_velocity = !columns[4].empty();
    if (has_velocity == columns[5].empty()) {
        throw SceneError(
            fmt::format("{} has only one of the columns 'vx' and 'vy'", file.string()));
    }
    const auto [first_x, last_x] = body_of(scene, nodes, 0);
    const auto [first_y, last_y] = body_of(scene, nodes, 1);
    std::vector<bool> is_given(std::size_t(last_x - first_x) * std::size_t(last_y - first_y));
    for (std::size_t row = 0; row < columns[0].size(); ++row) {
        const auto value = [&](std::size_t column) { return columns[column][row]; };
        const auto [x, y] = node_of(scene, nodes, {value(0), value(1)});
        const auto node = std::size_t((y - first_y) * (last_x - first_x) + x - first_x);
        if (is_given[node]) {
            throw SceneError(fmt::format("{}: the node at [{}, {}] is there twice", file.string(),
                                         value(0), value(1)));
        }
        is_given[node] = true;
        nodes.set(x, y,
                  {.u = {value(2), value(3)},
                   .v = has_velocity ? std::array{value(4), value(5)} : std::array{0.0, 0.0}});
    }
    return has_velocity;
}

/// ny x nx of the file, whose datasets have as many nodes each.
std::array<std::size_t, 2> size_of(const std::vector<Hdf5Dataset>& datasets,
                                   const std::filesystem::path& file) {
    std::array<std::size_t, 2> size{};
    for (const Hdf5Dataset& dataset : datasets) {
        const std::vector<std::size_t>& extents = dataset.extents();
        if (extents.size() != 3 || extents[0] == 0 || extents[1] == 0 || extents[2] < 2 ||
            extents[2] > 3 ||
            (&dataset != &datasets.front() && (extents[0] != size[0] || extents[1] != size[1]))) {
            throw SceneError(
                fmt::format("{}: '{}' has the size [{}], and must have [ny, nx, 2] or [ny, nx, 3], "
                            "with ny and nx "
                            "of 'displacement'",
                            file.string(), dataset.name(), fmt::join(extents, ", ")));
        }
        size = {extents[0], extents[1]};
    }
    return size;
}

/// The node that the file's first one is.
std::array<std::ptrdiff_t, 2> first_node_of(const PlaneScene& scene, const StartOfNodes& nodes,
                                            const std::array<std::size_t, 2>& size) {
    const auto [ny, nx] = size;
    const std::string file = scene.initial->file.string();
    if (!scene.initial->first_node) {
        const auto [first_x, last_x] = body_of(scene, nodes, 0);
        const auto [first_y, last_y] = body_of(scene, nodes, 1);
        if (nx != std::size_t(last_x - first_x) || ny != std::size_t(last_y - first_y)) {
            throw SceneError(fmt::format(
                "{} has {} x {} nodes, the body {} x {}: initial.origin puts the file's first "
                "node where you want it, and cuts off what is outside",
                file, nx, ny, last_x - first_x, last_y - first_y));
        }
        return {first_x, first_y};
    }
    const auto [x, y] = *scene.initial->first_node;
    const auto overlaps = [](std::ptrdiff_t first, std::size_t count, std::size_t of_scene) {
        return first < std::ptrdiff_t(of_scene) && first + std::ptrdiff_t(count) > 0;
    };
    if (!overlaps(x, nx, scene.nodes[0]) || !overlaps(y, ny, scene.nodes[1])) {
        throw SceneError(fmt::format(
            "initial.origin puts all {} x {} nodes of {} outside of the plane", nx, ny, file));
    }
    return {x, y};
}

void require_spacing(const PlaneScene& scene, const Hdf5Input& input) {
    constexpr double roundings = 1e-9;
    const auto spacing = input.attached_number("dX");
    if (spacing && !(std::abs(*spacing / scene.spacing - 1) <= roundings)) {
        throw SceneError(fmt::format("{} is of a lattice with dX = {}, the scene of one with {}",
                                     scene.initial->file.string(), *spacing, scene.spacing));
    }
}

bool read_hdf5(const PlaneScene& scene, StartOfNodes& nodes) {
    const std::filesystem::path& file = scene.initial->file;
    const Hdf5Input input(file);
    const bool has_velocity = input.has("velocity");
    std::vector<Hdf5Dataset> datasets;
    datasets.push_back(input.dataset("displacement"));
    if (has_velocity) {
        datasets.push_back(input.dataset("velocity"));
    }
    const auto size = size_of(datasets, file);
    require_spacing(scene, input);
    const auto [x0, y0] = first_node_of(scene, nodes, size);
    const std::size_t ny = size[0];
    const std::size_t nx = size[1];
    // Row by row: not a second time in memory.
    for (std::size_t row = 0; row < ny; ++row) {
        const std::ptrdiff_t y = y0 + std::ptrdiff_t(row);
        if (!nodes.has(1, y)) {
            continue;
        }
        std::vector<std::vector<double>> values;
        values.reserve(datasets.size());
        for (const Hdf5Dataset& dataset : datasets) {
            values.push_back(dataset.rows(row, 1));
        }
        for (std::size_t column = 0; column < nx; ++column) {
            const std::ptrdiff_t x = x0 + std::ptrdiff_t(column);
            const auto pair_in = [&](std::size_t dataset) {
                const std::vector<double>& of_row = values[dataset];
                const std::size_t components = of_row.size() / nx;
                if (components == 3 && of_row[column * 3 + 2] != 0) {
                    throw SceneError(fmt::format(
                        "{}: '{}'[{}, {}, 2] is {}: nodes of a plane do not move along z",
                        file.string(), datasets[dataset].name(), row, column,
                        of_row[column * 3 + 2]));
                }
                return std::array{of_row[column * components], of_row[column * components + 1]};
            };
            if (nodes.has(0, x)) {
                nodes.set(x, y,
                          {.u = pair_in(0), .v = has_velocity ? pair_in(1) : std::array{0.0, 0.0}});
            }
        }
    }
    return has_velocity;
}

}  // namespace

bool read_initial_fields(const PlaneScene& scene, StartOfNodes& nodes) {
    return scene.initial->format == FileFormat::csv ? read_csv(scene, nodes)
                                                    : read_hdf5(scene, nodes);
}

}  // namespace nmbcrun
