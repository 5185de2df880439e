// SPDX-License-Identifier: MIT
/// The versions of what tables are written as: raised by any change that an old reader would
/// misread.
#pragma once

namespace nmbcgen {

/// Of the JSON (docs/json.md).
inline constexpr int json_schema = 3;

/// Of the headers: nmbc::table_schema in runtime/nmbc/table.hpp.
inline constexpr int header_schema = 4;

}  // namespace nmbcgen
