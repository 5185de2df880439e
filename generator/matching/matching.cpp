// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/matching.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

#include "generator/matching/moebius.hpp"

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

/// The sum of expanded summands, in one go.
ex expanded_sum(const GiNaC::exvector& summands) {
    return GiNaC::dynallocate<GiNaC::add>(summands);
}

/// Adds the terms of left * right, both expanded: of each term of `left`, the shorter, with all of
/// `right`. expand() of the whole would add them up term by term, which takes most of its time.
void add_product(GiNaC::exvector& summands, const ex& left, const ex& right) {
    if (!GiNaC::is_a<GiNaC::add>(left)) {
        summands.push_back((left * right).expand());
        return;
    }
    for (const ex& term : left) {
        summands.push_back((term * right).expand());
    }
}

Series sums(const std::vector<GiNaC::exvector>& lists) {
    Series result;
    for (const GiNaC::exvector& summands : lists) {
        result.push_back(expanded_sum(summands));
    }
    return result;
}

/// Coefficients of P: the maximal minors, with alternating signs, of the Hankel system
/// sum_j p_j g_{k-j} = 0, k = l+1 .. l+m. No division, so nothing can vanish unseen. All of them
/// come from one Laplace expansion, row by row: the minors of the first r rows, one for every set
/// of r columns, serve all those of r + 1 rows.
Series denominator_by_minors(const Series& g, unsigned m, unsigned l) {
    using Columns = std::vector<unsigned>;  // ascending
    std::map<Columns, ex> minors{{{}, ex(1)}};
    for (unsigned k = l + 1; k <= l + m; ++k) {
        std::map<Columns, GiNaC::exvector> summands;
        for (const auto& [columns, minor] : minors) {
            for (unsigned j = 0; j <= m; ++j) {
                const auto place = std::ranges::lower_bound(columns, j);
                if (place != columns.end() && *place == j) {
                    continue;
                }
                const bool odd = (columns.end() - place) % 2 == 1;
                Columns wider(columns.begin(), place);
                wider.push_back(j);
                wider.insert(wider.end(), place, columns.end());
                add_product(summands[wider], odd ? -g[k - j] : g[k - j], minor);
            }
        }
        minors.clear();
        for (const auto& [columns, terms] : summands) {
            minors.emplace(columns, expanded_sum(terms));
        }
    }
    Series p;
    for (unsigned left_out = 0; left_out <= m; ++left_out) {
        Columns columns(m + 1);
        std::iota(columns.begin(), columns.end(), 0U);
        columns.erase(columns.begin() + left_out);
        p.push_back(left_out % 2 == 0 ? minors.at(columns) : -minors.at(columns));
    }
    return p;
}

/// Adds weight * (z - 1)^a (z + 1)^b to the polynomial, whose coefficients are lists of summands.
void add_factors(std::vector<GiNaC::exvector>& polynomial, const ex& weight, unsigned a,
                 unsigned b) {
    const std::vector<numeric> product = moebius_factors<numeric>(a, b);
    for (std::size_t j = 0; j < product.size(); ++j) {
        polynomial[j].push_back(weight * product[j]);
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

    std::vector<GiNaC::exvector> C(order + 1);
    std::vector<GiNaC::exvector> B(order + 1);
    for (unsigned k = 0; k <= m; ++k) {
        add_factors(C, p[k], power * k, order - power * k);
    }
    for (unsigned k = 0; k <= l; ++k) {
        GiNaC::exvector q;
        for (unsigned j = 0; j <= std::min(k, m); ++j) {
            add_product(q, g[k - j], p[j]);
        }
        add_factors(B, expanded_sum(q), power * k + 1, order - power * k - 1);
    }
    return {sums(C), sums(B)};
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
