// SPDX-License-Identifier: MIT
/// Runs a scene.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "tools/nmbcrun/scene.hpp"

namespace nmbcrun {

/// The run became non-finite; what() says at which step and node, and the likely cause.
struct Unstable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// There is no table of this family, horizon, order and stride; what() lists those there are.
struct NoTable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Runs the scene, writes FOLDER/NAME.csv and prints a table of energies on stdout; with `quiet`,
/// only the energy left and the file.
/// Throws NoTable, Unstable (what was computed up to there is written), nmbc::CoefficientError,
/// std::invalid_argument (parameters the runtime refuses), FileError.
void run(const Scene& scene, const std::filesystem::path& folder, bool quiet);

}  // namespace nmbcrun
