// SPDX-License-Identifier: MIT
/// Closed forms in the horizon to text. Same data, same bytes.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "generator/table/closed_forms.hpp"

namespace nmbcgen {

/// What closed forms can be written as.
struct ClosedFormat {
    std::string_view name;  ///< on the command line
    std::string (*emit)(const FamilyClosedForms&);
};

/// text, latex, json; the first is the usual one.
std::span<const ClosedFormat> closed_formats();

/// For people: powers of G ascending, those of n descending, linear factors taken out.
std::string closed_forms_text(const FamilyClosedForms& forms);

/// The same for a paper; needs amsmath.
std::string closed_forms_latex(const FamilyClosedForms& forms);

/// For programs; docs/reference/closed-forms.md says every key.
std::string closed_forms_json(const FamilyClosedForms& forms);

}  // namespace nmbcgen
