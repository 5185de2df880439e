// SPDX-License-Identifier: MIT
/// How the energy that nodes get is shared among the waves of a lattice of the plane.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <nmbc/plane_wave.hpp>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/start_of_nodes.hpp"

namespace nmbcrun {

/// A wave of a lattice. It is carried if its group goes forwards, nearly at the solid's speed.
struct PlaneLatticeWave {
    std::array<double, 2> direction{};  ///< of u, of length 1
    double omega = 0;                   ///< [1/time]
    bool is_carried = false;
};

/// Energy in waves of a lattice.
class Waves {
  public:
    explicit Waves(const PlaneScene& scene);

    /// xi: wave vector times dX.
    PlaneLatticeWave wave(const std::array<double, 2>& xi, bool is_P) const;

    void add(const PlaneLatticeWave& wave, double energy) {
        all_ += energy;
        lost_ += wave.is_carried ? 0 : energy;
    }

    /// The part in waves that the lattice does not carry.
    double not_carried() const { return all_ > 0 ? lost_ / all_ : 0; }

  private:
    double rate_;
    nmbc::PlaneModel model_;
    double all_ = 0;
    double lost_ = 0;
};

/// What nodes get, row by row, within a square of `across` nodes a side; nothing beyond its rows.
struct Patch {
    static constexpr int across = 64;

    std::size_t nx = 0;
    std::vector<StartOfNode> gives{};

    bool moves() const {
        return std::ranges::any_of(gives, [](const StartOfNode& node) {
            return node.u[0] != 0 || node.u[1] != 0 || node.v[0] != 0 || node.v[1] != 0;
        });
    }
};

/// Energy that patches give the waves of half the zone, at `across` wave numbers along x and half
/// as many along y.
class PatchSpectrum {
  public:
    explicit PatchSpectrum(const PlaneScene& scene);

    /// weight(omega): what a wave has of the power of `gives.v`.
    void add(const Patch& patch, const std::function<double(double omega)>& weight);

    /// The part in waves that the lattice does not carry.
    double not_carried() const { return waves_.not_carried(); }

  private:
    /// exp(-i xi_k place)
    std::complex<double> turn(std::size_t k, std::size_t place) const {
        return turns_[(2 * k + 1) * place % turns_.size()];
    }

    Waves waves_;
    std::array<std::complex<double>, std::size_t(2 * Patch::across)> turns_{};
    std::vector<PlaneLatticeWave> of_zone_{};  // polarisations fastest, then x
};

}  // namespace nmbcrun
