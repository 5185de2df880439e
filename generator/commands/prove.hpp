// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen prove: what of a certificate is a proof.
#pragma once

#include <string>

#include "generator/commands/recommend.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

struct ProofTask {
    double cfl = 0;                ///< up to which steps are to be stable, too; G is open
    std::optional<double> finest;  ///< of an interval of G; none: a thousandth of the window
};

/// A condition that no proof by enclosures is made for.
struct NotProvable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Where G is open, the parts of the certified windows in which the grade is proved, in continuous
/// time and in all steps up to a cfl; at one G the largest cfl up to which it is. Of a condition
/// that is matched in time steps, in its own step alone.
/// Throws NotProvable.
std::string proof_text(const Specification& what, const ProofTask& task, const Progress& progress);

/// The same of one G, which is given, as an object (docs/reference/json-other.md).
std::string proof_json(const Specification& what, const Progress& progress);

}  // namespace nmbcgen
