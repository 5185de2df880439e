// SPDX-License-Identifier: GPL-2.0-or-later
/// Real roots and algebraic numbers: known answers, and polynomials made of known factors.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "tests/support/generators.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Rational everywhere = -Rational(pow(Integer(10), 30));

Polynomial poly(std::vector<Rational> coefficients) {
    return {std::move(coefficients)};
}

Polynomial linear(const Rational& root) {
    return poly({-root, 1});
}

using Texts = std::vector<std::string>;

Texts texts(const std::vector<AlgebraicNumber>& numbers) {
    Texts result(numbers.size());
    std::ranges::transform(numbers, result.begin(), to_text);
    return result;
}

bool equal(const AlgebraicNumber& left, const AlgebraicNumber& right) {
    return std::is_eq(compare(left, right));
}

/// The number lies within half a unit in the last place, as its polynomial's signs there tell.
bool rounded_correctly(const AlgebraicNumber& number) {
    const double value = nearest_double(number);
    if (number.low == number.high) {
        return value == nearest_double(number.low);
    }
    const auto half_way = [value](double towards) {
        return Rational((Rational(value) + Rational(std::nextafter(value, towards))) / 2);
    };
    // No further than the interval, so that a change of sign is this root's.
    const Rational from = std::max(half_way(-infinity), number.low);
    const Rational to = std::min(half_way(infinity), number.high);
    const Polynomial f = over_rationals(number.polynomial);
    return from < to && evaluate(f, from) * evaluate(f, to) < 0;
}

/// What AlgebraicNumber promises.
bool well_formed(const AlgebraicNumber& number) {
    const auto& coefficients = number.polynomial.data();
    Integer content = 0;
    for (const Integer& coefficient : coefficients) {
        content = gcd(content, coefficient);
    }
    const Polynomial f = over_rationals(number.polynomial);
    const bool rational = number.low == number.high;
    return content == 1 && coefficients.back() > 0 &&
           rational == (number.polynomial.degree() == 1) && square_free(f) == f &&
           count_real_roots(f, number.low, number.high) == 1 &&
           (rational || evaluate(f, number.low) * evaluate(f, number.high) < 0);
}

/// All of them, ascending and disjoint.
bool all_well_formed(const std::vector<AlgebraicNumber>& numbers) {
    const auto meet = [](const auto& left, const auto& right) { return left.high >= right.low; };
    return std::ranges::adjacent_find(numbers, meet) == numbers.end() &&
           std::ranges::all_of(numbers, well_formed);
}

/// A root known by construction: centre + branch * radicand^(1/degree).
struct KnownRoot {
    Rational centre;
    unsigned degree = 1;
    Rational radicand = 0;
    int branch = 1;  ///< of the square root

    /// (x - centre)^degree - radicand
    Polynomial factor() const {
        Polynomial power = constant(1);
        for (unsigned k = 0; k < degree; ++k) {
            power *= linear(centre);
        }
        return power - constant(radicand);
    }

    /// The sign of the root minus x, by powers of x - centre alone.
    int minus(const Rational& x) const {
        const Rational d = x - centre;
        if (degree != 2) {
            return Rational(radicand - (degree == 1 ? d : Rational(d * d * d))).sign();
        }
        return branch * d <= 0 ? branch : branch * Rational(radicand - d * d).sign();
    }
};

/// A polynomial made of known factors, of random multiplicity.
struct Construction {
    Polynomial polynomial = constant(1);
    std::vector<KnownRoot> roots;

    void multiply(const KnownRoot& root) {
        if ((polynomial % root.factor()).is_zero()) {
            return;
        }
        const bool complex = root.degree == 2 && root.radicand < 0;
        for (const int branch : {-1, 1}) {
            if (!complex && (branch == 1 || root.degree == 2)) {
                roots.push_back(root);
                roots.back().branch = branch;
            }
        }
        for (int k = *rc::gen::inRange(1, 3); k > 0; --k) {
            polynomial *= root.factor() * constant(*rc::gen::inRange(1, 4));
        }
    }
};

