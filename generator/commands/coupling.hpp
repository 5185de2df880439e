// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen coupling: bars that are local here and nonlocal there (Seleson 2011, part IV).
#pragma once

#include <string>

#include "generator/coupling/mesh.hpp"

namespace nmbcgen {

enum class CouplingPart { stencil, junction, cases, waves };

struct CouplingTask {
    CouplingPart part = CouplingPart::stencil;
    Rational horizon;           ///< delta of the left bar, or of all [h]
    Rational other_horizon;     ///< of two bars: of the right one [h of the left one]; 0: local
    Rational other_length = 1;  ///< of two bars: of its elements [h of the left one]
};

/// Waves take steps by the square of it.
inline constexpr unsigned largest_wave_horizon = 10;

inline constexpr const char* coupling_source = "Seleson 2011, part IV: linear elements of length h";

/// For people, or JSON (docs/reference/json-other.md).
std::string coupling_text(const CouplingTask& task);
std::string coupling_json(const CouplingTask& task);

}  // namespace nmbcgen
