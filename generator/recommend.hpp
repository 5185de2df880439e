// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen recommend: which boundary to use at a horizon and a G.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Wave numbers [1/dX].
struct Band {
    double low;
    double high;
};

struct Question {
    std::string family = "nopd1d";
    unsigned horizon = 1;
    Rational G = 0;
    std::optional<unsigned> order;  ///< exactly this one; none: 1 to 4
    /// Of the mean reflected energy; none: 1e-6, or the next power of ten that can be kept, up to
    /// 1e-4 without damping.
    std::optional<double> tolerance;
    Band band{0.05, 0.3};  ///< the reflected energy is averaged over
};

/// A condition with the least damping of the ladder that certifies it at the G of the question, in
/// the largest certified steps in which it meets the tolerance, or reflects least.
struct Candidate {
    Specification what;
    double certified_cfl = 0;  ///< the largest one; 0: not certified with any damping
    double cfl = 0;            ///< of the steps
    double reflected = 0;      ///< mean reflected energy over the band, in these steps
    double loss = 0;           ///< of the energy of a wave of 20 dX over one wavelength, by damping
    std::string lost;          ///< why another one is recommended; empty: this one is
};

/// Orders 1 to 4 (or the one asked for) with strides 1 to n + 2, the recommended one first. Of
/// those within the tolerance less damping comes first, since it changes the model, then larger
/// steps, then less reflection.
std::vector<Candidate> candidates(const Question& question, double tolerance);

/// The candidates as a text for people. Throws NoSuchBoundary, with the same table, where none of
/// them answers the question.
std::string recommendation(const Question& question);

}  // namespace nmbcgen