/// Radicands of which neither the square nor the cube root is rational; x^2 = -1 is irreducible.
Rational random_radicand() {
    return *rc::gen::element(2, 3, 5, 6, 12, 18, 99991, -1, -2) *
           *rc::gen::element(Rational(1), Rational(1, 25), Rational(9, 49));
}

Construction construct() {
    Construction result;
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
        result.multiply({*small_rational()});
    }
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
        result.multiply({*small_rational(), 2, random_radicand()});
    }
    for (int k = *rc::gen::inRange(0, 3); k > 0; --k) {
        result.multiply({*small_rational(), 3, 2 * *rc::gen::inRange(1, 4)});
    }
    return result;
}

/// The one of the known roots that the interval holds.
const KnownRoot& identify(const AlgebraicNumber& found, const std::vector<KnownRoot>& known) {
    const auto held = [&found](const KnownRoot& root) {
        return root.minus(found.low) >= 0 && root.minus(found.high) <= 0;
    };
    RC_ASSERT(std::ranges::count_if(known, held) == 1);
    return *std::ranges::find_if(known, held);
}

}  // namespace

TEST_CASE("quadratic numbers as radicals") {
    CHECK(texts(real_roots(poly({2, -4, 1}), 0)) == Texts{"2 - sqrt(2)", "2 + sqrt(2)"});
    // Sum 2*5584/4335, product (5584^2 - 80^2 433)/4335^2 = 32768/21675.
    CHECK(texts(real_roots(poly({Rational(32768, 21675), Rational(-11168, 4335), 1}), 0)) ==
          Texts{"(5584 - 80*sqrt(433))/4335", "(5584 + 80*sqrt(433))/4335"});
    CHECK(texts(real_roots(poly({-9, 0, 2}), -9)) == Texts{"-3*sqrt(2)/2", "3*sqrt(2)/2"});
    CHECK(texts(real_roots(poly({-1, -1, 1}), -9)) == Texts{"(1 - sqrt(5))/2", "(1 + sqrt(5))/2"});
    CHECK(texts(real_roots(poly({-3, 0, 1}), 0)) == Texts{"sqrt(3)"});
    CHECK(texts(real_roots(poly({-3, 0, 1}), -2, 0)) == Texts{"-sqrt(3)"});
    CHECK(texts(real_roots(poly({-3, 0, 9}), 0)) == Texts{"sqrt(3)/3"});
    // Radicands with square factors: 4*49*11, and the square of a prime above 10^6 times 2.
    CHECK(texts(real_roots(poly({-2156, 0, 1}), 0)) == Texts{"14*sqrt(11)"});
    const Integer prime = 1000003;
    CHECK(texts(real_roots(poly({Rational(-2 * prime * prime), 0, 1}), 0)) ==
          Texts{"1000003*sqrt(2)"});
    CHECK(texts(real_roots(poly({-2, 0, 0, 1}), 0)) == Texts{""});  // a cube root has no text
}

TEST_CASE("factors are found in products, with multiple roots and among others") {
    // (x^2 - 4x + 2)^2 (3x - 1)^3 x (x^2 + 1) (x^3 - 2)
    const Polynomial quadratic = poly({2, -4, 1});
    const Polynomial cubic = poly({-2, 0, 0, 1});
    const Polynomial third = poly({-1, 3});
    const Polynomial f =
        quadratic * quadratic * third * third * third * poly({0, 1}) * poly({1, 0, 1}) * cubic;
    const auto roots = real_roots(f, everywhere);
    CHECK(texts(roots) == Texts{"0", "1/3", "2 - sqrt(2)", "", "2 + sqrt(2)"});
    CHECK(all_well_formed(roots));
    CHECK(over_rationals(roots[2].polynomial) == quadratic);
    CHECK(equal(roots[3], real_roots(cubic, 0).at(0)));
    CHECK(nearest_double(roots[3]) == std::cbrt(2.0));
    CHECK(square_free(f).degree() == 9U);

    // Irrational roots only in pairs that do not make a rational quadratic: sqrt(2) +- sqrt(3).
    CHECK(texts(real_roots(poly({1, 0, -10, 0, 1}), everywhere)) == Texts{"", "", "", ""});
    // A quadratic whose other root is below the limit.
    CHECK(texts(real_roots(quadratic * cubic, 2)) == Texts{"2 + sqrt(2)"});
}

