// SPDX-License-Identifier: MIT
/// The coefficients of a table at a value of G: exact evaluation, rounded once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nmbc/certificate.hpp>
#include <nmbc/natural.hpp>
#include <nmbc/table.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nmbc {

/// What boundary coefficients are certified for.
struct BoundaryCertificate {
    const LatticeTable* lattice;
    double G;
    StableStep steps;   ///< as cfl = dt omega_max / 2, midpoint ghosts; cfl 0: none
    Opposite opposite;  ///< the end at the other side of the chain
    /// Interior nodes a chain needs, of its table. Chain refuses shorter ones; loops of your own
    /// have to see to it.
    std::size_t least_nodes;
};

/// c_j [1] and b_j [c/dX], j = 0 .. N, of  sum_j c_j v_{M+js} = sum_j b_j u_{M+js}  (60), j
/// counted inwards from the ghost node itself; s is the stride, c[0] = 1.
struct BoundaryCoefficients {
    std::vector<double> c;
    std::vector<double> b;
    int stride = 1;
    /// The time step [dX/c] the condition is matched in, with midpoint ghosts; 0: in continuous
    /// time, for steps of any length and any ghosts. MatchingBoundary refuses others.
    double matched_time_step = 0;
    /// None: made by hand, or taken with allow_unstable. MatchingBoundary and Chain refuse what a
    /// certificate does not cover.
    std::optional<BoundaryCertificate> certificate{};
};

/// The value does not exist: a pole of the coefficients, or C(1) = 0. what() says which and where.
struct CoefficientError : std::domain_error {
    using std::domain_error::domain_error;
};

namespace detail {

/// A signed exact integer as the difference of two naturals.
struct Difference {
    Natural plus;
    Natural minus;

    /// |plus - minus| and whether it is negative.
    std::pair<Natural, bool> magnitude() const {
        const bool negative = plus < minus;
        Natural larger = negative ? minus : plus;
        larger -= negative ? plus : minus;
        return {std::move(larger), negative};
    }
};

/// G = mantissa * 2^exponent exactly, mantissa an integer.
struct BinaryFraction {
    explicit BinaryFraction(double G) {
        int power = 0;
        const double fraction = std::frexp(G, &power);
        constexpr int digits = std::numeric_limits<double>::digits;
        mantissa = Natural(static_cast<std::uint64_t>(std::ldexp(fraction, digits)));
        exponent = power - digits;
    }
    Natural mantissa;
    int exponent = 0;
};

/// Calls use(k, text of the k-th integer) for each integer of a list with one space between.
template <class Use>
void for_each_integer(std::string_view list, Use use) {
    std::size_t k = 0;
    for (std::size_t start = 0; start < list.size(); ++k) {
        const std::size_t end = std::min(list.find(' ', start), list.size());
        use(k, list.substr(start, end - start));
        start = end + 1;
    }
}

/// 2^shift * polynomial(G), an integer, with shift = max(0, -exponent of G) * degree;
/// degree must not be less than the polynomial's own.
inline Difference evaluate_scaled(std::string_view coefficients, const BinaryFraction& G,
                                  std::size_t degree) {
    Difference sum;
    Natural power(1);  // mantissa^k
    const auto bits = static_cast<std::size_t>(std::abs(G.exponent));
    for_each_integer(coefficients, [&](std::size_t k, std::string_view digits) {
        const bool negative = digits.front() == '-';
        digits.remove_prefix(negative ? 1 : 0);
        Natural term;
        for (const char digit : digits) {
            term.multiply_add(10, static_cast<std::uint32_t>(digit - '0'));
        }
        term = term * power;
        term <<= bits * (G.exponent < 0 ? degree - k : k);
        (negative ? sum.minus : sum.plus) += term;
        power = power * G.mantissa;
    });
    return sum;
}

inline std::size_t degree_of(std::string_view coefficients) {
    return static_cast<std::size_t>(std::ranges::count(coefficients, ' '));
}

/// The double nearest to numerator/denominator (both positive), ties to even, in the normal
/// range: 64 quotient bits by long division, and what is left over as a sticky bit.
inline double nearest_quotient(Natural numerator, Natural denominator) {
    constexpr int quotient_bits = 64;
    const auto top = static_cast<int>(numerator.bit_length());
    const auto bottom = static_cast<int>(denominator.bit_length());
    int exponent = top - bottom;  // quotient in (2^(exponent-1), 2^(exponent+1))
    if (exponent >= 0) {
        denominator <<= static_cast<std::size_t>(exponent);
    } else {
        numerator <<= static_cast<std::size_t>(-exponent);
    }
    if (numerator < denominator) {
        numerator <<= 1;
        --exponent;
    }
    std::uint64_t quotient = 0;  // of numerator/denominator in [1, 2), leading bit set
    for (int bit = 0; bit < quotient_bits; ++bit) {
        quotient <<= 1;
        if (denominator <= numerator) {
            numerator -= denominator;
            quotient |= 1;
        }
        numerator <<= 1;
    }
    constexpr int dropped = quotient_bits - std::numeric_limits<double>::digits;
    constexpr std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    const std::uint64_t rest = quotient & (2 * half - 1);
    std::uint64_t kept = quotient >> dropped;
    const bool above_half = rest > half || (rest == half && !numerator.is_zero());
    if (above_half || (rest == half && kept % 2 == 1)) {
        ++kept;
    }
    return std::ldexp(static_cast<double>(kept), exponent - quotient_bits + 1 + dropped);
}

inline void require_possible(double G) {
    if (!std::isfinite(G) || G < 0) {
        throw std::invalid_argument("the stabilisation G must be finite and not negative, not " +
                                    to_text(G));
    }
}

}  // namespace detail

