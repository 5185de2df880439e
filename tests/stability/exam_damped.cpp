// SPDX-License-Identifier: GPL-2.0-or-later
/// Damped chains: the condition on round trips against spectra of assembled chains, and what the
/// condition is made of.
#include <cmath>
#include <numbers>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/modes.hpp"
#include "generator/stability/reflection.hpp"
#include "tests/stability/boundary.hpp"
#include "tests/stability/spectra.hpp"

namespace {

using nmbcgen::HalfSpace;
using nmbcgen::Rational;
using nmbcgen::test::relative;
using Complex = std::complex<double>;

struct Damped {
    unsigned horizon, order, stride;
    Rational G;
    Rational tau;
};

HalfSpace half_space(const Damped& what) {
    return nmbcgen::make_half_space(
        nmbcgen::derive({"nopd1d", what.horizon, what.order, what.stride, std::nullopt, what.tau}),
        what.G);
}

const Damped examples[]{
    {1, 2, 1, Rational(1, 8), Rational(1, 50)},
    {1, 3, 2, 0, Rational(1, 10)},
    {2, 2, 2, 0, Rational(1, 10)},
    {2, 3, 4, Rational(1, 4), Rational(1, 5)},
    {3, 2, 4, 0, Rational(1, 5)},
    {3, 2, 3, 1, Rational(1, 100)},
    {4, 2, 6, 0, Rational(3, 10)},
};

/// What is left of the interior's equation for a wave k, over the largest of its terms. first and
/// second: s and s^2, or in steps (1 - 1/zeta)/dt and (zeta - 2 + 1/zeta)/dt^2.
double residual(const HalfSpace& h, Complex k, Complex first, Complex second) {
    Complex sum = second;
    double size = 0;
    for (std::size_t m = 0; m <= h.reach(); ++m) {
        const Complex pair = m == 0 ? 1.0 : std::pow(k, double(m)) + std::pow(k, -double(m));
        const Complex term = (h.symbol[m] + first * h.damping[m]) * pair;
        sum += term;
        size = std::max(size, std::abs(term));
    }
    return std::abs(sum) / size;
}

void check_outgoing_modes(const HalfSpace& h, double omega) {
    const double dt = h.time_step;
    const Complex zeta = std::polar(1.0, 2 * std::asin(omega * dt / 2));
    const Complex first = dt > 0 ? (1.0 - 1.0 / zeta) / dt : Complex(0, omega);
    const Complex second = dt > 0 ? (zeta - 2.0 + 1.0 / zeta) / (dt * dt) : -omega * omega;
    const auto modes = outgoing_modes(h, omega);
    CHECK(modes.size() == h.reach());
    for (const nmbcgen::Mode& mode : modes) {
        CHECK(std::abs(mode.k) < 1);
        CHECK(residual(h, mode.k, first, second) < 1e-10);  // roundings of a root
    }
}

TEST_CASE("outgoing waves obey the damped interior and decay inwards, in steps and without") {
    for (const Damped& what : examples) {
        for (const double time_step : {0.0, 0.4}) {
            for (const double omega : {1e-3, 0.1, 0.37, 1.1, 2.9}) {
                check_outgoing_modes(stepped(half_space(what), time_step), omega);
            }
        }
    }
}

/// rho(R D) of a chain of so many nodes whose waves arrive with these phases added.
double radius(const nmbcgen::Reflection& R, std::size_t nodes, const Eigen::VectorXcd& phases) {
    Eigen::MatrixXcd product = R.matrix;
    for (Eigen::Index i = 0; i < product.cols(); ++i) {
        product.col(i) *=
            phases(i) * std::pow(std::abs(R.outgoing[std::size_t(i)].k), double(nodes) + 1);
    }
    return nmbcgen::eigenvalues(product).cwiseAbs().maxCoeff();
}

TEST_CASE("waves next to known ones are the same as without") {
    for (const Damped& what : examples) {
        const HalfSpace h = half_space(what);
        const double top = maximum_frequency(h);
        nmbcgen::OutgoingModes waves(h);
        // steps of all sizes, backwards, too, and none
        for (const double part : {1e-5, 0.01, 0.3, 0.31, 0.31, 0.99, 1.2, 0.5, 3.0}) {
            const auto known = waves.at(part * top);
            const auto afresh = outgoing_modes(h, part * top);
            REQUIRE(known.size() == afresh.size());
            for (const nmbcgen::Mode& mode : afresh) {
                double nearest = HUGE_VAL;
                for (const nmbcgen::Mode& other : known) {
                    nearest = std::min(nearest, std::abs(mode.k - other.k));
                }
                // Two waves that are nearly one are known to the square root of roundings.
                constexpr double root_of_roundings = 1e-7;
                CHECK(nearest < root_of_roundings);
            }
        }
    }
}

TEST_CASE("a coarse bound on a round trip bounds it, by up to the number of waves too much") {
    for (const Damped& what : examples) {
        const HalfSpace h = half_space(what);
        for (const double part : {0.1, 0.6, 1.1}) {
            const auto R = reflection(h, part * maximum_frequency(h));
            constexpr std::size_t nodes = 30;
            const double exact = damped_round_trip_supremum(R, R, nodes);
            const double coarse = damped_round_trip_supremum(R, R, nodes, HUGE_VAL);
            constexpr double roundings = 1e-12;
            CHECK(coarse >= exact * (1 - roundings));
            CHECK(coarse <= double(R.matrix.rows()) * exact * (1 + roundings));
            CHECK(damped_round_trip_supremum(R, R, nodes, coarse / 2) == exact);
        }
    }
}

TEST_CASE("the supremum over phases bounds every choice of them, and is nearly reached") {
    for (const Damped& what : examples) {
        const HalfSpace h = half_space(what);
        const double top = nmbcgen::maximum_frequency(h);
        for (const double part : {0.1, 0.5, 0.9}) {
            const nmbcgen::Reflection R = reflection(h, part * top);
            constexpr std::size_t nodes = 20;
            const double bound = std::sqrt(damped_round_trip_supremum(R, R, nodes));
            // Coordinate ascent from the phases of none: each wave's phase in turn.
            Eigen::VectorXcd phases = Eigen::VectorXcd::Ones(R.matrix.cols());
            double best = radius(R, nodes, phases);
            for (int sweep = 0; sweep < 6; ++sweep) {
                for (Eigen::Index i = 0; i < phases.size(); ++i) {
                    constexpr int count = 60;
                    for (int turn = 0; turn < count; ++turn) {
                        Eigen::VectorXcd other = phases;
                        other(i) = std::polar(1.0, 2 * std::numbers::pi * turn / count);
                        const double value = radius(R, nodes, other);
                        CHECK(value < bound * (1 + 1e-9));  // roundings of eigenvalues
                        if (value > best) {
                            best = value;
                            phases = other;
                        }
                    }
                }
            }
            CAPTURE(part);
            CHECK(best > 0.98 * bound);  // phases in steps of 6 degrees
        }
    }
}

TEST_CASE("chains of the certified length and longer do not grow, and shorter ones can") {
    struct Known {
        Damped what;
        std::size_t nodes = 0;
        double growth = 0;  // found by another program; 0: none
    };
    for (const Known& known : {
             Known{{2, 2, 2, 0, Rational(1, 10)}, 19, 1e-2},
             Known{{2, 2, 2, 0, Rational(1, 10)}, 59, 0},
             Known{{2, 2, 2, 0, Rational(1, 20)}, 39, 1e-3},
             Known{{2, 2, 2, 0, Rational(1, 20)}, 79, 0},
             Known{{3, 2, 4, 0, Rational(1, 5)}, 59, 0},
             Known{{1, 2, 1, Rational(1, 8), Rational(1, 50)}, 29, 0},
         }) {
        const HalfSpace h = half_space(known.what);
        const double amplification = nmbcgen::damped_amplification(h, known.nodes).value;
        const double abscissa = nmbcgen::test::spectral_abscissa(h, known.nodes);
        CAPTURE(known.nodes);
        CAPTURE(amplification);
        if (known.growth > 0) {
            CHECK(amplification > 1);
            CHECK(abscissa > known.growth);
        } else {
            CHECK(amplification < 1);
            CHECK(abscissa < 1e-7);  // a double eigenvalue 0 splits by the root of roundings
        }
    }
}

// Next to a G with C(1) = 0, C and B nearly share a zero k next to 1, where both nearly cancel. The
// mode there was taken for one that decays. Its chains strain uniformly, at any length.
TEST_CASE("a mode at a zero that C and B nearly share grows") {
    for (const Damped& what : {Damped{1, 2, 1, Rational(409547, 409600), Rational(9, 50)},
                               Damped{1, 2, 1, Rational(12799, 12800), Rational(19, 100)},
                               Damped{1, 3, 1, Rational(926437, 819200), Rational(4, 25)}}) {
        CAPTURE(what.G);
        const HalfSpace h = half_space(what);
        const auto mode = nmbcgen::growing_mode(h);
        REQUIRE(mode);
        CHECK(mode->real() == relative(nmbcgen::test::spectral_abscissa(h, 100), 1e-3));
        CHECK(nmbcgen::stable_range(h).largest == 0);
    }
}

TEST_CASE("a longer chain amplifies less") {
    for (const Damped& what : examples) {
        const HalfSpace h = half_space(what);
        double before = HUGE_VAL;
        for (const std::size_t nodes : {20U, 40U, 80U, 160U}) {
            const double value = nmbcgen::damped_amplification(h, nodes).value;
            CHECK(value < before);
            before = value;
        }
    }
}

TEST_CASE("in steps the interior's own limit is that of the quadratic in zeta") {
    for (const Damped& what : examples) {
        const HalfSpace h = half_space(what);
        const double top = nmbcgen::maximum_frequency(h);
        for (const double cfl : {0.3, 0.6, 0.8, 0.9, 0.97}) {
            const double dt = 2 * cfl / top;
            // zeta^2 - (2 - dt^2 omega^2 - dt tau sigma) zeta + 1 - dt tau sigma = 0
            double largest = 0;
            for (int i = 0; i <= 2000; ++i) {
                const double xi = std::numbers::pi * i / 2000;
                double damping = h.damping[0];
                for (std::size_t m = 1; m <= h.reach(); ++m) {
                    damping += 2 * h.damping[m] * std::cos(double(m) * xi);
                }
                const double half = 1 - dt * (dt * nmbcgen::omega_squared(h, xi) + damping) / 2;
                const Complex root = std::sqrt(Complex(half * half - (1 - dt * damping)));
                largest = std::max({largest, std::abs(half + root), std::abs(half - root)});
            }
            CAPTURE(cfl);
            CHECK(interior_is_stable(stepped(h, dt)) == (largest < 1 + 1e-9));
        }
    }
}

TEST_CASE("at the largest cfl a damped chain does not grow, and a tenth above it can") {
    for (const Damped& what : {examples[2], examples[4], examples[6]}) {
        const HalfSpace h = half_space(what);
        const double cfl = stable_range(h).largest;
        const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
        const auto radius_at = [&](double part, std::size_t nodes) {
            const double time_step = 2 * part * cfl / nmbcgen::maximum_frequency(h);
            return spectral_radius(end, end, nodes, time_step);
        };
        CHECK(cfl > 0.15);
        for (const std::size_t nodes : {100U, 101U}) {
            CHECK(radius_at(1, nodes) < 1 + 1e-7);  // as above
        }
        CHECK(radius_at(1.15, 100) > 1 + 1e-6);
    }
}

TEST_CASE(
    "near a pole of the coefficients a chain grows in short steps, and `from` says up to which") {
    struct Known {
        Damped what;
        double from = 0;  // found by assembled spectra of 104 nodes, within 0.002
    };
    for (const Known& known :
         {Known{{2, 3, 2, Rational(1, 50), Rational(1, 10)}, 0.035},
          Known{{2, 3, 2, 0, Rational(1, 10)}, 0.034},
          Known{{2, 3, 2, Rational(3, 10), Rational(1, 10)}, 0.047},
          Known{{1, 2, 1, Rational(9, 200), Rational(1, 50)}, 0.047}, Known{examples[2], 0}}) {
        const HalfSpace h = half_space(known.what);
        const nmbcgen::StepRange steps = stable_range(h);
        CAPTURE(known.from);
        CHECK(steps.from >= known.from);
        CHECK(steps.from < known.from + 0.0025);
        CHECK(steps.largest > steps.from);
        const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
        const auto radius_at = [&](double cfl) {
            const double time_step = 2 * cfl / nmbcgen::maximum_frequency(h);
            return spectral_radius(end, end, 100, time_step);
        };
        constexpr double roundings = 1e-7;  // a double eigenvalue 1 splits by their root
        CHECK(radius_at(std::max(steps.from, 1e-3)) < 1 + roundings);
        for (const double cfl : {0.5 * known.from, 0.9 * known.from}) {
            CHECK((cfl == 0 || radius_at(cfl) > 1.05));
        }
    }
}

TEST_CASE("matching the damped symbol keeps the order that matching the undamped one loses") {
    // The energy sent back falls as xi^8 at order 2, and as xi^6 where a_4 is missed. At xi = 0.05
    // to 0.1 the next power still shows.
    for (const unsigned horizon : {2U, 3U}) {
        const Damped what{horizon, 2, horizon, Rational(1, 4), Rational(3, 10)};
        const HalfSpace matched = half_space(what);
        const HalfSpace plain = half_space({horizon, 2, horizon, what.G, Rational(0)});
        HalfSpace undamped = matched;
        undamped.c = plain.c;
        undamped.b = plain.b;
        const auto power = [](const HalfSpace& h) {
            return std::log2(reflected_energy(h, 0.1) / reflected_energy(h, 0.05));
        };
        CHECK(power(matched) == relative(8, 0.05));
        CHECK(power(undamped) < 7);
        CHECK(reflected_energy(undamped, 0.05) > 10 * reflected_energy(matched, 0.05));
    }
}

TEST_CASE("where the stencil is shorter, the top of the band is that of the G next to it") {
    // G = n^4/A_n: the last coefficient of omega^2 is exactly 0, that of the damping is not.
    for (const auto& [horizon, G] : {std::pair(3U, Rational(81, 28)), {4U, Rational(64, 15)}}) {
        const Damped what{horizon, 2, horizon, G, Rational(1, 20)};
        Damped next = what;
        next.G += Rational(1, 1000000);
        CHECK(nmbcgen::maximum_frequency(half_space(what)) ==
              relative(nmbcgen::maximum_frequency(half_space(next)), 1e-5));
    }
}

TEST_CASE("what a wave loses over a wavelength is what the damped symbol says") {
    const HalfSpace h = half_space({2, 2, 2, 0, Rational(1, 10)});
    // The energy falls at twice -Re s, s the root of s^2 + tau sigma s + omega^2 at xi = 2 pi/20.
    const double xi = std::numbers::pi / 10;
    double damping = h.damping[0];
    for (std::size_t m = 1; m <= h.reach(); ++m) {
        damping += 2 * h.damping[m] * std::cos(double(m) * xi);
    }
    const Complex s =
        (-damping + std::sqrt(Complex(damping * damping - 4 * nmbcgen::omega_squared(h, xi)))) /
        2.0;
    const double velocity =
        omega_squared_slope(h, xi) / (2 * std::sqrt(nmbcgen::omega_squared(h, xi)));
    CHECK(loss_per_wavelength(h, 20) == relative(1 - std::exp(2 * s.real() * 20 / velocity), 1e-9));
    CHECK(loss_per_wavelength(half_space({2, 2, 2, 0, Rational(0)}), 20) == 0);
}

TEST_CASE("a wave that goes backwards loses as one that goes forwards") {
    const HalfSpace h = half_space({2, 2, 2, 0, Rational(1, 10)});
    const double wavelength = 4;
    REQUIRE(omega_squared_slope(h, 2 * std::numbers::pi / wavelength) < 0);
    const double loss = loss_per_wavelength(h, wavelength);
    CHECK(loss > 0);
    CHECK(loss < 1);
}

}  // namespace
