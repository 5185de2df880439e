// SPDX-License-Identifier: MIT
/// What the sources of a scene send out, found without a run of it.
#pragma once

#include <nmbc/lattice.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/prediction/spectrum.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct SourceSpectrum {
    std::string name;   ///< of its table in the scene
    Spectrum spectrum;  ///< of the energy of its waves, in the same units for all sources
    double first = 0;  ///< the interior nodes that its waves start from, counted from 0 at the left
    double last = 0;
    double start = 0;  ///< [time]: before it the source sends out less than 1e-6 of its energy
};

/// Of each source but a preload, which does not move; time_step [time]. Of a drive and of files the
/// spectrum is that of the lattice's own waves, of shapes that of the continuous shape, folded into
/// the band where it is too narrow for the lattice. A drive that is longer than 500 dX/c counts as
/// one of that length. Throws as the sources do, where they are made.
std::vector<SourceSpectrum> source_spectra(const Scene& scene, const nmbc::Lattice& lattice,
                                           double time_step);

/// Of all of them together.
Spectrum spectrum_of_sources(const Scene& scene, const nmbc::Lattice& lattice, double time_step);

}  // namespace nmbcrun
