// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/names/checksum.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {
namespace {

/// FAMILY_nH[_w_PoQ_PoQ ..], or FAMILY_nH_wCHECKSUM where that would be long.
std::string undamped_name(const Specification& specification) {
    std::string weights;
    for (const Rational& weight : specification.weights) {
        weights += "_" + p_over_q(weight);
    }
    constexpr std::size_t readable = 40;
    if (weights.size() > readable) {
        weights = fmt::format("{:016x}", checksum(weights));
    }
    return fmt::format("{}_n{}{}{}", specification.family, specification.horizon,
                       weights.empty() ? "" : "_w", weights);
}

std::string damping_suffix(const Specification& specification) {
    return specification.damping == 0 ? "" : "_tau" + p_over_q(specification.damping);
}

}  // namespace

std::string lattice_name(const Specification& specification) {
    return undamped_name(specification) + damping_suffix(specification);
}

std::string table_name(const Specification& specification) {
    std::string name = undamped_name(specification);
    name += fmt::format("_order{}", specification.order);
    if (specification.stride != 1) {
        name += fmt::format("_s{}", specification.stride);
    }
    name += damping_suffix(specification);
    if (specification.time_step != 0) {
        name += fmt::format("_dt{}", p_over_q(specification.time_step));
    }
    for (const MatchingPoint& point : specification.points) {
        name += fmt::format("_at{}{}x{}", point.of_pi ? "pi" : "", p_over_q(point.wave_number),
                            point.multiplicity);
    }
    if (specification.stabilisation) {
        name += fmt::format("_G{}", p_over_q(*specification.stabilisation));
    }
    return name;
}

std::string to_string(const MatchingPoint& point) {
    if (!point.of_pi) {
        return to_string(point.wave_number);
    }
    const Integer p = numerator(point.wave_number);
    const Integer q = denominator(point.wave_number);
    return (p == 1 ? "" : p.str()) + "pi" + (q == 1 ? "" : "/" + q.str());
}

std::string matching_text(const Specification& specification) {
    std::string text = fmt::format("0:{}", rows_at_zero(specification));
    for (const MatchingPoint& point : specification.points) {
        text += fmt::format(",{}:{}", to_string(point), point.multiplicity);
    }
    return text;
}

std::string weights_text(const Specification& specification) {
    std::string text;
    for (const Rational& weight : specification.weights) {
        text += (text.empty() ? "" : ",") + to_string(weight);
    }
    return text;
}

std::string regenerating_command(const Specification& specification) {
    const std::string condition = specification.points.empty()
                                      ? fmt::format("--order {}", specification.order)
                                      : "--match " + matching_text(specification);
    const auto projected = projected_family(specification.family);
    std::string command = projected
                              ? fmt::format("nmbcgen {} {}", options_of(*projected), condition)
                              : fmt::format("nmbcgen --family {} {} --horizon {}",
                                            specification.family, condition, specification.horizon);
    if (!specification.weights.empty()) {
        command += " --weights " + weights_text(specification);
    }
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
