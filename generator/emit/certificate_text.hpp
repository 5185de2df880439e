// SPDX-License-Identifier: MIT
/// A certificate as C++ source and as a sentence.
#pragma once

#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// The arrays `reflection`, `modal`, `contractive`, `max_cfl` and `max_cfl_contractive`,
/// as far as they are not empty, with a comment on both ends of every window.
std::string window_arrays(const Certificate& certificate);

/// The initialisers of the table's members of these names; those that are not sought of a damped
/// table are empty, with a comment.
std::string window_members(const std::string& table_name, const Certificate& certificate,
                           bool damped);

/// What the windows of a table mean and how they were found.
std::string certificate_statement(const Table& table);

}  // namespace nmbcgen
