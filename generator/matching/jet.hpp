// SPDX-License-Identifier: GPL-2.0-or-later
/// Truncated power series in a local variable.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// Coefficients of ascending powers of the local variable, cut at the size. Jets that meet in an
/// operation have the same size.
template <class T>
using Jet = std::vector<T>;

/// The constant.
template <class T>
Jet<T> constant_jet(const T& value, std::size_t size) {
    Jet<T> jet(size, T(0));
    jet[0] = value;
    return jet;
}

/// left + factor * right
template <class T>
Jet<T> sum(Jet<T> left, const Jet<T>& right, const T& factor) {
    for (std::size_t k = 0; k < left.size(); ++k) {
        left[k] += factor * right[k];
    }
    return left;
}

template <class T>
Jet<T> product(const Jet<T>& left, const Jet<T>& right) {
    Jet<T> result(left.size(), T(0));
    for (std::size_t k = 0; k < left.size(); ++k) {
        for (std::size_t i = 0; i <= k; ++i) {
            result[k] += left[i] * right[k - i];
        }
    }
    return result;
}

/// denominator[0] is not zero.
template <class T>
Jet<T> quotient(Jet<T> numerator, const Jet<T>& denominator) {
    for (std::size_t k = 0; k < numerator.size(); ++k) {
        for (std::size_t i = 0; i < k; ++i) {
            numerator[k] -= numerator[i] * denominator[k - i];
        }
        numerator[k] /= denominator[0];
    }
    return numerator;
}

/// The square root that starts with the given root of square[0], which is not zero.
template <class T>
Jet<T> square_root(const Jet<T>& square, const T& first) {
    Jet<T> root(square.size(), T(0));
    root[0] = first;
    for (std::size_t k = 1; k < square.size(); ++k) {
        T rest = square[k];
        for (std::size_t i = 1; i < k; ++i) {
            rest -= root[i] * root[k - i];
        }
        root[k] = rest / (T(2) * first);
    }
    return root;
}

/// T_0 .. T_highest, Chebyshev's polynomials, of a jet.
template <class T>
std::vector<Jet<T>> chebyshev(const Jet<T>& x, std::size_t highest) {
    std::vector<Jet<T>> values{constant_jet(T(1), x.size()), x};
    while (values.size() <= highest) {
        const Jet<T> twice = product(constant_jet(T(2), x.size()), x);
        values.push_back(sum(product(twice, values.back()), values[values.size() - 2], T(-1)));
    }
    return values;
}

}  // namespace nmbcgen
