// SPDX-License-Identifier: GPL-2.0-or-later
/// Random exact data for rapidcheck, small enough that a failure can be checked by hand.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen::test {

/// p/q with |p| <= 20 and q <= 12: zero, integers and coinciding denominators are common.
inline rc::Gen<Rational> small_rational() {
    return rc::gen::apply([](int p, int q) { return Rational(p, q); }, rc::gen::inRange(-20, 21),
                          rc::gen::inRange(1, 13));
}

/// A value of G > 0 such as people choose.
inline rc::Gen<Rational> positive_rational() {
    return rc::gen::apply([](int p, int q) { return Rational(p, q); }, rc::gen::inRange(1, 60),
                          rc::gen::inRange(1, 25));
}

/// A value of tau > 0 such as people choose, and larger ones.
inline rc::Gen<Rational> positive_damping() {
    return rc::gen::apply([](int p, int q) { return Rational(p, q); }, rc::gen::inRange(1, 9),
                          rc::gen::inRange(1, 60));
}

/// Of degree < size, often less, sometimes zero.
inline rc::Gen<Polynomial> polynomial(std::size_t size) {
    return rc::gen::map(rc::gen::container<std::vector<Rational>>(size, small_rational()),
                        [](std::vector<Rational> c) { return Polynomial(std::move(c)); });
}

inline rc::Gen<Polynomial> nonzero_polynomial(std::size_t size) {
    return rc::gen::suchThat(polynomial(size), [](const Polynomial& p) { return !p.is_zero(); });
}

/// From first to last - 1, all alike: rapidcheck alone would begin with small ones.
inline int whole_number(int first, int last) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last));
}

}  // namespace nmbcgen::test