/// function at G >= 0, correctly rounded where the value is in the normal range of doubles
/// (within 1/2 ulp, however near to a pole).
/// Throws CoefficientError at a pole or where the value overflows, and std::invalid_argument where
/// G is negative or not finite.
inline double evaluate(const RationalFunction& function, double G) {
    detail::require_possible(G);
    const detail::BinaryFraction exact_G(G);
    const std::size_t degree =
        std::max(detail::degree_of(function.numerator), detail::degree_of(function.denominator));
    auto [top, top_negative] =
        detail::evaluate_scaled(function.numerator, exact_G, degree).magnitude();
    auto [bottom, bottom_negative] =
        detail::evaluate_scaled(function.denominator, exact_G, degree).magnitude();
    if (bottom.is_zero()) {
        throw CoefficientError("pole of a coefficient at G = " + detail::to_text(G));
    }
    if (top.is_zero()) {
        return 0;
    }
    const double magnitude = detail::nearest_quotient(std::move(top), std::move(bottom));
    if (std::isinf(magnitude)) {
        throw CoefficientError("a coefficient exceeds every double at G = " + detail::to_text(G));
    }
    return top_negative == bottom_negative ? magnitude : -magnitude;
}

/// The whole list at G.
inline std::vector<double> evaluate(std::span<const RationalFunction> functions, double G) {
    std::vector<double> values;
    values.reserve(functions.size());
    for (const RationalFunction& function : functions) {
        values.push_back(evaluate(function, G));
    }
    return values;
}

namespace detail {

/// The double nearest to a fraction "p/q" or "p".
inline double nearest_to_fraction(std::string_view fraction) {
    const std::size_t slash = std::min(fraction.find('/'), fraction.size());
    const bool whole = slash == fraction.size();
    return evaluate(
        RationalFunction{fraction.substr(0, slash), whole ? "1" : fraction.substr(slash + 1)}, 0);
}

/// Throws std::invalid_argument where the table was made for one G, and this is another.
inline void require_own_G(const MatchingTable& table, double G) {
    if (!table.fixed_G.empty() && nearest_to_fraction(table.fixed_G) != G) {
        throw std::invalid_argument(std::string(table.name) +
                                    " was made for G = " + std::string(table.fixed_G) + " only");
    }
}

}  // namespace detail

/// To be named where coefficients are wanted that no certificate covers.
struct AllowUnstable {
    explicit AllowUnstable() = default;
};
inline constexpr AllowUnstable allow_unstable{};

namespace detail {

inline constexpr const char* how_to_run_it =
    "; take the coefficients with allow_unstable to run it";

}  // namespace detail

/// The boundary coefficients of a table at G >= 0, certified or not; at the table's own G where
/// that is fixed. Throws CoefficientError where there is no boundary condition at this G (a pole,
/// or C(1) = 0, which would let a constant grow like t^2), std::invalid_argument for a bad G or for
/// a G other than the one the table was made for.
///
/// Where the coefficients of order N are z + 1 times those of order N - 1 (n = 1, N = 2, G = 1, for
/// one), the generator refuses the table at this G, since (49) is singular; its limit is returned
/// here: the same condition, asked of two neighbouring nodes.
inline BoundaryCoefficients boundary_coefficients(const MatchingTable& table, double G,
                                                  AllowUnstable /*certificate*/) {
    detail::require_own_G(table, G);
    const std::string where =
        "NMBC" + std::to_string(table.order) + " (" + std::string(table.name) + ")";
    BoundaryCoefficients result;
    result.stride = table.stride;
    result.matched_time_step = detail::nearest_to_fraction(table.time_step);
    try {
        result.c = evaluate(table.c, G);
        result.b = evaluate(table.b, G);
    } catch (const CoefficientError& pole) {
        throw CoefficientError(where + " does not exist here: " + pole.what());
    }
    double sum = 0;
    double magnitude = 0;
    for (const double c : result.c) {
        sum += c;
        magnitude += std::abs(c);
    }
    // At the double nearest to a degenerate G, C(1) is not 0 but what one rounding of G, and one
    // of each c_j, make of it: coefficients can change 1000 times as fast as G.
    if (std::abs(sum) <= 1e-12 * magnitude) {
        throw CoefficientError(where + " is degenerate at G = " + detail::to_text(G) +
                               ": C(1) = 0, a constant would grow like t^2; use another order or "
                               "another G");
    }
    return result;
}

/// The boundary coefficients of a table at a G >= 0 where it is certified to be stable opposite
/// such an end. Throws as above, and NotCertified, which names what is certified instead: other G,
/// and of `others`, such as nmbc::generated::tables, other orders and strides.
inline BoundaryCoefficients boundary_coefficients(
    const MatchingTable& table, double G, Opposite opposite,
    std::span<const MatchingTable* const> others = {}) {
    BoundaryCoefficients result = boundary_coefficients(table, G, allow_unstable);
    require_certified(table, G, opposite, others);
    result.certificate = {table.lattice, G, certified_steps(table, G, opposite), opposite,
                          static_cast<std::size_t>(table.least_nodes)};
    return result;
}

/// With its like at the other end.
inline BoundaryCoefficients boundary_coefficients(
    const MatchingTable& table, double G, std::span<const MatchingTable* const> others = {}) {
    return boundary_coefficients(table, G, Opposite::like, others);
}

}  // namespace nmbc
