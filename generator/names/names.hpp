// SPDX-License-Identifier: MIT
/// Tables by name: of files, and on the command line that makes them.
#pragma once

#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// FAMILY_nH[_w_PoQ_PoQ ..]_orderN[_sS][_tauPoQ][_dtPoQ][_at[pi]PoQxM ..][_GPoQ], the name of the
/// table and of its files. Weights of more than 40 characters have a checksum instead.
std::string table_name(const Specification& specification);

/// FAMILY_nH[_w_PoQ_PoQ ..][_tauPoQ], that of its lattice.
std::string lattice_name(const Specification& specification);

/// The influence as on the command line: 1,1/2; empty where it is constant.
std::string weights_text(const Specification& specification);

/// The wave number as on the command line: 6/5, pi, 2pi/3.
std::string to_string(const MatchingPoint& point);

/// All that is matched, as on the command line: 0:5,6/5:2.
std::string matching_text(const Specification& specification);

/// PoQ, which a C++ name may have in it.
std::string p_over_q(const Rational& value);

/// The command line that makes this table again.
std::string regenerating_command(const Specification& specification);

}  // namespace nmbcgen
