// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/reason.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

/// symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m)
GiNaC::ex laurent_sum(const std::vector<GiNaC::ex>& symbol, const GiNaC::ex& z) {
    GiNaC::ex sum = 0;
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        sum += symbol[m] * (m == 0 ? 1 : GiNaC::pow(z, int(m)) + GiNaC::pow(z, -int(m)));
    }
    return sum;
}

/// Whether s = B/C solves s^2 + tau sigma s + omega^2 = 0, or its like in time steps, for every z:
/// the condition is then exact, and s itself a rational function.
bool is_exact(const MatchingPolynomials& matching, const Dispersion& dispersion, unsigned stride) {
    const GiNaC::symbol z("z");
    GiNaC::ex C = 0;
    GiNaC::ex B = 0;
    for (std::size_t j = 0; j < matching.C.size(); ++j) {
        C += matching.C[j] * GiNaC::pow(z, int(j * stride));
        B += matching.B[j] * GiNaC::pow(z, int(j * stride));
    }
    const GiNaC::ex omega_squared = laurent_sum(dispersion.symbol, z);
    const GiNaC::ex tau_sigma = laurent_sum(dispersion.damping, z);
    const GiNaC::ex half_step = B * dispersion.time_step / 2;
    return !C.is_zero() && (B * B + tau_sigma * B * (C - half_step) +
                            omega_squared * (C - half_step) * (C + half_step))
                               .expand()
                               .is_zero();
}

/// How often z - 1 divides the polynomial, which is not zero.
unsigned zeros_at_one(const std::vector<GiNaC::ex>& polynomial) {
    for (unsigned k = 0;; ++k) {  // the k-th derivative at 1, over k!
        GiNaC::ex derivative = 0;
        for (std::size_t j = k; j < polynomial.size(); ++j) {
            derivative +=
                GiNaC::binomial(GiNaC::numeric(long(j)), GiNaC::numeric(long(k))) * polynomial[j];
        }
        if (!derivative.expand().is_zero()) {
            return k;
        }
    }
}

}  // namespace

std::string reason(Degeneracy found, const Specification& specification,
                   const Dispersion& dispersion, const std::vector<GiNaC::ex>& taylor) {
    const std::string where = fmt::format(
        "NMBC{} does not exist for horizon {}, stride {}{}{} at {}", specification.order,
        specification.horizon, specification.stride,
        specification.damping != 0 ? ", damping " + to_string(specification.damping)
                                   : std::string(),
        specification.time_step != 0 ? ", steps of " + to_string(specification.time_step)
                                     : std::string(),
        specification.stabilisation ? "G = " + to_string(*specification.stabilisation)
                                    : std::string("any G"));

    unsigned lower = 0;  // the highest order below that exists
    for (unsigned order = 1; order <= specification.order; ++order) {
        const auto matching = match(taylor, specification.stride, order);
        const bool exists = degeneracy(matching) == Degeneracy::none;
        if (is_exact(matching, dispersion, specification.stride)) {
            const unsigned singular = exists ? order + 1 : order;
            return fmt::format(
                "{}: {} is itself a rational function of z there (a block of the Pade "
                "table), so (49) is singular for every order N >= {}. Use an order below {}, "
                "another stride or another G.",
                where,
                dispersion.damping.empty() && dispersion.time_step.is_zero() ? "i*omega" : "s",
                singular, singular);
        }
        if (exists) {
            lower = order;
        }
    }
    const std::string instead =
        lower > 0 ? fmt::format("Use order {}, or another G.", lower) : "Use another G.";
    switch (found) {
        case Degeneracy::vanishing_at_one: {
            const auto C = match(taylor, specification.stride, specification.order).C;
            const unsigned zeros = zeros_at_one(C);
            const std::string power = zeros > 1 ? fmt::format("^{}", zeros) : "";
            return fmt::format(
                "{}: it would be (z-1){} times NMBC{}, with C(1) = 0 and a Jordan block at s = 0 "
                "(growth like t{}). {}",
                where, power, lower, power, instead);
        }
        case Degeneracy::pole:
            return fmt::format("{}: the coefficients have a pole there (c_0 = 1 is impossible). {}",
                               where, instead);
        default:  // pade_block and lower_order: more than one approximant, of one value
            return fmt::format(
                "{}: NMBC{} meets its conditions already, and so does every multiple of it, so "
                "(49) is singular. {}",
                where, lower, instead);
    }
}

}  // namespace nmbcgen
