// SPDX-License-Identifier: MIT
/// A bond-based model of a plane lattice: the energy of a bond.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <nmbc/plane_family.hpp>
#include <nmbc/plane_wave.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nmbc {

/// One bond (i, j), i >= j >= 0, of each class that the square's symmetries make alike: shortest
/// first, and of equal ones that of larger i.
inline std::vector<PlaneOffset> plane_bond_classes(unsigned radius_squared) {
    std::vector<PlaneOffset> classes = plane_family(radius_squared);
    std::erase_if(classes, [](const PlaneOffset& bond) { return bond.y < 0 || bond.x < bond.y; });
    std::ranges::sort(classes, {}, [](const PlaneOffset& bond) {
        return std::pair(bond.x * bond.x + bond.y * bond.y, -bond.x);
    });
    return classes;
}

namespace detail {

/// "(1, 0), (1, 1)"
inline std::string list_of_bonds(const std::vector<PlaneOffset>& bonds) {
    std::string list;
    for (const PlaneOffset& bond : bonds) {
        list += (list.empty() ? "(" : ", (") + std::to_string(bond.x) + ", " +
                std::to_string(bond.y) + ")";
    }
    return list;
}

}  // namespace detail

/// 2D bond-based peridynamics, linear in the stretch R.(u_J - u_I)/|R|^2 of a bond R, whose energy
/// is w (R.(u_J - u_I))^2/2, where E = density = dX = 1. bond2d() makes it.
class BondModel {
  public:
    struct Bond {
        PlaneOffset offset{};
        double weight = 0;  ///< w
    };

    unsigned radius_squared() const { return radius_squared_; }  ///< delta^2 [dX^2]
    /// Of a node with its whole family.
    const std::vector<Bond>& bonds() const { return bonds_; }

    std::size_t horizon() const { return horizon_of(radius_squared_); }
    std::size_t reach() const { return horizon(); }  ///< of forces [dX]
    /// Of long waves along an axis. c_S is 0 at radius 1, whose bonds do not resist shear.
    double speed_P() const { return std::sqrt(moment(4, 0)); }
    double speed_S() const { return std::sqrt(moment(2, 2)); }

  private:
    friend BondModel bond2d(unsigned radius_squared, const std::vector<double>& weights);
    BondModel(unsigned radius_squared, std::vector<Bond> bonds)
        : radius_squared_(radius_squared), bonds_(std::move(bonds)) {}

    /// sum w x^p y^q/2.
    double moment(int p, int q) const {
        double sum = 0;
        for (const auto& [offset, weight] : bonds_) {
            sum += weight * std::pow(offset.x, p) * std::pow(offset.y, q) / 2;
        }
        return sum;
    }

    unsigned radius_squared_;
    std::vector<Bond> bonds_;
};

/// omega^2 and u of the eigenvectors of D = sum w R R^T (1 - cos R.xi) over the family: P is the
/// one that moves more along xi than across it.
inline PlaneWave plane_wave(const BondModel& model, const std::array<double, 2>& xi, bool is_P) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const auto& [bond, weight] : model.bonds()) {
        const double factor = weight * (1 - std::cos(bond.x * xi[0] + bond.y * xi[1]));
        xx += factor * bond.x * bond.x;
        xy += factor * bond.x * bond.y;
        yy += factor * bond.y * bond.y;
    }
    const double angle = std::atan2(2 * xy, xx - yy) / 2;  // of the larger eigenvalue
    const std::array<double, 2> larger{std::cos(angle), std::sin(angle)};
    const double along = larger[0] * xi[0] + larger[1] * xi[1];
    const double across = larger[0] * xi[1] - larger[1] * xi[0];
    const double split = std::hypot((xx - yy) / 2, xy);
    const bool is_larger = (std::abs(along) >= std::abs(across)) == is_P;
    if (is_larger) {
        return {(xx + yy) / 2 + split, larger};
    }
    return {(xx + yy) / 2 - split, {-larger[1], larger[0]}};
}

/// Whether all bonds have weights above 0: no bond that breaks takes the energy's lower bound away.
inline bool is_positive(const BondModel& model) {
    return std::ranges::all_of(model.bonds(), [](const auto& bond) { return bond.weight > 0; });
}

/// weights: of plane_bond_classes(), some of which may be below 0. Throws std::invalid_argument of
/// a radius squared that is no sum of two squares, of another number of weights, of one that is 0
/// or not finite, and where waves would grow: with weights below 0, omega^2 is sampled at wave
/// vectors in steps of pi/64.
inline BondModel bond2d(unsigned radius_squared, const std::vector<double>& weights) {
    detail::require_radius(radius_squared);
    const auto classes = plane_bond_classes(radius_squared);
    if (weights.size() != classes.size() ||
        !std::ranges::all_of(weights, [](double one) { return std::isfinite(one) && one != 0; })) {
        throw std::invalid_argument(std::to_string(classes.size()) +
                                    " finite weights are needed, none of them 0: of the bonds " +
                                    detail::list_of_bonds(classes));
    }
    std::vector<BondModel::Bond> bonds;
    for (const PlaneOffset& bond : plane_family(radius_squared)) {
        const PlaneOffset alike{std::max(std::abs(bond.x), std::abs(bond.y)),
                                std::min(std::abs(bond.x), std::abs(bond.y))};
        const auto number = std::ranges::find(classes, alike) - classes.begin();
        bonds.push_back({bond, weights[static_cast<std::size_t>(number)]});
    }
    BondModel model(radius_squared, std::move(bonds));
    if (is_positive(model)) {
        return model;
    }
    detail::for_each_wave_vector([&](const std::array<double, 2>& xi) {
        for (const bool is_P : {true, false}) {
            if (!(plane_wave(model, xi, is_P).omega_squared > 0)) {
                throw std::invalid_argument(
                    "with these weights the lattice has waves that grow: omega^2 is not above 0");
            }
        }
    });
    return model;
}

/// The weights of Alebrahim 2022's model in plane strain (nu = 1/4), whose bonds up to N dX have
/// the micromodulus 48/(5 pi N^3) times alpha, radius_squared = N^2. alpha: of
/// plane_bond_classes(). Throws std::invalid_argument where there is no such N.
inline std::vector<double> bond_weights(unsigned radius_squared, std::vector<double> alpha) {
    const std::size_t N = horizon_of(radius_squared);
    if (N * N != radius_squared) {
        throw std::invalid_argument(
            "alpha is of lattices whose radius squared is the square of a whole number, not " +
            std::to_string(radius_squared) + ", which takes weights");
    }
    const std::vector<PlaneOffset> classes = plane_bond_classes(radius_squared);
    for (std::size_t i = 0; i < std::min(alpha.size(), classes.size()); ++i) {
        const double r = std::hypot(classes[i].x, classes[i].y);
        alpha[i] *= 48 / (5 * std::numbers::pi * std::pow(static_cast<double>(N), 3) * r * r * r);
    }
    return alpha;
}

/// The energy per length of a crack along an axis whose bonds break at this stretch, where E = dX =
/// 1: what they have then.
inline double fracture_energy(const BondModel& model, double stretch) {
    double energy = 0;
    for (const auto& [bond, weight] : model.bonds()) {
        const double extension = stretch * (bond.x * bond.x + bond.y * bond.y);
        energy += bond.y > 0 ? bond.y * weight * extension * extension / 2 : 0;
    }
    return energy;
}

}  // namespace nmbc
