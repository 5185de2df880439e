// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/evidence.hpp"

#include <stdexcept>

#include "generator/enclosures/prove.hpp"
#include "generator/exact/exact_table.hpp"
#include "tools/nmbcrun/sides/half_line.hpp"

namespace nmbcrun {
namespace {

bool is_proved(const nmbc::MatchingTable& table, double G, double step, nmbcgen::Grade grade) {
    try {
        return nmbcgen::Prover(nmbcgen::exact_table(table)).holds_in_step({G, G}, step, grade);
    } catch (const std::invalid_argument&) {
        return false;  // of another kind than there are proofs for
    }
}

}  // namespace

std::string evidence_of(const Scene& scene, const nmbc::Lattice& lattice,
                        const nmbc::MatchingTable& left, const nmbc::MatchingTable& right,
                        double step) {
    const bool matches_left = scene.left.kind == BoundaryKind::nmbc;
    const bool matches_right = scene.right.kind == BoundaryKind::nmbc;
    if (!matches_left && !matches_right) {
        return "by construction";
    }
    const bool are_alike = scene.left == scene.right;
    const auto grade_against = [&](const Boundary& opposite) {
        return are_alike || is_half_line(scene, opposite, lattice, step)
                   ? nmbcgen::Grade::paired
                   : nmbcgen::Grade::contractive;
    };
    const bool proved =
        (!matches_left || is_proved(left, scene.G, step, grade_against(scene.right))) &&
        (!matches_right || are_alike || is_proved(right, scene.G, step, grade_against(scene.left)));
    return proved ? "proved at this G in these steps, for chains that decaying waves do not cross"
                  : "sampled (docs/explanation/stability.md)";
}

}  // namespace nmbcrun
