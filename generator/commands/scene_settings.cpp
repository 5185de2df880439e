// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/scene_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen {

bool is_committed(const Specification& what) {
    Specification of_any_G = what;
    of_any_G.stabilisation.reset();
    return std::ranges::any_of(committed_set(), [&](const Specification& other) {
        return table_name(other) == table_name(of_any_G);
    });
}

std::string scene_settings(const Candidate& candidate) {
    const Specification& what = candidate.what;
    std::vector<std::string> settings;
    const auto set = [&](const char* key, const auto& value) {
        settings.push_back(fmt::format("--set {}={}", key, value));
    };
    if (what.family != Specification().family) {
        set("model.family", what.family);
    }
    set("model.horizon", what.horizon);
    if (is_stabilised(what.family)) {
        set("model.G", to_string(*what.stabilisation));
    }
    if (!what.weights.empty()) {
        std::vector<std::string> weights;
        for (const Rational& weight : what.weights) {
            weights.push_back(fmt::format("\"{}\"", to_string(weight)));
        }
        settings.push_back(fmt::format("--set 'model.influence=[{}]'", fmt::join(weights, ", ")));
    }
    if (what.damping != 0) {
        set("model.damping", to_string(what.damping));
    }
    if (!is_committed(what)) {
        settings.push_back(fmt::format("--set 'model.tables=[\"{}.json\"]'", table_name(what)));
    }
    set("boundary.kind", "nmbc");
    set("boundary.order", what.order);
    set("boundary.stride", what.stride);
    if (what.time_step != 0) {
        set("boundary.matched_step", to_string(what.time_step));
    } else {
        constexpr double digits = 100;  // rounded down: what is certified has an end above
        set("time.cfl", fmt::format("{:g}", std::floor(candidate.cfl * digits + 1e-9) / digits));
    }
    return fmt::format("{}", fmt::join(settings, " "));
}

}  // namespace nmbcgen
