// SPDX-License-Identifier: GPL-2.0-or-later
/// A file of tables, of which what is accepted makes lattices and coefficients.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <nmbc/lattice.hpp>
#include <string>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace {

/// At its own G, or at one of those that it is for. There may be none of it, but for a reason.
void use(const nmbc::MatchingTable& table) {
    const double G =
        table.fixed_G.empty() ? 0.75 : nmbc::detail::nearest_to_fraction(table.fixed_G);
    try {
        const auto lattice = nmbc::make_lattice(table, G);
        const auto coefficients = nmbc::boundary_coefficients(table, G, nmbc::allow_unstable);
        if (lattice.symbol.size() != table.lattice->symbol.size() ||
            coefficients.c.size() != std::size_t(table.order) + 1) {
            std::cerr << "other lengths than those of " << table.name << "\n";
            std::abort();
        }
    } catch (const nmbc::CoefficientError&) {  // a pole, or C(1) = 0
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's own
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const nmbcrun::TableFile file(std::string(data, data + size), "mine.json");
        for (const nmbcrun::OwnTable& own : file.tables()) {
            use(own.table);
        }
    } catch (const nmbcrun::SceneError& error) {
        if (!std::string(error.what()).starts_with("mine.json")) {
            std::cerr << "says not where: " << error.what() << "\n";
            std::abort();
        }
    }
    return 0;
}
