// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/taylor.hpp"

#include <algorithm>
#include <stdexcept>

namespace nmbcgen {

using GiNaC::ex;

namespace {

/// Coefficients of (i xi)^0 .. (i xi)^highest in -omega^2, or in -tau sigma. Odd ones vanish by
/// symmetry.
std::vector<ex> moments(const std::vector<ex>& symbol, unsigned highest) {
    std::vector<ex> result(highest + 1, ex(0));
    for (unsigned power = 0; power <= highest && !symbol.empty(); power += 2) {
        ex sum = power == 0 ? symbol[0] : ex(0);
        for (std::size_t m = 1; m < symbol.size(); ++m) {
            sum += 2 * symbol[m] * GiNaC::pow(GiNaC::numeric(long(m)), int(power));
        }
        result[power] = (-sum / GiNaC::factorial(int(power))).expand();
    }
    return result;
}

}  // namespace

std::vector<ex> taylor_coefficients(const Dispersion& dispersion, unsigned highest) {
    const unsigned enough = std::max(highest + 1, 2U);  // xi^2 tells c
    auto a = taylor_coefficients(Moments{.symbol = moments(dispersion.symbol, enough),
                                         .damping = moments(dispersion.damping, enough),
                                         .time_step = dispersion.time_step});
    a.resize(highest + 1);
    return a;
}

std::vector<ex> taylor_coefficients(const Moments& moments) {
    const auto& [symbol, damping, dt] = moments;
    if (!symbol.at(0).is_zero() || !symbol.at(2).is_equal(1)) {
        throw std::invalid_argument("the symbol must start as omega^2 = xi^2 (c = 1)");
    }
    if (!damping.at(0).is_zero()) {
        throw std::invalid_argument("damping must leave a rigid motion alone (tau sigma(0) = 0)");
    }
    const std::size_t highest = symbol.size() - 2;
    // Compare powers of x in s^2 w = -omega^2 - tau sigma s, w = 1 - tau sigma dt/2 - omega^2
    // dt^2/4; a_0 = 0 and a_1 = c = 1.
    std::vector<ex> a{0, 1};
    std::vector<ex> square{0, 0, 1};  // of s
    for (std::size_t k = 2; k <= highest; ++k) {
        ex next = symbol[k + 1];  // in s^2
        for (std::size_t i = 1; i < k; ++i) {
            next += a[i] * damping.at(k + 1 - i);
        }
        for (std::size_t i = 2; i < k && !dt.is_zero(); ++i) {
            const std::size_t power = k + 1 - i;
            next -= square[i] * (damping[power] + symbol[power] * dt / 2) * dt / 2;
        }
        square.push_back(next.expand());
        for (std::size_t i = 2; i < k; ++i) {
            next -= a[i] * a[k + 1 - i];
        }
        a.push_back((next / 2).expand());
    }
    return a;
}

}  // namespace nmbcgen
