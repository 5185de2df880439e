// SPDX-License-Identifier: MIT
#include "generator/coupling/packet.hpp"

#include <algorithm>
#include <cmath>
#include <nmbc/boundary.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "generator/coupling/assembly.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double widths = 7;  // a Gaussian is below 1e-10 there
constexpr std::size_t elements_to_end = 40;

SparseMatrix accelerations(const Mesh& mesh, CouplingForm form) {
    SparseMatrix matrix = stiffness_of(mesh, form);
    const VectorXd masses = masses_of(mesh);
    for (Index row = 0; row < matrix.rows(); ++row) {
        for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
            entry.valueRef() /= masses[row];
        }
    }
    return matrix;
}

/// No omega^2 is above the largest sum of a row's absolute values.
double step_of(const SparseMatrix& matrix) {
    double largest = 0;
    for (Index row = 0; row < matrix.rows(); ++row) {
        double sum = 0;
        for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
            sum += std::abs(entry.value());
        }
        largest = std::max(largest, sum);
    }
    return 1 / std::sqrt(largest);
}

/// The packet at a time, far from the junction, of waves that travel to the right.
class Arrival {
  public:
    Arrival(const Halves& halves, const Packet& packet, double time_step)
        : waves_(packet.waves()), centre_(-widths * packet.width) {
        const LateralChain chain = bar_chain(halves.left_length, halves.left);
        const auto phase = [&](double xi) {  // omega = (2/dt) sin(phase dt/2) in leapfrog steps
            return 2 * std::asin(std::sqrt(omega_squared(chain, xi)) * time_step / 2) / time_step;
        };
        for (const Packet::Wave& wave : waves_) {
            phases_.push_back(phase(wave.xi));
        }
        constexpr double small = 1e-4;
        speed_ = (phase(packet.middle + small) - phase(packet.middle - small)) / (2 * small);
    }

    double operator()(double X, double time) const {
        double sum = 0;
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            sum += waves_[i].amplitude * std::cos(waves_[i].xi * (X - centre_) - phases_[i] * time);
        }
        return sum;
    }

    /// Until the middle of what is reflected is where the packet started.
    double duration() const { return -2 * centre_ / speed_; }
    double distance() const { return -centre_; }

  private:
    std::vector<Packet::Wave> waves_;
    std::vector<double> phases_;  ///< per time
    double centre_;
    double speed_ = 0;  ///< of the packet [1/time]
};

/// Displacements of all nodes, in leapfrog steps.
class Bars {
  public:
    Bars(const Mesh& mesh, CouplingForm form, double time_step)
        : matrix_(accelerations(mesh, form)),
          time_step_(time_step),
          u_(VectorXd::Zero(matrix_.rows())),
          v_(VectorXd::Zero(matrix_.rows())) {}

    const VectorXd& u() const { return u_; }

    void start(const Arrival& arrival, std::size_t left_elements) {
        for (Index i = 0; i < Index(left_elements); ++i) {
            const double X = double(i) - double(left_elements);
            u_[i] = arrival(X, 0);
            v_[i] = (u_[i] - arrival(X, -time_step_)) / time_step_;
        }
    }

    void step(const nmbc::MatchingBoundary* end) {
        v_.noalias() -= time_step_ * (matrix_ * u_);
        if (end != nullptr) {
            const auto size = std::size_t(u_.size());
            end->update({u_.data(), size}, {v_.data(), size}, nmbc::End::right);
        }
        u_ += time_step_ * v_;
    }

  private:
    SparseMatrix matrix_;
    double time_step_;
    VectorXd u_;
    VectorXd v_;
};

}  // namespace

std::vector<Packet::Wave> Packet::waves() const {
    constexpr int count = 160;
    std::vector<Wave> all;
    for (int i = 0; i <= count; ++i) {
        const double off = 5 * (2.0 * i / count - 1);
        const double xi = middle + off / width;
        if (xi > 0 && xi < std::numbers::pi) {
            all.push_back({xi, std::exp(-off * off / 2)});
        }
    }
    return all;
}

double Packet::mean(const std::function<double(double xi)>& part) const {
    double sum = 0;
    double all = 0;
    for (const Wave& wave : waves()) {
        sum += wave.amplitude * wave.amplitude * part(wave.xi);
        all += wave.amplitude * wave.amplitude;
    }
    return sum / all;
}

double packet_time_step(const Halves& halves, CouplingForm form) {
    // Long enough for rows of either bar.
    const Rational farthest = std::max(halves.left.horizon, halves.right.horizon);
    const Rational shortest = std::min(halves.left_length, halves.right_length);
    const std::size_t elements = 2 * (floor(farthest / shortest).convert_to<std::size_t>() + 3);
    return step_of(accelerations(mesh_of(halves, elements, elements), form));
}

PacketResult run_packet(const Halves& halves, CouplingForm form, const Packet& packet,
                        const nmbc::BoundaryCoefficients* end) {
    const double time_step = packet_time_step(halves, form);
    const Arrival arrival(halves, packet, time_step);
    const double left_length = nearest_double(halves.left_length);
    const double right_length = nearest_double(halves.right_length);
    const double speed = std::sqrt(nearest_double(halves.right.stiffness));

    // With an end, so much longer that what comes back of it is in the left bar.
    double duration = arrival.duration();
    if (end != nullptr) {
        duration += 2 * double(elements_to_end) * right_length / speed;
    }
    const auto steps = std::size_t(std::lround(duration / time_step));
    const auto left = std::size_t(2 * arrival.distance() * duration / arrival.duration()) + 1;
    const auto right = std::size_t(1.1 * speed * duration / right_length);

    Bars bars(mesh_of(halves, left, right), form, time_step);
    bars.start(arrival, left);
    const auto size = [&](const VectorXd& u) {
        return std::pair(left_length * u.head(Index(left)).squaredNorm(),
                         right_length * u.tail(u.size() - Index(left)).squaredNorm());
    };
    const double whole = size(bars.u()).first;
    std::optional<nmbc::MatchingBoundary> boundary;
    std::optional<Bars> ended;
    if (end != nullptr) {
        boundary.emplace(*end, nmbc::BoundaryParameters{.ghost_layers = 1,
                                                        .wave_speed = speed,
                                                        .spacing = right_length,
                                                        .time_step = time_step});
        ended.emplace(mesh_of(halves, left, elements_to_end), form, time_step);
        ended->start(arrival, left);
    }
    for (std::size_t i = 0; i < steps; ++i) {
        bars.step(nullptr);
        if (ended) {
            ended->step(&*boundary);
        }
    }
    const auto [reflected, transmitted] = size(bars.u());
    PacketResult result{reflected / whole, transmitted / whole, 0};
    if (ended) {
        result.from_end = size(ended->u() - bars.u().head(ended->u().size())).first / whole;
    }
    return result;
}

}  // namespace nmbcgen
