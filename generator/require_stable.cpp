// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/require_stable.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

std::string how_it_fails(const Table& table, const Rational& G) {
    const ModalVerdict verdict = modal_verdict(make_half_space(table, G));
    switch (verdict.failure) {
        case ModalFailure::growing_mode:
            return fmt::format("a boundary mode grows, Re s = {:.3g} c/dX", verdict.growth.real());
        case ModalFailure::resonance:
            return fmt::format("it sends out a wave of its own at xi = {:.3g}/dX",
                               verdict.wave_number);
        default:
            return fmt::format(
                "waves are amplified by up to {:.6g} a reflection, most at the frequency of xi = "
                "{:.3g}/dX{}",
                verdict.supremum, verdict.wave_number,
                verdict.backward ? ", where backward waves travel" : "");
    }
}

std::string text_of(const std::vector<StabilityWindow>& windows) {
    std::string text;
    for (const StabilityWindow& window : windows) {
        text +=
            fmt::format("{}{:.7g} {}", text.empty() ? "" : "; ", window.low.inner,
                        window.high ? fmt::format("to {:.7g}", window.high->inner) : "and above");
    }
    return text.empty() ? "none" : text;
}

}  // namespace

void require_stable(const Table& table) {
    if (!table.certificate->modal.empty()) {
        return;
    }
    const Specification& what = table.specification;
    const Rational& G = *what.stabilisation;
    std::string message = fmt::format(
        "NMBC{} at horizon {}, stride {},{} G = {} is not stable: {}. Nothing was "
        "written.\nG where it is stable:",
        what.order, what.horizon, what.stride,
        what.damping != 0 ? " damping " + to_string(what.damping) + "," : std::string(),
        to_string(G), how_it_fails(table, G));
    std::vector<Table> open;
    for (const unsigned stride : std::set{1U, what.horizon, what.stride}) {
        open.push_back(
            derive({what.family, what.horizon, what.order, stride, std::nullopt, what.damping}));
    }
    certify_all(open);
    for (const Table& other : open) {
        message += fmt::format("\n  stride {}: {}", other.specification.stride,
                               text_of(other.certificate->modal));
    }
    throw NotStable(message);
}

}  // namespace nmbcgen
