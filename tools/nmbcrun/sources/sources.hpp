// SPDX-License-Identifier: MIT
/// What starts and drives the chain of a scene.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <nmbc/chain.hpp>
#include <nmbc/lattice.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/nmbcrun/ends/incident_field.hpp"
#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/sources/driver.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"
#include "tools/nmbcrun/sources/forcing.hpp"

namespace nmbcrun {

/// The sources of a scene, for a run of so many steps: incident fields at its ends, what the chain
/// is started with, and what acts on it in every step.
class Sources {
  public:
    /// Throws SceneError where a source selects no node or cannot be, FileError where its file
    /// cannot be read.
    Sources(const Scene& scene, const nmbc::Lattice& lattice,
            const nmbc::ChainParameters& parameters, std::size_t steps);

    /// An end of the chain with what it lets in.
    nmbc::ChainEnd end(nmbc::End side, const nmbc::ChainEnd& inner) const;

    /// Starts a chain between two such ends at t = 0.
    void start(nmbc::Chain& chain);

    /// Forces and prescribed velocities in the step that ends at this time, as Chain::step takes
    /// them; start() was called.
    void operator()(std::span<const double> u, std::span<double> v, double time) const;

    /// The interior nodes that it may act on, from 0.
    std::vector<std::size_t> nodes() const;

    /// Whether a source still feeds the chain in the step that ends at this time.
    bool is_driven(double time) const;

    /// In words: what the run misses of the sources.
    std::vector<std::string> warnings() const;

    /// In words: why a chain with these sources may have had no energy at any time.
    std::string why_no_energy() const;

  private:
    nmbc::End exact_end_that_moves(const nmbc::Chain& chain, std::span<const double> u,
                                   std::span<const double> v) const;
    /// u and v at t = 0. staggered: v at -dt/2, in the place of what the chain makes of v; empty:
    /// none. Throws SceneError, with the end, where an exact end refuses what moves next to it.
    void start_from(nmbc::Chain& chain, std::span<const double> u, std::span<const double> v,
                    std::span<const double> staggered) const;

    Scene scene_;
    double time_step_;
    std::size_t first_interior_ = 0;
    std::optional<Driver> driver_;
    std::optional<Forcing> forcing_;
    std::map<std::string, ForceInTime> surfaces_;  ///< what is given on them, by table
    std::vector<std::string> of_start_{};          ///< warnings of start()
    std::shared_ptr<const IncidentField> left_;    // none: nullptr
    std::shared_ptr<const IncidentField> right_;
};

}  // namespace nmbcrun