TEST_CASE("a root 1e-30 from a quadratic number is not taken for it") {
    const Polynomial quadratic = poly({-2, 0, 1});
    const Polynomial near =
        poly({0, 0, 0, 0, 0, 0, 0, 1}) + quadratic * constant(Rational(pow(Integer(10), 30)));
    CHECK(texts(real_roots(near, everywhere)) == Texts{"", "", ""});
    CHECK(texts(real_roots(near * quadratic, everywhere)) ==
          Texts{"", "", "-sqrt(2)", "", "sqrt(2)"});
}

TEST_CASE("Sturm's chain may leave out degrees") {
    CHECK(count_real_roots(poly({1, 4, 0, 0, 1}), std::nullopt, std::nullopt) == 2);  // 4, 3, 1, 0
    CHECK(count_real_roots(poly({1, -4, 0, 0, 1}), std::nullopt, std::nullopt) == 2);
}

TEST_CASE("rounding next to half-way, and of very large and very small numbers") {
    const auto power = [](int exponent) {
        const Rational value(Integer(1) << unsigned(std::abs(exponent)));
        return exponent < 0 ? Rational(1 / value) : value;
    };
    // Cube roots of m^3 -+ 2^-300, m = 1 + 2^-53 half-way between two doubles.
    const Rational m = 1 + power(-53);
    for (const int side : {-1, 1}) {
        const KnownRoot next_to_m{0, 3, m * m * m + side * power(-300)};
        const auto numbers = real_roots(next_to_m.factor(), 0);
        CHECK(nearest_double(numbers.at(0)) == (side < 0 ? 1 : 1 + 0x1p-52));
    }
    for (const int exponent : {1023, -1022, -1040, -1070}) {  // the last two subnormal
        const auto large = real_roots(KnownRoot{0, 2, 2 * power(2 * exponent)}.factor(), 0);
        CHECK(nearest_double(large.at(0)) == std::ldexp(std::numbers::sqrt2, exponent));
    }
    const auto huge = real_roots(KnownRoot{0, 2, 2 * power(2048)}.factor(), 0);
    CHECK_THROWS_AS(nearest_double(huge.at(0)), std::overflow_error);
    CHECK(nearest_double(to_algebraic_number(m)) == 1);  // a tie, to even
}

TEST_CASE("roots at the ends of the interval") {
    const Polynomial f = linear(1) * linear(Rational(5, 3)) * linear(4) * poly({2, -4, 1});
    CHECK(texts(real_roots(f, 1, 4)) == Texts{"1", "5/3", "2 + sqrt(2)", "4"});
    CHECK(texts(real_roots(f, Rational(5, 3))) == Texts{"5/3", "2 + sqrt(2)", "4"});
    CHECK(texts(real_roots(f, 4, 4)) == Texts{"4"});
    CHECK(real_roots(f, 4, 1).empty());
    CHECK(real_roots(f, 5).empty());
    CHECK(real_roots(constant(-7), 0).empty());
    CHECK(count_real_roots(f, 1, 4) == 4);
    CHECK(count_real_roots(f, 1, 4, Ends::open) == 2);
    CHECK(count_real_roots(f, 4, 4) == 1);
    CHECK(count_real_roots(f, 4, 4, Ends::open) == 0);
    CHECK(count_real_roots(f, 4, 1) == 0);
    CHECK(count_real_roots(f, std::nullopt, 1) == 2);
    CHECK(count_real_roots(f, std::nullopt, 1, Ends::open) == 1);
    CHECK(count_real_roots(f, 4, std::nullopt, Ends::open) == 0);
    CHECK(count_real_roots(f, std::nullopt, std::nullopt, Ends::open) == 5);
    CHECK(count_real_roots(f, std::nullopt, -1000000) == 0);
    CHECK(count_real_roots(f, 1000000, std::nullopt) == 0);
    // Intervals keep to the limits.
    const auto near = real_roots(poly({2, -4, 1}), Rational(58, 100), Rational(59, 100));
    CHECK(near.at(0).low >= Rational(58, 100));
    CHECK(near.at(0).high <= Rational(59, 100));
    CHECK_THROWS_AS(real_roots(Polynomial(), 0), std::domain_error);
    CHECK_THROWS_AS(count_real_roots(Polynomial(), 0, 1), std::domain_error);
    CHECK_THROWS_AS(square_free(Polynomial()), std::domain_error);
}

