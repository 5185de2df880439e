// SPDX-License-Identifier: MIT
/// What an end sends back by its modal analysis.
#pragma once

#include <optional>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The part of a packet's energy that the end reflects in waves of any wave number: the mean over
/// the packet's energy of what each of its waves loses none of. time_step [dX/c]. Nothing for ends
/// that the modal analysis does not know, and for damped lattices, where waves fade on their way.
std::optional<double> predicted_reflection(const Scene& scene, const Boundary& boundary,
                                           const Packet& packet, double time_step);

}  // namespace nmbcrun
