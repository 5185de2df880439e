// SPDX-License-Identifier: MIT
/// The rows of a plane lattice in pieces, one a thread, whose rows drift before they are kicked.
#pragma once

#include <algorithm>
#include <cstddef>
#include <nmbc/plane_block.hpp>
#include <nmbc/plane_nodes.hpp>
#include <nmbc/sweep.hpp>
#include <utility>

namespace nmbc::detail {

/// u += time_step v, on these columns of the field.
template <class Real>
struct PlaneDrift {
    Real time_step = 0;
    PlaneRange columns{};
};

/// The kick of a row reads u of the rows up to `reach` away, and as many nodes beyond its ends.
class PlanePieces {
  public:
    /// pitch: entries of a field from one row to the next.
    PlanePieces(PlaneAxis x, std::ptrdiff_t rows, std::ptrdiff_t pitch, std::ptrdiff_t reach)
        : x_(std::move(x)), rows_(rows), pitch_(pitch), reach_(reach) {}

    /// How many there are now, which is the same within a step only: threads may become more or
    /// fewer. Of several pieces none is shorter than 2 reach.
    std::size_t count() const {
        const auto rows = static_cast<std::size_t>(rows_);
        return std::min(pieces_for_threads(rows * static_cast<std::size_t>(x_.nodes())),
                        std::max<std::size_t>(rows / static_cast<std::size_t>(2 * reach_), 1));
    }
    /// Calls work(piece, its rows) for each of so many, in threads.
    template <class Work>
    void for_each(std::size_t count, const Work& work) const {
        in_threads_each(count, [&](std::size_t piece) { work(piece, rows_of(piece, count)); });
    }

    /// Whether a step's drift and kick can be one sweep: first drift_ends(), then in each piece
    /// drift_inner() of the row that the next kick is the first to read, and that kick.
    bool can_drift() const { return rows_ >= 2 * reach_; }

    /// The drift of the first and last `reach` rows of each piece, which the next piece or images
    /// read, too.
    template <class Real>
    void drift_ends(std::size_t count, const PlaneDrift<Real>& drift, PlaneField<Real> u,
                    PlaneField<Real> v) const {
        for_each(count, [&](std::size_t /*piece*/, const PlaneRange& rows) {
            for (std::ptrdiff_t y = 0; y < reach_; ++y) {
                drift_row(rows.first + y, drift, u, v);
                drift_row(rows.last - 1 - y, drift, u, v);
            }
        });
    }
    /// The drift of row y, if it is one between these.
    template <class Real>
    void drift_inner(const PlaneRange& piece, std::ptrdiff_t y, const PlaneDrift<Real>& drift,
                     PlaneField<Real> u, PlaneField<Real> v) const {
        if (y >= piece.first + reach_ && y < piece.last - reach_) {
            drift_row(y, drift, u, v);
        }
    }
    template <class Real>
    void drift_row(std::ptrdiff_t y, const PlaneDrift<Real>& drift, PlaneField<Real> u,
                   PlaneField<Real> v) const {
        const auto nodes = static_cast<std::size_t>(drift.columns.last - drift.columns.first);
        const std::ptrdiff_t first = y * pitch_ + drift.columns.first;
        for (std::size_t a = 0; a < 2; ++a) {
            drift_nodes(drift.time_step, u[a] + first, v[a] + first, 0, nodes);
            close_row(x_, a, u[a] + y * pitch_, reach_);
        }
    }

  private:
    PlaneRange rows_of(std::size_t piece, std::size_t count) const {
        const auto rows = static_cast<std::size_t>(rows_);
        return {static_cast<std::ptrdiff_t>(rows * piece / count),
                static_cast<std::ptrdiff_t>(rows * (piece + 1) / count)};
    }

    PlaneAxis x_;
    std::ptrdiff_t rows_;
    std::ptrdiff_t pitch_;
    std::ptrdiff_t reach_;
};

}  // namespace nmbc::detail
