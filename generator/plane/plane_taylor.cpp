// SPDX-License-Identifier: MIT
#include "generator/plane/plane_taylor.hpp"

#include <optional>
#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"

namespace nmbcgen {
namespace {

/// Coefficients of X = x^2 and its powers, from the first one on.
using Series = std::vector<Polynomial>;

std::optional<Rational> rational_root(const Rational& square) {
    if (square < 0) {
        return std::nullopt;
    }
    const Integer p = sqrt(numerator(square));
    const Integer q = sqrt(denominator(square));
    const Rational root(p, q);
    return root * root == square ? std::optional(root) : std::nullopt;
}

/// (i cos + j sin)^power, power even, as even + odd cos sin.
struct Turned {
    Rational even = 0;
    Rational odd = 0;
};

Turned turned(const Offset& offset, const Rational& cosine_squared, unsigned power) {
    const Rational sine_squared = 1 - cosine_squared;
    Turned sum;
    Integer binomial = 1;
    for (unsigned a = 0; a <= power; ++a) {
        // i^a j^(power - a) cos^a sin^(power - a)
        Rational term(binomial * pow(Integer(offset[0]), a) * pow(Integer(offset[1]), power - a));
        for (unsigned half = 0; half < a / 2; ++half) {
            term *= cosine_squared;
        }
        for (unsigned half = 0; half < (power - a) / 2; ++half) {
            term *= sine_squared;
        }
        (a % 2 == 0 ? sum.even : sum.odd) += term;
        binomial = binomial * (power - a) / (a + 1);
    }
    return sum;
}

/// -D = [[xx, cos sin xy], [., yy]]
struct Block {
    Series xx;
    Series xy;
    Series yy;
};

Block block_of(const ForceConstants& phi, const Rational& cosine_squared, unsigned terms) {
    Block block;
    Rational factorial = 1;
    for (unsigned k = 1; k <= terms; ++k) {
        factorial *= 2 * k * (2 * k - 1);
        Polynomial xx;
        Polynomial xy;
        Polynomial yy;
        Polynomial skew;
        for (const auto& [offset, matrix] : phi) {
            const auto [even, odd] = turned(offset, cosine_squared, 2 * k);
            const Polynomial in_even = constant(-even / factorial);
            const Polynomial in_odd = constant(-odd / factorial);
            xx += matrix[0][0] * in_even;
            xy += matrix[0][1] * in_odd;
            yy += matrix[1][1] * in_even;
            skew += matrix[0][1] * in_even + (matrix[0][0] + matrix[1][1]) * in_odd;
        }
        if (!skew.is_zero()) {
            throw NoProjection("x -> -x is no symmetry of this lattice");
        }
        block.xx.push_back(xx);
        block.xy.push_back(xy);
        block.yy.push_back(yy);
    }
    return block;
}

/// Coefficient k of the product.
Polynomial product_at(const Series& left, const Series& right, std::size_t k) {
    Polynomial sum;
    for (std::size_t i = 0; i <= k; ++i) {
        sum += left[i] * right[k - i];
    }
    return sum;
}

/// c^2 of both long waves: t^2 - trace t + determinant = 0.
struct Speeds {
    Rational own;
    Rational other;
};

Speeds speeds_of(const Block& block, const Rational& cosine_squared, bool is_P) {
    const Rational both = cosine_squared * (1 - cosine_squared);
    const Polynomial& xx = block.xx.front();
    const Polynomial& xy = block.xy.front();
    const Polynomial& yy = block.yy.front();
    if (xx.size() > 1 || yy.size() > 1 || xy.size() > 1) {
        throw NoProjection("the speed of long waves depends on G in this model");
    }
    const auto value = [](const Polynomial& one) { return evaluate(one, 0); };
    const Rational trace = value(xx) + value(yy);
    const Rational determinant = value(xx) * value(yy) - both * value(xy) * value(xy);
    const Rational difference_squared = trace * trace - 4 * determinant;
    const std::optional<Rational> difference = rational_root(difference_squared);
    if (!difference) {
        throw NoProjection(
            "the speed of long waves in this direction is no root of a rational number");
    }
    // What long waves that move along the wave vector have, between both c^2.
    const Rational longitudinal =
        cosine_squared * value(xx) + (1 - cosine_squared) * value(yy) + 2 * both * value(xy);
    if (2 * longitudinal == trace) {
        throw NoProjection("long waves in this direction are neither P nor S");
    }
    const bool is_faster = (2 * longitudinal > trace) == is_P;
    const Rational signed_half = (is_faster ? *difference : Rational(-*difference)) / 2;
    return {.own = trace / 2 + signed_half, .other = trace / 2 - signed_half};
}

PlaneTaylor taylor_of(const ForceConstants& phi, std::size_t polarisation,
                      const Rational& cosine_squared, unsigned order) {
    const Block block = block_of(phi, cosine_squared, order + 1);
    const Speeds speeds = speeds_of(block, cosine_squared, polarisation == 0);
    if (speeds.own <= 0) {
        throw long_waves_do_not_travel(polarisation);
    }
    // s^2 = X m: m^2 - t m + d = 0, X t = tr(-D), X^2 d = det(D).
    const Polynomial both = constant(cosine_squared * (1 - cosine_squared));
    const Polynomial apart = constant(1 / (speeds.own - speeds.other));
    Series m{constant(speeds.own)};
    for (std::size_t k = 1; k <= order; ++k) {
        Polynomial sum =
            both * product_at(block.xy, block.xy, k) - product_at(block.xx, block.yy, k);
        for (std::size_t i = 1; i <= k; ++i) {
            sum += (block.xx[i] + block.yy[i]) * m[k - i];
        }
        for (std::size_t i = 1; i < k; ++i) {
            sum -= m[i] * m[k - i];
        }
        m.push_back(sum * apart);
    }
    // (sum a_{2k+1} X^k)^2 = m/c^2
    const Polynomial over_speed = constant(1 / speeds.own);
    PlaneTaylor taylor{.speed_squared = speeds.own, .a = {constant(1)}};
    for (std::size_t k = 1; k <= order; ++k) {
        Polynomial rest = m[k] * over_speed;
        for (std::size_t i = 1; i < k; ++i) {
            rest -= taylor.a[i] * taylor.a[k - i];
        }
        taylor.a.push_back(rest * constant(Rational(1, 2)));
    }
    return taylor;
}

}  // namespace

PlaneTaylor plane_taylor(const VectorModel& model, std::size_t polarisation,
                         const Rational& cosine_squared, unsigned order) {
    return taylor_of(force_constants(model), polarisation, cosine_squared, order);
}

PlaneTaylorClosed plane_taylor_closed(const VectorModel& model, std::size_t polarisation,
                                      unsigned order) {
    struct Sample {
        Rational q;
        PlaneTaylor taylor;
    };
    const ForceConstants phi = force_constants(model);
    std::vector<Sample> samples;  // at different q; the last one is a check
    for (unsigned j = 0; j <= order + 1; ++j) {
        const Rational cosine_squared(j, 2 * (order + 1));
        samples.push_back({4 * cosine_squared * (1 - cosine_squared),
                           taylor_of(phi, polarisation, cosine_squared, order)});
    }
    PlaneTaylorClosed closed{.speed_squared = samples.front().taylor.speed_squared, .a = {}};
    for (const Sample& sample : samples) {
        if (sample.taylor.speed_squared != closed.speed_squared) {
            throw NoProjection("the speed of long waves depends on the angle in this model");
        }
    }
    for (unsigned k = 0; k <= order; ++k) {
        // Newton's divided differences, and their product sum as powers of q.
        std::vector<Polynomial> differences;
        for (unsigned j = 0; j <= k; ++j) {
            differences.push_back(samples[j].taylor.a[k]);
        }
        for (unsigned level = 1; level <= k; ++level) {
            for (unsigned j = k; j >= level; --j) {
                differences[j] = (differences[j] - differences[j - 1]) *
                                 constant(1 / (samples[j].q - samples[j - level].q));
            }
        }
        std::vector<Polynomial> powers(k + 1);
        for (unsigned j = k + 1; j-- > 0;) {
            for (unsigned i = k; i > 0; --i) {
                powers[i] = powers[i - 1] - powers[i] * constant(samples[j].q);
            }
            powers[0] = differences[j] - powers[0] * constant(samples[j].q);
        }
        Polynomial value;
        for (unsigned i = k + 1; i-- > 0;) {
            value = value * constant(samples.back().q) + powers[i];
        }
        if (value != samples.back().taylor.a[k]) {
            throw std::logic_error("not proved: a_k is a polynomial of sin^2(2 angle)");
        }
        closed.a.push_back(std::move(powers));
    }
    return closed;
}

}  // namespace nmbcgen
