// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/matching.hpp"

#include <algorithm>
#include <stdexcept>

namespace nmbcgen {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

using Series = std::vector<ex>;  // ascending powers, cut at the size

/// Product of two series, cut at the length of the first.
Series multiply(const Series& left, const Series& right) {
    Series product(left.size(), ex(0));
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (std::size_t j = 0; i + j < left.size() && j < right.size(); ++j) {
            product[i + j] += left[i] * right[j];
        }
    }
    for (ex& coefficient : product) {
        coefficient = coefficient.expand();
    }
    return product;
}

/// g_0 .. g_{count-1} of  s = y g(w), w = y^p, from  i xi = (2/h) artanh(y); s has the powers
/// 1, 1 + p, 1 + 2p, .. of i xi only.
Series series_of(const std::vector<ex>& taylor, const ex& spacing, unsigned p, unsigned count) {
    Series slope(count, ex(0));  // artanh(y)/y in powers of w
    for (unsigned k = 0; k < count; ++k) {
        if (p * k % 2 == 0) {
            slope[k] = numeric(1, long(p) * long(k) + 1);
        }
    }
    const Series slope_to_p = p == 2 ? multiply(slope, slope) : slope;
    Series power = slope;  // (artanh(y)/y)^(pk+1)
    Series g(count, ex(0));
    for (unsigned k = 0; k < count; ++k) {
        const ex factor = taylor[p * k + 1] * GiNaC::pow(2 / spacing, int(p * k + 1));
        for (unsigned j = k; j < count; ++j) {
            g[j] += factor * power[j - k];
        }
        power = multiply(power, slope_to_p);
    }
    for (ex& coefficient : g) {
        coefficient = coefficient.expand();
    }
    return g;
}

/// Coefficients of P: the maximal minors, with alternating signs, of the Hankel system
/// sum_j p_j g_{k-j} = 0, k = l+1 .. l+m. No division, so nothing can vanish unseen.
Series denominator_by_minors(const Series& g, unsigned m, unsigned l) {
    Series p(m + 1, ex(1));
    if (m == 0) {
        return p;
    }
    for (unsigned left_out = 0; left_out <= m; ++left_out) {
        GiNaC::matrix minor(m, m);
        for (unsigned row = 0; row < m; ++row) {
            for (unsigned column = 0; column < m; ++column) {
                const unsigned j = column + (column >= left_out ? 1 : 0);
                minor(row, column) = g[l + 1 + row - j];
            }
        }
        const ex determinant = minor.determinant(GiNaC::determinant_algo::laplace).expand();
        p[left_out] = left_out % 2 == 0 ? determinant : -determinant;
    }
    return p;
}

/// Adds weight * (z - 1)^a (z + 1)^b to the polynomial.
void add_factors(std::vector<ex>& polynomial, const ex& weight, unsigned a, unsigned b) {
    std::vector<numeric> product{1};
    for (unsigned factor = 0; factor < a + b; ++factor) {
        const numeric constant = factor < a ? -1 : 1;
        product.emplace_back(0);
        for (std::size_t j = product.size() - 1; j > 0; --j) {
            product[j] = product[j] * constant + product[j - 1];
        }
        product[0] = product[0] * constant;
    }
    for (std::size_t j = 0; j < product.size(); ++j) {
        polynomial[j] += weight * product[j];
    }
}

bool all_zero(const std::vector<ex>& coefficients) {
    return std::ranges::all_of(coefficients, [](const ex& c) { return c.is_zero(); });
}

/// The polynomial's value at z = 1 or -1.
ex value_at(const std::vector<ex>& coefficients, int z) {
    ex sum = 0;
    for (std::size_t j = coefficients.size(); j-- > 0;) {
        sum = sum * z + coefficients[j];
    }
    return sum.expand();
}

}  // namespace

MatchingPolynomials match(const std::vector<ex>& taylor, const ex& spacing, unsigned order) {
    if (order < 1 || taylor.size() < 2 * std::size_t(order) + 1) {
        throw std::invalid_argument("match: order N needs the Taylor coefficients a_0 .. a_2N");
    }
    if (!taylor[0].is_zero()) {
        throw std::invalid_argument("match: a_0 is not zero");
    }
    unsigned power = 2;  // p of w = y^p
    for (unsigned k = 2; k <= 2 * order; k += 2) {
        if (!taylor[k].is_zero()) {
            power = 1;
        }
    }
    const unsigned m = order / power;        // degree of P
    const unsigned l = (order - 1) / power;  // degree of Q
    const Series g = series_of(taylor, spacing, power, l + m + 1);
    const Series p = denominator_by_minors(g, m, l);

    MatchingPolynomials result{Series(order + 1, ex(0)), Series(order + 1, ex(0))};
    for (unsigned k = 0; k <= m; ++k) {
        add_factors(result.C, p[k], power * k, order - power * k);
    }
    for (unsigned k = 0; k <= l; ++k) {
        ex q = 0;
        for (unsigned j = 0; j <= std::min(k, m); ++j) {
            q += p[j] * g[k - j];
        }
        add_factors(result.B, q.expand(), power * k + 1, order - power * k - 1);
    }
    for (unsigned j = 0; j <= order; ++j) {
        result.C[j] = result.C[j].expand();
        result.B[j] = result.B[j].expand();
    }
    return result;
}

Degeneracy degeneracy(const MatchingPolynomials& matching) {
    if (all_zero(matching.C)) {
        return Degeneracy::pade_block;
    }
    // Where det of the Hankel system, and with it C(1), is not zero, Q/P is in lowest terms, and
    // z + 1 is the only factor C and B can still share (where w = y^2: else they share none).
    if (value_at(matching.C, 1).is_zero()) {
        return Degeneracy::vanishing_at_one;
    }
    if (value_at(matching.C, -1).is_zero() && value_at(matching.B, -1).is_zero()) {
        return Degeneracy::lower_order;
    }
    if (matching.C.front().is_zero()) {
        return Degeneracy::pole;
    }
    return Degeneracy::none;
}

}  // namespace nmbcgen
