// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/real_roots.hpp"

#include <algorithm>
#include <boost/math/tools/polynomial_gcd.hpp>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

using boost::math::tools::leading_coefficient;
using boost::math::tools::subresultant_gcd;

/// The integer polynomial with the same roots, primitive, the leading coefficient positive.
IntegerPolynomial primitive(const Polynomial& polynomial) {
    IntegerPolynomial result = to_rational_function(polynomial).numerator;
    const Integer content = abs(boost::math::tools::content(result));
    result /= leading_coefficient(result) < 0 ? Integer(-content) : content;
    return result;
}

/// primitive(polynomial / divisor), where divisor divides it.
IntegerPolynomial quotient(const IntegerPolynomial& polynomial, const IntegerPolynomial& divisor) {
    // Boost's division over Z would scale the quotient; over Q it is the quotient.
    return primitive(over_rationals(polynomial) / over_rationals(divisor));
}

IntegerPolynomial primitive_square_free(const Polynomial& polynomial) {
    if (polynomial.is_zero()) {
        throw std::domain_error("every number is a root of the polynomial 0");
    }
    const IntegerPolynomial f = primitive(polynomial);
    return quotient(f, subresultant_gcd(f, f.prime()));
}

/// q^degree times the value at x = p/q, which needs no fractions.
Integer scaled_value(const IntegerPolynomial& polynomial, const Rational& x) {
    const Integer p = numerator(x);
    const Integer q = denominator(x);
    Integer value = 0;
    Integer power = 1;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        value = value * p + polynomial[k] * power;
        power *= q;
    }
    return value;
}

int sign_of(const IntegerPolynomial& polynomial, const Rational& x) {
    return scaled_value(polynomial, x).sign();
}

bool changes_sign(const IntegerPolynomial& polynomial, const AlgebraicNumber& between) {
    return sign_of(polynomial, between.low) != sign_of(polynomial, between.high);
}

Integer floor(const Rational& value) {
    const Integer p = numerator(value);
    const Integer q = denominator(value);
    return p < 0 ? Integer(-((q - 1 - p) / q)) : Integer(p / q);
}

/// Sturm's chain of a square-free polynomial, its members up to positive factors.
class SturmChain {
  public:
    explicit SturmChain(const IntegerPolynomial& polynomial) : chain_{polynomial} {
        if (polynomial.degree() > 0) {
            chain_.push_back(polynomial.prime());
        }
        while (chain_.back().degree() > 0) {
            IntegerPolynomial divisor = chain_.back();
            if (leading_coefficient(divisor) < 0) {
                divisor = -divisor;  // pseudo-division multiplies by powers of this coefficient
            }
            const IntegerPolynomial remainder = chain_[chain_.size() - 2] % divisor;
            chain_.push_back(remainder / Integer(-abs(boost::math::tools::content(remainder))));
        }
    }

    /// The changes of sign along the chain; (x, y] holds changes(x) - changes(y) roots.
    std::size_t changes(const Rational& x) const {
        std::size_t changes = 0;
        int last = 0;
        for (const IntegerPolynomial& member : chain_) {
            const int next = sign_of(member, x);
            changes += std::size_t(last * next < 0);
            last = next == 0 ? last : next;
        }
        return changes;
    }

    std::size_t roots_in_closed(const Rational& low, const Rational& high) const {
        return changes(low) - changes(high) + std::size_t(sign_of(chain_[0], low) == 0);
    }

  private:
    std::vector<IntegerPolynomial> chain_;
};

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

/// Replaces an end of the interval by the point, if it lies in between; where it is the root, the
/// number becomes the point.
void cut(AlgebraicNumber& number, const Rational& point) {
    if (point <= number.low || number.high <= point) {
        return;
    }
    const int sign = sign_of(number.polynomial, point);
    if (sign == 0) {
        number = to_algebraic_number(point);
    } else if (sign == sign_of(number.polynomial, number.low)) {
        number.low = point;
    } else {
        number.high = point;
    }
}

