// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/certificate_json.hpp"

#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/exact/real_roots.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

Json end_point(const AlgebraicNumber& number) {
    Json end = {{"value", nearest_double(number)}};
    const std::string exact = to_text(number);
    if (!exact.empty()) {
        end["exact"] = exact;
        return end;
    }
    Json polynomial = Json::array();
    for (const Integer& coefficient : number.polynomial.data()) {
        polynomial.push_back(coefficient.str());
    }
    end["poly"] = polynomial;
    end["interval"] = {to_string(number.low), to_string(number.high)};
    return end;
}

Json end_point(const Edge& edge) {
    Json end;
    if (const auto* exact = std::get_if<AlgebraicNumber>(&edge.where)) {
        end = end_point(*exact);
        end["value"] = edge.inner;
    } else {
        const auto& bracket = std::get<Bracket>(edge.where);
        end = {{"value", edge.inner}, {"bracket", {bracket.low, bracket.high}}};
    }
    if (edge.beyond != Failure::none) {
        end["beyond"] = name_of(edge.beyond);
    }
    if (edge.wave_number != 0) {
        end["wave_number"] = std::round(100 * edge.wave_number) / 100;
    }
    return end;
}

template <class SomeWindow>
Json window_array(const std::vector<SomeWindow>& windows) {
    Json array = Json::array();
    for (const SomeWindow& window : windows) {
        array.push_back(
            {end_point(window.low), window.high ? end_point(*window.high) : Json(nullptr)});
    }
    return array;
}

}  // namespace

Json windows_object(const Certificate& certificate) {
    return {{"reflection", window_array(certificate.reflection)},
            {"modal", window_array(certificate.modal)},
            {"contractive", window_array(certificate.contractive)}};
}

Json poles_array(const Certificate& certificate) {
    Json array = Json::array();
    for (const AlgebraicNumber& pole : certificate.poles) {
        array.push_back(end_point(pole));
    }
    return array;
}

Json max_cfl_array(const Certificate& certificate) {
    Json array = Json::array();
    for (const StableStep& step : certificate.max_cfl) {
        array.push_back({{"low", step.low},
                         {"high", std::isinf(step.high) ? Json(nullptr) : Json(step.high)},
                         {"cfl", step.cfl}});
    }
    return array;
}

}  // namespace nmbcgen
