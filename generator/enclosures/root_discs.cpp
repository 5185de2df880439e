// SPDX-License-Identifier: MIT
#include "generator/enclosures/root_discs.hpp"

#include <algorithm>
#include <cmath>

#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {

ComplexInterval enclose(const std::complex<double>& z) {
    return {Interval(z.real()), Interval(z.imag())};
}

ComplexInterval box_about(const RootDisc& disc) {
    const Interval spread(-disc.radius, disc.radius);
    return {disc.centre.real() + spread, disc.centre.imag() + spread};
}

namespace {

using Complex = std::complex<double>;

void number_components(std::vector<RootDisc>& discs) {
    for (const RootDisc& one : discs) {
        for (const RootDisc& other : discs) {
            // A little more than needed: components may be taken too large.
            constexpr double outwards = 1 + 1e-9;
            const std::size_t from = other.component;
            if (from != one.component &&
                std::abs(one.centre - other.centre) <= outwards * (one.radius + other.radius)) {
                for (RootDisc& disc : discs) {
                    disc.component = disc.component == from ? one.component : disc.component;
                }
            }
        }
    }
}

/// Smith's radii: degree |f(z_i)| / (leading prod_{l != i} |z_i - z_l|).
void set_radii(std::vector<RootDisc>& discs, const std::vector<double>& values, double leading) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
        Interval denominator = leading;
        for (std::size_t l = 0; l < discs.size(); ++l) {
            denominator *=
                l == i ? Interval(1) : modulus(enclose(discs[i].centre) - enclose(discs[l].centre));
        }
        discs[i].radius = denominator.lower() > 0
                              ? (Interval(values[i]) * double(discs.size()) / denominator).upper()
                              : HUGE_VAL;
    }
}

/// From z to any root that is in one of the discs of this component; 0 where it may be one itself.
double least_distance(const Complex& z, const std::vector<RootDisc>& discs, std::size_t component) {
    double least = HUGE_VAL;
    for (const RootDisc& disc : discs) {
        if (disc.component == component) {
            const double distance =
                (modulus(enclose(z) - enclose(disc.centre)) - disc.radius).lower();
            least = distance > 0 ? std::min(least, distance) : 0;
        }
    }
    return least;
}

/// Of discs that no other one touches, where that is less: |f(z_i)| / (leading prod_{l != i}
/// |z_i - x_l|). The roots x_l of a component of several discs are anywhere in these.
void narrow(std::vector<RootDisc>& discs, const std::vector<double>& values, double leading) {
    std::vector<double> radii;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        radii.push_back(discs[i].radius);
        if (std::ranges::count(discs, discs[i].component, &RootDisc::component) > 1) {
            continue;
        }
        Interval denominator = leading;
        for (std::size_t l = 0; l < discs.size(); ++l) {
            if (l != i) {
                denominator *= least_distance(discs[i].centre, discs, discs[l].component);
            }
        }
        if (denominator.lower() > 0) {
            radii.back() = std::min(radii.back(), (Interval(values[i]) / denominator).upper());
        }
    }
    for (std::size_t i = 0; i < discs.size(); ++i) {
        discs[i].radius = radii[i];
    }
}

}  // namespace

std::vector<RootDisc> root_discs(
    const EnclosedPolynomial& f,
    const std::function<ComplexInterval(const ComplexInterval&)>& value) {
    if (zero_in(f.back())) {
        return {};
    }
    std::vector<double> middle;
    for (const Interval& coefficient : f) {
        middle.push_back(median(coefficient));
    }
    std::vector<RootDisc> discs;
    const auto approximations = polynomial_roots(middle);
    if (approximations.size() != f.size() - 1) {
        return {};
    }
    std::vector<double> corrections;  // times the leading coefficient
    for (const Complex& z : approximations) {
        corrections.push_back(modulus(value(enclose(z))).upper());
        discs.push_back({z, 0, discs.size()});
    }
    const double leading = abs(f.back()).lower();
    set_radii(discs, corrections, leading);
    number_components(discs);
    constexpr int narrower = 3;
    for (int step = 0; step < narrower; ++step) {
        narrow(discs, corrections, leading);
    }
    return discs;
}

}  // namespace nmbcgen
