// SPDX-License-Identifier: MIT
#include "generator/emit/cpp_source.hpp"

#include <fmt/format.h>

#include "generator/emit/coefficients.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

std::string cpp_preamble(const std::string& further_includes) {
    return "#include <nmbc/table.hpp>\n" + further_includes +
           fmt::format(
               "\nstatic_assert(nmbc::table_schema == {},\n"
               "              \"tables and runtime differ: run the target 'regenerate'\");\n\n",
               nmbc::table_schema);
}

std::string initialiser(const ExactFunction& function) {
    return fmt::format(R"({{"{}", "{}"}})", fmt::join(texts_of(function.numerator), " "),
                       fmt::join(texts_of(function.denominator), " "));
}

std::string initialiser(const Polynomial& polynomial) {
    return initialiser(to_rational_function(polynomial));
}

}  // namespace nmbcgen
