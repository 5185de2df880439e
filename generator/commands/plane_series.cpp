// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_series.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/formula.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/plane/plane_taylor.hpp"

namespace nmbcgen {
namespace {

/// Either kind: [k][j], in powers of q; at one direction j = 0 alone.
PlaneTaylorClosed series_of(const PlaneSeriesTask& task, const VectorModel& model) {
    const std::size_t polarisation = task.polarisation == Polarisation::P ? 0 : 1;
    if (!task.direction) {
        return plane_taylor_closed(model, polarisation, task.order);
    }
    const PlaneTaylor at =
        plane_taylor(model, polarisation, task.direction->cosine_squared, task.order);
    PlaneTaylorClosed series{.speed_squared = at.speed_squared, .a = {}};
    for (const Polynomial& coefficient : at.a) {
        series.a.push_back({coefficient});
    }
    return series;
}

std::string series_units(const PlaneSeriesTask& task) {
    return fmt::format("dX = 1 and the speed of these long waves = 1; c^2 in E/density{}",
                       find_vector_family(task.family).has_stabilisation ? "; g = G/pi" : "");
}

/// (-15g + 8)/12
std::string text_of(const Polynomial& coefficient) {
    const ExactFunction exact = to_rational_function(coefficient);
    std::string numerator = formula(exact.numerator, "g", Notation::text);
    if (exact.denominator == IntegerPolynomial{1}) {
        return numerator;
    }
    const std::string denominator = exact.denominator[0].str();
    return numerator.find(' ') == std::string::npos
               ? fmt::format("{}/{}", numerator, denominator)
               : fmt::format("({})/{}", numerator, denominator);
}

std::string sum_of_powers(const std::vector<Polynomial>& coefficients) {
    std::string sum;
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
        if (coefficients[j].is_zero()) {
            continue;
        }
        sum += sum.empty() ? "" : "\n            + ";
        sum += text_of(coefficients[j]) + (j == 0 ? "" : j == 1 ? " q" : fmt::format(" q^{}", j));
    }
    return sum.empty() ? "0" : sum;
}

}  // namespace

std::string plane_series_text(const PlaneSeriesTask& task) {
    const VectorModel model = find_vector_family(task.family).describe(task.choice);
    const PlaneTaylorClosed series = series_of(task, model);
    std::string text = fmt::format(
        "model       {}\nwaves       {}, s = i omega = sum a_k (i xi)^k, even a_k = 0\nunits       "
        "{}\nangle       {}\nc^2         {}\n",
        model.description, task.polarisation == Polarisation::P ? 'P' : 'S', series_units(task),
        task.direction ? fmt::format("{}: cos^2 = {}", task.direction->text,
                                     to_string(task.direction->cosine_squared))
                       : "any; q = sin^2(2 angle)",
        to_string(series.speed_squared));
    for (std::size_t k = 0; k < series.a.size(); ++k) {
        text +=
            fmt::format("{:<12}{}\n", fmt::format("a_{}", 2 * k + 1), sum_of_powers(series.a[k]));
    }
    return text;
}

std::string plane_series_json(const PlaneSeriesTask& task) {
    using Json = nlohmann::ordered_json;
    const VectorModel model = find_vector_family(task.family).describe(task.choice);
    const PlaneTaylorClosed series = series_of(task, model);
    const auto exact = [](const Polynomial& coefficient) {
        const ExactFunction function = to_rational_function(coefficient);
        return Json{{"num", texts_of(function.numerator)}, {"den", texts_of(function.denominator)}};
    };
    Json taylor = Json::array();
    for (const std::vector<Polynomial>& powers : series.a) {
        Json list = Json::array();
        for (const Polynomial& coefficient : powers) {
            list.push_back(exact(coefficient));
        }
        taylor.push_back(task.direction ? list.front() : list);
    }
    const Json all{
        {"taylor_of", task.family},
        {"model", model.description},
        {"polarisation", task.polarisation == Polarisation::P ? "P" : "S"},
        {"units", series_units(task)},
        {"direction", task.direction ? Json(task.direction->text) : Json(nullptr)},
        {"cosine_squared",
         task.direction ? Json(to_string(task.direction->cosine_squared)) : Json(nullptr)},
        {"speed_squared", to_string(series.speed_squared)},
        {"taylor", taylor},
        {"source", model.source}};
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
