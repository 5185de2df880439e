// SPDX-License-Identifier: MIT
/// The CSV file of a run's energies: lines "# ..", a header and rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

inline constexpr std::string_view energies_header =
    "time,kinetic,strain,stabilisation,total,staggered,damped,ledger,work,left_end,right_end,drift";

inline constexpr auto energies_columns = std::size_t(std::ranges::count(energies_header, ',')) + 1;

/// What a file says of a run whose energies are per this: whole lines. heading: of its scene.
std::string about(const std::string& heading, const StepPlan& plan, std::string_view per);

/// The lines before the rows; about: what is said of the run, whole lines.
std::string energies_head(std::string_view about, std::string_view header);

std::string energies_row(const Sample& sample);

/// Of a file with this header: calls with the numbers of each wanted row (counted from 0). Throws
/// FileError where a wanted row has others than its columns.
void read_energies(const std::filesystem::path& path, std::string_view header,
                   const std::function<bool(std::size_t)>& is_wanted,
                   const std::function<void(const std::vector<double>&)>& take);

/// Of the numbers of a row.
Sample sample_of(const std::vector<double>& row);

}  // namespace nmbcrun
