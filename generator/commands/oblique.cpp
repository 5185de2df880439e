// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/oblique.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/real.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/plane/plane_taylor.hpp"

namespace nmbcgen {
namespace {

/// r_0 + r_1 b_1 + r_2 b_2 + r_3 b_1 b_2
using InRoots = std::array<Rational, 4>;

struct Factor {
    ObliqueWave wave;
    Rational speed_squared;
    Rational b_squared;
};

struct ObliqueCondition {
    VectorModel model;
    Rational decay;
    std::vector<Factor> factors;
    /// [p][j]: of D^p Z^j
    std::vector<std::vector<InRoots>> coefficients;
};

InRoots product_in_roots(const InRoots& one, const InRoots& other,
                         const std::vector<Factor>& factors) {
    InRoots result{};
    for (unsigned i = 0; i < one.size(); ++i) {
        for (unsigned j = 0; j < other.size(); ++j) {
            Rational term = one[i] * other[j];
            for (unsigned bit = 0; bit < factors.size(); ++bit) {
                if (((i & j) >> bit & 1U) != 0) {
                    term *= factors[bit].b_squared;
                }
            }
            result[i ^ j] += term;
        }
    }
    return result;
}

/// times (D + e)(1 + Z) - b (Z - 1), b the factor's.
std::vector<std::vector<InRoots>> times_factor(
    const std::vector<std::vector<InRoots>>& coefficients, std::size_t which,
    const ObliqueCondition& condition) {
    InRoots b{};
    b[std::size_t(1) << which] = 1;
    InRoots at_ghost{condition.decay};  // e + b, and of Z e - b
    InRoots inside = at_ghost;
    at_ghost[std::size_t(1) << which] = 1;
    inside[std::size_t(1) << which] = -1;
    const std::array<std::array<InRoots, 2>, 2> own{{{at_ghost, inside}, {InRoots{1}, InRoots{1}}}};
    std::vector<std::vector<InRoots>> result(coefficients.size() + 1,
                                             std::vector<InRoots>(coefficients.front().size() + 1));
    for (std::size_t p = 0; p < coefficients.size(); ++p) {
        for (std::size_t j = 0; j < coefficients[p].size(); ++j) {
            for (const std::size_t q : {0U, 1U}) {
                for (const std::size_t i : {0U, 1U}) {
                    const InRoots term =
                        product_in_roots(coefficients[p][j], own[q][i], condition.factors);
                    for (std::size_t r = 0; r < term.size(); ++r) {
                        result[p + q][j + i][r] += term[r];
                    }
                }
            }
        }
    }
    return result;
}

/// With b cos = 2 c. Of waves at their angle, s = c x + O(x^3) and z = exp(x cos), x = i xi, so
/// that the residual s (1 + z) - b (z - 1) = (2 c - b cos) (x + x^2 cos/2) + O(x^3).
ObliqueCondition condition_of(const ObliqueTask& task) {
    ObliqueCondition condition{
        .model = find_vector_family(task.family).describe(task.choice),
        .decay = task.decay.value_or(task.waves.size() == 1 ? Rational(0) : Rational(1, 500)),
        .factors = {},
        .coefficients = {{InRoots{1}}}};
    for (const ObliqueWave& wave : task.waves) {
        const Rational& cosine_squared = wave.direction.cosine_squared;
        const PlaneTaylor taylor = plane_taylor(
            condition.model, wave.polarisation == Polarisation::P ? 0 : 1, cosine_squared, 1);
        condition.factors.push_back({.wave = wave,
                                     .speed_squared = taylor.speed_squared,
                                     .b_squared = 4 * taylor.speed_squared / cosine_squared});
    }
    for (std::size_t which = 0; which < condition.factors.size(); ++which) {
        condition.coefficients = times_factor(condition.coefficients, which, condition);
    }
    return condition;
}

double number_of(const InRoots& value, const std::vector<Factor>& factors) {
    Real sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        Real term(value[i]);
        for (std::size_t bit = 0; bit < factors.size(); ++bit) {
            if ((i >> bit & 1U) != 0) {
                term *= sqrt(Real(factors[bit].b_squared));
            }
        }
        sum += term;
    }
    return double(sum);
}

/// "16*sqrt(5)/15"
std::string root_text(const Rational& square) {
    const Polynomial equation{-square, 0, 1};
    return to_text(real_roots(equation, 0).back());
}

std::string name_of(const ObliqueWave& wave) {
    return fmt::format("{} {}", wave.polarisation == Polarisation::P ? 'P' : 'S',
                       wave.direction.text);
}

constexpr const char* oblique_form =
    "on every ghost layer and both components: the product of (D + e)(1 + Z) - b (Z - 1), D = "
    "d/dt, Z one node inwards";
constexpr const char* oblique_units =
    "dX = E = density = 1: times in dX sqrt(density/E); angles from the normal of the side";
constexpr const char* oblique_proof =
    "b cos(angle) = 2 c, c that of the dynamical matrix at this angle: where e = 0 the residual of "
    "such waves has no power of the wave number below the third one, exactly";
constexpr const char* oblique_source =
    "Nicely 2018 (75) to (85), (85) corrected; a product of two: Higdon 1986";

double speed_of(const Factor& factor) {
    return double(sqrt(Real(factor.b_squared)) / 2);
}

}  // namespace

