// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

std::string emit_csv(const Table& table) {
    const bool fixed = table.specification.stabilisation.has_value();
    std::string text = fixed ? "list,index,exact,value\n" : "list,index,numerator,denominator\n";
    for (const CoefficientList& list : coefficient_lists(table)) {
        for (std::size_t i = 0; i < list.functions.size(); ++i) {
            const ExactFunction& function = list.functions[i];
            text += fmt::format("{},{},", list.name, list.first + i);
            if (fixed) {
                const Rational value = evaluate(function, 0);
                text += fmt::format("{},{:.17g}\n", to_string(value), nearest_double(value));
            } else {
                text += fmt::format("{},{}\n", fmt::join(texts_of(function.numerator), " "),
                                    fmt::join(texts_of(function.denominator), " "));
            }
        }
    }
    return text;
}

}  // namespace nmbcgen
