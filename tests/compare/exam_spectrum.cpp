// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/ends.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>

#include "tools/nmbcrun/prediction/spectrum.hpp"

namespace {

nmbc::Chain gaussian_chain(double half_width, double middle_wave) {
    nmbc::Chain chain(nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0.5), nmbc::FixedEnd{},
                      {.nodes = 1001, .spacing = 0.5, .youngs_modulus = 9, .time_step = 0.01});
    std::vector<double> u(chain.nodes());
    for (std::size_t node = 0; node < u.size(); ++node) {
        const double x = double(node) - 502;
        u[node] = std::exp(-std::pow(x / half_width, 2)) * std::cos(middle_wave * x);
    }
    chain.start(u, std::vector<double>(u.size()));
    return chain;
}

TEST_CASE("the spectrum of a Gaussian at rest") {
    const nmbcrun::Spectrum spectrum(gaussian_chain(20, 0), 512);
    double sum = 0;
    for (std::size_t part = 0; part < spectrum.parts(); ++part) {
        sum += spectrum.share(part);
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    // u_hat = exp(-(20 xi)^2/4) and omega = 2 sin(xi/2) at G = 1/2: energy omega^2 u_hat^2.
    const auto energy = [](double xi) {
        return std::pow(2 * std::sin(xi / 2), 2) * std::exp(-200 * xi * xi);
    };
    const double one = spectrum.wave_number(8);
    const double other = spectrum.wave_number(20);
    CHECK(one == doctest::Approx(8.5 * std::numbers::pi / 512).epsilon(1e-15));
    // v at -dt/2 adds (dt omega/2)^2/rate^2 of it at most: 2.3e-4 at these xi.
    CHECK(spectrum.share(20) / spectrum.share(8) ==
          doctest::Approx(energy(other) / energy(one)).epsilon(3e-4));
}

TEST_CASE("quantiles of a packet") {
    const nmbcrun::Spectrum spectrum(gaussian_chain(60, 1.2), 1024);
    const double part = std::numbers::pi / 1024;
    // omega^2 weights the shorter waves a little more: by 2 d ln(omega)/d xi / 60^2 = 4e-4.
    CHECK(std::abs(spectrum.quantile(0.5) - 1.2) < part);
    CHECK(spectrum.quantile(0) == doctest::Approx(part / 2));
    CHECK(spectrum.quantile(0.99) < 1.3);
    CHECK(spectrum.quantile(0.01) > 1.1);
}

TEST_CASE("no energy") {
    const nmbc::Chain chain(nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0.5),
                            nmbc::FixedEnd{}, {.nodes = 10, .time_step = 0.1});
    const nmbcrun::Spectrum spectrum(chain, 8);
    CHECK(spectrum.share(3) == 0);
}

}  // namespace
