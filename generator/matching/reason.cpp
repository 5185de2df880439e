// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/reason.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

/// Whether (i omega)^2 C^2 = B^2 holds for every z: the condition is then exact, and i omega
/// itself is the rational function B/C.
bool is_exact(const MatchingPolynomials& matching, const std::vector<GiNaC::ex>& symbol,
              unsigned stride) {
    const GiNaC::symbol z("z");
    GiNaC::ex C = 0;
    GiNaC::ex B = 0;
    for (std::size_t j = 0; j < matching.C.size(); ++j) {
        C += matching.C[j] * GiNaC::pow(z, int(j * stride));
        B += matching.B[j] * GiNaC::pow(z, int(j * stride));
    }
    GiNaC::ex omega_squared = symbol[0];
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        omega_squared += symbol[m] * (GiNaC::pow(z, int(m)) + GiNaC::pow(z, -int(m)));
    }
    return !C.is_zero() && (omega_squared * C * C + B * B).expand().is_zero();
}

}  // namespace

std::string reason(Degeneracy found, const Specification& specification,
                   const std::vector<GiNaC::ex>& symbol, const std::vector<GiNaC::ex>& taylor) {
    const std::string where =
        fmt::format("NMBC{} does not exist for horizon {}, stride {} at {}", specification.order,
                    specification.horizon, specification.stride,
                    specification.stabilisation ? "G = " + to_string(*specification.stabilisation)
                                                : std::string("any G"));

    unsigned lower = 0;  // the highest order below that exists
    for (unsigned order = 1; order <= specification.order; ++order) {
        const auto matching = match(taylor, specification.stride, order);
        if (is_exact(matching, symbol, specification.stride)) {
            return fmt::format(
                "{}: i*omega is itself a rational function of z there (a block of the Pade "
                "table), so (49) is singular for every order N >= {}. Use an order below {}, "
                "another stride or another G.",
                where, order, order);
        }
        if (degeneracy(matching) == Degeneracy::none) {
            lower = order;
        }
    }
    const std::string instead =
        lower > 0 ? fmt::format("Use order {}, or another G.", lower) : "Use another G.";
    switch (found) {
        case Degeneracy::vanishing_at_one:
            return fmt::format(
                "{}: it would be (z-1)^2 times NMBC{}, with C(1) = 0 and a Jordan block at s = 0 "
                "(growth like t^2). {}",
                where, lower, instead);
        case Degeneracy::lower_order:
            return fmt::format(
                "{}: NMBC{} meets its conditions already, and so does every multiple of it, so "
                "(49) is singular. {}",
                where, lower, instead);
        case Degeneracy::pole:
            return fmt::format("{}: the coefficients have a pole there (c_0 = 1 is impossible). {}",
                               where, instead);
        default:
            return fmt::format("{}: (49) is singular. {}", where, instead);
    }
}

}  // namespace nmbcgen
