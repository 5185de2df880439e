// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <variant>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// The nodes of the layer of a side, corners included.
std::vector<std::size_t> entries_of_layer(const nmbc::Plane& plane, std::size_t side) {
    const nmbc::Grid grid = plane.grid();
    const std::size_t ghosts = plane.ghosts();
    const bool is_high = side % 2 == 1;
    const std::size_t across = side / 2 == 0 ? grid.nx : grid.ny;
    const std::size_t along = side / 2 == 0 ? grid.ny : grid.nx;
    const std::size_t line = is_high ? across - 1 - ghosts : ghosts;
    std::vector<std::size_t> entries;
    for (std::size_t i = ghosts; i + ghosts < along; ++i) {
        entries.push_back(side / 2 == 0 ? i * grid.nx + line : line * grid.nx + i);
    }
    return entries;
}

/// Of these nodes: what a traction on the surface does to each, over what it does to a node of a
/// whole cell.
std::vector<double> shares_of_layer(const nmbc::Plane& plane, std::size_t side,
                                    const std::vector<std::size_t>& entries) {
    const nmbc::PlaneParameters& p = plane.parameters();
    const double whole = p.density * p.spacing * p.spacing;
    const auto is_summed = [&](std::size_t number) {
        const nmbc::PlaneSide& one = plane.sides().at(nmbc::plane_sides[number]);
        return std::holds_alternative<nmbc::ClosedSide>(one) ||
               (std::holds_alternative<nmbc::PassiveSide>(one) &&
                nmbc::detail::own_layers(one) == 1);
    };
    const auto* const closed =
        std::get_if<nmbc::ClosedSide>(&plane.sides().at(nmbc::plane_sides[side]));
    const std::vector<double> surface =
        closed != nullptr ? closed->closure->surface : std::vector{0.5, 1.0};
    const std::size_t along = side / 2 == 0 ? 2 : 0;  // the sides that it begins and ends at
    std::vector<double> shares;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::size_t last = surface.size() - 1;
        const double low = surface[is_summed(along) ? std::min(i, last) : last];
        const double high =
            surface[is_summed(along + 1) ? std::min(entries.size() - 1 - i, last) : last];
        shares.push_back(low * high * whole / plane.mass(0, entries[i]));
    }
    return shares;
}

}  // namespace

PlaneInitialField::PlaneInitialField(const PlaneScene& scene)
    : initial_(*scene.initial), spacing_(scene.spacing) {
    if (initial_.shape != PlaneShape::packet) {
        return;
    }
    const double radians = initial_.angle * std::numbers::pi / 180;
    xi_ = {initial_.wave_number * std::cos(radians), initial_.wave_number * std::sin(radians)};
    const nmbc::PlaneModel model = model_of(scene);
    const double rate = rate_of(scene);
    const auto omega_at = [&](double x, double y) {
        return rate * std::sqrt(nmbc::plane_wave(model, {x, y}, initial_.is_P).omega_squared);
    };
    omega_ = omega_at(xi_[0], xi_[1]);
    constexpr double aside = 1e-5;  // central differences: 1e-10 of the group velocity
    const double scale = scene.spacing / (2 * aside);
    group_velocity_ = {
        scale * (omega_at(xi_[0] + aside, xi_[1]) - omega_at(xi_[0] - aside, xi_[1])),
        scale * (omega_at(xi_[0], xi_[1] + aside) - omega_at(xi_[0], xi_[1] - aside))};
    direction_ = nmbc::plane_wave(model, xi_, initial_.is_P).direction;
}

PlaneStart PlaneInitialField::at(const std::array<double, 2>& point) const {
    const double x = point[0] - initial_.centre[0];
    const double y = point[1] - initial_.centre[1];
    const double r = std::hypot(x, y) / initial_.width;
    PlaneStart start;
    if (initial_.shape == PlaneShape::packet) {
        const double phase = (xi_[0] * x + xi_[1] * y) / spacing_;
        const double height = initial_.amplitude * std::exp(-r * r);
        // The envelope moves with the group velocity: -c_g . grad of it is its rate of change.
        const double envelope = 2 * (x * group_velocity_[0] + y * group_velocity_[1]) /
                                (initial_.width * initial_.width);
        for (const std::size_t a : {0U, 1U}) {
            start.u[a] = height * direction_[a] * std::cos(phase);
            start.v[a] =
                height * direction_[a] * (omega_ * std::sin(phase) + envelope * std::cos(phase));
        }
        return start;
    }
    const double shape = initial_.shape == PlaneShape::gaussian ? std::exp(-r * r)
                         : r <= 1 ? (1 + std::cos(std::numbers::pi * r)) / 2
                                  : 0;
    (initial_.of_velocity ? start.v : start.u)[initial_.component] = initial_.amplitude * shape;
    return start;
}

PlaneSources::Source PlaneSources::source_of(const PlaneLoad& load) {
    return {.at =
                [load](double time) {
                    return time > load.until  ? 0
                           : time < load.rise ? load.amplitude * time / load.rise
                                              : load.amplitude;
                },
            .last = load.until};
}

PlaneSources::Source PlaneSources::source_of(const PlaneDrive& drive) {
    return {.gives = Source::Gives::displacement,
            .at =
                [drive](double time) {
                    return drive.amplitude / 2 *
                           (1 - std::cos(2 * std::numbers::pi * time / drive.duration));
                },
            .last = drive.duration};
}

