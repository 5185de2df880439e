// SPDX-License-Identifier: MIT
#include "generator/bonds/pi_polynomial.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/exact/rational.hpp"

namespace nmbcgen {

Quadratic::Quadratic(Rational rational, Rational irrational, unsigned radicand)
    : rational_(std::move(rational)), irrational_(std::move(irrational)), radicand_(radicand) {
    for (unsigned k = 2; k * k <= radicand; ++k) {
        if (radicand % (k * k) == 0) {
            throw std::invalid_argument("the radicand has a square factor");
        }
    }
    if (radicand < 2) {
        throw std::invalid_argument("the radicand is not above 1");
    }
    settle();
}

void Quadratic::meet(const Quadratic& other) {
    if (radicand_ == 1) {
        radicand_ = other.radicand_;
    } else if (other.radicand_ != 1 && other.radicand_ != radicand_) {
        throw std::logic_error("numbers of two quadratic fields");
    }
}

void Quadratic::settle() {
    if (irrational_ == 0) {
        radicand_ = 1;
    }
}

Quadratic& Quadratic::operator+=(const Quadratic& other) {
    meet(other);
    rational_ += other.rational_;
    irrational_ += other.irrational_;
    settle();
    return *this;
}

Quadratic& Quadratic::operator-=(const Quadratic& other) {
    meet(other);
    rational_ -= other.rational_;
    irrational_ -= other.irrational_;
    settle();
    return *this;
}

Quadratic& Quadratic::operator*=(const Quadratic& other) {
    meet(other);
    const Rational product =
        rational_ * other.rational_ + radicand_ * irrational_ * other.irrational_;
    irrational_ = rational_ * other.irrational_ + irrational_ * other.rational_;
    rational_ = product;
    settle();
    return *this;
}

Quadratic& Quadratic::operator/=(const Quadratic& other) {
    const Rational norm =
        other.rational_ * other.rational_ - other.radicand_ * other.irrational_ * other.irrational_;
    if (norm == 0) {
        throw std::domain_error("division by 0");
    }
    Quadratic inverse = other;
    inverse.rational_ /= norm;
    inverse.irrational_ /= -norm;
    return *this *= inverse;
}

Quadratic square_root(unsigned n) {
    unsigned outside = 1;
    for (unsigned k = 2; k * k <= n; ++k) {
        while (n % (k * k) == 0) {
            n /= k * k;
            outside *= k;
        }
    }
    return n == 1 ? Quadratic(Rational(outside)) : Quadratic(0, outside, n);
}

Real value_of(const PiPolynomial& number) {
    Real value = 0;
    Real power = 1;
    for (const Quadratic& term : number) {
        value +=
            power * (Real(term.rational()) + Real(term.irrational()) * sqrt(Real(term.radicand())));
        power *= pi();
    }
    return value;
}

std::string to_text(const PiPolynomial& number) {
    std::string text;
    const auto append = [&](const Rational& factor, const std::string& unit) {
        if (factor == 0) {
            return;
        }
        const Rational size = abs(factor);
        text += text.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
        if (unit.empty()) {
            text += to_string(size);
        } else {
            text += size == 1 ? unit : to_string(size) + "*" + unit;
        }
    };
    for (std::size_t power = 0; power < number.size(); ++power) {
        const std::string of_pi = power == 0 ? "" : power == 1 ? "pi" : fmt::format("pi^{}", power);
        const Quadratic& term = number[power];
        append(term.rational(), of_pi);
        append(term.irrational(),
               fmt::format("sqrt({}){}", term.radicand(), power == 0 ? "" : "*" + of_pi));
    }
    return text.empty() ? "0" : text;
}

}  // namespace nmbcgen
