// SPDX-License-Identifier: MIT
/// The version of tables in JSON; that of the headers is nmbc::table_schema.
#pragma once

namespace nmbcgen {

/// Raised by any change of the JSON that an old reader would misread.
inline constexpr int json_schema = 4;

}  // namespace nmbcgen
