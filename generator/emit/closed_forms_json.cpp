// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/closed_forms.hpp"
#include "generator/emit/coefficients.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

Json polynomials(const std::vector<Polynomial>& list) {
    Json array = Json::array();
    for (const Polynomial& polynomial : list) {
        const ExactFunction function = to_rational_function(polynomial);
        array.push_back(
            {{"num", texts_of(function.numerator)}, {"den", function.denominator[0].str()}});
    }
    return array;
}

}  // namespace

std::string closed_forms_json(const FamilyClosedForms& forms) {
    Json taylor = Json::array();
    for (std::size_t i = 0; i < forms.taylor.functions.size(); ++i) {
        taylor.push_back(
            {{"k", 2 * i + 1}, {"coefficients", polynomials(forms.taylor.functions[i])}});
    }
    Json bands = Json::array();
    for (const BandStructure& band : forms.bands) {
        bands.push_back({{"horizon", band.horizon},
                         {"threshold", number_object(band.threshold)},
                         {"slope", number_object(band.slope)},
                         {"below", polynomials(band.below)}});
    }
    const Json all{{"schema", 1},      {"family", forms.family}, {"pole", forms.taylor.pole},
                   {"taylor", taylor}, {"proved", forms.proved}, {"bands", bands}};
    return all.dump(1) + "\n";
}

}  // namespace nmbcgen
