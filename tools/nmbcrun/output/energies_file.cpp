// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/energies_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

std::string about(const std::string& heading, const StepPlan& plan, std::string_view per) {
    return fmt::format(
        "nmbcrun   {}\n{}step      {}\nunits     those of the scene, any consistent system; "
        "energies per {}\n",
        NMBC_VERSION, heading, heading_of(plan), per);
}

std::string energies_head(std::string_view about, std::string_view header) {
    std::string head;
    while (!about.empty()) {
        const std::size_t size = about.find('\n') + 1;
        head += fmt::format("# {}", about.substr(0, size));
        about.remove_prefix(size);
    }
    return fmt::format("{}{}\n", head, header);
}

std::string energies_row(const Sample& sample) {
    const auto& [time, e, balance] = sample;
    // The time is a rounded multiple of the step, which ten digits hide; the energies read back.
    std::string row = fmt::format("{:.10g}", time);
    for (const double value :
         {e.kinetic, e.strain, e.stabilisation, e.total(), e.staggered, e.damped, balance.energy,
          balance.work, balance.left, balance.right, balance.drift}) {
        fmt::format_to(std::back_inserter(row), FMT_COMPILE(",{}"), value);
    }
    return row + '\n';
}

void read_energies(const std::filesystem::path& path, std::string_view header,
                   const std::function<bool(std::size_t)>& is_wanted,
                   const std::function<void(const std::vector<double>&)>& take) {
    std::ifstream stream(path);
    std::vector<double> row;
    std::string line;
    std::size_t rows = 0;
    const auto columns = std::size_t(std::ranges::count(header, ',')) + 1;
    while (std::getline(stream, line)) {
        if (line.starts_with('#') || line == header || !is_wanted(rows++)) {
            continue;
        }
        row.clear();
        const char* next = line.data();
        const char* const end = next + line.size();
        while (next < end) {
            const auto [after, error] = std::from_chars(next, end, row.emplace_back());
            if (error != std::errc()) {
                row.clear();
                break;
            }
            next = after + 1;
        }
        if (row.size() != columns) {
            throw FileError(fmt::format("cannot read {}: {}", path.string(), line));
        }
        take(row);
    }
}

Sample sample_of(const std::vector<double>& row) {
    return {
        .time = row[0],
        .energies = {.kinetic = row[1],
                     .strain = row[2],
                     .stabilisation = row[3],
                     .staggered = row[5],
                     .damped = row[6]},
        .balance = {
            .energy = row[7], .work = row[8], .left = row[9], .right = row[10], .drift = row[11]}};
}

}  // namespace nmbcrun
