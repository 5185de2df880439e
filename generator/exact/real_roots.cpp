// SPDX-License-Identifier: MIT
#include "generator/exact/real_roots.hpp"

#include <algorithm>
#include <boost/math/tools/polynomial_gcd.hpp>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/sturm.hpp"

namespace nmbcgen {
namespace {

using boost::math::tools::leading_coefficient;

/// A power of two above the absolute value of every root: Fujiwara's 2 max |a_(n-k)/a_n|^(1/k).
Rational root_bound(const IntegerPolynomial& polynomial) {
    const std::size_t degree = polynomial.degree();
    int exponent = 0;
    for (std::size_t k = 1; k <= degree; ++k) {
        const Integer coefficient = abs(polynomial[degree - k]);
        if (coefficient != 0) {
            const int bits = int(msb(coefficient)) + 1 - int(msb(polynomial[degree]));
            exponent = std::max(exponent, (bits + int(k) - 1) / int(k));
        }
    }
    return Integer(1) << unsigned(exponent + 1);
}

/// All real roots of a square-free polynomial, ascending. No end of an interval is a root, but
/// neighbours may have one end in common.
std::vector<AlgebraicNumber> isolate(const IntegerPolynomial& polynomial) {
    struct Interval {
        Rational low, high;
        std::size_t changes_low, changes_high;
    };
    const SturmChain chain(polynomial);
    const Rational bound = root_bound(polynomial);
    std::vector<Interval> stack{{-bound, bound, chain.changes(-bound), chain.changes(bound)}};
    std::vector<AlgebraicNumber> roots;
    while (!stack.empty()) {
        const Interval interval = stack.back();
        stack.pop_back();
        const std::size_t count = interval.changes_low - interval.changes_high;
        if (count == 1) {
            roots.push_back({polynomial, interval.low, interval.high});
        } else if (count > 1) {
            Rational middle = (interval.low + interval.high) / 2;
            while (sign_of(polynomial, middle) == 0) {
                middle = (interval.low + middle) / 2;
            }
            const std::size_t changes = chain.changes(middle);
            stack.push_back({middle, interval.high, changes, interval.changes_high});
            stack.push_back({interval.low, middle, interval.changes_low, changes});
        }
    }
    return roots;
}

/// The multiple of 1/denominator in [low, high], which is narrower than that.
std::optional<Rational> multiple_within(const Rational& low, const Rational& high,
                                        const Integer& denominator) {
    const Rational candidate(floor(high * denominator), denominator);
    return candidate < low ? std::nullopt : std::optional(candidate);
}

/// Finds the rational ones among all real roots of a polynomial, and divides the polynomial of the
/// others by their factors.
void split_off_rational(std::vector<AlgebraicNumber>& roots, const IntegerPolynomial& polynomial) {
    IntegerPolynomial rest = polynomial;
    const Integer leading = leading_coefficient(polynomial);
    for (AlgebraicNumber& root : roots) {
        AlgebraicNumber narrow = root;
        refine(narrow, Rational(1, 2 * leading));
        const auto candidate = multiple_within(narrow.low, narrow.high, leading);
        if (candidate && sign_of(polynomial, *candidate) == 0) {
            root = to_algebraic_number(*candidate);
            rest = quotient(rest, root.polynomial);
        }
    }
    for (AlgebraicNumber& root : roots) {
        root.polynomial = is_rational(root) ? root.polynomial : rest;
    }
}

/// The quadratic factor that two irrational roots of one polynomial are the roots of, if there is
/// one. Their sum and their product must be known to less than 1/leading coefficient.
std::optional<IntegerPolynomial> quadratic_factor(const AlgebraicNumber& one,
                                                  const AlgebraicNumber& other) {
    const Integer leading = leading_coefficient(one.polynomial);
    const auto [least, greatest] =
        std::minmax({Rational(one.low * other.low), Rational(one.low * other.high),
                     Rational(one.high * other.low), Rational(one.high * other.high)});
    const auto sum = multiple_within(one.low + other.low, one.high + other.high, leading);
    const auto product = multiple_within(least, greatest, leading);
    if (!sum || !product) {
        return std::nullopt;
    }
    const Polynomial factor(std::vector<Rational>{*product, -*sum, 1});
    const IntegerPolynomial result = primitive(factor);
    // A divisor's roots are among the polynomial's, of which either interval has only one.
    const bool found = (over_rationals(one.polynomial) % factor).is_zero() &&
                       changes_sign(result, one) && changes_sign(result, other);
    return found ? std::optional(result) : std::nullopt;
}

/// Likewise for quadratic roots, in all pairs of irrational ones.
void split_off_quadratic(std::vector<AlgebraicNumber*> roots) {
    if (roots.size() < 2) {
        return;
    }
    IntegerPolynomial rest = roots[0]->polynomial;
    // Of width w, two roots have a sum of width 2w, a product of width < 2 bound w. The 2^20
    // leaves few pairs that only seem to have a sum and a product with the denominator.
    const Rational width =
        1 / (root_bound(rest) * leading_coefficient(rest) * Integer(Integer(1) << 20));
    std::vector<AlgebraicNumber> narrow;
    for (const AlgebraicNumber* root : roots) {
        narrow.push_back(*root);
        refine(narrow.back(), width);
    }
    for (std::size_t i = 0; i < roots.size(); ++i) {
        for (std::size_t j = i + 1; j < roots.size(); ++j) {
            if (const auto factor = quadratic_factor(narrow[i], narrow[j])) {
                roots[i]->polynomial = roots[j]->polynomial = *factor;
                rest = quotient(rest, *factor);
            }
        }
    }
    for (AlgebraicNumber* root : roots) {
        const bool quadratic = root->polynomial.degree() == 2;
        root->polynomial = quadratic ? root->polynomial : rest;
    }
}

}  // namespace

Polynomial square_free(const Polynomial& polynomial) {
    return over_rationals(primitive_square_free(polynomial));
}

std::size_t count_real_roots(const Polynomial& polynomial, const std::optional<Rational>& low,
                             const std::optional<Rational>& high, Ends ends) {
    const IntegerPolynomial f = primitive_square_free(polynomial);
    const Rational bound = root_bound(f);
    const Rational from = low.value_or(std::min(-bound, high.value_or(-bound)));
    const Rational to = high.value_or(std::max(bound, from));
    if (to < from || (to == from && ends == Ends::open)) {
        return 0;
    }
    const auto at = [&f](const Rational& end) { return std::size_t(sign_of(f, end) == 0); };
    const std::size_t closed = SturmChain(f).roots_in_closed(from, to);
    return ends == Ends::closed ? closed : closed - at(from) - at(to);
}

std::vector<AlgebraicNumber> real_roots(const Polynomial& polynomial, const Rational& low,
                                        const std::optional<Rational>& high) {
    const IntegerPolynomial f = primitive_square_free(polynomial);
    std::vector<AlgebraicNumber> roots = isolate(f);
    split_off_rational(roots, f);
    std::vector<AlgebraicNumber*> irrational;
    for (AlgebraicNumber& root : roots) {
        if (!is_rational(root)) {
            irrational.push_back(&root);
        }
    }
    split_off_quadratic(irrational);

    std::erase_if(roots, [&](const AlgebraicNumber& root) {
        return std::is_lt(compare(root, low)) || (high && std::is_gt(compare(root, *high)));
    });
    for (AlgebraicNumber& root : roots) {
        cut(root, low);
        cut(root, high.value_or(low));
    }
    for (std::size_t i = 1; i < roots.size(); ++i) {
        while (roots[i - 1].high >= roots[i].low) {
            halve(roots[i - 1]);
            halve(roots[i]);
        }
    }
    return roots;
}

}  // namespace nmbcgen
