// SPDX-License-Identifier: MIT
/// A certificate as JSON; keys and types: docs/reference/json.md.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// {"value", "exact", "poly", "interval"}, as the end of a window in docs/reference/json.md.
nlohmann::ordered_json number_object(const AlgebraicNumber& number);

/// damped: of a table with tau > 0; the windows that are not sought of one are null.
nlohmann::ordered_json windows_object(const Certificate& certificate, bool damped);
nlohmann::ordered_json poles_array(const Certificate& certificate);
nlohmann::ordered_json steps_array(const std::vector<StableStep>& steps);
/// By key of the table, the word that it rests on, or "not sought".
nlohmann::ordered_json evidence_object(const Certificate& certificate, bool damped);

/// The certificate of an object with the keys windows, poles, max_cfl, max_cfl_contractive,
/// least_nodes and evidence, as written by the functions above. Throws nlohmann::json::exception or
/// std::invalid_argument where it is not.
Certificate read_certificate(const nlohmann::ordered_json& object);

}  // namespace nmbcgen
