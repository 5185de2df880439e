// SPDX-License-Identifier: GPL-2.0-or-later
/// The hierarchy of Seleson 2011, part II: EAM-like models, the linear peridynamic solid (LPS) and
/// the prototype microelastic brittle model (PMB), as identities of states and of linearised
/// lattices.
#include <doctest/doctest.h>

#include <array>
#include <random>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/moduli.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/lattice/symbol.hpp"

using namespace nmbcgen;

namespace {

/// A node's bonds: length |xi|, extension e and influence omega, V = 1, all random.
struct Bond {
    Rational length, extension, influence;
};

std::vector<Bond> random_bonds(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&random](int least) {
        return Rational(int(random() % 30) + least, int(random() % 7) + 1);
    };
    std::vector<Bond> bonds(6);
    for (Bond& bond : bonds) {
        bond = {number(1), number(-15), number(1)};
    }
    return bonds;
}

/// m, and the dilatation theta = (3/m) sum omega |xi| e.
struct Volume {
    Rational m = 0;
    Rational theta = 0;
};

Volume volume_of(const std::vector<Bond>& bonds) {
    Volume volume;
    for (const Bond& bond : bonds) {
        volume.m += bond.influence * bond.length * bond.length;
        volume.theta += 3 * bond.influence * bond.length * bond.extension;
    }
    volume.theta /= volume.m;
    return volume;
}

/// t = (3 K theta/m) omega |xi| + (15 G/m) omega (e - theta |xi|/3)
Rational force_of_lps(const Bond& bond, const Volume& volume, const Rational& bulk_modulus,
                      const Rational& shear_modulus) {
    const auto& [m, theta] = volume;
    return 3 * bulk_modulus * theta / m * bond.influence * bond.length +
           15 * shear_modulus / m * bond.influence * (bond.extension - theta * bond.length / 3);
}

const Rational bulk_modulus(7, 3);
const Rational shear_modulus(5, 4);

/// The weights of springs that have what is left of LPS without its dilatation: 2 alpha
/// omega/|R|^2.
std::vector<Rational> springs_of(const VectorChoice& lps, std::size_t dimensions,
                                 const Moduli& moduli) {
    const auto classes = bond_classes(lps.radius_squared, dimensions);
    Rational m = 0;
    for (const Offset& bond : neighbours(lps.radius_squared, dimensions)) {
        m += weight_of(bond, classes, lps.weights) * length_squared(bond);
    }
    const auto d = Rational(dimensions);
    std::vector<Rational> springs;
    for (std::size_t a = 0; a < classes.size(); ++a) {
        springs.push_back(2 * d * (d + 2) * moduli.shear / m * lps.weights[a] /
                          length_squared(classes[a]));
    }
    return springs;
}

std::vector<Rational> some_weights(unsigned radius_squared, std::size_t dimensions) {
    std::vector<Rational> weights;
    for (std::size_t a = 0; a < bond_classes(radius_squared, dimensions).size(); ++a) {
        weights.emplace_back(7, 5 + int(a * a));
    }
    return weights;
}

/// The energy of a node under u = gradient x.
Rational energy_of(const VectorModel& model, const std::array<std::array<Rational, 3>, 3>& strain) {
    Rational energy = 0;
    for (const VectorSquare& square : model.energy) {
        Rational sum = 0;
        for (const VectorTerm& term : square.terms) {
            for (std::size_t a = 0; a < 3; ++a) {
                for (std::size_t b = 0; b < 3; ++b) {
                    sum += term.factors[a] * strain[a][b] * term.offset[b];
                }
            }
        }
        energy += evaluate(square.weight, 0) * sum * sum / 2;
    }
    return energy;
}

}  // namespace