TEST_CASE("roots 1e-12 apart") {
    const Rational gap(1, pow(Integer(10), 12));
    const Rational third(1, 3);
    CHECK(texts(real_roots(linear(third) * linear(third + gap), 0)) ==
          Texts{"1/3", "1000000000003/3000000000000"});
    // x^3 - 2 and the same moved by the gap: neither rational nor quadratic.
    const Polynomial moved = poly({-gap, 1}) * poly({-gap, 1}) * poly({-gap, 1}) - constant(2);
    const auto roots = real_roots(poly({-2, 0, 0, 1}) * moved, everywhere);
    REQUIRE(roots.size() == 2);
    CHECK(all_well_formed(roots));
    CHECK(std::is_lt(compare(roots[0], roots[1])));
    CHECK(nearest_double(roots[1]) - nearest_double(roots[0]) ==
          doctest::Approx(1e-12).epsilon(1e-3));
    const Rational between = rational_between(roots[0], roots[1]);
    CHECK(std::is_lt(compare(roots[0], between)));
    CHECK(std::is_gt(compare(roots[1], between)));
}

TEST_CASE("Wilkinson's polynomial of degree 15, and disturbed") {
    Polynomial f = constant(1);
    Texts expected;
    for (int k = 1; k <= 15; ++k) {
        f *= linear(k);
        expected.push_back(std::to_string(k));
    }
    CHECK(texts(real_roots(f, 0)) == expected);
    // Minus x^14/2^23, two pairs of roots have turned complex (mpmath, 60 digits).
    std::vector<Rational> x14(15, Rational(0));
    x14.back() = Rational(1, 1 << 23);
    const auto roots = real_roots(f - Polynomial(std::move(x14)), everywhere);
    CHECK(all_well_formed(roots));
    REQUIRE(roots.size() == 11);
    CHECK(nearest_double(roots[8]) == doctest::Approx(9.1101512));
    CHECK(nearest_double(roots[9]) == doctest::Approx(9.7574589));
    CHECK(nearest_double(roots[10]) == doctest::Approx(15.0367));
}

TEST_CASE("roots of the Chebyshev polynomial T_9 are cosines") {
    Polynomial last = constant(1);
    Polynomial chebyshev = poly({0, 1});
    for (int k = 1; k < 9; ++k) {
        last = poly({0, 2}) * chebyshev - last;
        std::swap(last, chebyshev);
    }
    const auto roots = real_roots(chebyshev, -1, 1);
    CHECK(texts(roots) == Texts{"", "-sqrt(3)/2", "", "", "0", "", "", "sqrt(3)/2", ""});
    CHECK(all_well_formed(roots));
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double angle = (17 - 2 * double(k)) * std::numbers::pi / 18;
        CHECK(std::abs(nearest_double(roots[k]) - std::cos(angle)) < 2.3e-16);
        CHECK(rounded_correctly(roots[k]));
        CHECK(sign_at(chebyshev, roots[k]) == 0);
        CHECK(sign_at(chebyshev.prime(), roots[k]) == (k % 2 == 0 ? 1 : -1));
    }
}

