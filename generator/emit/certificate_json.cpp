// SPDX-License-Identifier: MIT
#include "generator/emit/certificate_json.hpp"

#include <cmath>
#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

using Json = nlohmann::ordered_json;

Json number_object(const AlgebraicNumber& number) {
    Json end = {{"value", nearest_double(number)}};
    const std::string exact = to_text(number);
    if (!exact.empty()) {
        end["exact"] = exact;
    }
    if (number.polynomial.degree() == 1) {
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

namespace {

Json end_point(const AlgebraicNumber& number) {
    return number_object(number);
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
        end["wave_number"] = edge.wave_number;
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

AlgebraicNumber read_number(const Json& end) {
    if (!end.contains("poly")) {
        return to_algebraic_number(Rational(end.at("exact").get<std::string>()));
    }
    std::vector<Integer> coefficients;
    for (const Json& coefficient : end.at("poly")) {
        coefficients.emplace_back(coefficient.get<std::string>());
    }
    return {IntegerPolynomial(std::move(coefficients)),
            Rational(end.at("interval").at(0).get<std::string>()),
            Rational(end.at("interval").at(1).get<std::string>())};
}

Failure read_failure(const std::string& name) {
    for (int i = 0; i <= int(Failure::time_step); ++i) {
        if (name_of(Failure(i)) == name) {
            return Failure(i);
        }
    }
    throw std::invalid_argument("'" + name + "' is no kind of failure");
}

void read_end(const Json& end, AlgebraicNumber& number) {
    number = read_number(end);
}

void read_end(const Json& end, Edge& edge) {
    if (end.contains("bracket")) {
        const Json& bracket = end.at("bracket");
        edge.where = Bracket{bracket.at(0).get<double>(), bracket.at(1).get<double>()};
    } else {
        edge.where = read_number(end);
    }
    edge.inner = end.at("value").get<double>();
    edge.beyond = read_failure(end.value("beyond", "none"));
    edge.wave_number = end.value("wave_number", 0.0);
}

template <class SomeWindow>
std::vector<SomeWindow> read_windows(const Json& array) {
    std::vector<SomeWindow> windows;
    if (array.is_null()) {
        return windows;  // not sought
    }
    for (const Json& ends : array) {
        SomeWindow window;
        read_end(ends.at(0), window.low);
        if (!ends.at(1).is_null()) {
            read_end(ends.at(1), window.high.emplace());
        }
        windows.push_back(std::move(window));
    }
    return windows;
}

std::vector<StableStep> read_steps(const Json& array) {
    std::vector<StableStep> steps;
    for (const Json& step : array) {
        steps.push_back(
            {{step.at("low").get<double>(),
              step.at("high").is_null() ? nmbc::unbounded : step.at("high").get<double>()},
             step.at("cfl").get<double>(),
             step.at("from").get<double>()});
    }
    return steps;
}

}  // namespace

Json windows_object(const Certificate& certificate, bool damped) {
    return {{"reflection", damped ? Json(nullptr) : window_array(certificate.reflection)},
            {"modal", window_array(certificate.modal)},
            {"contractive", damped ? Json(nullptr) : window_array(certificate.contractive)}};
}

Json poles_array(const Certificate& certificate) {
    Json array = Json::array();
    for (const AlgebraicNumber& pole : certificate.poles) {
        array.push_back(end_point(pole));
    }
    return array;
}

Json steps_array(const std::vector<StableStep>& steps) {
    Json array = Json::array();
    for (const StableStep& step : steps) {
        array.push_back(
            {{"low", step.window.low},
             {"high", std::isinf(step.window.high) ? Json(nullptr) : Json(step.window.high)},
             {"cfl", step.cfl},
             {"from", step.from}});
    }
    return array;
}

Json evidence_object(const Certificate& certificate, bool damped) {
    const std::string_view paired = name_of(certificate.paired);
    const std::string_view with_any = damped ? "not sought" : name_of(certificate.with_any);
    return {{"modal", paired},
            {"contractive", with_any},
            {"max_cfl", paired},
            {"max_cfl_contractive", with_any},
            {"least_nodes", name_of(Evidence::sampled)}};
}

Certificate read_certificate(const Json& object) {
    const Json& windows = object.at("windows");
    Certificate certificate{.reflection = read_windows<ExactWindow>(windows.at("reflection")),
                            .poles = {},
                            .modal = read_windows<StabilityWindow>(windows.at("modal")),
                            .contractive = read_windows<StabilityWindow>(windows.at("contractive")),
                            .max_cfl = read_steps(object.at("max_cfl")),
                            .max_cfl_contractive = read_steps(object.at("max_cfl_contractive")),
                            .least_nodes = object.at("least_nodes").get<unsigned>()};
    const auto read_evidence = [&object](const char* of) {
        return object.at("evidence").at(of) == name_of(Evidence::proved) ? Evidence::proved
                                                                         : Evidence::sampled;
    };
    certificate.paired = read_evidence("max_cfl");
    certificate.with_any = read_evidence("max_cfl_contractive");
    for (const Json& pole : object.at("poles")) {
        certificate.poles.push_back(read_number(pole));
    }
    return certificate;
}

}  // namespace nmbcgen
