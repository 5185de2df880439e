// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/incoming_wave.hpp"
#include "tools/nmbcrun/simulation/initial_fields.hpp"
#include "tools/nmbcrun/simulation/preload.hpp"

namespace nmbcrun {
namespace {

std::shared_ptr<const Background> background_of(const Scene& scene, nmbc::End side,
                                                const nmbc::Lattice& lattice,
                                                const nmbc::ChainParameters& parameters,
                                                std::size_t steps) {
    const bool comes_in = scene.incoming && scene.incoming->end == side;
    if (!scene.preload && !comes_in) {
        return nullptr;
    }
    const PreloadField preload(scene);
    Background background{.per_node = preload.per_node, .middle = preload.middle};
    if (comes_in) {
        add_incoming_wave(scene, lattice, parameters, steps, background);
    }
    return std::make_shared<const Background>(std::move(background));
}

/// u at t = 0 of all nodes, and v half a step before and after.
struct WavesAtStart {
    std::vector<double> u;
    std::vector<double> before;
    std::vector<double> after;
};

void add_waves(const Background& background, nmbc::End side, const nmbc::Chain& chain,
               WavesAtStart& fields) {
    const std::size_t outside =
        side == nmbc::End::left ? chain.first_interior()
                                : chain.nodes() - chain.first_interior() - chain.parameters().nodes;
    const double reached = double(outside) + 1 + std::ceil(background.inside);
    const auto nodes = std::size_t(std::min(reached, double(chain.nodes())));
    const std::size_t first = side == nmbc::End::left ? 0 : chain.nodes() - nodes;
    const WavesAtNodes waves(background.waves,
                             double(first) + 1 - double(chain.first_interior()) - background.origin,
                             chain.parameters().time_step);
    const auto reached_part = [&](std::vector<double>& field) {
        return std::span(field).subspan(first, nodes);
    };
    std::vector<double> ignored(nodes);
    waves.add(-background.arrival, reached_part(fields.u), reached_part(fields.after));
    waves.add(-background.arrival - 1, ignored, reached_part(fields.before));
}

}  // namespace

Sources::Sources(const Scene& scene, const nmbc::Lattice& lattice,
                 const nmbc::ChainParameters& parameters, std::size_t steps)
    : scene_(scene),
      time_step_(parameters.time_step),
      left_(background_of(scene, nmbc::End::left, lattice, parameters, steps)),
      right_(background_of(scene, nmbc::End::right, lattice, parameters, steps)) {
    if (scene.drive) {
        driver_.emplace(scene, time_step_);
    }
    if (scene.force) {
        forcing_.emplace(scene, time_step_);
    }
}

nmbc::ChainEnd Sources::end(nmbc::End side, const nmbc::ChainEnd& inner) const {
    const auto& background = side == nmbc::End::left ? left_ : right_;
    return background ? nmbc::ChainEnd(BackgroundEnd{inner, side, background}) : inner;
}

void Sources::start(nmbc::Chain& chain) {
    first_interior_ = chain.first_interior();
    if (!scene_.initial && !scene_.incoming && !scene_.preload) {
        return;
    }
    auto [u, v, is_staggered] = initial_fields(scene_, chain.lattice(), chain.parameters(),
                                               chain.nodes(), chain.first_interior());
    const std::vector<double> zeros(chain.nodes());
    WavesAtStart waves{zeros, zeros, zeros};
    for (const auto side : {nmbc::End::left, nmbc::End::right}) {
        const auto& background = side == nmbc::End::left ? left_ : right_;
        if (background) {
            add_waves(*background, side, chain, waves);
        }
    }
    // The chain takes v at t = 0 and goes back by half a step itself.
    const PreloadField preload(scene_);
    std::vector<double> at_start(chain.nodes());
    for (std::size_t entry = 0; entry < u.size(); ++entry) {
        u[entry] += waves.u[entry] + preload(double(entry) + 1 - double(first_interior_));
        at_start[entry] =
            (waves.before[entry] + waves.after[entry]) / 2 + (is_staggered ? 0 : v[entry]);
    }
    start_from(chain, u, at_start);
    if (is_staggered) {
        const std::span<double> velocity = chain.velocity();
        for (std::size_t entry = chain.ghosts(); entry + chain.ghosts() < v.size(); ++entry) {
            velocity[entry] = v[entry] + waves.before[entry];
        }
    }
}

/// An exact end refuses what moves next to it: says which end, what moves and what to do.
void Sources::start_from(nmbc::Chain& chain, std::span<const double> u,
                         std::span<const double> v) const {
    const auto is_exact = [&](nmbc::End side) {
        return (side == nmbc::End::left ? scene_.left : scene_.right).kind == BoundaryKind::exact;
    };
    const auto is_at_rest = [&](nmbc::End side) {
        const auto near = std::ptrdiff_t(2 * chain.ghosts());
        const auto first = side == nmbc::End::left ? u.begin() : u.end() - near;
        return std::all_of(first, first + near, [](double value) { return value == 0; });
    };
    try {
        chain.start(u, v);
    } catch (const std::invalid_argument&) {
        if (!is_exact(nmbc::End::left) && !is_exact(nmbc::End::right)) {
            throw;
        }
        const bool is_left = is_exact(nmbc::End::left) &&
                             !(is_exact(nmbc::End::right) && is_at_rest(nmbc::End::left));
        throw SceneError(fmt::format(
            "the exact end on the {} starts from rest, and something moves there at t = 0: {}",
            is_left ? "left" : "right",
            scene_.incoming ? "give a later incoming.arrival"
                            : "initial has to be farther from it"));
    }
}

void Sources::operator()(std::span<const double> u, std::span<double> v, double time) const {
    if (forcing_) {
        (*forcing_)(v, first_interior_, time);
    }
    if (driver_) {  // what is prescribed is prescribed, whatever else acts
        (*driver_)(u, v, first_interior_, time);
    }
}

bool Sources::is_driven(double time) const {
    const auto comes_in = [&](const std::shared_ptr<const Background>& background) {
        return background && time <= background->last_wave * time_step_;
    };
    return (driver_ && driver_->drives(time)) || (forcing_ && forcing_->drives(time)) ||
           comes_in(left_) || comes_in(right_);
}

std::string Sources::why_no_energy() const {
    std::string why;
    if (scene_.force || scene_.incoming) {
        why += "a force or an incoming wave acts at no time of the run, or ";
    }
    if (scene_.initial) {
        why += "initial lies outside of the bar, or ";
    }
    return why + "an amplitude is too small for doubles, or preload.strain is 0";
}

}  // namespace nmbcrun