TEST_CASE("LPS is an EAM-like model: t = -P j + kappa/2, P = -dE/d(vartheta)") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<Bond> bonds = random_bonds(seed);
        const Volume volume = volume_of(bonds);
        const Rational& m = volume.m;
        Rational vartheta = 0;  // sum j |y' - y|, j = omega |xi|
        for (const Bond& bond : bonds) {
            vartheta += bond.influence * bond.length * (bond.length + bond.extension);
        }
        CHECK(volume.theta == 3 * (vartheta / m - 1));
        // E = ((3K - 5G)/m) (3 vartheta^2/(2m) - 3 vartheta + C), of which P is the derivative:
        // exact by central differences of a quadratic.
        const auto E = [&](const Rational& at) {
            return (3 * bulk_modulus - 5 * shear_modulus) / m * (3 * at * at / (2 * m) - 3 * at);
        };
        const Rational P = -(E(vartheta + 1) - E(vartheta - 1)) / 2;
        CHECK(P == -(3 * bulk_modulus - 5 * shear_modulus) / m * volume.theta);
        for (const Bond& bond : bonds) {
            const Rational j = bond.influence * bond.length;
            const Rational kappa = 30 * shear_modulus / m * j * (bond.extension / bond.length);
            CHECK(-P * j + kappa / 2 == force_of_lps(bond, volume, bulk_modulus, shear_modulus));
        }
    }
}

TEST_CASE("PMB is an LPS: nu = 1/4, G = 3K/5, t = (9K/m) omega e = kappa/2") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::vector<Bond> bonds = random_bonds(seed);
        const Volume volume = volume_of(bonds);
        Rational denominator = 0;  // of c_g = 18 K/sum |xi| omega_g, omega_g = omega |xi|
        for (const Bond& bond : bonds) {
            denominator += bond.length * bond.length * bond.influence;
        }
        CHECK(denominator == volume.m);
        for (const Bond& bond : bonds) {
            const Rational t = force_of_lps(bond, volume, bulk_modulus, 3 * bulk_modulus / 5);
            CHECK(t == 9 * bulk_modulus / volume.m * bond.influence * bond.extension);
            const Rational c_g = 18 * bulk_modulus / denominator;
            const Rational omega_g = bond.influence * bond.length;
            CHECK(t == c_g * omega_g * (bond.extension / bond.length) / 2);
            // kappa = dw/d(extension), w = c_g s^2 |xi| omega_g/2: a quadratic.
            const auto w = [&](const Rational& extension) {
                return c_g * extension * extension / bond.length * omega_g / 2;
            };
            CHECK((w(bond.extension + 1) - w(bond.extension - 1)) / 2 == 2 * t);
        }
    }
}

TEST_CASE("under a dilatation W = 9 K s^2/2, of GPMB at c_g = 18 K/sum |xi| omega_g, and of LPS") {
    const Rational s(2, 7);
    Rational of_bonds = 0;
    std::vector<Bond> bonds = random_bonds(3);
    const Rational m = volume_of(bonds).m;
    for (const Bond& bond : bonds) {
        // (1/2) w, w = c_g s^2 |xi| omega_g/2
        of_bonds += 18 * bulk_modulus / m * s * s * bond.length * bond.influence * bond.length / 4;
    }
    CHECK(of_bonds == 9 * bulk_modulus * s * s / 2);
    for (const unsigned radius_squared : {1U, 2U, 3U, 4U, 6U}) {
        for (const Rational& nu : {Rational(1, 4), Rational(-1, 2), Rational(2, 5)}) {
            const VectorChoice choice{.radius_squared = radius_squared,
                                      .poisson = nu,
                                      .weights = some_weights(radius_squared, 3)};
            CHECK(energy_of(lps3d(choice), {{{s, 0, 0}, {0, s, 0}, {0, 0, s}}}) ==
                  9 * solid_moduli(choice).bulk * s * s / 2);
        }
    }
    const VectorChoice plane{.radius_squared = 5, .poisson = Rational(1, 10)};
    CHECK(energy_of(lps2d(plane), {{{s, 0, 0}, {0, s, 0}, {0, 0, 0}}}) ==
          4 * plane_moduli(plane).bulk * s * s / 2);
}

TEST_CASE("lattices: LPS without its own dilatation is bonds, K = (d + 2) mu/d") {
    for (const unsigned radius_squared : {1U, 2U, 3U, 4U, 5U}) {
        VectorChoice choice{.radius_squared = radius_squared,
                            .poisson = Rational(1, 4),
                            .weights = some_weights(radius_squared, 3)};
        const ForceConstants lps = force_constants(lps3d(choice));
        choice.weights = springs_of(choice, 3, solid_moduli(choice));
        CHECK(lps == force_constants(bond3d(choice)));
        choice.poisson = Rational(3, 10);
        choice.weights = some_weights(radius_squared, 3);
        const ForceConstants other = force_constants(lps3d(choice));
        choice.weights = springs_of(choice, 3, solid_moduli(choice));
        CHECK_FALSE(other == force_constants(bond3d(choice)));
    }
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        for (const bool strain : {false, true}) {
            VectorChoice choice{.radius_squared = radius_squared,
                                .poisson = strain ? Rational(1, 4) : Rational(1, 3),
                                .plane_strain = strain,
                                .weights = some_weights(radius_squared, 2)};
            const ForceConstants lps = force_constants(lps2d(choice));
            choice.weights = springs_of(choice, 2, plane_moduli(choice));
            CHECK(lps == force_constants(bond2d(choice)));
        }
    }
}

