// SPDX-License-Identifier: MIT
/// Laurent polynomials in exp(i xi_x), exp(i xi_y) whose coefficients are polynomials in g.
#pragma once

#include <map>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/force_constants.hpp"

namespace nmbcgen::test {

/// sum of coefficients times exp(i xi . offset); no coefficient is zero.
class Laurent {
  public:
    Laurent() = default;
    explicit Laurent(const Rational& value) { add({}, constant(value)); }
    Laurent(const Offset& offset, const Rational& value) { add(offset, constant(value)); }

    /// Entry (a, b) of a dynamical matrix.
    Laurent(const ForceConstants& phi, std::size_t a, std::size_t b) {
        for (const auto& [offset, matrix] : phi) {
            add(offset, matrix[a][b]);
        }
    }

    void add(const Offset& offset, const Polynomial& value) {
        Polynomial& coefficient = coefficients_[offset];
        coefficient += value;
        if (coefficient.is_zero()) {
            coefficients_.erase(offset);
        }
    }

    /// At a value of g.
    Laurent at(const Rational& value) const {
        Laurent result;
        for (const auto& [offset, coefficient] : coefficients_) {
            result.add(offset, constant(evaluate(coefficient, value)));
        }
        return result;
    }

    /// sum of coefficients times offset_x^power.
    Polynomial moment(int power) const {
        Polynomial sum;
        for (const auto& [offset, coefficient] : coefficients_) {
            sum += coefficient * constant(Rational(pow(Integer(offset[0]), unsigned(power))));
        }
        return sum;
    }

    friend Laurent operator+(Laurent left, const Laurent& right) {
        for (const auto& [offset, value] : right.coefficients_) {
            left.add(offset, value);
        }
        return left;
    }
    friend Laurent operator-(const Laurent& left, const Laurent& right) {
        return left + Laurent(Rational(-1)) * right;
    }
    friend Laurent operator*(const Laurent& left, const Laurent& right) {
        Laurent product;
        for (const auto& [p, f] : left.coefficients_) {
            for (const auto& [q, g] : right.coefficients_) {
                product.add({p[0] + q[0], p[1] + q[1], p[2] + q[2]}, f * g);
            }
        }
        return product;
    }
    friend Laurent operator*(const Polynomial& factor, Laurent right) {
        for (auto& [offset, value] : right.coefficients_) {
            value *= factor;
        }
        return right;
    }
    friend bool operator==(const Laurent& left, const Laurent& right) = default;

  private:
    std::map<Offset, Polynomial> coefficients_;
};

}  // namespace nmbcgen::test
