// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen prove: what of a certificate is a proof.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "generator/commands/recommend.hpp"
#include "generator/enclosures/prove.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

struct ProofTask {
    bool all = false;              ///< of the committed set
    bool steps = false;            ///< every certified step, not windows in continuous time
    double cfl = 0;                ///< else up to which steps are to be stable, too
    std::optional<double> finest;  ///< piece of G; none: 1e-4, or a thousandth of a window
};

/// A condition that no proof by enclosures is made for.
struct NotProvable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// At one G, which is given: the largest cfl up to which a grade is proved, from the one on from
/// which it is sampled. Of a condition that is matched in time steps, in its own step alone.
/// Throws NotProvable.
std::string proof_at_G(const Specification& what, const Progress& progress);

/// The same as an object (docs/reference/json-other.md).
std::string proof_at_G_json(const Specification& what, const Progress& progress);

/// Where G is open, the parts in which the grade is proved: of the certified windows, in continuous
/// time and in all steps up to a cfl; or of the ranges of G that steps are certified in, in all of
/// these steps; of a condition that is matched in time steps, in its own one. Throws NotProvable.
std::string proof_of_windows(const Specification& what, const ProofTask& task,
                             const Progress& progress);

/// The same as an object (docs/reference/json-other.md).
std::string proof_of_windows_json(const Specification& what, const ProofTask& task,
                                  const Progress& progress);

/// How much of these is proved for every table of the committed set that has any, and for all.
std::string proof_of_set(const ProofTask& task, const Progress& progress);

/// What all of these begin with.
Table with_open_G(const Specification& what);
Prover prover_of(const Table& table);  ///< throws NotProvable
std::string proof_heading(const Specification& what, const Table& table);
double own_step(const Specification& what);          ///< dt [dX/c] that it is matched in, or 0
std::string in_own_step(const Specification& what);  ///< a clause

}  // namespace nmbcgen
