// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

std::string table_name(const Specification& specification) {
    std::string name = fmt::format("{}_n{}_order{}", specification.family, specification.horizon,
                                   specification.order);
    if (specification.stride != 1) {
        name += fmt::format("_s{}", specification.stride);
    }
    if (specification.damping != 0) {
        name += fmt::format("_tau{}o{}", numerator(specification.damping).str(),
                            denominator(specification.damping).str());
    }
    if (specification.time_step != 0) {
        name += fmt::format("_dt{}o{}", numerator(specification.time_step).str(),
                            denominator(specification.time_step).str());
    }
    if (specification.stabilisation) {
        name += fmt::format("_G{}o{}", numerator(*specification.stabilisation).str(),
                            denominator(*specification.stabilisation).str());
    }
    return name;
}

std::string regenerating_command(const Specification& specification) {
    std::string command =
        fmt::format("nmbcgen --family {} --order {} --horizon {}", specification.family,
                    specification.order, specification.horizon);
    if (specification.stride != 1) {
        command += fmt::format(" --stride {}", specification.stride);
    }
    if (specification.damping != 0) {
        command += " --damping " + to_string(specification.damping);
    }
    if (specification.time_step != 0) {
        command += " --time-step " + to_string(specification.time_step);
    }
    if (specification.stabilisation) {
        command += " --G " + to_string(*specification.stabilisation);
    }
    return command;
}

}  // namespace nmbcgen
