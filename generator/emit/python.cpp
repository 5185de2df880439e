// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

std::string upper(std::string_view name) {
    std::string text(name);
    for (char& letter : text) {
        letter = char(std::toupper(static_cast<unsigned char>(letter)));
    }
    return text;
}

std::string tuple(const IntegerPolynomial& polynomial) {
    const std::vector<std::string> texts = texts_of(polynomial);
    return fmt::format("({}{})", fmt::join(texts, ", "), texts.size() == 1 ? "," : "");
}

std::string number(double value) {
    return std::isinf(value) ? "inf" : fmt::format("{}", value);
}

std::string tuple_of(const ExactWindow& window) {
    return fmt::format("({}, {})", number(nearest_double(window.low)),
                       number(window.high ? nearest_double(*window.high) : HUGE_VAL));
}

std::string tuple_of(const StabilityWindow& window) {
    return fmt::format("({}, {})", number(window.low.inner),
                       number(window.high ? window.high->inner : HUGE_VAL));
}

std::string tuple_of(const StableStep& step) {
    return fmt::format("({}, {}, {}, {})", number(step.window.low), number(step.window.high),
                       number(step.cfl), number(step.from));
}

template <class Item>
std::string list(const std::string& name, const std::vector<Item>& items) {
    std::string text = name + " = [\n";
    for (const Item& item : items) {
        text += "    " + tuple_of(item) + ",\n";
    }
    return text + "]\n";
}

constexpr const char* functions = R"(

def evaluate(function, G=0):
    """The value at G (int, Fraction, float or text such as "1/2") as a Fraction: exact.

    Raises ZeroDivisionError at a pole.
    """
    G = Fraction(G)
    numerator, denominator = (sum(a * G**k for k, a in enumerate(p)) for p in function)
    if denominator == 0:
        raise ZeroDivisionError(f"it has a pole at G = {G}")
    return Fraction(numerator) / denominator


def coefficients(G=FIXED_G):
    """c_0 .. c_N [1] and b_0 .. b_N [c/dX] at G, as two lists of Fractions.

    Raises ValueError where no G is given, one below 0 or another than the table's own.
    """
    if G is None or Fraction(G) < 0 or (FIXED_G is not None and Fraction(G) != FIXED_G):
        raise ValueError(f"a G >= 0 is needed, and no other than FIXED_G = {FIXED_G}")
    return [evaluate(f, G) for f in C], [evaluate(f, G) for f in B]


def largest_cfl(G, steps=MAX_CFL + MAX_CFL_CONTRACTIVE):
    """The largest certified cfl = dt omega_max / 2 at G, given as in evaluate(); 0: none is.

    Of like ends; of any other end, steps=MAX_CFL_CONTRACTIVE.
    """
    G = float(Fraction(G))  # as the ends of the windows are
    return max((cfl for low, high, cfl, _ in steps if low <= G <= high), default=0)


def smallest_cfl(G, steps=MAX_CFL + MAX_CFL_CONTRACTIVE):
    """The least cfl from which all steps to the largest are certified; 0: all shorter ones are."""
    G = float(Fraction(G))
    found = (step for step in steps if step[0] <= G <= step[1])
    return max(found, key=lambda step: step[2], default=(0, 0, 0, 0))[3]
)";

}  // namespace

std::string emit_python(const Table& table) {
    const Specification& what = table.specification;
    const Certificate certificate = table.certificate.value_or(Certificate{});
    std::string text = heading("#", table, " --format python");
    text += fmt::format(
        "\"\"\"{}: nmbcgen.\n\nPython 3.6 or later, its standard library alone.\n\"\"\"\n\n",
        title(what));
    text += "from fractions import Fraction\nfrom math import inf\n\n";
    text += fmt::format(
        "FAMILY = \"{}\"\nHORIZON = {}  # dX\nORDER = {}\nSTRIDE = {}\n"
        "TAU = Fraction(\"{}\")  # c/dX\nTIME_STEP = Fraction(\"{}\")  # dX/c; 0: continuous time\n"
        "FIXED_G = {}\nLEAST_NODES = {}\n\n",
        what.family, what.horizon, what.order, what.stride, to_string(what.damping),
        to_string(what.time_step),
        what.stabilisation ? "Fraction(\"" + to_string(*what.stabilisation) + "\")" : "None",
        certificate.least_nodes);
    text +=
        "# Functions of G: numerator and denominator, integer coefficients by ascending powers.\n";
    for (const CoefficientList& list : coefficient_lists(table)) {
        text += fmt::format("{} = [{}\n", upper(list.name),
                            list.first > 0 ? fmt::format("  # from index {}", list.first) : "");
        for (const ExactFunction& function : list.functions) {
            text += fmt::format("    ({}, {}),\n", tuple(function.numerator),
                                tuple(function.denominator));
        }
        text += "]\n";
    }
    text += "# Windows of G, (low, high), and steps, (low, high, cfl, from).\n";
    text += list("REFLECTION", certificate.reflection) + list("MODAL", certificate.modal) +
            list("CONTRACTIVE", certificate.contractive) + list("MAX_CFL", certificate.max_cfl) +
            list("MAX_CFL_CONTRACTIVE", certificate.max_cfl_contractive);
    return text + functions;
}

}  // namespace nmbcgen
