// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/taylor.hpp"

#include <stdexcept>

namespace nmbcgen {

using GiNaC::ex;

namespace {

/// Coefficient of (i xi)^power in -omega^2, or in -tau sigma. Odd ones vanish by symmetry.
ex moment(const std::vector<ex>& symbol, unsigned power) {
    if (power % 2 != 0 || symbol.empty()) {
        return 0;
    }
    ex sum = power == 0 ? symbol[0] : ex(0);
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        sum += 2 * symbol[m] * GiNaC::pow(GiNaC::numeric(long(m)), int(power));
    }
    return (-sum / GiNaC::factorial(int(power))).expand();
}

}  // namespace

std::vector<ex> taylor_coefficients(const Dispersion& dispersion, unsigned highest) {
    const auto& [symbol, damping, dt] = dispersion;
    if (!moment(symbol, 0).is_zero() || !moment(symbol, 2).is_equal(1)) {
        throw std::invalid_argument("the symbol must start as omega^2 = xi^2 (c = 1)");
    }
    if (!moment(damping, 0).is_zero()) {
        throw std::invalid_argument("damping must leave a rigid motion alone (tau sigma(0) = 0)");
    }
    // Compare powers of x in s^2 w = -omega^2 - tau sigma s, w = 1 - tau sigma dt/2 - omega^2
    // dt^2/4; a_0 = 0 and a_1 = c = 1.
    std::vector<ex> a{0, 1};
    std::vector<ex> square{0, 0, 1};  // of s
    for (unsigned k = 2; k <= highest; ++k) {
        ex next = moment(symbol, k + 1);  // in s^2
        for (unsigned i = 1; i < k; ++i) {
            next += a[i] * moment(damping, k + 1 - i);
        }
        for (unsigned i = 2; i < k && !dt.is_zero(); ++i) {
            const unsigned power = k + 1 - i;
            next -= square[i] * (moment(damping, power) + moment(symbol, power) * dt / 2) * dt / 2;
        }
        square.push_back(next.expand());
        for (unsigned i = 2; i < k; ++i) {
            next -= a[i] * a[k + 1 - i];
        }
        a.push_back((next / 2).expand());
    }
    a.resize(highest + 1);
    return a;
}

}  // namespace nmbcgen
