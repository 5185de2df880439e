// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/snapshots.hpp"

#include <fmt/format.h>

#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/hdf5_file.hpp"

namespace nmbcrun {
namespace {

void append(Journal& journal, std::span<const double> values) {
    const auto bytes = std::as_bytes(values);
    journal.append(
        {static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size()});
}

bool read(std::istream& stream, std::span<double> values) {
    return bool(stream.read(static_cast<char*>(static_cast<void*>(values.data())),
                            std::streamsize(values.size_bytes())));
}

}  // namespace

void append_snapshot(Journal& snapshots, const nmbc::Chain& chain) {
    const std::size_t first = chain.first_interior();
    const std::size_t nodes = chain.parameters().nodes;
    const double time = chain.time();
    append(snapshots, {&time, 1});
    append(snapshots, chain.displacement().subspan(first, nodes));
    append(snapshots, chain.velocity().subspan(first, nodes));
}

nmbcgen::NewFile write_snapshots(Journal& snapshots, Journal& energies,
                                 const nmbc::ChainParameters& p) {
    const std::size_t times = snapshots.size() / (sizeof(double) * (1 + 2 * p.nodes));
    std::vector<double> rows;
    read_energies(
        energies.source(), energies_header, [](std::size_t /*row*/) { return true; },
        [&](const std::vector<double>& row) { rows.insert(rows.end(), row.begin(), row.end()); });

    Hdf5File file(snapshots.path());
    file.describe(
        {{"layout", "one-dimensional chain, interior nodes; each row of u and v is a time"},
         {"units", "those of the scene, any consistent system"}});
    file.add("time", {times}, {{"unit", "time"}, {"meaning", "t of each row of u and v"}});
    file.add("x", {p.nodes}, {{"unit", "length"}, {"meaning", "position of each node, X"}});
    file.add("u", {times, p.nodes},
             {{"unit", "length"}, {"layout", "time x node"}, {"meaning", "displacement at t"}});
    file.add(
        "v", {times, p.nodes},
        {{"unit", "length/time"},
         {"layout", "time x node"},
         {"meaning", fmt::format("velocity at t - {}, half a step before u", p.time_step / 2)}});
    file.add("energies", {rows.size() / energies_columns, energies_columns},
             {{"unit", "energy/area; the first column: time"},
              {"layout", "row x column"},
              {"columns", std::string(energies_header)}});

    std::vector<double> x(p.nodes);
    for (std::size_t node = 0; node < p.nodes; ++node) {
        x[node] = double(node + 1) * p.spacing;
    }
    file.write("x", x);
    if (!rows.empty()) {
        file.write("energies", rows);
    }
    std::ifstream stream(snapshots.source(), std::ios::binary);
    std::vector<double> field(p.nodes);
    for (std::size_t row = 0; row < times; ++row) {
        double time = 0;
        bool whole = read(stream, {&time, 1});
        file.write("time", row, {&time, 1});
        for (const char* const name : {"u", "v"}) {
            whole = whole && read(stream, field);
            file.write(name, row, field);
        }
        if (!whole) {
            throw FileError(fmt::format("cannot read {}", snapshots.source().string()));
        }
    }
    return file.whole();
}

}  // namespace nmbcrun