TEST_CASE("the roots of random products are found again") {
    CHECK(rc::check("all of them, each with its own polynomial", [] {
        const Construction made = construct();
        const auto found = real_roots(made.polynomial, everywhere);
        RC_ASSERT(all_well_formed(found));
        RC_ASSERT(found.size() == made.roots.size());
        for (const AlgebraicNumber& number : found) {
            const KnownRoot& known = identify(number, made.roots);
            const Polynomial own = over_rationals(number.polynomial);
            RC_ASSERT((own % known.factor()).is_zero());
            RC_ASSERT((known.degree == 3 ? own.degree() >= 3 : own.degree() == known.degree));
            for (const KnownRoot& other : made.roots) {
                // No factor is left in the polynomial of a root it does not belong to.
                RC_ASSERT((other.degree == 3 || other.factor() == known.factor() ||
                           !(own % other.factor()).is_zero()));
            }
            RC_ASSERT(rounded_correctly(number));
            RC_ASSERT(to_text(number).empty() == (known.degree == 3));
        }
    }));
    CHECK(rc::check("counts, and roots between two limits", [] {
        const Construction made = construct();
        Rational low = *small_rational();
        Rational high = *small_rational();
        if (!made.roots.empty() && *rc::gen::arbitrary<bool>()) {
            low = made.roots.front().centre;  // often a root
        }
        const auto count = [&made](const auto& counted) {
            return std::size_t(std::ranges::count_if(made.roots, counted));
        };
        const auto closed =
            count([&](const KnownRoot& r) { return r.minus(low) >= 0 && r.minus(high) <= 0; });
        const auto open =
            count([&](const KnownRoot& r) { return r.minus(low) > 0 && r.minus(high) < 0; });
        const auto above = count([&](const KnownRoot& r) { return r.minus(low) >= 0; });
        RC_ASSERT(count_real_roots(made.polynomial, low, high) == closed);
        RC_ASSERT(count_real_roots(made.polynomial, low, high, Ends::open) == open);
        RC_ASSERT(count_real_roots(made.polynomial, low, std::nullopt) == above);
        const auto between = real_roots(made.polynomial, low, high);
        RC_ASSERT(between.size() == closed);
        RC_ASSERT(real_roots(made.polynomial, low).size() == above);
        for (const AlgebraicNumber& number : between) {
            RC_ASSERT(low <= number.low && number.high <= high);
        }
    }));
}

TEST_CASE("comparisons are exact") {
    CHECK(rc::check("with the roots of a multiple of the polynomial", [] {
        const Construction made = construct();
        Construction more = made;
        more.multiply({*small_rational(), 3, 7});
        more.multiply({*small_rational(), 2, 7});
        const auto few = real_roots(made.polynomial, everywhere);
        const auto many = real_roots(more.polynomial, everywhere);
        std::size_t j = 0;
        for (const AlgebraicNumber& number : few) {
            for (; j < many.size() && !equal(number, many[j]); ++j) {
                RC_ASSERT(std::is_gt(compare(number, many[j])));
            }
            RC_ASSERT(j < many.size());
            for (std::size_t after = j + 1; after < many.size(); ++after) {
                RC_ASSERT(std::is_lt(compare(number, many[after])));
            }
        }
    }));
    CHECK(rc::check("with a rational", [] {
        const Construction made = construct();
        const Rational x = *small_rational();
        for (const AlgebraicNumber& number : real_roots(made.polynomial, everywhere)) {
            const int sign = identify(number, made.roots).minus(x);
            RC_ASSERT(compare(number, x) == sign <=> 0);
            RC_ASSERT(compare(number, to_algebraic_number(x)) == sign <=> 0);
        }
    }));
    CHECK(rc::check("the sign of a polynomial at a quadratic number", [] {
        const KnownRoot known{*small_rational(), 2, *rc::gen::element(2, 3, 75)};
        const auto number = real_roots(known.factor(), known.centre).at(0);
        const Polynomial p = *polynomial(6);
        const Polynomial rest = p % known.factor();  // u + v x at the number
        const Rational u = rest.size() > 0 ? rest[0] : Rational(0);
        const Rational v = rest.size() > 1 ? rest[1] : Rational(0);
        RC_ASSERT(sign_at(p, number) == (v == 0 ? u.sign() : v.sign() * known.minus(-u / v)));
        RC_ASSERT(sign_at(p * known.factor(), number) == 0);
    }));
}

