// SPDX-License-Identifier: MIT
/// The start and a step of a plane: its nodes move, its ghosts follow, forces kick it, its sides
/// close. A part of plane.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/certificate.hpp>
#include <nmbc/plane.hpp>
#include <nmbc/plane_pieces.hpp>
#include <nmbc/sweep.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

template <class Real>
void BasicPlane<Real>::start() {
    start_staggered();
    const double rate = parameters_.rate();
    const double back = -parameters_.time_step / 2;
    auto dragged = v_;
    for (const auto& group : dashpots_) {
        group.drag(back * rate, field(dragged));
    }
    friction_.drag(back / parameters_.time_step, field(dragged));
    kick_by_forces(back, dragged);
    if (damping_) {
        find_damping(back);
        add_damping(dragged);
    }
    v_ = std::move(dragged);
    for (auto& lines : ghost_lines_) {
        lines.start(u_, v_);
    }
}

template <class Real>
void BasicPlane<Real>::start_staggered() {
    steps_ = 0;
    gone_ = {};
    broken_ = 0;
    released_ = 0;
    damped_ = 0;
    clear_ghosts();
    close_ghosts(u_);
    for (auto& lines : ghost_lines_) {
        lines.start(u_, v_);
    }
}

template <class Real>
void BasicPlane<Real>::require_stable_interior() {
    if (longest_step_ == 0) {
        longest_step_ = 2 / std::sqrt(highest_eigenvalue(model_)) / parameters_.rate();
    }
    constexpr double roundings = 1e-9;
    if (parameters_.time_step > longest_step_ * (1 + roundings)) {
        throw NotCertified("the interior of the plane is stable in steps up to " +
                           detail::to_text(longest_step_) + ", and the step is " +
                           detail::to_text(parameters_.time_step));
    }
}

template <class Real>
void BasicPlane<Real>::kick() {
    close_ghosts(u_);
    keep_velocities();
    if (damping_) {
        find_damping(parameters_.time_step);
        count_damped();
    }
    if (auto* const bonds = std::get_if<detail::BondForce<Real>>(&force_)) {
        bonds->break_and_kick(kick_scale(parameters_.time_step), field(std::as_const(u_)),
                              field(v_));
        count_broken();
    } else {
        kick_by_forces(parameters_.time_step, v_);
    }
    if (damping_) {
        add_damping(v_);
    }
}

template <class Real>
void BasicPlane<Real>::keep_velocities() {
    for (auto& group : dashpots_) {
        group.keep(field(std::as_const(v_)));
    }
    friction_.keep(field(std::as_const(v_)));
}

/// In one sweep over memory, but in thin bodies and beside damping.
template <class Real>
void BasicPlane<Real>::drift_and_kick() {
    const detail::PlanePieces& pieces = std::visit(
        [](const auto& force) -> const detail::PlanePieces& { return force.pieces(); }, force_);
    if (!pieces.can_drift() || damping_) {
        drift();
        kick();
        return;
    }
    keep_velocities();
    const auto u = field(u_);
    const auto v = field(v_);
    const detail::PlaneDrift<Real> drift = drift_of_rows();
    for (std::size_t ghost = 0; ghost < moving_ghosts_[2]; ++ghost) {
        pieces.drift_row(-1 - static_cast<std::ptrdiff_t>(ghost), drift, u, v);
    }
    for (std::size_t ghost = 0; ghost < moving_ghosts_[3]; ++ghost) {
        pieces.drift_row(static_cast<std::ptrdiff_t>(ny_ + ghost), drift, u, v);
    }
    const std::size_t count = pieces.count();
    pieces.drift_ends(count, drift, u, v);
    close_ghosts(u_);
    ++steps_;
    const double scale = kick_scale(parameters_.time_step);
    std::visit([&](auto& force) { force.drift_and_kick(count, drift, scale, u, v); }, force_);
    count_broken();
}

template <class Real>
template <class Prescribe>
void BasicPlane<Real>::close_sides(Prescribe& prescribe) {
    prescribe(*this, time() + parameters_.time_step);
    for (auto& group : dashpots_) {
        group.close(field(v_), gone_);
    }
    friction_.close(field(v_), parameters_.time_step * parameters_.rate(), gone_);
    for (auto& lines : ghost_lines_) {
        lines.close(u_, v_, steps_);
    }
    if (damping_) {
        count_damped();
    }
}

template <class Real>
void BasicPlane<Real>::drift() {
    const auto dt = static_cast<Real>(parameters_.time_step);
    const std::size_t first_x = ghosts_ - moving_ghosts_[0];
    const std::size_t last_x = ghosts_ + nx_ + moving_ghosts_[1];
    const std::size_t first_y = ghosts_ - moving_ghosts_[2];
    const std::size_t rows = ny_ + moving_ghosts_[2] + moving_ghosts_[3];
    const std::size_t pieces = std::min(detail::pieces_of(nx_ * ny_), rows);
    detail::for_each_piece(rows, pieces, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first_y + first; y < first_y + last; ++y) {
            for (std::size_t a = 0; a < 2; ++a) {
                detail::drift_nodes(dt, u_[a].data(), v_[a].data(), y * grid().nx + first_x,
                                    y * grid().nx + last_x);
            }
        }
    });
    ++steps_;
}

template <class Real>
void BasicPlane<Real>::clear_ghosts() {
    const auto is_kept = [&](std::size_t axis, std::size_t place) {
        return axis_of(axis).is_material(static_cast<std::ptrdiff_t>(place) -
                                         static_cast<std::ptrdiff_t>(ghosts_));
    };
    for (Fields* const fields : {&u_, &v_}) {
        for (std::vector<Real>& component : *fields) {
            for (std::size_t y = 0; y < grid().ny; ++y) {
                Real* const row = &component[y * grid().nx];
                if (!is_kept(1, y)) {
                    std::fill_n(row, grid().nx, Real(0));
                    continue;
                }
                for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
                    for (const std::size_t x : {ghost, grid().nx - 1 - ghost}) {
                        row[x] = is_kept(0, x) ? row[x] : 0;
                    }
                }
            }
        }
    }
}

/// Images: of moving ghosts, too.
template <class Real>
void BasicPlane<Real>::close_ghosts(Fields& fields) const {
    const auto pitch = static_cast<std::ptrdiff_t>(grid().nx);
    const auto ghosts = static_cast<std::ptrdiff_t>(ghosts_);
    const detail::PlaneAxis& rows = axis_of(1);
    for (std::size_t a = 0; a < 2; ++a) {
        Real* const first = fields[a].data() + ghosts * pitch;  // entry of row 0
        for (std::ptrdiff_t y = -ghosts; y < rows.nodes() + ghosts; ++y) {
            detail::close_row(axis_of(0), a, first + y * pitch + ghosts, ghosts);
        }
        for (std::ptrdiff_t ghost = 0; ghost < ghosts; ++ghost) {
            for (const std::size_t end : {0U, 1U}) {
                const std::ptrdiff_t y = end == 0 ? -1 - ghost : rows.nodes() + ghost;
                if (rows.has_images(end)) {
                    std::transform(
                        first + rows.original(y) * pitch, first + (rows.original(y) + 1) * pitch,
                        first + y * pitch,
                        [sign = static_cast<Real>(rows.sign(a, y))](Real u) { return sign * u; });
                }
            }
        }
    }
}

}  // namespace nmbc
