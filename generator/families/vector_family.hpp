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
    std::size_t dimensions = 2;
    bool has_poisson;  ///< and, in the plane, a choice of plane stress and plane strain
    /// Of bond classes, in the order of bond_classes(). A family with Poisson's ratio has them all
    /// 1 where none are given.
    bool has_weights;
    bool has_stabilisation;
    unsigned largest_radius_squared = 0;  ///< larger ones take many seconds; 0: any will do
    /// Throws NoSuchModel (families/family.hpp) where there is none.
    VectorModel (*describe)(const VectorChoice& choice);
    /// The energy of a node so many layers from an edge at x = 0, neighbours beyond which are
    /// missing; nullptr of families without designed sides. beta is the factor of a null Lagrangian
    /// u_x,x u_y,y - u_x,y u_y,x, which adds no force to the interior; squares are linear in it.
    std::vector<VectorSquare> (*at_edge)(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta) = nullptr;
    /// Up to this beta the energy is a sum of squares; 0: the family has none.
    Rational (*largest_beta)(const VectorChoice& choice) = nullptr;
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

unsigned length_squared(const Offset& offset);

/// All offsets of the plane, or of space, with 0 < i^2 + j^2 + k^2 <= radius_squared. Throws
/// NoSuchModel where no node has exactly this distance: another radius then has the same
/// neighbours.
std::vector<Offset> neighbours(unsigned radius_squared, std::size_t dimensions);
std::vector<Offset> neighbours_in_plane(unsigned radius_squared);

/// (i, j, k), i >= j >= k >= 0: a class has all bonds that the lattice's symmetries make of it;
/// shortest first, and of equal ones that of larger i.
std::vector<Offset> bond_classes(unsigned radius_squared, std::size_t dimensions);
std::vector<Offset> bond_classes_in_plane(unsigned radius_squared);

/// The bond of its class with i >= j >= k >= 0.
Offset class_of(const Offset& bond);

/// That of its class.
const Rational& weight_of(const Offset& bond, std::span<const Offset> classes,
                          std::span<const Rational> weights);

/// Throws NoSuchModel where there is not one for each class, none of them 0.
void require_weights(std::span<const Offset> classes, std::span<const Rational> weights,
                     bool may_be_negative);

VectorModel nopd2d(const VectorChoice& choice);
VectorModel bond2d(const VectorChoice& choice);
VectorModel bond3d(const VectorChoice& choice);
VectorModel lps2d(const VectorChoice& choice);
VectorModel lps3d(const VectorChoice& choice);

std::vector<VectorSquare> nopd2d_at_edge(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta);
/// A spring of the constant w |R|^2 for each bond R, counted once; w one for each class.
std::vector<VectorSquare> springs(std::span<const Offset> family, std::span<const Offset> classes,
                                  std::span<const Rational> weights);
std::vector<VectorSquare> bond2d_at_edge(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta);
Rational nopd2d_largest_beta(const VectorChoice& choice);
PlaneLimit nopd2d_limit(const VectorChoice& choice, double g, double xi);

}  // namespace nmbcgen
