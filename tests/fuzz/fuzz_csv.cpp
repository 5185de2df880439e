// SPDX-License-Identifier: GPL-2.0-or-later
/// The CSV files that a scene names.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"

namespace {

/// Columns that are read have to be as long as each other, and of finite numbers.
void read(const std::string& text, const std::vector<std::string>& names) {
    std::istringstream stream(text);
    try {
        const auto columns = nmbcrun::read_columns(stream, "file.csv", names);
        for (const std::vector<double>& column : columns) {
            if (column.empty() || column.size() != columns.front().size()) {
                std::cerr << "columns of " << column.size() << " and " << columns.front().size()
                          << " rows\n";
                std::abort();
            }
            for (const double value : column) {
                if (!std::isfinite(value)) {
                    std::cerr << "read as a number: " << value << "\n";
                    std::abort();
                }
            }
        }
    } catch (const nmbcrun::SceneError& error) {
        if (!std::string(error.what()).starts_with("file.csv")) {
            std::cerr << "says not where: " << error.what() << "\n";
            std::abort();
        }
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's own
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    read(text, {"node", "u", "v"});
    read(text, {"time", "force"});
    return 0;
}
