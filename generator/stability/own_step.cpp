// SPDX-License-Identifier: MIT
#include "generator/stability/own_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

class OwnStep {
  public:
    explicit OwnStep(const Table& table)
        : table_(table), dt_(nearest_double(table.specification.time_step)) {}

    /// What is left of the pieces.
    std::vector<StableStep> pieces(const std::vector<StableStep>& steps, Grade least) {
        std::vector<StableStep> found;
        for (StableStep step : steps) {
            step.window.high = last_within(step);
            if (step.window.low <= step.window.high && has_grade(step, least)) {
                found.push_back(step);
            }
        }
        return found;
    }

  private:
    double cfl_at(double G) const { return cfl_of(half_space_at(G), dt_); }

    HalfSpace half_space_at(double G) const { return make_half_space(table_, Rational(G)); }

    /// The largest G of the piece where the step is no longer than its cfl allows; omega_max grows
    /// with G, the energy being a sum of squares. Less than its low where the step is not certified
    /// there.
    double last_within(const StableStep& step) const {
        double inside = step.window.low;
        if (cfl_at(inside) > step.cfl || cfl_at(inside) < step.from) {
            return -1;
        }
        double outside =
            std::isinf(step.window.high) ? std::max(2 * step.window.low, 1.0) : step.window.high;
        while (std::isinf(step.window.high) && cfl_at(outside) <= step.cfl) {
            outside *= 2;
        }
        if (cfl_at(outside) <= step.cfl) {
            return outside;
        }
        for (double middle = (inside + outside) / 2; inside < middle && middle < outside;
             middle = (inside + outside) / 2) {
            (cfl_at(middle) <= step.cfl ? inside : outside) = middle;
        }
        return inside;
    }

    bool has_grade(const StableStep& step, Grade least) {
        // At an edge of a window there may be a pole, or sup rho is 1.
        const double near = 1e-6 * (step.window.high - step.window.low);
        const auto holds = [&](double G) {
            const auto [grade, is_new] = known_.try_emplace(G);
            if (is_new) {
                grade->second = stability_grade(stepped(half_space_at(G), off_the_edge * dt_));
            }
            return grade->second >= least;
        };
        return holds(step.window.low + near) && holds((step.window.low + step.window.high) / 2) &&
               holds(step.window.high - near);
    }

    const Table& table_;
    double dt_;
    std::map<double, Grade> known_;  ///< by G
};

/// The windows of which these are the pieces; edges that are not those of `windows` are where the
/// step is not certified any more.
std::vector<StabilityWindow> joined(const std::vector<StableStep>& pieces,
                                    const std::vector<StabilityWindow>& windows) {
    std::vector<StabilityWindow> found;
    for (const StabilityWindow& window : windows) {
        const auto edge_at = [&window](double G) {
            if (G == window.low.inner) {
                return window.low;
            }
            return window.high && G == window.high->inner
                       ? *window.high
                       : Edge{.where = Bracket{G, G}, .inner = G, .beyond = Failure::time_step};
        };
        bool follows = false;  // a piece of this window
        for (const StableStep& piece : pieces) {
            if (piece.window.low < window.low.inner ||
                (window.high && piece.window.high > window.high->inner)) {
                continue;
            }
            if (follows && found.back().high->inner == piece.window.low) {
                found.back().high = edge_at(piece.window.high);
            } else {
                found.push_back({edge_at(piece.window.low), edge_at(piece.window.high)});
            }
            follows = true;
        }
    }
    return found;
}

/// The parts of the pieces that are in the windows.
std::vector<StableStep> within(const std::vector<StabilityWindow>& windows,
                               const std::vector<StableStep>& pieces) {
    std::vector<StableStep> found;
    for (const StableStep& piece : pieces) {
        for (const StabilityWindow& window : windows) {
            const double low = std::max(piece.window.low, window.low.inner);
            const double high = std::min(piece.window.high, window.high->inner);
            if (low <= high) {
                found.push_back({{low, high}, piece.cfl, piece.from});
            }
        }
    }
    return found;
}

}  // namespace

void cut_to_own_step(const Table& table, Certificate& certificate) {
    OwnStep own(table);
    certificate.max_cfl = own.pieces(certificate.max_cfl, Grade::paired);
    certificate.modal = joined(certificate.max_cfl, certificate.modal);
    certificate.max_cfl_contractive =
        within(certificate.modal, own.pieces(certificate.max_cfl_contractive, Grade::contractive));
    certificate.contractive = joined(certificate.max_cfl_contractive, certificate.contractive);
}

}  // namespace nmbcgen
