// SPDX-License-Identifier: GPL-2.0-or-later
/// A certificate as JSON; keys and types: docs/json.md.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/table/certificate.hpp"

namespace nmbcgen {

nlohmann::ordered_json windows_object(const Certificate& certificate);
nlohmann::ordered_json poles_array(const Certificate& certificate);
nlohmann::ordered_json max_cfl_array(const Certificate& certificate);

}  // namespace nmbcgen