TEST_CASE("refinement keeps the number and gives the width") {
    CHECK(rc::check([] {
        const Construction made = construct();
        for (const AlgebraicNumber& number : real_roots(made.polynomial, everywhere)) {
            const Rational width(1, pow(Integer(10), *rc::gen::inRange(0U, 200U)));
            AlgebraicNumber narrow = number;
            refine(narrow, width);
            RC_ASSERT(narrow.high - narrow.low <= width);
            RC_ASSERT(number.low <= narrow.low && narrow.high <= number.high);
            RC_ASSERT(well_formed(narrow));
        }
    }));
    AlgebraicNumber number = real_roots(poly({-2, 0, 1}), 0).at(0);
    CHECK_THROWS_AS(refine(number, 0), std::invalid_argument);
}

TEST_CASE("rationals between") {
    CHECK(rc::check("the simplest between two rationals", [] {
        const Rational a = *small_rational();
        const Rational b = *small_rational();
        RC_PRE(a != b);
        const auto low = std::min(a, b);
        const auto high = std::max(a, b);
        const Rational found = rational_between(to_algebraic_number(a), to_algebraic_number(b));
        RC_ASSERT(low < found && found < high);
        for (Integer q = 1; q <= denominator(found); ++q) {
            for (Integer p = -20 * q; p <= 20 * q; ++p) {
                const Rational other(p, q);
                const bool between = low < other && other < high;
                RC_ASSERT(!between || denominator(other) > denominator(found) ||
                          abs(other) >= abs(found));
                RC_ASSERT(!between || q == denominator(found) || denominator(found) == 1);
            }
        }
    }));
    CHECK(rc::check("any two roots, whatever their intervals", [] {
        const auto roots = real_roots(construct().polynomial, everywhere);
        for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
            const Rational found = rational_between(roots[i], roots[i + 1]);
            RC_ASSERT(std::is_lt(compare(roots[i], found)));
            RC_ASSERT(std::is_gt(compare(roots[i + 1], found)));
            AlgebraicNumber narrow = roots[i];
            refine(narrow, Rational(1, pow(Integer(10), 30)));
            RC_ASSERT(rational_between(roots[i + 1], narrow) == found);
        }
        if (!roots.empty()) {
            const Rational above = rational_above(roots.back());
            RC_ASSERT(std::is_lt(compare(roots.back(), above)));
            RC_ASSERT(above == 0 || std::is_gteq(compare(roots.back(), above - 1)));
            CHECK_THROWS_AS(rational_between(roots[0], roots[0]), std::invalid_argument);
        }
    }));
    CHECK(rational_above(to_algebraic_number(3)) == 4);
    CHECK(rational_above(to_algebraic_number(Rational(-7, 2))) == 0);
    CHECK(rational_between(to_algebraic_number(0), to_algebraic_number(Rational(2, 7))) ==
          Rational(1, 4));
}

TEST_CASE("radicals are written in lowest terms") {
    CHECK(rc::check([] {
        const int p = *rc::gen::inRange(-30, 31);
        const int s = *rc::gen::inRange(2, 30);
        const int q = *rc::gen::inRange(2, 30);
        const int d = *rc::gen::element(2, 3, 5, 6, 7, 10, 433, 1000003);
        RC_PRE(std::gcd(std::gcd(p, s), q) == 1 && p != 0);
        // x = (p - s sqrt(d))/q: (q x - p)^2 = s^2 d
        const auto numbers =
            real_roots(poly({-p, q}) * poly({-p, q}) - constant(Rational(s) * s * d), everywhere);
        const std::string root = std::to_string(s) + "*sqrt(" + std::to_string(d) + "))/";
        const std::string whole = "(" + std::to_string(p);
        const Texts expected{whole + " - " + root + std::to_string(q),
                             whole + " + " + root + std::to_string(q)};
        RC_ASSERT(texts(numbers) == expected);
    }));
}
