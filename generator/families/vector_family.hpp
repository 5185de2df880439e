// SPDX-License-Identifier: MIT
/// Families of lattice models whose nodes move in two directions (or three: a model states its
/// dimensions). A new family is one file that states an energy as a sum of squares, and one line in
/// vector_families.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generator/families/limit.hpp"
#include "generator/table/vector_model.hpp"

namespace nmbcgen {

struct VectorFamily {
    std::string_view name;
    bool has_poisson;  ///< and a choice of plane stress and plane strain
    bool has_weights;  ///< of bond classes, in the order of bond_classes_in_plane()
    bool has_stabilisation;
    /// Throws NoSuchModel (families/family.hpp) where there is none.
    VectorModel (*describe)(const VectorChoice& choice);
    /// The energy of a node so many layers from an edge at x = 0, neighbours beyond which are
    /// missing. beta is the factor of a null Lagrangian u_x,x u_y,y - u_x,y u_y,x, which adds no
    /// force to the interior; squares are linear in it.
    std::vector<VectorSquare> (*at_edge)(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta);
    /// Up to this beta the energy is a sum of squares; 0: the family has none.
    Rational (*largest_beta)(const VectorChoice& choice);
    /// The continuum limit at a fixed radius delta, nullptr where a family states none: what the
    /// model with radius k delta and stabilisation k^2 g on a lattice of spacing dX/k tends to as
    /// k -> infinity, at every angle, for xi > 0 [1/dX].
    PlaneLimit (*limit)(const VectorChoice& choice, double g, double xi) = nullptr;
};

/// The families there are, in the order they are listed to a user.
std::span<const VectorFamily> vector_families();

/// nullptr where there is no such family.
const VectorFamily* vector_family(std::string_view name);

/// Throws NoSuchModel where there is no such family.
const VectorFamily& find_vector_family(std::string_view name);

/// All offsets of the plane with 0 < i^2 + j^2 <= radius_squared. Throws NoSuchModel where no node
/// has exactly this distance: another radius then has the same neighbours.
std::vector<Offset> neighbours_in_plane(unsigned radius_squared);

/// (i, j), i >= j >= 0: a class has all bonds that the square lattice's symmetries make of it;
/// shortest first, and of equal ones that of larger i.
std::vector<Offset> bond_classes_in_plane(unsigned radius_squared);

VectorModel nopd2d(const VectorChoice& choice);
VectorModel bond2d(const VectorChoice& choice);

std::vector<VectorSquare> nopd2d_at_edge(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta);
std::vector<VectorSquare> bond2d_at_edge(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta);
Rational nopd2d_largest_beta(const VectorChoice& choice);
PlaneLimit nopd2d_limit(const VectorChoice& choice, double g, double xi);

}  // namespace nmbcgen
