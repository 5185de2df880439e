// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_sources.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

nmbc::PlaneModel model_of(const PlaneScene& scene) {
    return nmbc::nopd2d(scene.radius_squared, nmbcgen::nearest_double(scene.nu), scene.G,
                        scene.state);
}

double rate_of(const PlaneScene& scene) {
    return std::sqrt(scene.youngs_modulus / scene.density) / scene.spacing;
}

PlaneInitialField::PlaneInitialField(const PlaneScene& scene)
    : initial_(*scene.initial), spacing_(scene.spacing) {
    if (initial_.shape != PlaneShape::packet) {
        return;
    }
    const double radians = initial_.angle * pi / 180;
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
                         : r <= 1                               ? (1 + std::cos(pi * r)) / 2
                                                                : 0;
    (initial_.of_velocity ? start.v : start.u)[initial_.component] = initial_.amplitude * shape;
    return start;
}

PlaneSources::PlaneSources(const PlaneScene& scene, const nmbc::Plane& plane,
                           const std::array<std::size_t, 2>& extension, double time_step)
    : drive_(scene.drive),
      density_(scene.density),
      mass_(scene.density * scene.spacing * scene.spacing),
      time_step_(time_step) {
    if (scene.force) {
        force_in_time_.emplace(scene.force->history);
    }
    constexpr double roundings = 1e-9;  // of the spacing: a node on the edge of a region is in it
    const double more = roundings * scene.spacing;
    for (std::size_t y = 0; y < scene.nodes[1]; ++y) {
        for (std::size_t x = 0; x < scene.nodes[0]; ++x) {
            const auto [X, Y] = position_of(scene, x, y);
            for (const std::size_t a : {0U, 1U}) {
                Moved node{.component = a,
                           .entry = plane.entry(x + extension[0], y + extension[1])};
                node.is_forced =
                    scene.force && scene.force->component == a &&
                    std::hypot(X - scene.force->centre[0], Y - scene.force->centre[1]) <=
                        scene.force->half_width + more;
                node.is_driven = drive_ && drive_->component == a &&
                                 std::abs(X - drive_->centre[0]) <= drive_->half_width[0] + more &&
                                 std::abs(Y - drive_->centre[1]) <= drive_->half_width[1] + more;
                if (node.is_forced || node.is_driven) {
                    moved_.push_back(node);
                }
            }
        }
    }
    if (scene.force && std::ranges::none_of(moved_, &Moved::is_forced)) {
        throw SceneError("force.centre and force.half_width select no node");
    }
    if (drive_ && std::ranges::none_of(moved_, &Moved::is_driven)) {
        throw SceneError("drive.centre and drive.half_width select no node");
    }
}

bool PlaneSources::drives(double time) const {
    return (force_in_time_ && force_in_time_->drives(time)) || (drive_ && time <= drive_->duration);
}

void PlaneSources::start(const nmbc::Plane& plane, double work) {
    work_ = work;
    for (Moved& node : moved_) {
        node.before = plane.velocity(node.component)[node.entry];
    }
}

/// What is driven follows its course, whatever force acts on it.
void PlaneSources::operator()(nmbc::Plane& plane, double time) {
    const double push =
        force_in_time_ ? time_step_ * force_in_time_->at(time - time_step_) / density_ : 0;
    const bool is_driven = drive_ && time <= drive_->duration;
    const double course =
        is_driven ? drive_->amplitude / 2 * (1 - std::cos(2 * pi * time / drive_->duration)) : 0;
    for (Moved& node : moved_) {
        double& v = plane.velocity(node.component)[node.entry];
        const double kicked = v;
        if (node.is_driven && is_driven) {
            v = (course - plane.displacement(node.component)[node.entry]) / time_step_;
        } else if (node.is_forced) {
            v += push;
        }
        work_ += mass_ * (v - kicked) * (node.before + v) / 2;
        node.before = v;
    }
}

}  // namespace nmbcrun
