// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/evidence.hpp"

#include <stdexcept>

#include "generator/enclosures/prove.hpp"
#include "generator/exact/exact_table.hpp"
#include "tools/nmbcrun/certification/certificate.hpp"
#include "tools/nmbcrun/ends/half_line.hpp"

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
    if (scene.left.kind == BoundaryKind::snm || scene.right.kind == BoundaryKind::snm) {
        return "sampled (docs/reference/scene.md)";
    }
    if (!matches_left && !matches_right) {
        return "by construction";
    }
    const bool meets_half_line = is_half_line(scene, scene.left, lattice, step) ||
                                 is_half_line(scene, scene.right, lattice, step);
    if (has_eigenvalues(scene) && !meets_half_line) {
        return "sampled: the eigenvalues of this chain";
    }
    const bool are_alike = scene.left == scene.right;
    const nmbcgen::Grade grade = are_alike || meets_half_line || is_damped(scene)
                                     ? nmbcgen::Grade::paired
                                     : nmbcgen::Grade::contractive;
    const bool proved = (meets_half_line || !is_short(scene)) &&
                        (!matches_left || is_proved(left, scene.G, step, grade)) &&
                        (!matches_right || are_alike || is_proved(right, scene.G, step, grade));
    if (!proved) {
        return "sampled (docs/explanation/stability.md)";
    }
    return meets_half_line ? "proved of this end at this G in these steps"
                           : "proved of these ends far apart, at this G in these steps; sampled: "
                             "that this is far enough";
}

}  // namespace nmbcrun
