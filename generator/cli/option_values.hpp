// SPDX-License-Identifier: GPL-2.0-or-later
/// The values of nmbcgen's options: text to value. Each throws std::invalid_argument with a message
/// for people that quotes the text and says what is allowed.
#pragma once

#include <string>
#include <vector>

#include "generator/commands/oblique.hpp"
#include "generator/commands/plane_sides.hpp"
#include "generator/commands/recommend.hpp"
#include "generator/emit/closed_forms.hpp"
#include "generator/emit/emit.hpp"
#include "generator/families/influence.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of an order, a horizon or a stride: 1 to 100, far beyond what finishes in a day with G open.
unsigned parse_count(const std::string& text);

unsigned parse_samples(const std::string& text);  ///< 1 to a million

/// The names that are allowed, with commas between.
std::string family_names();
std::string chain_family_names();
std::string plane_family_names();
std::string format_names();
std::string influence_names();

std::string parse_family(const std::string& text);
std::string parse_chain_family(const std::string& text);  ///< no plane family
std::string parse_plane_family(const std::string& text);
unsigned parse_radius_squared(const std::string& text);  ///< 1 to largest_radius_squared
bool parse_plane_state(const std::string& text);         ///< "strain", or "stress": false
Polarisation parse_polarisation(const std::string& text);
/// -180 to 180 degrees: a list, or FROM..TO/STEP.
std::vector<double> parse_angles(const std::string& text);
/// Exact ones: 0, 30, 45, 60, 90, or X:Y of whole numbers.
Direction parse_direction(const std::string& text);
/// P:DIRECTION or S:DIRECTION below 90 degrees, one or two of them with a comma between.
std::vector<ObliqueWave> parse_oblique_waves(const std::string& text);
/// P:DEGREES or S:DEGREES, one or two of them with a comma between.
std::vector<AbsorbedWave> parse_absorbed(const std::string& text);
const Format* parse_format(const std::string& text);
std::string closed_format_names();
const ClosedFormat* parse_closed_format(const std::string& text);
unsigned parse_closed_order(const std::string& text);  ///< 1 to 12; higher ones take minutes
std::string parse_folder(const std::string& text);

/// An exact cfl between 0 and 1.
Rational parse_cfl(const std::string& text);

/// XI:ROWS,..  as matching_text() of emit.hpp has them, in any order; XI = 0 among them.
struct Matching {
    unsigned order;  ///< with which there are as many equations as coefficients
    std::vector<MatchingPoint> points;
};
Matching parse_matching(const std::string& text);

/// An influence function by its name, or w_1,w_2,.. themselves, none of them 0.
struct WeightChoice {
    const Influence* named = nullptr;
    std::vector<Rational> values;
};
WeightChoice parse_weights(const std::string& text);

/// normalised(): as Specification has them. Throws std::invalid_argument where there are not as
/// many as the horizon needs.
std::vector<Rational> weights_at(const WeightChoice& choice, unsigned horizon);

unsigned parse_recommended_order(const std::string& text);  ///< 1 to 8; higher ones take minutes
double parse_recommended_cfl(const std::string& text);      ///< 0.01 at least, below 1

/// A number between 0 and 1.
double parse_fraction(const std::string& text);

/// Horizons or exact values of G, with commas between: none empty, none twice.
std::vector<unsigned> parse_counts(const std::string& text);
std::vector<Rational> parse_rationals(const std::string& text);

/// LO..HI, 0 < LO < HI < pi.
WaveNumberRange parse_band(const std::string& text);
WaveNumberRange parse_wide_band(
    const std::string& text);  ///< of narrowest_band (matching_search.hpp) or more

}  // namespace nmbcgen
