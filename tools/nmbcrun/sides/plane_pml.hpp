// SPDX-License-Identifier: MIT
/// Perfectly matched layers of a plane of nopd2d.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/correspondence_model.hpp>
#include <span>
#include <vector>

#include "tools/nmbcrun/sides/loss_layer.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

/// In the layers, where the velocity is held at 0 behind them, derivatives along x are divided by
/// 1 + sigma_x/(i omega), those along y likewise, with sigma of the node where they are taken: the
/// two of the gradient, and the two of the stress whose sum is the force. Losses rise with the
/// depth as those of a chain's layer do (PmlEnd); in a corner both act. The stabilisation has no
/// derivatives along one axis and stays as it is: of order xi^4.
///
/// Leapfrog, with the trapezoidal rule for what the layer remembers. Where both losses are
/// constant, no wave of the lattice grows, at any loss, radius and G, in every step that is stable
/// in the interior: with p = (2/dt) (z - 1)/(z + 1) and the strain's parts K_x^2, K_y^2 and the
/// stabilisation's S of omega^2, waves z^n have
///     1 + (1 - p^2 dt^2/4) (K_x^2/(p + sigma_x)^2 + K_y^2/(p + sigma_y)^2 + S/p^2) = 0.
/// For |z| > 1, Re p is above 0: off the real axis all terms but the 1 have imaginary parts of one
/// sign, and on it their sum is above -(K_x^2 + K_y^2 + S) dt^2/4 > -1. Where losses vary there is
/// no such proof, and some fields grow: at G = 0 with more than nearest neighbours, with profile 0,
/// in plane strain at Poisson's ratios near 1/2 (tools/scripts/pml-map).
class PlanePml {
  public:
    /// layers: of the sides in the order of nmbc::plane_sides, none where they have no nodes. The
    /// plane has a sponge without friction of as many layers there; no side cuts its families off.
    /// Throws std::invalid_argument as half_step_losses does.
    PlanePml(const nmbc::CorrespondenceModel& model, const std::array<LossLayer, 4>& layers,
             const nmbc::Plane& plane);

    /// To be called after the kick of every step.
    void operator()(nmbc::Plane& plane);

    /// What the layers remember; and to go on from it, of such a plane.
    std::span<const double> memory() const { return memory_; }
    void remember(std::span<const double> memory);

  private:
    /// Nodes of a row of the grid, with or near losses.
    struct Segment {
        std::size_t y = 0;
        std::size_t first = 0;
        std::size_t nodes = 0;
        std::size_t place = 0;  ///< of the first one in what is remembered
    };
    /// xx, xy, yx, yy: the second letter is the axis.
    using Parts = std::array<std::vector<double>, 4>;

    void find_losses(const std::array<LossLayer, 4>& layers, const nmbc::Plane& plane);
    void find_segments();
    /// Without ghosts.
    Segment of_body(Segment segment) const;
    void find_stresses(const Segment& segment, const nmbc::Plane& plane);
    void kick(const Segment& segment, nmbc::Plane& plane);
    /// Finds what the losses take from the parts of row_, given those of the steps before.
    void find_taken(const Segment& segment, std::size_t first_part);

    nmbc::CorrespondenceModel model_;
    std::vector<nmbc::PlaneOffset> half_family_{};  ///< one of each pair +R, -R
    double shape_ = 0;                              ///< A, the sum of x^2 over the family
    double kick_ = 0;                               ///< dt E/(density dX^2)
    nmbc::Grid grid_{};
    std::size_t horizon_;
    std::size_t ghosts_;
    std::array<std::vector<double>, 2> losses_{};  ///< sigma dt/2 along x and y, of the grid
    std::vector<Segment> segments_{};
    std::size_t remembered_nodes_ = 0;
    std::vector<double> memory_{};  ///< of the gradients, then of the forces
    Parts row_{};                   ///< of a segment
    Parts taken_{};                 ///< likewise
    // On the grid, where there are segments:
    Parts stress_{};  ///< P/A of the stretched gradients
    Parts excess_{};  ///< what it has over P/A of the gradients
};

}  // namespace nmbcrun
