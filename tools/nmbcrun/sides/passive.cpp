// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sides/passive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>
#include <nmbc/passive.hpp>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "generator/families/family.hpp"
#include "generator/passive/chain_end.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sides/cut_families.hpp"

namespace nmbcrun {
namespace {

struct Designed {
    nmbcgen::PassiveSide side;
    nmbcgen::EdgeEnergies energies;
};
using Design = std::shared_ptr<const Designed>;

Design designed(const nmbc::Lattice& lattice, double time_step) {
    static std::mutex mutex;
    static std::map<std::tuple<unsigned, double, double>, Design> known;
    const double G = stabilisation_of(lattice);
    const auto n = unsigned(lattice.reach() / 2);
    const std::lock_guard lock(mutex);
    Design& design = known[{n, G, time_step}];
    if (!design) {
        try {
            nmbcgen::PassiveSide side = nmbcgen::passive_end(
                lattice.symbol, n, nmbcgen::Rational(G),
                [n](unsigned layer) { return nmbcgen::nopd1d_at_edge(n, layer); }, time_step);
            nmbcgen::EdgeEnergies energies = side.task.at(0);
            design = std::make_shared<const Designed>(
                Designed{.side = std::move(side), .energies = std::move(energies)});
        } catch (const std::domain_error& reason) {
            throw SceneError(fmt::format(
                "no passive end was found at n = {}, G = {}, dt = {:.4g} dX/c: {}. Try a smaller "
                "time.cfl, or another kind",
                n, G, time_step, reason.what()));
        }
    }
    return design;
}

/// Row by row.
std::vector<double> entries_of(const Eigen::MatrixXd& matrix) {
    std::vector<double> entries;
    for (const auto& row : matrix.rowwise()) {
        entries.insert(entries.end(), row.begin(), row.end());
    }
    return entries;
}

/// From node to node what decays does so by a half or more, of all but the wildest lattices.
std::size_t further_of(const nmbcgen::EdgeReach& reach) {
    return std::size_t(4 * reach.node);
}

nmbc::PassiveEnd end_of(const Designed& design) {
    const auto& [side, energies] = design;
    const auto rows = side.task.reach.interior();
    const Eigen::MatrixXd stiffness = energies.stiffness(side.edge).topRows(rows);
    return {.rows = std::size_t(rows),
            .stiffness = entries_of(stiffness),
            .mass = entries_of(side.edge.mass),
            .dashpots = entries_of(side.edge.dashpots.front()),
            .highest_eigenvalue = side.highest_eigenvalue,
            .further = further_of(side.task.reach)};
}

/// At a few wave numbers a wave cannot be told from another one of its frequency.
nmbcgen::ArrivingWave told_apart(const nmbcgen::LateralChain& chain, double xi) {
    constexpr double aside = 1e-4;
    try {
        return arriving_wave(chain, xi);
    } catch (const std::domain_error&) {
        return arriving_wave(chain, xi + aside);
    }
}

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> DesignedEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> precision) const {
    const double step = parameters.time_step * parameters.wave_speed() / parameters.spacing;
    return end_of(*designed(lattice, step)).make(lattice, parameters, precision);
}

std::function<WavesSentBack(double xi)> sent_back_by_passive_end(const nmbc::Lattice& lattice,
                                                                 double time_step) {
    const Design design = designed(lattice, time_step);
    return [design, chain = nmbcgen::chain_of(lattice.symbol)](double xi) {
        const auto& [side, energies] = *design;
        const nmbcgen::ArrivingWave wave = told_apart(chain, xi);
        const Eigen::MatrixXcd amplitudes =
            edge_amplitudes(energies, side.edge, wave.outgoing, wave.omega, side.task.time_step);
        WavesSentBack sent{.k = {}, .amplitudes = amplitudes, .column = wave.column, .energy = 0};
        const nmbcgen::EdgeReach& reach = side.task.reach;
        const auto further =
            double(reach.interior() - 1 - reach.waves()) + double(further_of(reach));
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
