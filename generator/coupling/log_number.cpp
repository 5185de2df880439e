// SPDX-License-Identifier: MIT
#include "generator/coupling/log_number.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/real.hpp"

namespace nmbcgen {
namespace {

constexpr unsigned largest_prime = 1000000;

/// Adds sign times the logarithm of a positive integer.
void add_factors(std::map<unsigned, Rational>& of_log, Integer number, int sign) {
    for (unsigned p = 2; number > 1; ++p) {
        if (Integer(p) * p > number && number <= largest_prime) {
            p = number.convert_to<unsigned>();  // a prime, which is left over
        }
        if (p > largest_prime) {
            throw std::invalid_argument("a logarithm of a prime above a million");
        }
        while (number % p == 0) {
            of_log[p] += sign;
            number /= p;
        }
    }
}

Real real_of(const Rational& number) {
    return Real(Integer(numerator(number))) / Real(Integer(denominator(number)));
}

}  // namespace

LogNumber& LogNumber::operator+=(const LogNumber& other) {
    rational += other.rational;
    for (const auto& [prime, coefficient] : other.of_log) {
        of_log[prime] += coefficient;
    }
    std::erase_if(of_log, [](const auto& term) { return term.second == 0; });
    return *this;
}

LogNumber operator*(const Rational& factor, const LogNumber& number) {
    LogNumber product;
    if (factor != 0) {
        product.rational = factor * number.rational;
        for (const auto& [prime, coefficient] : number.of_log) {
            product.of_log[prime] = factor * coefficient;
        }
    }
    return product;
}

LogNumber log_of(const Rational& number) {
    if (number <= 0) {
        throw std::invalid_argument("a logarithm of what is not positive");
    }
    LogNumber log;
    add_factors(log.of_log, numerator(number), 1);
    add_factors(log.of_log, denominator(number), -1);
    return log;  // numerator and denominator have no common factor: no coefficient is 0
}

std::string to_string(const LogNumber& number) {
    std::string text;
    if (number.rational != 0 || number.of_log.empty()) {
        text = to_string(number.rational);
    }
    for (const auto& [prime, coefficient] : number.of_log) {
        text +=
            fmt::format("{}({}) ln({})", text.empty() ? "" : " + ", to_string(coefficient), prime);
    }
    return text;
}

double nearest_double(const LogNumber& number) {
    Real sum = real_of(number.rational);
    for (const auto& [prime, coefficient] : number.of_log) {
        sum += real_of(coefficient) * log(Real(prime));
    }
    return sum.convert_to<double>();
}

}  // namespace nmbcgen
