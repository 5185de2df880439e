// SPDX-License-Identifier: MIT
/// A scene made ready to be stepped: lattice, time step, ends and sources.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
#include <nmbc/energy.hpp>
#include <string>
#include <utility>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/simulation/ledger.hpp"
#include "tools/nmbcrun/sources/sources.hpp"

namespace nmbcrun {

struct Plan : StepPlan {
    /// How the two ends can grow together, in words; empty where they are certified not to. Others
    /// are run only where the scene allows it.
    std::string objection{};
};

class Simulation {
  public:
    /// Throws SceneError where the scene asks for what there is not or cannot be,
    /// nmbc::CoefficientError where a boundary does not exist at its G, std::invalid_argument as
    /// nmbc::Chain does, and Unstable where its ends are not certified to be stable together.
    explicit Simulation(const Scene& scene);

    const Scene& scene() const { return scene_; }
    const Plan& plan() const { return plan_; }
    const nmbc::Chain& chain() const { return chain_; }

    bool is_done() const { return chain_.steps() >= plan_.steps; }

    /// Whether a source still feeds the chain in the step that ends at this time.
    bool is_driven(double time) const { return sources_.is_driven(time); }

    /// In words: what the time steps miss of the sources; empty where they do not.
    std::vector<std::string> warnings() const { return sources_.warnings(); }

    /// In words: why a run may have had no energy at any time.
    std::string why_no_energy() const { return sources_.why_no_energy(); }

    /// One step. `observe` sees u at the old time and v half a step on, as Chain::step has it.
    template <class Observe>
    void step(Observe&& observe) {
        chain_.step(sources_, std::forward<Observe>(observe));
    }
    void step() { chain_.step(sources_); }
    /// Steps, all at once.
    void advance(std::size_t steps) { chain_.advance(steps, sources_); }
    /// Steps that are entered into the ledger of this simulation.
    void advance(std::size_t steps, Ledger& ledger) { ledger.advance(chain_, steps, sources_); }
    Ledger make_ledger() const { return {chain_, sources_.nodes()}; }

    /// Goes on from the state of a simulation of the same scene.
    void resume(const nmbc::ChainState<double>& state) { chain_.resume(state); }

    /// Of the interior nodes, at chain().time() - dt/2.
    nmbc::Energies energies() const;

  private:
    Simulation(const Scene& scene, nmbc::Lattice lattice, const nmbc::ChainEnd& left,
               const nmbc::ChainEnd& right);

    Scene scene_;
    Plan plan_;
    Sources sources_;
    nmbc::Chain chain_;
};

}  // namespace nmbcrun
