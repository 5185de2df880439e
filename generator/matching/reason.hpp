// SPDX-License-Identifier: GPL-2.0-or-later
/// Why a matching boundary condition does not exist, in words, and what to use instead.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "generator/matching/matching.hpp"
#include "generator/matching/taylor.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// One or two sentences for the given degeneracy of the specification; dispersion and taylor are
/// those it was found with.
std::string reason(Degeneracy found, const Specification& specification,
                   const Dispersion& dispersion, const std::vector<GiNaC::ex>& taylor);

}  // namespace nmbcgen
