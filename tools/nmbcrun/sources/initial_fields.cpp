// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/initial_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "tools/nmbcrun/ends/lattice_wave.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"

namespace nmbcrun {
namespace {

/// v at -dt/2 of a wave that is the pulse at t = 0. Far from its middle it is left at 0.
void add_velocity_of_wave(const Initial& initial, nmbc::End towards, const nmbc::Lattice& lattice,
                          const nmbc::ChainParameters& p, std::size_t first_interior,
                          std::vector<double>& v) {
    // So far apart copies of it know nothing of each other; long for the sake of pulses that have
    // waves of no group velocity, whose v fades slowly.
    constexpr double least_period = 4096;
    const double width = initial.pulse.width / p.spacing;
    const double middle = initial.centre / p.spacing - 1 + double(first_interior);  // its entry
    const double half_period = std::max(least_period, std::ceil(80 * width)) / 2;
    const double begin = std::ceil(std::max(0.0, middle - half_period));
    const double end = std::floor(std::min(double(v.size()) - 1, middle + half_period)) + 1;
    const Transform transform = transform_of(initial.pulse, middle - begin, p.spacing);
    if (begin >= end) {
        return;
    }
    const auto waves = one_way_waves(transform, std::size_t(2 * half_period), towards, lattice, p);
    const auto of_wave = std::span(v).subspan(std::size_t(begin), std::size_t(end - begin));
    std::vector<double> u_before(of_wave.size());
    WavesAtNodes(waves, 0, p.time_step).add(-1, u_before, of_wave);
}

void read_file(const std::filesystem::path& file, const nmbc::ChainParameters& p,
               std::size_t first_interior, InitialFields& fields) {
    const auto columns = read_columns(file, {"node", "u", "v"});
    std::vector<bool> is_given(p.nodes);
    for (std::size_t row = 0; row < columns[0].size(); ++row) {
        const double node = columns[0][row];
        if (node != std::floor(node) || node < 1 || node > double(p.nodes)) {
            throw SceneError(fmt::format("{}: node {} is none of the {} of domain.nodes",
                                         file.string(), node, p.nodes));
        }
        const std::size_t interior = std::size_t(node) - 1;
        if (is_given[interior]) {
            throw SceneError(fmt::format("{}: node {} is there twice", file.string(), node));
        }
        is_given[interior] = true;
        fields.u[first_interior + interior] = columns[1][row];
        fields.v[first_interior + interior] = columns[2][row];
    }
    fields.is_staggered = true;
}

/// Of a displacement that is the same all over the bar, roundings would be all that moves.
void require_shape(const Initial& initial, std::span<const double> u) {
    const auto [lowest, highest] = std::ranges::minmax(u);
    constexpr double roundings = 1e-9;
    const double largest = std::max(std::abs(lowest), std::abs(highest));
    if (u.size() > 1 && largest > 0 && highest - lowest <= roundings * largest) {
        throw SceneError(
            fmt::format("initial.width is {:g}, so wide that the displacement is the same all over "
                        "the bar to {:g}",
                        initial.pulse.width, roundings));
    }
}

}  // namespace

InitialFields initial_fields(const Scene& scene, const nmbc::Lattice& lattice,
                             const nmbc::ChainParameters& parameters, std::size_t nodes,
                             std::size_t first_interior) {
    InitialFields fields{std::vector<double>(nodes), std::vector<double>(nodes)};
    if (!scene.initial) {
        return fields;
    }
    const Initial& initial = *scene.initial;
    if (initial.kind == InitialKind::file) {
        read_file(initial.file, parameters, first_interior, fields);
        return fields;
    }
    auto& pulsed = initial.kind == InitialKind::velocity ? fields.v : fields.u;
    for (std::size_t entry = 0; entry < nodes; ++entry) {
        const double X = (double(entry) + 1 - double(first_interior)) * scene.spacing;
        pulsed[entry] = value_at(initial.pulse, X - initial.centre, scene.spacing);
    }
    if (initial.kind != InitialKind::velocity) {
        require_shape(initial, std::span(fields.u).subspan(first_interior, parameters.nodes));
    }
    fields.is_staggered =
        initial.kind == InitialKind::to_the_right || initial.kind == InitialKind::to_the_left;
    if (fields.is_staggered) {
        const auto towards =
            initial.kind == InitialKind::to_the_right ? nmbc::End::right : nmbc::End::left;
        add_velocity_of_wave(initial, towards, lattice, parameters, first_interior, fields.v);
    }
    return fields;
}

}  // namespace nmbcrun
