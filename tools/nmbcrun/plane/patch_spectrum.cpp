// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/patch_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

using std::numbers::pi;

bool is_carried(const nmbc::PlaneModel& model, const std::array<double, 2>& xi, bool is_P) {
    const auto omega = [&](double x, double y) {
        return std::sqrt(std::max(0.0, nmbc::plane_wave(model, {x, y}, is_P).omega_squared));
    };
    constexpr double aside = 1e-4;
    const std::array<double, 2> group{
        (omega(xi[0] + aside, xi[1]) - omega(xi[0] - aside, xi[1])) / (2 * aside),
        (omega(xi[0], xi[1] + aside) - omega(xi[0], xi[1] - aside)) / (2 * aside)};
    const double forwards = (group[0] * xi[0] + group[1] * xi[1]) / std::hypot(xi[0], xi[1]);
    const double speed = forwards / (is_P ? model.speed_P() : model.speed_S());
    constexpr double far_off = 0.25;
    return std::abs(speed - 1) <= far_off;
}

/// Components of u and v, in this order.
using Amplitudes = std::array<std::complex<double>, 4>;

template <class Values>
void add_turned(Amplitudes& sums, const Values& values, std::complex<double> turn) {
    for (std::size_t a = 0; a < sums.size(); ++a) {
        sums[a] += turn * values[a];
    }
}

}  // namespace

Waves::Waves(const PlaneScene& scene) : rate_(rate_of(scene)), model_(model_of(scene)) {}

PlaneLatticeWave Waves::wave(const std::array<double, 2>& xi, bool is_P) const {
    const nmbc::PlaneWave wave = nmbc::plane_wave(model_, xi, is_P);
    return {wave.direction, rate_ * std::sqrt(std::max(0.0, wave.omega_squared)),
            is_carried(model_, xi, is_P)};
}

PatchSpectrum::PatchSpectrum(const PlaneScene& scene) : waves_(scene) {
    for (std::size_t turn = 0; turn < turns_.size(); ++turn) {
        turns_[turn] = std::polar(1.0, -pi * double(turn) / Patch::across);
    }
    for (std::size_t y = 0; y < Patch::across / 2; ++y) {
        for (std::size_t x = 0; x < Patch::across; ++x) {
            const auto xi = [](std::size_t k) {
                return std::remainder(pi * double(2 * k + 1) / Patch::across, 2 * pi);
            };
            for (const bool is_P : {true, false}) {
                of_zone_.push_back(waves_.wave({xi(x), xi(y)}, is_P));
            }
        }
    }
}

void PatchSpectrum::add(const Patch& patch, const std::function<double(double omega)>& weight) {
    if (patch.gives.empty()) {
        return;
    }
    const std::size_t ny = patch.gives.size() / patch.nx;
    std::vector<Amplitudes> of_rows(ny);
    for (std::size_t x = 0; x < Patch::across; ++x) {
        for (std::size_t row = 0; row < ny; ++row) {
            of_rows[row] = {};
            for (std::size_t i = 0; i < patch.nx; ++i) {
                const StartOfNode& node = patch.gives[row * patch.nx + i];
                add_turned(of_rows[row], std::array{node.u[0], node.u[1], node.v[0], node.v[1]},
                           turn(x, i));
            }
        }
        for (std::size_t y = 0; y < Patch::across / 2; ++y) {
            Amplitudes all{};
            for (std::size_t row = 0; row < ny; ++row) {
                add_turned(all, of_rows[row], turn(y, row));
            }
            for (const std::size_t polarisation : {0U, 1U}) {
                const PlaneLatticeWave& wave = of_zone_[2 * (y * Patch::across + x) + polarisation];
                const auto along = [&](std::size_t first) {
                    return std::norm(wave.direction[0] * all[first] +
                                     wave.direction[1] * all[first + 1]);
                };
                waves_.add(wave,
                           wave.omega * wave.omega * along(0) + weight(wave.omega) * along(2));
            }
        }
    }
}

}  // namespace nmbcrun
