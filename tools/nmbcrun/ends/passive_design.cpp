// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/passive_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <nmbc/passive.hpp>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "generator/families/family.hpp"
#include "generator/passive/chain_end.hpp"
#include "tools/nmbcrun/ends/cut_families.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

struct Designed {
    nmbcgen::DesignedSide side;
    nmbcgen::EdgeEnergies energies;
    nmbc::PassiveEnd end;
};
using Design = std::shared_ptr<const Designed>;

std::string beyond_designs(long n) {
    return fmt::format("designed for n up to {}, not {}", DesignedEnd::largest_horizon, n);
}

Design designed(const nmbc::Lattice& lattice, double time_step) {
    static std::mutex mutex;
    struct Known {
        Design found;
        std::string why_not;
    };
    static std::map<std::tuple<unsigned, double, double>, Known> known;
    const double G = stabilisation_of(lattice);
    const auto n = unsigned(lattice.reach() / 2);
    static_assert(DesignedEnd::largest_horizon == nmbcgen::largest_designed_horizon);
    if (n > nmbcgen::largest_designed_horizon) {
        throw SceneError("passive ends are " + beyond_designs(n));
    }
    const std::lock_guard lock(mutex);
    const auto [entry, is_new] = known.try_emplace({n, G, time_step});
    Known& design = entry->second;
    if (is_new) {
        try {
            nmbcgen::DesignedSide side = nmbcgen::passive_end(
                lattice.symbol, n, nmbcgen::Rational(G),
                [n](unsigned layer) { return nmbcgen::nopd1d_at_edge(n, layer); }, time_step);
            nmbcgen::EdgeEnergies energies = side.task.at(0);
            nmbc::PassiveEnd end = for_runtime(side, energies);
            design.found = std::make_shared<const Designed>(
                Designed{std::move(side), std::move(energies), std::move(end)});
        } catch (const std::domain_error& reason) {
            design.why_not = reason.what();
        }
    }
    if (!design.found) {
        throw SceneError(fmt::format(
            "no passive end was found at n = {}, G = {}, dt = {:.4g} dX/c: {}. Try a smaller "
            "time.cfl, or another kind",
            n, G, time_step, design.why_not));
    }
    return design.found;
}

/// Wave numbers of packets go beyond the band, where they are those of other waves; at its ends and
/// at a few others a wave cannot be told from another one of its frequency. Nothing where it cannot
/// be told from others nearby, either.
std::optional<nmbcgen::ArrivingWave> told_apart(const nmbcgen::LateralChain& chain, double xi) {
    using std::numbers::pi;
    const double folded = std::abs(std::remainder(xi, 2 * pi));
    for (const double aside : {0.0, 1e-4, -1e-4, 1e-3, -1e-3}) {
        try {
            constexpr double nearest = 1e-4;
            return arriving_wave(chain, std::clamp(folded + aside, nearest, pi - nearest));
        } catch (const std::domain_error&) {
            continue;
        }
    }
    return std::nullopt;
}

}  // namespace

std::string why_not_designed(const Scene& scene) {
    if (!has_constant_influence(scene) || is_damped(scene)) {
        return "designed for nopd1d of constant influence, undamped";
    }
    return scene.horizon > DesignedEnd::largest_horizon ? beyond_designs(scene.horizon) : "";
}

std::unique_ptr<nmbc::BoundaryCondition<double>> DesignedEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> precision) {
    const double step = parameters.time_step * parameters.wave_speed() / parameters.spacing;
    return designed(lattice, step)->end.make(lattice, parameters, precision);
}

std::function<WavesSentBack(double xi)> sent_back_by_passive_end(const nmbc::Lattice& lattice,
                                                                 double time_step) {
    const Design design = designed(lattice, time_step);
    return [design, chain = nmbcgen::chain_of(lattice.symbol)](double xi) {
        const auto& [side, energies, end] = *design;
        const auto told = told_apart(chain, xi);
        if (!told) {  // as much as can come back
            return WavesSentBack{.k = {std::polar(1.0, -xi)},
                                 .amplitudes = Eigen::MatrixXcd::Ones(1, 1),
                                 .column = 0,
                                 .energy = 1};
        }
        const nmbcgen::ArrivingWave& wave = *told;
        const Eigen::MatrixXcd amplitudes =
            edge_amplitudes(energies, side.edge, wave.outgoing, wave.omega, side.task.time_step);
        WavesSentBack sent{.k = {}, .amplitudes = amplitudes, .column = wave.column, .energy = 0};
        const nmbcgen::EdgeReach& reach = side.task.reach;
        const auto further = double(reach.interior() - 1 - reach.waves()) + double(end.further);
        for (const nmbcgen::PlaneMode& mode : wave.outgoing) {
            sent.k.push_back(mode.z);
        }
        for (Eigen::Index o = 0; o < amplitudes.rows(); ++o) {
            for (Eigen::Index i = 0; i < amplitudes.cols(); ++i) {
                sent.amplitudes(o, i) *=
                    std::pow(sent.k[std::size_t(o)] * sent.k[std::size_t(i)], further);
            }
        }
        sent.energy = in_flux_metric(amplitudes.topRows(amplitudes.cols()), wave.outgoing)
                          .col(wave.column)
                          .squaredNorm();
        return sent;
    };
}

}  // namespace nmbcrun
