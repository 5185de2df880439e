// SPDX-License-Identifier: GPL-2.0-or-later
/// Back from y = (z - 1)/(z + 1) to z.
#pragma once

#include <cstddef>
#include <vector>

namespace nmbcgen {

/// The coefficients of (z - 1)^a (z + 1)^b in ascending powers, as numbers of type T.
template <class T>
std::vector<T> moebius_factors(unsigned a, unsigned b) {
    std::vector<T> product{T(1)};
    for (unsigned factor = 0; factor < a + b; ++factor) {
        const T constant = T(factor < a ? -1 : 1);
        product.push_back(T(0));
        for (std::size_t j = product.size() - 1; j > 0; --j) {
            product[j] = product[j] * constant + product[j - 1];
        }
        product[0] = product[0] * constant;
    }
    return product;
}

}  // namespace nmbcgen
