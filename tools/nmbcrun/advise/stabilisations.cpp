// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/stabilisations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nmbc/coefficients.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <numbers>
#include <utility>

#include "tools/nmbcrun/advise/candidates.hpp"
#include "tools/nmbcrun/advise/continuum.hpp"
#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

bool is_stabilised(const nmbc::Lattice& lattice) {
    return std::ranges::find(lattice.energy, nmbc::EnergyPart::stabilisation,
                             &nmbc::Lattice::Square::part) != lattice.energy.end();
}

struct Weight {
    double xi;
    double weight;
};

/// Of the wave equation's waves: |amplitude|^2, but for what is too small to count.
std::vector<Weight> spectrum_of(const Scene& scene, const Pause& pause) {
    constexpr double cfl = 0.2;
    const Outgoing outgoing = EndlessScene(scene, pause).outgoing(cfl);
    const ContinuumWaves waves = continuum_waves(scene, outgoing, pause);
    std::vector<Weight> weights;
    weights.reserve(outgoing.bands.size());
    double largest = 0;
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        weights.push_back({outgoing.bands[band].xi,
                           std::norm(waves.forwards[band]) + std::norm(waves.backwards[band])});
        largest = std::max(largest, weights.back().weight);
    }
    std::erase_if(weights, [&](const Weight& one) { return one.weight < 1e-12 * largest; });
    return weights;
}

/// Where value(x) is least, 0 <= x <= highest, to a ten-thousandth of that or so.
template <class Value>
double minimum(Value value, double highest) {
    constexpr int parts = 40;
    const double part = highest / parts;
    int best = 0;
    double least = value(0.0);
    for (int i = 1; i <= parts; ++i) {
        const double one = value(i * part);
        if (one < least) {
            best = i;
            least = one;
        }
    }
    double low = std::max(best - 1, 0) * part;
    double high = std::min(best + 1, parts) * part;
    for (int i = 0; i < 14; ++i) {
        const double inset = (high - low) * (1 - 1 / std::numbers::phi);
        if (value(low + inset) > value(high - inset)) {
            low += inset;
        } else {
            high -= inset;
        }
    }
    return (low + high) / 2;
}

double to_four_digits(double value) {
    return std::round(value * 1e4) / 1e4;
}

/// The lattices of one horizon beside the wave equation.
class Fit {
  public:
    /// Among G from 0 to the highest. The scene's horizon is settled.
    Fit(const Scene& scene, std::vector<Weight> spectrum, double highest, const Pause& pause)
        : scene_(scene), spectrum_(std::move(spectrum)), highest_(highest), pause_(pause) {}

    /// The G at which the waves are least off, in steps of time_step_of(omega_max) [dX/c].
    template <class TimeStepOf>
    double best_G(TimeStepOf time_step_of) {
        return to_four_digits(minimum(
            [&](double G) {
                pause_();
                const Band& band = band_of(G);
                return misfit(band, time_step_of(band.omega_max));
            },
            highest_));
    }

  private:
    struct Band {
        double omega_max = 0;
        std::vector<double> omega;  // of the spectrum's wave numbers
    };

    const Band& band_of(double G) {
        const auto [known, is_new] = bands_.try_emplace(G);
        if (is_new) {
            const nmbc::Lattice lattice = lattice_of(with_lattice(scene_, scene_.horizon, G));
            Band& band = known->second;
            band.omega_max = nmbc::maximum_frequency(lattice);
            band.omega.reserve(spectrum_.size());
            for (const Weight& one : spectrum_) {
                band.omega.push_back(
                    std::sqrt(std::max(nmbc::omega_squared(lattice, one.xi), 0.0)));
            }
        }
        return known->second;
    }

    /// How far the waves are off in a unit of time, squared.
    double misfit(const Band& band, double time_step) const {
        double sum = 0;
        for (std::size_t i = 0; i < spectrum_.size(); ++i) {
            const auto& [xi, weight] = spectrum_[i];
            sum += weight * std::pow(frequency_in_steps(band.omega[i], time_step) - xi, 2);
        }
        return sum;
    }

    const Scene& scene_;
    std::vector<Weight> spectrum_;
    double highest_;
    const Pause& pause_;
    std::map<double, Band> bands_;  // by G
};

/// The largest cfl that tables are certified for, with their windows of G.
std::vector<nmbc::StableStep> longest_steps(const Scene& scene) {
    std::vector<nmbc::StableStep> steps;
    for (const nmbc::MatchingTable* table : tables_of(scene)) {
        for (const auto list : {table->max_cfl, table->max_cfl_contractive}) {
            steps.insert(steps.end(), list.begin(), list.end());
        }
    }
    return steps;
}

/// Each G with the cfl it is best in, of all cfl worth a look.
std::map<double, double> best_in_steps(const Scene& scene, Fit& fit) {
    std::map<double, double> best;  // G by cfl
    const auto best_at = [&](double cfl) {
        const auto [known, is_new] = best.try_emplace(cfl, 0.0);
        if (is_new) {
            known->second = fit.best_G([cfl](double omega_max) { return 2 * cfl / omega_max; });
        }
        return known->second;
    };
    std::map<double, double> cfls;
    for (const double cfl : {0.05, 0.3, 0.5, 0.7, 0.9, 0.99}) {
        cfls[best_at(cfl)] = cfl;
    }
    for (const nmbc::StableStep& longest : longest_steps(scene)) {
        const double G = best_at(longest.cfl);
        if (longest.window.contains(G)) {
            cfls[G] = longest.cfl;
        }
    }
    return cfls;
}

}  // namespace

std::vector<Stabilisation> stabilisations_to_try(const Scene& scene, const Pause& pause) {
    const double base = nmbc::detail::nearest_to_fraction(best_G(scene.horizon));
    const nmbc::MatchingTable& any =
        table_of(with_lattice(scene, scene.horizon, 0), {.kind = BoundaryKind::fixed});
    if (!is_stabilised(nmbc::make_lattice(any, base))) {
        return {{}};
    }
    Fit fit(scene, spectrum_of(with_lattice(scene, scene.horizon, base), pause), 2 * base, pause);
    std::map<double, double> cfls;  // by G
    if (scene.step || scene.cfl) {
        const double unit = unit_of_time(scene);
        cfls[fit.best_G([&](double omega_max) {
            return scene.step ? *scene.step / unit : 2 * *scene.cfl / omega_max;
        })] = 0;
    } else {
        cfls = best_in_steps(scene, fit);
    }
    cfls.try_emplace(0, 0);
    std::vector<Stabilisation> result;
    result.reserve(cfls.size());
    for (const auto& [G, cfl] : cfls) {
        result.push_back({G, cfl});
    }
    return result;
}

}  // namespace nmbcrun