std::string oblique_text(const ObliqueTask& task) {
    const ObliqueCondition condition = condition_of(task);
    std::string text = fmt::format("model       {}\ncondition   {}\nunits       {}\n",
                                   condition.model.description, oblique_form, oblique_units);
    for (const Factor& factor : condition.factors) {
        const std::string exact = root_text(factor.b_squared);
        const std::string rounded = fmt::format("{:.10g}", 2 * speed_of(factor));
        text += fmt::format("{:<12}c^2 = {}, cos^2 = {}, b = {}{}\n", name_of(factor.wave),
                            to_string(factor.speed_squared),
                            to_string(factor.wave.direction.cosine_squared), exact,
                            exact == rounded ? "" : " = " + rounded);
    }
    text += fmt::format("e           {}\n", to_string(condition.decay));
    for (std::size_t p = 0; p < condition.coefficients.size(); ++p) {
        text += fmt::format("{:<12}", p == 0 ? "1" : p == 1 ? "D" : "D^2");
        std::string sum;
        for (std::size_t j = 0; j < condition.coefficients[p].size(); ++j) {
            sum += fmt::format("{}{:.10g}{}", j == 0 ? "" : "   ",
                               number_of(condition.coefficients[p][j], condition.factors),
                               j == 0   ? ""
                               : j == 1 ? " Z"
                                        : " Z^2");
        }
        text += sum + "\n";
    }
    return text + fmt::format("proved      {}\n", oblique_proof);
}

std::string oblique_json(const ObliqueTask& task) {
    using Json = nlohmann::ordered_json;
    const ObliqueCondition condition = condition_of(task);
    Json factors = Json::array();
    for (const Factor& factor : condition.factors) {
        factors.push_back(
            {{"polarisation", factor.wave.polarisation == Polarisation::P ? "P" : "S"},
             {"angle", factor.wave.direction.text},
             {"cosine_squared", to_string(factor.wave.direction.cosine_squared)},
             {"speed_squared", to_string(factor.speed_squared)},
             {"b_squared", to_string(factor.b_squared)},
             {"b", 2 * speed_of(factor)},
             {"speed", speed_of(factor)}});
    }
    const std::size_t used = std::size_t(1) << condition.factors.size();
    const std::array basis{"1", "b_1", "b_2", "b_1 b_2"};
    Json exact = Json::array();
    Json numbers = Json::array();
    for (const std::vector<InRoots>& of_power : condition.coefficients) {
        Json exact_row = Json::array();
        Json row = Json::array();
        for (const InRoots& coefficient : of_power) {
            Json texts = Json::array();
            for (std::size_t i = 0; i < used; ++i) {
                texts.push_back(to_string(coefficient[i]));
            }
            exact_row.push_back(texts);
            row.push_back(number_of(coefficient, condition.factors));
        }
        exact.push_back(exact_row);
        numbers.push_back(row);
    }
    const Json all{{"condition", "oblique"},
                   {"family", task.family},
                   {"model", condition.model.description},
                   {"form", oblique_form},
                   {"units", oblique_units},
                   {"factors", factors},
                   {"decay", to_string(condition.decay)},
                   {"basis", std::vector<std::string>(basis.begin(), basis.begin() + long(used))},
                   {"coefficients", exact},
                   {"numbers", numbers},
                   {"source", oblique_source},
                   {"proved", oblique_proof}};
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