TEST_CASE("in one dimension LPS is nopd1d, and without its own dilatation, K = 3 mu, bond1d") {
    // nopd1d's stabilisation is (G/n^3) (w_k/sum_1^n w) z^2 of each bond, LPS's alpha omega z^2
    // with alpha = 3 mu/m = K/m, m = 2 sum w_k k^2.
    const std::vector<Rational> influence{Rational(1), Rational(2, 3), Rational(1, 7),
                                          Rational(1, 9)};
    for (unsigned n = 1; n <= 4; ++n) {
        const std::vector<Rational> omega(influence.begin(), influence.begin() + n);
        std::vector<Rational> spring;  // w_k of bond1d is omega_k |xi|
        Rational sum = 0;
        Rational m = 0;
        for (unsigned k = 1; k <= n; ++k) {
            spring.push_back(omega[k - 1] * k);
            sum += omega[k - 1];
            m += 2 * omega[k - 1] * k * k;
        }
        const Rational at = Rational(n * n * n) * sum / m;
        const auto lps = make_model("nopd1d", n, 0, omega).symbol;
        const auto bonds = make_model("bond1d", n, 0, spring).symbol;
        for (std::size_t k = 0; k < lps.size(); ++k) {
            CHECK(evaluate(lps[k], at) == (k < bonds.size() ? evaluate(bonds[k], 0) : Rational(0)));
        }
    }
}

TEST_CASE("speeds along an axis, whatever the influence: c_P^2 + (d - 1) c_S^2") {
    // Springs obey Cauchy's relation, so that C_12 - C_44 = K - (d + 2) mu/d, and a dilatation says
    // C_11 + (d - 1) C_12 = d K.
    const auto speeds = [](const VectorModel& model) {
        const auto squared = [&](std::size_t direction) {
            return evaluate(speed_squared(model, direction), 0);
        };
        CHECK((model.dimensions == 2 || squared(1) == squared(2)));
        return squared(0) + Rational(model.dimensions - 1) * squared(1);
    };
    for (const Rational& nu : {Rational(1, 4), Rational(-1, 3), Rational(9, 20)}) {
        const VectorChoice solid{.radius_squared = 5, .poisson = nu, .weights = some_weights(5, 3)};
        const auto [K3, mu3] = solid_moduli(solid);
        CHECK(speeds(lps3d(solid)) == 3 * K3 - 2 * (K3 - 5 * mu3 / 3));
        const VectorChoice plane{.radius_squared = 5, .poisson = nu, .weights = some_weights(5, 2)};
        const auto [K2, mu2] = plane_moduli(plane);
        CHECK(speeds(lps2d(plane)) == 2 * K2 - (K2 - 2 * mu2));
    }
}

TEST_CASE("models that there are not") {
    CHECK_THROWS_WITH_AS(lps3d({.radius_squared = 7, .poisson = Rational(1, 4)}),
                         "no node of the cubic lattice is at a distance of 7 squared: it is no sum "
                         "of three squares. The radius below is 6",
                         NoSuchModel);
    CHECK_THROWS_WITH_AS(lps3d({.radius_squared = 1, .poisson = Rational(1, 2)}),
                         "Poisson's ratio 1/2: an isotropic solid needs -1 < nu < 1/2",
                         NoSuchModel);
    CHECK_THROWS_WITH_AS(
        lps3d({.radius_squared = 3, .poisson = 0, .weights = {1, 1}}),
        "3 weights are needed, all above 0: of the bonds (1, 0, 0), (1, 1, 0), (1, 1, 1)",
        NoSuchModel);
    CHECK_THROWS_AS(bond3d({.radius_squared = 2, .weights = {1, -1}}), NoSuchModel);
    CHECK_THROWS_AS(lps2d({.radius_squared = 2, .poisson = 1}), NoSuchModel);
}
