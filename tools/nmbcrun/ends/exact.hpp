// SPDX-License-Identifier: MIT
/// The exact end: as if the lattice went on for ever, by convolution with its own kernel
/// (as Ji et al. 2020, arXiv:2002.12846, do in continuous time), in the chain's own steps.
#pragma once

#include <cstddef>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <type_traits>

namespace nmbcrun {

/// What is beyond this end is at rest at t = 0, so start() throws std::invalid_argument where u or
/// v of a ghost, or of one of as many interior nodes next to it, is more than 1e-12 of the largest
/// of the chain, v counted in c/dX. A chain whose fields are written to, or asked for in order to
/// be, starts anew, and so throws once waves have come to this end.
///
/// The lattice has no layer here, and the ghosts' displacements follow those of the interior by
/// transparent_kernel(): the same as a chain that is longer than any wave gets, but for roundings.
struct ExactEnd {
    std::size_t steps = 0;  ///< of the whole run; one more throws std::length_error

    /// Steps that memory and time are tried for.
    static constexpr std::size_t most_steps = 200'000;

    /// Throws std::invalid_argument where there are no steps or more than most_steps, and as
    /// transparent_kernel() does.
    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
