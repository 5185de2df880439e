// SPDX-License-Identifier: MIT
/// What an end sends back by its modal analysis.
#pragma once

#include <functional>
#include <optional>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The part of the energy of an incident wave that the end sends back in waves of any wave number,
/// as a function of its own [1/dX]. Nothing where nothing is known, as below. time_step [dX/c].
std::optional<std::function<double(double xi)>> reflected_energy_of(const Scene& scene,
                                                                    const Boundary& boundary,
                                                                    double time_step);

/// The part of a packet's energy that the end reflects in waves of any wave number: the mean over
/// the packet's energy of what each of its waves loses none of. time_step [dX/c]. Nothing for ends
/// that the modal analysis does not know, and for damped lattices, where waves fade on their way.
std::optional<double> predicted_reflection(const Scene& scene, const Boundary& boundary,
                                           const Packet& packet, double time_step);

}  // namespace nmbcrun
