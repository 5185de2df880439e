// SPDX-License-Identifier: GPL-2.0-or-later
/// What nmbcgen recommend chooses from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/commands/recommend.hpp"
#include "generator/stability/discrete.hpp"

namespace nmbcgen {

inline constexpr double faded_wavelength = 20;  ///< [dX], of the loss that is stated

/// A condition with the least damping tried that certifies it at the G of the question.
struct Certified {
    Specification what;
    StepRange steps{};                    ///< certified; none with any damping: largest is 0
    std::optional<HalfSpace> half_space;  ///< where it is certified
};

/// The steps of one condition with its G and tau, whatever they are; none where it is unstable, and
/// where it is matched in others. Without a half space where there is no such condition.
Certified certified(const Specification& what);

/// "steps of cfl 0.69 or less", or "steps of cfl 0.041 to 0.15".
std::string in_words(const StepRange& steps);

/// The certified steps of a condition; time_step [dX/c] is to be one of them, unless that is 0.
StepRange certified_steps(const HalfSpace& half_space, double time_step);

/// Orders 1 to 6, or the one asked for, with strides 1 to n + 2; above 4 those alone that are
/// certified without damping; those above order 1 also matched in time steps, of the two largest
/// cfl tried in which they are certified, or of the question's.
std::vector<Certified> all_certified(const Question& question, const Progress& progress);

/// One in the question's steps, or in those it is matched in, or else in the largest certified
/// steps in which it meets the tolerance or reflects least.
struct Candidate {
    Specification what;
    StepRange certified{};
    double cfl = 0;        ///< of the steps
    double time_step = 0;  ///< [dX/c]; 0: it is not certified in them
    double reflected = 0;  ///< mean reflected energy over the band, in these steps
    double loss = 0;       ///< of the energy of a wave of 20 dX over one wavelength, by damping
    std::string lost;      ///< why another one is recommended; empty: this one is
};

/// The recommended one first; of the same condition matched in several steps the best.
std::vector<Candidate> in_order(const std::vector<Certified>& certified, const Question& question,
                                double tolerance);

}  // namespace nmbcgen
