// SPDX-License-Identifier: MIT
/// A family of lattice models, one per horizon. Everything the project computes follows from a
/// model's symbol, and the symbol from the model's energy, so a new family is one file that
/// states an energy as a sum of squares, and one line in families.cpp.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

#include "generator/families/limit.hpp"
#include "generator/table/closed_forms.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// There is no such model; what() says why, for people.
struct NoSuchModel : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

struct Family {
    std::string_view name;
    /// The energy, description and source of the model with the given horizon n >= 1 and weights
    /// w_1 .. w_n of its bonds, none of them 0, of which a common factor > 0 says nothing; symbol
    /// and damping are filled in by make_model. The weight of stabilisation is proportional to G.
    /// Throws NoSuchModel where the family has none of this horizon.
    Model (*describe)(unsigned horizon, std::span<const Rational> weights);
    /// At constant influence, the coefficients of x^2, x^4, .. x^(2 count), x = i xi, in -omega^2
    /// as functions of the horizon; nullptr where no closed form is known. The proof of what
    /// follows from them (generator/commands/closed_forms.hpp) rests on this: n^(pole g) times the
    /// coefficient of G^g x^(2k) in -omega^2 of the described models is a polynomial in n of degree
    /// <= 2k - 2 + pole g.
    ClosedForms (*moments)(unsigned count) = nullptr;
    /// At constant influence, the continuum limit at a fixed horizon delta = n dX, nullptr where a
    /// family states none: what the model with horizon kn and stabilisation kG on a lattice of
    /// spacing dX/k tends to as k -> infinity, for xi > 0 [1/dX].
    SquaredFrequency (*limit)(unsigned horizon, const Real& G, const Real& xi) = nullptr;
    /// Its weights may be below 0, as long as omega^2 is above 0 for 0 < xi <= pi.
    bool has_signed_weights = false;
};

/// The families there are, in the order they are listed to a user.
std::span<const Family> families();

/// Throws NoSuchModel where there is no such family.
const Family& find_family(std::string_view name);

/// Whether its models have a G; of a projected or a plane family, too. Throws NoSuchModel.
bool is_stabilised(std::string_view family);

/// The model of a family, or of a projected one (names/projected_family.hpp), at a horizon, with
/// damping tau >= 0 [c/dX] and the influence w_1 .. w_n, constant where it is empty; symbol and
/// damping are derived from its energy. Throws NoSuchModel where there is no such family or
/// horizon, where tau < 0, for tau > 0 in a family without stabilisation, and where there are not n
/// weights that the family allows.
Model make_model(std::string_view family, unsigned horizon, const Rational& damping = 0,
                 std::span<const Rational> weights = {});

/// What make_model does for the damping, with a model that has its energy: tau times the symbol of
/// the stabilisation at G = 1, and a word of it in description and source.
void damp(Model& model, const Rational& damping);

Model nopd1d(unsigned horizon, std::span<const Rational> weights);
/// At constant influence, the energy of a node so many layers from an end at x = 0: neighbours
/// beyond it are missing, and A_n is of those that are left. Stencils from -n to n.
std::vector<ExactSquare> nopd1d_at_edge(unsigned horizon, unsigned layer);
Model bond1d(unsigned horizon, std::span<const Rational> weights);
Model chain1d(unsigned horizon, std::span<const Rational> weights);
SquaredFrequency nopd1d_limit(unsigned horizon, const Real& G, const Real& xi);
ClosedForms nopd1d_moments(unsigned count);

}  // namespace nmbcgen
