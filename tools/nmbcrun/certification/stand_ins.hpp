// SPDX-License-Identifier: MIT
/// What is certified for a scene: its own ends, or others in the place of its nmbc.
#pragma once

#include <functional>
#include <nmbc/lattice.hpp>
#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// What else is asked of a scene with other ends; empty: nothing.
using Suits = std::function<bool(const Scene& scene)>;

/// "Certified at this G: ..": what may stand in the place of the scene's nmbc, of what suits: the
/// orders and strides that are certified, and passive ends; where no order is, those at best_G(),
/// too, unless that is best for another lattice. Empty where nothing may.
std::string choices_in_place(const Scene& scene, const Suits& suits = {});

/// A sentence: the largest cfl that the scene's ends are certified for or, where there is none,
/// what is certified in the place of its nmbc.
std::string what_is_certified(const Scene& scene, const nmbc::Lattice& lattice);

}  // namespace nmbcrun
