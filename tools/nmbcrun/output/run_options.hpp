// SPDX-License-Identifier: MIT
/// How a scene is run, whatever it is.
#pragma once

#include <filesystem>

namespace nmbcrun {

struct RunOptions {
    std::filesystem::path folder;  ///< for what the run writes
    bool quiet = false;            ///< only the last lines on stdout
    bool resume = false;           ///< go on from the checkpoint in the folder
    bool keep_checkpoint = false;  ///< at the end, too: a later run may have a later end
};

}  // namespace nmbcrun