void halve(AlgebraicNumber& number) {
    cut(number, (number.low + number.high) / 2);
}

/// Where the secant through the interval's ends vanishes, in units of 2^-bits of the interval from
/// its low end, to the nearest unit.
Integer nearest_to_secant(const AlgebraicNumber& number, unsigned bits) {
    const auto degree = unsigned(number.polynomial.degree());
    const Integer low =
        scaled_value(number.polynomial, number.low) * pow(denominator(number.high), degree);
    const Integer high =
        scaled_value(number.polynomial, number.high) * pow(denominator(number.low), degree);
    const Integer span = 2 * (low - high);
    return ((low << (bits + 1)) + span / 2) / span;
}

bool is_rational(const AlgebraicNumber& number) {
    return number.low == number.high;
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

/// The rational of least denominator, and then nearest to zero, with low < it < high.
Rational simplest_between(const Rational& low, const std::optional<Rational>& high) {
    if (low < 0) {
        const bool around_zero = !high || *high > 0;
        return around_zero ? Rational(0) : Rational(-simplest_between(-*high, -low));
    }
    const Integer whole = floor(low);
    if (!high || whole + 1 < *high) {
        return whole + 1;
    }
    // No integer lies between, so that whole < it < whole + 1: the next step of the continued
    // fraction, down the Stern-Brocot tree.
    const Rational inverse_low = 1 / (*high - whole);
    const auto inverse_high = low == whole ? std::nullopt : std::optional(1 / (low - whole));
    return whole + 1 / simplest_between(inverse_low, inverse_high);
}

/// n = square^2 * radicand.
struct SquareFactor {
    Integer square = 1;
    Integer radicand = 1;
};

SquareFactor square_factor(Integer n) {
    constexpr unsigned long limit = 1000000;
    SquareFactor result;
    // Once n < p^3 without a factor below p, only a perfect square has a square factor.
    for (unsigned long p = 2; p < limit && n >= p * p * p; ++p) {
        unsigned count = 0;
        for (; integer_modulus(n, p) == 0; ++count) {
            n /= p;
        }
        result.square *= pow(Integer(p), count / 2);
        result.radicand *= pow(Integer(p), count % 2);
    }
    Integer remainder;
    const Integer root = sqrt(n, remainder);
    (remainder == 0 ? result.square : result.radicand) *= remainder == 0 ? root : n;
    return result;
}

/// The root of an irreducible quadratic: (-b +- square sqrt(radicand))/2a in lowest terms.
std::string radical_text(const AlgebraicNumber& number) {
    const auto& coefficients = number.polynomial.data();
    const Integer& a = coefficients[2];
    const Integer& b = coefficients[1];
    const auto [square, radicand] = square_factor(b * b - 4 * a * coefficients[0]);
    const Integer common = gcd(gcd(b, square), 2 * a);
    const Integer whole = -b / common;
    const Integer multiple = square / common;
    const Integer denominator = 2 * a / common;

    const bool above = std::is_gt(compare(number, Rational(-b, 2 * a)));
    const std::string root =
        (multiple == 1 ? "" : multiple.str() + "*") + "sqrt(" + radicand.str() + ")";
    if (whole == 0) {
        return (above ? "" : "-") + root + (denominator == 1 ? "" : "/" + denominator.str());
    }
    const std::string sum = whole.str() + (above ? " + " : " - ") + root;
    return denominator == 1 ? sum : "(" + sum + ")/" + denominator.str();
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

AlgebraicNumber to_algebraic_number(const Rational& value) {
    return {IntegerPolynomial(std::vector<Integer>{-numerator(value), denominator(value)}), value,
            value};
}

void refine(AlgebraicNumber& number, const Rational& width) {
    if (width <= 0) {
        throw std::invalid_argument("refine: the width must be positive");
    }
    unsigned bits = 2;
    while (number.high - number.low > width) {
        const Rational step = (number.high - number.low) / Integer(Integer(1) << bits);
        const Rational middle = number.low + nearest_to_secant(number, bits) * step;
        cut(number, middle - step);
        cut(number, middle + step);
        if (number.high - number.low <= 2 * step) {
            bits *= 2;
        } else {
            halve(number);
            bits = std::max(bits / 2, 2U);
        }
    }
}

double nearest_double(const AlgebraicNumber& number) {
    AlgebraicNumber narrow = number;
    // First relative to the number, so that neither zero nor infinity is near if it is not.
    const Integer precision = Integer(1) << 60;
    while ((narrow.high - narrow.low) * precision > std::min(abs(narrow.low), abs(narrow.high))) {
        halve(narrow);
    }
    while (nearest_double(narrow.low) != nearest_double(narrow.high)) {
        halve(narrow);
    }
    return nearest_double(narrow.low);
}

std::strong_ordering compare(const AlgebraicNumber& left, const Rational& right) {
    AlgebraicNumber cut_there = left;
    cut(cut_there, right);
    if (is_rational(cut_there)) {
        return cut_there.low.compare(right) <=> 0;
    }
    return cut_there.high <= right ? std::strong_ordering::less : std::strong_ordering::greater;
}

std::strong_ordering compare(const AlgebraicNumber& left, const AlgebraicNumber& right) {
    const auto overlap = [](const AlgebraicNumber& a, const AlgebraicNumber& b) {
        return a.low <= b.high && b.low <= a.high;
    };
    if (overlap(left, right)) {
        const IntegerPolynomial common = subresultant_gcd(left.polynomial, right.polynomial);
        const SturmChain chain(common);
        if (chain.roots_in_closed(std::max(left.low, right.low), std::min(left.high, right.high)) >
            0) {
            return std::strong_ordering::equal;
        }
    }
    AlgebraicNumber a = left;
    AlgebraicNumber b = right;
    while (overlap(a, b)) {
        halve(a);
        halve(b);
    }
    return a.high < b.low ? std::strong_ordering::less : std::strong_ordering::greater;
}

int sign_at(const Polynomial& polynomial, const AlgebraicNumber& number) {
    if (polynomial.is_zero()) {
        return 0;
    }
    const IntegerPolynomial f = primitive_square_free(polynomial);
    AlgebraicNumber narrow = number;
    if (!is_rational(number)) {
        if (changes_sign(subresultant_gcd(f, number.polynomial), number)) {
            return 0;
        }
        const SturmChain chain(f);
        while (chain.roots_in_closed(narrow.low, narrow.high) > 0) {
            halve(narrow);
        }
    }
    return evaluate(polynomial, narrow.low).sign();
}

Rational rational_between(const AlgebraicNumber& one, const AlgebraicNumber& other) {
    const auto order = compare(one, other);
    if (std::is_eq(order)) {
        throw std::invalid_argument("no number lies between two equal ones");
    }
    AlgebraicNumber left = std::is_lt(order) ? one : other;
    AlgebraicNumber right = std::is_lt(order) ? other : one;
    // The simplest rational of the hull is the one wanted as soon as it lies in the gap. Simpler
    // ones before and behind leave the hull, which closes in on the two numbers.
    while (true) {
        Rational candidate = simplest_between(left.low, right.high);
        if (left.high < candidate && candidate < right.low) {
            return candidate;
        }
        halve(left);
        halve(right);
    }
}

Rational rational_above(const AlgebraicNumber& number) {
    const Integer positive_and_above = abs(floor(number.high)) + 2;
    return rational_between(number, to_algebraic_number(Rational(positive_and_above)));
}

std::string to_text(const AlgebraicNumber& number) {
    if (is_rational(number)) {
        return to_string(number.low);
    }
    return number.polynomial.degree() == 2 ? radical_text(number) : "";
}

}  // namespace nmbcgen
