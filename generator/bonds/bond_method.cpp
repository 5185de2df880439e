// SPDX-License-Identifier: MIT
#include "generator/bonds/bond_method.hpp"

#include <algorithm>
#include <array>

namespace nmbcgen {
namespace {

struct NamedMethod {
    std::string_view name;
    BondMethod method;
    /// What it solves, in one dimension and in two; empty where it is none.
    std::array<std::string_view, 2> equation;
};

constexpr std::array methods{
    NamedMethod{"point",
                BondMethod::point,
                {"point collocation, (40)", "point collocation on the contour, as (41), signed"}},
    NamedMethod{"subdomain",
                BondMethod::subdomain,
                {"sub-domain collocation, (42) signed",
                 "sub-domain collocation on the contour, (43) signed"}},
    NamedMethod{"galerkin",
                BondMethod::galerkin,
                {"Galerkin, (46) signed", "Galerkin on the contour, (47) signed"}},
    NamedMethod{"least-squares",
                BondMethod::least_squares,
                {"least squares over 0 .. pi, (44) as one problem",
                 "least squares on the contour, (45) as one problem"}},
    NamedMethod{"taylor", BondMethod::taylor, {"Taylor series at xi = 0", ""}},
    NamedMethod{"bz-ls",
                BondMethod::bz_ls,
                {"", "least squares of the dynamical matrix over the Brillouin zone"}},
};

const NamedMethod& named(BondMethod method) {
    return *std::ranges::find(methods, method, &NamedMethod::method);
}

}  // namespace

std::optional<BondMethod> bond_method(std::string_view name) {
    const auto* const found = std::ranges::find(methods, name, &NamedMethod::name);
    return found == methods.end() ? std::nullopt : std::optional(found->method);
}

std::string_view bond_method_name(BondMethod method) {
    return named(method).name;
}

std::string bond_method_names(unsigned dimension) {
    std::string names;
    for (const NamedMethod& method : methods) {
        if (has_method(dimension, method.method)) {
            names += (names.empty() ? "" : ", ") + std::string(method.name);
        }
    }
    return names;
}

bool has_method(unsigned dimension, BondMethod method) {
    return !equation_of(method, dimension).empty();
}

std::string_view equation_of(BondMethod method, unsigned dimension) {
    return named(method).equation[dimension - 1];
}

}  // namespace nmbcgen
