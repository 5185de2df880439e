// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/incoming_wave.hpp"
#include "tools/nmbcrun/sources/initial_fields.hpp"
#include "tools/nmbcrun/sources/preload.hpp"
#include "tools/nmbcrun/sources/start_at_edge.hpp"

namespace nmbcrun {
namespace {

std::shared_ptr<const IncidentField> incident_field_of(const Scene& scene, nmbc::End side,
                                                       const nmbc::Lattice& lattice,
                                                       const nmbc::ChainParameters& parameters,
                                                       std::size_t steps) {
    const bool comes_in = scene.incoming && scene.incoming->end == side;
    if (!scene.preload && !comes_in) {
        return nullptr;
    }
    const PreloadField preload(scene);
    IncidentField incident{.per_node = preload.per_node, .middle = preload.middle};
    if (comes_in) {
        add_incoming_wave(scene, lattice, parameters, steps, incident);
    }
    return std::make_shared<const IncidentField>(std::move(incident));
}

/// u at t = 0 of all nodes, and v half a step before and after.
struct WavesAtStart {
    std::vector<double> u;
    std::vector<double> before;
    std::vector<double> after;
};

void add_waves(const IncidentField& incident, nmbc::End side, const nmbc::Chain& chain,
               WavesAtStart& fields) {
    const std::size_t outside =
        side == nmbc::End::left ? chain.first_interior()
                                : chain.nodes() - chain.first_interior() - chain.parameters().nodes;
    const double reached = double(outside) + 1 + std::ceil(incident.inside);
    const auto nodes = std::size_t(std::min(reached, double(chain.nodes())));
    const std::size_t first = side == nmbc::End::left ? 0 : chain.nodes() - nodes;
    const WavesAtNodes waves(incident.waves,
                             double(first) + 1 - double(chain.first_interior()) - incident.origin,
                             chain.parameters().time_step);
    const auto reached_part = [&](std::vector<double>& field) {
        return std::span(field).subspan(first, nodes);
    };
    std::vector<double> ignored(nodes);
    waves.add(-incident.arrival, reached_part(fields.u), reached_part(fields.after));
    waves.add(-incident.arrival - 1, ignored, reached_part(fields.before));
}

/// Where [initial] moves the outermost node at an end that lets waves out. u, v: of the interior.
std::vector<std::string> warnings_of_start(const Scene& scene, std::span<const double> u,
                                           std::span<const double> v) {
    std::vector<std::string> warnings;
    if (!scene.initial || scene.initial->kind == InitialKind::file) {  // it may be going out
        return warnings;
    }
    const auto share_at = [](bool left, std::span<const double> field) {
        double most = 0;
        for (const double value : field) {
            most = std::max(most, std::abs(value));
        }
        return most > 0 ? std::abs(left ? field.front() : field.back()) / most : 0;
    };
    for (const bool left : {true, false}) {
        const Boundary& end = left ? scene.left : scene.right;
        const InitialKind outwards = left ? InitialKind::to_the_left : InitialKind::to_the_right;
        if (scene.initial->kind != outwards && !is_physical(end.kind) &&
            end.kind != BoundaryKind::extended) {
            warnings.push_back(warning_of_start_at(left ? "left end" : "right end",
                                                   std::max(share_at(left, u), share_at(left, v))));
        }
    }
    std::erase(warnings, "");
    return warnings;
}

}  // namespace

Sources::Sources(const Scene& scene, const nmbc::Lattice& lattice,
                 const nmbc::ChainParameters& parameters, std::size_t steps)
    : scene_(scene),
      time_step_(parameters.time_step),
      left_(incident_field_of(scene, nmbc::End::left, lattice, parameters, steps)),
      right_(incident_field_of(scene, nmbc::End::right, lattice, parameters, steps)) {
    if (scene.drive) {
        driver_.emplace(scene, time_step_);
    }
    if (scene.force) {
        forcing_.emplace(scene, time_step_);
    }
    const auto add_surface = [&](const char* table, const Boundary& end) {
        if (end.value) {
            surfaces_.emplace(table, value_in_time(*end.value))
                .first->second.require_resolved(table, time_step_);
        }
    };
    add_surface("boundary.left.value", scene.left);
    add_surface("boundary.right.value", scene.right);
}

nmbc::ChainEnd Sources::end(nmbc::End side, const nmbc::ChainEnd& inner) const {
    const auto& incident = side == nmbc::End::left ? left_ : right_;
    return incident ? nmbc::ChainEnd(IncidentFieldEnd{inner, side, incident}) : inner;
}

void Sources::start(nmbc::Chain& chain) {
    first_interior_ = chain.first_interior();
    if (!scene_.initial && !scene_.incoming && !scene_.preload && !has_loaded_surface(scene_)) {
        return;
    }
    auto [u, v, is_staggered] = initial_fields(scene_, chain.lattice(), chain.parameters(),
                                               chain.nodes(), chain.first_interior());
    const auto of_interior = [&](std::span<const double> field) {
        return field.subspan(first_interior_, chain.parameters().nodes);
    };
    of_start_ = warnings_of_start(scene_, of_interior(u), of_interior(v));
    const std::vector<double> zeros(chain.nodes());
    WavesAtStart waves{zeros, zeros, zeros};
    for (const auto side : {nmbc::End::left, nmbc::End::right}) {
        const auto& incident = side == nmbc::End::left ? left_ : right_;
        if (incident) {
            add_waves(*incident, side, chain, waves);
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
    std::vector<double> staggered;
    for (std::size_t entry = 0; is_staggered && entry < v.size(); ++entry) {
        staggered.push_back(v[entry] + waves.before[entry]);
    }
    start_from(chain, u, at_start, staggered);
}

/// The exact end that refuses these fields. The waves that come in are known to the end they come
/// through, so the other one is looked at first.
nmbc::End Sources::exact_end_that_moves(const nmbc::Chain& chain, std::span<const double> u,
                                        std::span<const double> v) const {
    const bool comes_from_left = scene_.incoming && scene_.incoming->end == nmbc::End::left;
    const auto first = comes_from_left ? nmbc::End::right : nmbc::End::left;
    const auto last = comes_from_left ? nmbc::End::left : nmbc::End::right;
    const PreloadField preload(scene_);
    const double unit_of_time = scene_.spacing / chain.parameters().wave_speed();
    double largest = 0;
    double near = 0;
    for (std::size_t entry = 0; entry < u.size(); ++entry) {
        const double at_rest = preload(double(entry) + 1 - double(first_interior_));
        const double size =
            std::max(std::abs(u[entry] - at_rest), std::abs(v[entry]) * unit_of_time);
        const std::size_t depth = first == nmbc::End::left ? entry : u.size() - 1 - entry;
        largest = std::max(largest, size);
        near = depth < 2 * chain.ghosts() ? std::max(near, size) : near;
    }
    const Boundary& boundary = first == nmbc::End::left ? scene_.left : scene_.right;
    constexpr double negligible = 1e-12;  // as the end has it
    return boundary.kind == BoundaryKind::exact && near > negligible * largest ? first : last;
}

void Sources::start_from(nmbc::Chain& chain, std::span<const double> u, std::span<const double> v,
                         std::span<const double> staggered) const {
    try {
        chain.start(u, v);
        if (!staggered.empty()) {
            const std::size_t ghosts = chain.ghosts();
            std::ranges::copy(staggered.subspan(ghosts, staggered.size() - 2 * ghosts),
                              chain.velocity().begin() + std::ptrdiff_t(ghosts));
            chain.restart_ends();  // their ghosts follow
        }
    } catch (const std::invalid_argument&) {
        if (scene_.left.kind != BoundaryKind::exact && scene_.right.kind != BoundaryKind::exact) {
            throw;
        }
        throw SceneError(fmt::format(
            "the exact end on the {} starts from rest, and something moves there at t = 0: {}",
            exact_end_that_moves(chain, u, staggered.empty() ? v : staggered) == nmbc::End::left
                ? "left"
                : "right",
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

std::vector<std::size_t> Sources::nodes() const {
    std::vector<std::size_t> nodes;
    if (driver_) {
        nodes = driver_->nodes();
    }
    if (forcing_) {
        nodes.insert(nodes.end(), forcing_->nodes().begin(), forcing_->nodes().end());
    }
    return nodes;
}

bool Sources::is_driven(double time) const {
    const auto comes_in = [&](const std::shared_ptr<const IncidentField>& incident) {
        return incident && time <= incident->last_wave * time_step_;
    };
    return (driver_ && driver_->drives(time)) || (forcing_ && forcing_->drives(time)) ||
           comes_in(left_) || comes_in(right_) ||
           std::ranges::any_of(surfaces_,
                               [time](const auto& surface) { return surface.second.drives(time); });
}

std::vector<std::string> Sources::warnings() const {
    std::vector<std::string> all =
        forcing_ ? forcing_->warnings(scene_.end) : std::vector<std::string>();
    for (const auto& [table, surface] : surfaces_) {
        const auto more = surface.warnings(table, time_step_, scene_.end);
        all.insert(all.end(), more.begin(), more.end());
    }
    all.insert(all.end(), of_start_.begin(), of_start_.end());
    return all;
}

std::string Sources::why_no_energy() const {
    std::string why;
    if (scene_.force || scene_.incoming || has_loaded_surface(scene_)) {
        why += "a force, a surface or an incoming wave acts at no time of the run, or ";
    }
    if (scene_.initial) {
        why += "initial lies outside of the bar or between two nodes, or ";
    }
    return why + "an amplitude is too small for doubles, or preload.strain is 0";
}

}  // namespace nmbcrun
