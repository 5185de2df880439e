// SPDX-License-Identifier: GPL-2.0-or-later
/// g = s/y and v = y^p, the two functions of points.hpp, about a wave number.
#pragma once

#include <stdexcept>

#include "generator/matching/jet.hpp"
#include "generator/matching/real.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// There is no such condition; what() says why, for people.
struct NotMatched : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// g and v in powers of a local variable.
template <class T>
struct Local {
    Jet<T> g;
    Jet<T> v;
};

/// A matching point, and which wave comes in there.
struct IncidentWave {
    Real xi;
    unsigned multiplicity;
    int direction;  ///< the sign of the group velocity
    int side;       ///< the sign of tan(h xi/2)
};

/// Throws NotMatched where the group velocity is zero, or z = 1 or -1 for the table's stride.
IncidentWave incident_wave(const Table& table, const MatchingPoint& point);

/// About xi = 0 in powers of i xi, from the Taylor coefficients and y = tanh(h i xi/2); size > 0.
/// v = y^2 where nothing is damped, else y.
Local<Rational> expand_at_zero(const Table& table, std::size_t size);

/// About the point in powers of x - cos xi, as many as its multiplicity; v = y^2.
/// The table is not damped.
Local<Real> expand(const Table& table, const IncidentWave& wave);

/// The same with damping; v = y. Throws NotMatched where damping stops the wave.
Local<PreciseComplex> expand_damped(const Table& table, const IncidentWave& wave);

}  // namespace nmbcgen
