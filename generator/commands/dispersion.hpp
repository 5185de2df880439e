// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen dispersion: the dispersion relations of lattice models, and of their continuum limits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "generator/families/family.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// Which curves: one for each horizon and G.
struct Curves {
    std::string family = "nopd1d";
    std::vector<unsigned> horizons;
    std::vector<std::vector<Rational>>
        weights{};  ///< as in Specification, of each; empty: constant
    std::vector<Rational> G;
    unsigned samples = 200;
    bool limit = false;  ///< the family's continuum limit, too
};

inline constexpr std::string_view dispersion_columns =
    "model,horizon,G,xi,omega,phase_velocity,group_velocity\n";

/// Of one of the horizons, at one G. CSV, a row for each xi = pi i/samples, i = 1 .. samples: xi
/// [1/dX], omega [c/dX], and the phase and group velocities [c], first of the model 'lattice',
/// then, with limit, of 'limit', the family's continuum limit (Family::limit). The values at the
/// exact xi are computed to 120 digits, of which cancellation leaves 25 even at a million samples,
/// and rounded once. Where omega vanishes, the group velocity is the limit from below.
std::string dispersion_rows(const Curves& curves, std::size_t which, const Rational& G);

/// Throws NoSuchModel where the family lacks one of the horizons.
void require_models(const Curves& curves);

/// Throws std::invalid_argument, with a message for people, where the family states no limit.
void require_limit(const Family& family);

}  // namespace nmbcgen
