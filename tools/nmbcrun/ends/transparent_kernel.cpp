// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/transparent_kernel.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include "tools/nmbcrun/ends/spectral_factor.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

using Real = long double;
static_assert(std::numeric_limits<Real>::digits >= 64,
              "the kernel needs a long double of 64 bits or more");

/// The points z_j = exp(log_radius + 2 pi i j / count), j = 0 .. count-1.
///
/// The sum over them gives kernel[.][m] + sum_{l>0} kernel[.][m + l count] radius^(-l count):
/// |kernel[i-1][m]| <= binomial(r, i), since the roots are within the unit circle wherever
/// |z| > 1, so that aliases are below binomial(r, i) 1e-18. The roundings of the values, 1e-19,
/// are multiplied by radius^m <= 1e18^(steps/count), 1e3 at most, and shared out over all m.
struct Circle {
    explicit Circle(std::size_t steps) {
        while (count < 6 * steps) {
            count = count % 3 == 0 ? count / 3 * 4 : count / 2 * 3;  // 2^k or 3 2^k
        }
        log_radius = std::log(Real(1e18)) / Real(count);
    }

    std::size_t count = 16;
    Real log_radius = 0;
};

std::vector<LongComplex> laurent_polynomial(const nmbc::Lattice& lattice, double courant,
                                            const LongComplex& half_log_z) {
    // By sinh, since z - 2 + 1/z of a z next to 1 would cancel.
    const LongComplex difference = Real(2) * std::sinh(half_log_z) / Real(courant);
    const LongComplex backward = difference * std::exp(-half_log_z);  // (1 - 1/z) / courant
    std::vector<LongComplex> a(lattice.symbol.begin(), lattice.symbol.end());
    a[0] += difference * difference;
    for (std::size_t m = 0; m < lattice.damping.size(); ++m) {
        a[m] += Real(lattice.damping[m]) * backward;
    }
    return a;
}

void require_stable(const nmbc::Lattice& lattice, double courant) {
    if (!(courant > 0) || !std::isfinite(courant)) {
        throw std::invalid_argument("an exact end needs a positive time step");
    }
    if (lattice.damping.size() > lattice.symbol.size()) {
        throw std::invalid_argument("an exact end's damping must not reach beyond its forces");
    }
    const double cfl = courant * nmbc::maximum_frequency(lattice) / 2;
    constexpr double roundings = 1e-12;  // of a time step that is made from cfl
    if (cfl > nmbc::interior_cfl(lattice) * (1 + roundings)) {
        throw std::invalid_argument(
            "an exact end needs a time step that the interior is stable in");
    }
}

}  // namespace

std::vector<std::vector<double>> transparent_kernel(const nmbc::Lattice& lattice, double courant,
                                                    std::size_t steps) {
    require_stable(lattice, courant);
    const std::size_t reach = lattice.reach();
    const Circle circle(steps);
    // kernel_i(conj z) = conj kernel_i(z): half of the circle will do.
    std::vector<std::vector<LongComplex>> values(reach,
                                                 std::vector<LongComplex>(circle.count / 2 + 1));
    SpectralFactor factor;
    for (std::size_t j = circle.count / 2 + 1; j-- > 0;) {
        stop_if_interrupted();
        const LongComplex half_log_z(circle.log_radius / 2,
                                     std::numbers::pi_v<Real> * Real(j) / Real(circle.count));
        const auto& f = factor.find(laurent_polynomial(lattice, courant, half_log_z));
        for (std::size_t i = 0; i < reach; ++i) {
            values[i][j] = -f[i + 1] / f[0];
        }
    }
    Eigen::FFT<Real> fft;
    fft.SetFlag(Eigen::FFT<Real>::HalfSpectrum);
    std::vector<Real> sums(circle.count);
    std::vector<std::vector<double>> kernel(reach, std::vector<double>(steps + 1, 0.0));
    for (std::size_t i = 0; i < reach; ++i) {
        fft.inv(sums.data(), values[i].data(), Eigen::Index(circle.count));
        // A wrong root at one z alone would show here.
        if (!(std::abs(sums[0]) < Real(1e-15))) {
            throw std::invalid_argument("the kernel of the exact end was not found to 1e-15");
        }
        for (std::size_t m = 1; m <= steps; ++m) {
            kernel[i][m] = double(sums[m] * std::exp(circle.log_radius * Real(m)));
        }
    }
    return kernel;
}

}  // namespace nmbcrun
