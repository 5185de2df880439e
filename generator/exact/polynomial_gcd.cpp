// SPDX-License-Identifier: MIT
#include "generator/exact/polynomial_gcd.hpp"

#include <algorithm>
#include <boost/math/tools/polynomial_gcd.hpp>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbcgen {
namespace {

using Residue = std::uint64_t;          // below the prime, so that products fit
using Residues = std::vector<Residue>;  // ascending, the last one not 0; none: 0

IntegerPolynomial primitive_part(IntegerPolynomial polynomial) {
    const Integer content = abs(boost::math::tools::content(polynomial));
    polynomial /= polynomial.data().back() < 0 ? Integer(-content) : content;
    return polynomial;
}

bool is_prime(Residue candidate) {
    for (Residue divisor = 2; divisor * divisor <= candidate; ++divisor) {
        if (candidate % divisor == 0) {
            return false;
        }
    }
    return true;
}

Residue prime_below(Residue bound) {
    do {
        --bound;
    } while (!is_prime(bound));
    return bound;
}

Residue modulo(const Integer& value, Residue prime) {
    const Integer rest = value % prime;
    return Residue(rest < 0 ? Integer(rest + prime) : rest);
}

Residues modulo(const IntegerPolynomial& polynomial, Residue prime) {
    Residues residues;
    for (const Integer& coefficient : polynomial.data()) {
        residues.push_back(modulo(coefficient, prime));
    }
    return residues;
}

Residue power(Residue base, Residue exponent, Residue prime) {
    Residue result = 1;
    for (; exponent > 0; exponent /= 2) {
        result = exponent % 2 == 1 ? result * base % prime : result;
        base = base * base % prime;
    }
    return result;
}

Residue inverse(Residue value, Residue prime) {
    return power(value, prime - 2, prime);
}

void make_monic(Residues& polynomial, Residue prime) {
    const Residue factor = inverse(polynomial.back(), prime);
    for (Residue& coefficient : polynomial) {
        coefficient = coefficient * factor % prime;
    }
}

/// Euclid's algorithm; monic.
Residues gcd_modulo(Residues a, Residues b, Residue prime) {
    while (!b.empty()) {
        make_monic(b, prime);
        while (a.size() >= b.size()) {
            const Residue factor = prime - a.back();
            const std::size_t shift = a.size() - b.size();
            for (std::size_t i = 0; i < b.size(); ++i) {
                a[shift + i] = (a[shift + i] + factor * b[i]) % prime;
            }
            while (!a.empty() && a.back() == 0) {
                a.pop_back();
            }
        }
        std::swap(a, b);
    }
    return a;
}

/// Whether the quotient has integer coefficients.
bool divides(const IntegerPolynomial& divisor, const IntegerPolynomial& polynomial) {
    std::vector<Integer> rest = polynomial.data();
    const std::vector<Integer>& by = divisor.data();
    while (rest.size() >= by.size()) {
        const Integer factor = rest.back() / by.back();
        if (factor * by.back() != rest.back()) {
            return false;
        }
        const std::size_t shift = rest.size() - by.size();
        for (std::size_t i = 0; i < by.size(); ++i) {
            rest[shift + i] -= factor * by[i];
        }
        rest.pop_back();
    }
    return std::ranges::all_of(rest, [](const Integer& entry) { return entry == 0; });
}

/// Coefficients known modulo a product of primes.
class Lifted {
  public:
    /// Where the image is of another degree, it is that of an unlucky prime, or all before were.
    void add(const Residues& image, Residue prime) {
        if (values_.empty() || image.size() < values_.size()) {
            values_.assign(image.begin(), image.end());
            modulus_ = prime;
            return;
        }
        if (image.size() > values_.size()) {
            return;
        }
        const Residue factor = inverse(modulo(modulus_, prime), prime);
        for (std::size_t i = 0; i < image.size(); ++i) {
            const Residue missing = (image[i] + prime - modulo(values_[i], prime)) % prime;
            values_[i] += modulus_ * Integer(missing * factor % prime);
        }
        modulus_ *= prime;
    }

    /// The coefficients of least size.
    std::vector<Integer> symmetric() const {
        std::vector<Integer> result = values_;
        for (Integer& value : result) {
            if (2 * value > modulus_) {
                value -= modulus_;
            }
        }
        return result;
    }

  private:
    std::vector<Integer> values_{};
    Integer modulus_ = 1;
};

}  // namespace

IntegerPolynomial primitive_gcd(const IntegerPolynomial& one, const IntegerPolynomial& other) {
    if (one.is_zero() && other.is_zero()) {
        throw std::domain_error("everything divides two polynomials 0");
    }
    if (one.is_zero() || other.is_zero()) {
        return primitive_part(one.is_zero() ? other : one);
    }
    const IntegerPolynomial a = primitive_part(one);
    const IntegerPolynomial b = primitive_part(other);
    // The leading coefficient of the divisor divides that of both.
    const Integer leading = gcd(a.data().back(), b.data().back());
    Lifted lifted;
    std::vector<Integer> before;
    constexpr Residue above_all = Residue{1} << 31;
    for (Residue prime = prime_below(above_all);; prime = prime_below(prime)) {
        if (modulo(a.data().back(), prime) == 0 || modulo(b.data().back(), prime) == 0) {
            continue;
        }
        Residues image = gcd_modulo(modulo(a, prime), modulo(b, prime), prime);
        if (image.size() == 1) {
            return IntegerPolynomial(std::vector<Integer>{1});
        }
        const Residue scale = modulo(leading, prime);
        for (Residue& coefficient : image) {
            coefficient = coefficient * scale % prime;
        }
        lifted.add(image, prime);
        std::vector<Integer> now = lifted.symmetric();
        if (now == before) {
            IntegerPolynomial candidate = primitive_part(IntegerPolynomial(now));
            if (divides(candidate, a) && divides(candidate, b)) {
                return candidate;
            }
        }
        before = std::move(now);
    }
}

}  // namespace nmbcgen
