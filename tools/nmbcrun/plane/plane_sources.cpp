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
#include "tools/nmbcrun/plane/plane_body.hpp"
#include "tools/nmbcrun/plane/source_region.hpp"

namespace nmbcrun {
namespace {

/// The field's entries of the body's outermost nodes at a side.
std::vector<std::size_t> entries_at_side(const PlaneScene& scene, const nmbc::Plane& plane,
                                         const std::array<std::size_t, 2>& extension,
                                         std::size_t side) {
    const PlaneBody body = body_of(scene, plane.layers());
    const std::size_t axis = side / 2;
    std::array<std::size_t, 2> node{};
    node[axis] = side % 2 == 0 ? 0 : body.nodes[axis] - 1;
    std::vector<std::size_t> entries;
    for (std::size_t i = 0; i < body.nodes[1 - axis]; ++i) {
        node[1 - axis] = i;
        entries.push_back(plane.entry(node[0] + extension[0] - body.before[0],
                                      node[1] + extension[1] - body.before[1]));
    }
    return entries;
}

/// For each of these entries: what a traction on the side does to it, over what it does to a node
/// of a whole cell.
std::vector<double> shares_of_traction(const PlaneScene& scene, const nmbc::Plane& plane,
                                       std::size_t side, const std::vector<std::size_t>& entries) {
    const nmbc::PlaneParameters& p = plane.parameters();
    const double whole = p.density * p.spacing * p.spacing;
    std::vector<double> surface{0.5, 1.0};  // of radius 1, whose closed sides have no closure
    for (const nmbc::Side place : nmbc::plane_sides) {
        if (const auto* const closed = std::get_if<nmbc::ClosedSide>(&plane.sides().at(place))) {
            surface = closed->closure->surface;
        }
    }
    const auto length = [&](std::size_t beside, std::size_t nodes_off) {
        return is_closed(scene.sides[beside].kind)
                   ? surface[std::min(nodes_off, surface.size() - 1)]
                   : 1.0;
    };
    const std::size_t along = side / 2 == 0 ? 2 : 0;  // the sides that it begins and ends at
    std::vector<double> shares;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        shares.push_back(length(along, i) * length(along + 1, entries.size() - 1 - i) * whole /
                         plane.mass(0, entries[i]));
    }
    return shares;
}

}  // namespace

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
    return {.given = Given::displacement,
            .at =
                [drive](double time) {
                    return drive.amplitude / 2 *
                           (1 - std::cos(2 * std::numbers::pi * time / drive.duration));
                },
            .last = drive.duration};
}

PlaneSources::Source PlaneSources::source_of(const ForceInTime& force,
                                             const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {  // loads may have one file
        if (std::ranges::find(warnings_, warning) == warnings_.end()) {
            warnings_.push_back(warning);
        }
    }
    return {.at = [force](double time) { return force.at(time); }, .last = force.last()};
}

void PlaneSources::add(Source source, std::size_t component, const Entries& entries,
                       const std::string& table, const nmbc::Plane& plane) {
    source.table = table;
    for (const std::size_t entry : entries) {
        const auto [found, is_new] = places_.try_emplace({component, entry}, moved_.size());
        if (is_new) {
            moved_.push_back(
                {.component = component, .entry = entry, .mass = plane.mass(component, entry)});
        }
        source.nodes.push_back(found->second);
        if (source.given != Given::force) {
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
    const SourceRegion region(scene, plane, extension);
    if (scene.force) {
        const ForceInTime force(scene.force->history);
        force.require_resolved("force", time_step);
        Source source = source_of(force, force.warnings("force", time_step, scene.end));
        PickedNodes picked = region.within("force", scene.force->centre, scene.force->half_width);
        source.shares = std::move(picked.shares);
        add(std::move(source), scene.force->component, picked.entries, "force", plane);
    }
    for (const PlaneLoad& load : scene.loads) {
        Source source;
        if (load.until < time_step) {
            throw SceneError(fmt::format(
                "{}.until is {:.6g}, less than a time step of {:.3g}: it would act for a whole one",
                load.name, load.until, time_step));
        }
        if (load.file.empty()) {
            source = source_of(load);
        } else {
            const ForceInTime force(
                {.history = History::file, .amplitude = load.amplitude, .file = load.file});
            source = source_of(force, force.warnings(load.name, time_step));
        }
        source.given = load.given;
        Entries entries;
        if (load.side) {
            entries = entries_at_side(scene, plane, extension, *load.side);
            if (load.is_traction) {
                source.shares = shares_of_traction(scene, plane, *load.side, entries);
            }
        } else {
            PickedNodes picked = region.within(load.name, load.centre, load.half_width);
            if (load.given == Given::force) {
                entries = std::move(picked.entries);
                source.shares = std::move(picked.shares);
            } else {
                entries = picked.whole(load.name);
            }
        }
        add(std::move(source), load.component, entries, load.name, plane);
    }
    if (scene.drive) {
        constexpr double least = 4;
        if (scene.drive->duration < least * time_step) {
            throw SceneError(fmt::format(
                "drive.duration is {:.6g}, less than {} time steps of {:.3g}, so that they miss "
                "how far it goes",
                scene.drive->duration, least, time_step));
        }
        add(source_of(*scene.drive), scene.drive->component,
            region.within("drive", scene.drive->centre, scene.drive->half_width).whole("drive"),
            "drive", plane);
    }
}

bool PlaneSources::drives(double time) const {
    return std::ranges::any_of(sources_, [&](const Source& source) { return time <= source.last; });
}

std::vector<PlaneSources::LoadedNodes> PlaneSources::loaded() const {
    std::vector<LoadedNodes> all;
    for (const Source& source : sources_) {
        LoadedNodes& loaded = all.emplace_back();
        loaded.table = source.table;
        for (const std::size_t node : source.nodes) {
            loaded.entries.push_back(moved_[node].entry);
        }
    }
    return all;
}

void PlaneSources::start(const nmbc::Plane& plane, double work) {
    work_ = work;
    for (Moved& node : moved_) {
        node.before = plane.velocity(node.component)[node.entry];
    }
}

void PlaneSources::push(nmbc::Plane& plane, double time, double duration) const {
    for (const Source& source : sources_) {
        if (source.given != Given::force) {
            continue;
        }
        const double change = duration * source.at(time) / density_;
        for (std::size_t i = 0; i < source.nodes.size(); ++i) {
            const Moved& node = moved_[source.nodes[i]];
            plane.velocity(node.component)[node.entry] +=
                source.shares.empty() ? change : change * source.shares[i];
        }
    }
}

void PlaneSources::operator()(nmbc::Plane& plane, double time) {
    const auto velocity = [&](const Moved& node) -> double& {
        return plane.velocity(node.component)[node.entry];
    };
    for (Moved& node : moved_) {
        node.kicked = velocity(node);
    }
    push(plane, time - time_step_, time_step_);
    // What follows a course does so whatever force acts on it.
    for (const Source& source : sources_) {
        const double middle = time - time_step_ / 2;
        if (source.given == Given::velocity && middle <= source.last) {
            const double speed = source.at(middle);
            for (const std::size_t place : source.nodes) {
                velocity(moved_[place]) = speed;
            }
        }
        if (source.given == Given::displacement && time <= source.last) {
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
