// SPDX-License-Identifier: MIT
#include "generator/emit/closed_forms.hpp"

#include <fmt/format.h>

#include <array>

#include "generator/emit/formula.hpp"

namespace nmbcgen {

std::span<const ClosedFormat> closed_formats() {
    static constexpr std::array list{
        ClosedFormat{"text", closed_forms_text},
        ClosedFormat{"latex", closed_forms_latex},
        ClosedFormat{"json", closed_forms_json},
    };
    return list;
}

std::string closed_forms_text(const FamilyClosedForms& forms) {
    std::string text = fmt::format(
        "Closed forms of {} in the horizon n and the stabilisation G; dX = c = 1.\n\n"
        "i omega = sum_k a_k (i xi)^k (47), even a_k = 0:\n\n",
        forms.family);
    for (std::size_t i = 0; i < forms.taylor.functions.size(); ++i) {
        const auto sum = terms(forms.taylor.functions[i], forms.taylor.pole, Notation::text);
        const std::string name = fmt::format("  a_{} = ", 2 * i + 1);
        for (std::size_t t = 0; t < sum.size(); ++t) {
            const bool plus = sum[t].front() == '+';
            text += t == 0 ? name + (plus ? sum[t].substr(2) : sum[t])
                           : std::string(name.size(), ' ') + sum[t];
            text += "\n";
        }
    }
    text += fmt::format(
        "\nProved: {}.\n\n"
        "The band: from G = G* on every extremum of omega keeps its xi, and omega_max^2 = K G;\n"
        "below, some move. Exact: discriminants, resultants, Sturm's theorem.\n\n",
        forms.proved);
    for (const BandStructure& band : forms.bands) {
        text += fmt::format("  n = {}  G* {}\n         K  {}\n", band.horizon,
                            value(band.threshold, "G", Notation::text),
                            value(band.slope, "K", Notation::text));
        if (!band.below.empty()) {
            text += fmt::format(
                "         below G* omega_max^2 is the greater of K G and the largest root W of\n"
                "         {}\n",
                equation(band.below, Notation::text));
        }
    }
    return text +
           "\nA number without a radical is neither rational nor quadratic; from n = 2 on G* and K "
           "are roots of\npolynomials of degree n - 1. Where no equation in W is given, moving "
           "extrema leave the band or meet\nbelow G*, and no closed form of omega_max is known "
           "there.\n";
}

std::string closed_forms_latex(const FamilyClosedForms& forms) {
    std::string text = fmt::format(
        "% Closed forms of {} in the horizon n and the stabilisation G; dX = c = 1. Needs "
        "amsmath.\n"
        "% i omega = sum_k a_k (i xi)^k (47), even a_k = 0.\n"
        "% Proved: {}.\n\\begin{{align*}}\n",
        forms.family, forms.proved);
    for (std::size_t i = 0; i < forms.taylor.functions.size(); ++i) {
        const auto sum = terms(forms.taylor.functions[i], forms.taylor.pole, Notation::latex);
        text += fmt::format("{}  a_{{{}}} &= ", i == 0 ? "" : " \\\\\n", 2 * i + 1);
        for (std::size_t t = 0; t < sum.size(); ++t) {
            const bool plus = sum[t].front() == '+';
            text += t == 0 ? (plus ? sum[t].substr(2) : sum[t]) : "\n     " + sum[t];
        }
    }
    text +=
        "\n\\end{align*}\n"
        "% From G = G^*_n on every extremum of omega keeps its xi, and omega_max^2 = K_n G. "
        "Below,\n"
        "% where an equation in W is given, omega_max^2 is the greater of K_n G and its largest "
        "root.\n\\begin{align*}\n";
    std::string lines;
    for (const BandStructure& band : forms.bands) {
        lines +=
            fmt::format("{}  G^*_{{{}}} &{} \\\\\n  K_{{{}}} &{}", lines.empty() ? "" : " \\\\\n",
                        band.horizon, value(band.threshold, "G", Notation::latex), band.horizon,
                        value(band.slope, "K", Notation::latex));
        if (!band.below.empty()) {
            lines += " \\\\\n  & " + equation(band.below, Notation::latex);
        }
    }
    return text + lines + "\n\\end{align*}\n";
}

}  // namespace nmbcgen