void PlaneSources::add(Source source, std::size_t component, const Entries& entries,
                       const std::string& table, const nmbc::Plane& plane) {
    if (entries.empty()) {
        throw SceneError(table + " acts on no node of the scene");
    }
    for (const std::size_t entry : entries) {
        const auto [found, is_new] = places_.try_emplace({component, entry}, moved_.size());
        if (is_new) {
            moved_.push_back(
                {.component = component, .entry = entry, .mass = plane.mass(component, entry)});
        }
        source.nodes.push_back(found->second);
        if (source.gives != Source::Gives::force) {
            std::string& course = moved_[found->second].course;
            if (!course.empty()) {
                throw SceneError(fmt::format("{} and {} both say how one and the same node moves",
                                             course, table));
            }
            course = table;
        }
    }
    sources_.push_back(std::move(source));
}

PlaneSources::PlaneSources(const PlaneScene& scene, const nmbc::Plane& plane,
                           const std::array<std::size_t, 2>& extension, double time_step)
    : density_(scene.density), time_step_(time_step) {
    constexpr double roundings = 1e-9;  // of the spacing: a node on the edge of a region is in it
    const double more = roundings * scene.spacing;
    const auto entries_where = [&](const auto& is_within) {
        Entries entries;
        for (std::size_t y = 0; y < scene.nodes[1]; ++y) {
            for (std::size_t x = 0; x < scene.nodes[0]; ++x) {
                if (is_within(position_of(scene, x, y))) {
                    entries.push_back(plane.entry(x + extension[0], y + extension[1]));
                }
            }
        }
        return entries;
    };
    const auto entries_around = [&](const std::array<double, 2>& centre,
                                    const std::array<double, 2>& half_width) {
        return entries_where([&](const std::array<double, 2>& X) {
            return std::abs(X[0] - centre[0]) <= half_width[0] + more &&
                   std::abs(X[1] - centre[1]) <= half_width[1] + more;
        });
    };
    const auto source_of_history = [&](const ForceHistory& history) {
        const ForceInTime force(history);
        warning_ = warning_.empty() ? force.warning(time_step) : warning_;
        return Source{.at = [force](double time) { return force.at(time); }, .last = force.last()};
    };
    if (scene.force) {
        const auto is_near = [&](const std::array<double, 2>& X) {
            return std::hypot(X[0] - scene.force->centre[0], X[1] - scene.force->centre[1]) <=
                   scene.force->half_width + more;
        };
        add(source_of_history(scene.force->history), scene.force->component, entries_where(is_near),
            "force", plane);
    }
    for (const PlaneLoad& load : scene.loads) {
        Source source =
            load.file.empty()
                ? source_of(load)
                : source_of_history(
                      {.history = History::file, .amplitude = load.amplitude, .file = load.file});
        source.gives = load.is_velocity ? Source::Gives::velocity : Source::Gives::force;
        const Entries entries = load.surface ? entries_of_layer(plane, *load.surface)
                                             : entries_around(load.centre, load.half_width);
        if (load.surface && load.is_traction) {
            source.shares = shares_of_layer(plane, *load.surface, entries);
        }
        add(std::move(source), load.component, entries, load.name, plane);
    }
    if (scene.drive) {
        add(source_of(*scene.drive), scene.drive->component,
            entries_around(scene.drive->centre, scene.drive->half_width), "drive", plane);
    }
}

bool PlaneSources::drives(double time) const {
    return std::ranges::any_of(sources_, [&](const Source& source) { return time <= source.last; });
}

void PlaneSources::start(const nmbc::Plane& plane, double work) {
    work_ = work;
    for (Moved& node : moved_) {
        node.before = plane.velocity(node.component)[node.entry];
    }
}

void PlaneSources::operator()(nmbc::Plane& plane, double time) {
    const auto velocity = [&](const Moved& node) -> double& {
        return plane.velocity(node.component)[node.entry];
    };
    for (Moved& node : moved_) {
        node.kicked = velocity(node);
    }
    for (const Source& source : sources_) {
        if (source.gives == Source::Gives::force) {
            const double push = time_step_ * source.at(time - time_step_) / density_;
            for (std::size_t i = 0; i < source.nodes.size(); ++i) {
                velocity(moved_[source.nodes[i]]) +=
                    source.shares.empty() ? push : push * source.shares[i];
            }
        }
    }
    // What follows a course does so whatever force acts on it.
    for (const Source& source : sources_) {
        const double middle = time - time_step_ / 2;
        if (source.gives == Source::Gives::velocity && middle <= source.last) {
            const double speed = source.at(middle);
            for (const std::size_t place : source.nodes) {
                velocity(moved_[place]) = speed;
            }
        }
        if (source.gives == Source::Gives::displacement && time <= source.last) {
            const double course = source.at(time);
            for (const std::size_t place : source.nodes) {
                const Moved& node = moved_[place];
                velocity(node) =
                    (course - plane.displacement(node.component)[node.entry]) / time_step_;
            }
        }
    }
    for (Moved& node : moved_) {
        const double now = velocity(node);
        work_ += node.mass * (now - node.kicked) * (node.before + now) / 2;
        node.before = now;
    }
}

}  // namespace nmbcrun
