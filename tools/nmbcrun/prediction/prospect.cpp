// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/prediction/prospect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/prediction/layer_reflection.hpp"
#include "tools/nmbcrun/prediction/prediction.hpp"
#include "tools/nmbcrun/prediction/source_spectrum.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"
#include "tools/nmbcrun/sources/short_waves.hpp"
#include "tools/nmbcrun/sources/source_length.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"
#include "tools/nmbcrun/tables/tables.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

using Energies = std::map<double, double>;  // by wave number

double sum_of(const Energies& energies) {
    double sum = 0;
    for (const auto& [xi, energy] : energies) {
        sum += energy;
    }
    return sum;
}

/// What gets to an end, or as many nodes beyond it, before the run is over, directly or by way of a
/// physical end opposite.
Energies arriving_at(nmbc::End side, const Simulation& simulation,
                     const std::vector<SourceSpectrum>& sources, std::size_t beyond = 0) {
    const Scene& scene = simulation.scene();
    const bool left = side == nmbc::End::left;
    const auto last = double(scene.nodes) - 1;
    const bool comes_round = is_physical((left ? scene.right : scene.left).kind);
    const double unit = unit_of_time(scene);
    const double step = simulation.plan().time_step / unit;
    Energies energies;
    for (const SourceSpectrum& source : sources) {
        double way = left ? source.first : last - source.last;
        if (source.name == "incoming" && scene.incoming->end == side) {  // it goes away from there
            way = comes_round ? 2 * last : std::numeric_limits<double>::infinity();
        }
        for (std::size_t part = 0; part < source.spectrum.parts(); ++part) {
            const double xi = source.spectrum.wave_number(part);
            const double speed = std::abs(group_velocity(simulation.chain().lattice(), xi, step));
            if (speed * (scene.end - source.start) / unit >= way + double(beyond)) {
                energies[xi] += source.spectrum.energy() * source.spectrum.share(part);
            }
        }
    }
    return energies;
}

/// By wave number, the part of the arriving energy that an end sends back before the run is over;
/// nothing where it is not known.
std::optional<std::function<double(double xi)>> sent_back(
    nmbc::End side, const Simulation& simulation, const std::vector<SourceSpectrum>& sources,
    const Energies& arriving) {
    const Scene& scene = simulation.scene();
    const Boundary& end = side == nmbc::End::left ? scene.left : scene.right;
    if (end.kind == BoundaryKind::extended && end.layer > 0 && !is_damped(scene)) {
        // Its far end is fixed: all comes back that has the time.
        return [arriving, back = arriving_at(side, simulation, sources, 2 * end.layer)](double xi) {
            const auto found = back.find(xi);
            return found == back.end() ? 0.0 : found->second / arriving.at(xi);
        };
    }
    return reflected_energy_of(scene, end, simulation.plan().time_step / unit_of_time(scene));
}

/// What comes back of the waves that get to one end or both.
class Returned {
  public:
    void add(const Energies& arriving, const std::function<double(double)>& reflected_energy) {
        const double negligible = 1e-9 * sum_of(arriving);
        for (const auto& [xi, energy] : arriving) {
            arrived_ += energy;
            if (energy > negligible) {
                const double part = reflected_energy(xi);
                back_[xi] += part * energy;
                constexpr double roundings = 1e-6;
                if (part > 1 + roundings) {
                    amplified_[xi] += energy;
                    most_ = std::max(most_, part);
                }
            }
        }
    }

    std::string in_words() const {
        if (arrived_ == 0) {
            return "nothing gets there before time.end";
        }
        const double back = sum_of(back_) / arrived_;
        if (back == 0) {
            return "nothing of the energy that reaches them comes back";
        }
        if (back < 1e-12) {
            return "less than 1e-12 of the energy that reaches them comes back";
        }
        const auto most = std::ranges::max_element(back_, {}, &Energies::value_type::second);
        constexpr double nearly = 0.95;
        const std::string part = back < nearly       ? fmt::format("about {:.1g} of ", back)
                                 : back < 1 / nearly ? "all of "
                                                     : fmt::format("{:.2g} times ", back);
        return fmt::format("{}the energy that reaches them comes back, most at xi dX = {:.2g}",
                           part, most->first);
    }

    /// Whether more than a tenth comes back of what arrives, if that counts beside what was sent.
    bool is_much(double sent) const {
        constexpr double much = 0.1;
        constexpr double negligible = 1e-3;
        return arrived_ > negligible * sent && sum_of(back_) > much * arrived_;
    }

    /// Empty where next to nothing is amplified.
    std::string amplified_in_words() const {
        constexpr double negligible = 1e-3;
        const double share = arrived_ > 0 ? sum_of(amplified_) / arrived_ : 0;
        return share <= negligible
                   ? ""
                   : fmt::format(
                         "sends back up to {:.2g} times the energy that comes, at xi dX = "
                         "{:.2g} to {:.2g}, which holds {:.1g} of the energy that gets there",
                         most_, amplified_.begin()->first, amplified_.rbegin()->first, share);
    }

  private:
    double arrived_ = 0;
    double most_ = 0;
    Energies back_;
    Energies amplified_;
};

/// The part of the energy in waves that are much slower or faster than c, or go backwards.
double not_carried(const SourceSpectrum& source, const nmbc::Lattice& lattice, double step) {
    double share = 0;
    for (std::size_t part = 0; part < source.spectrum.parts(); ++part) {
        const double speed = group_velocity(lattice, source.spectrum.wave_number(part), step);
        share += speed < 0.75 || speed > 1.25 ? source.spectrum.share(part) : 0;
    }
    return share;
}

/// "; KEY = VALUE would do" or that none would: zero-energy modes answer to a single node at any
/// pace. What would do is carried by the lattice, and absorbed by the ends.
std::string what_would_do(const Simulation& simulation, const std::string& source) {
    Scene scene = with_source_alone(simulation.scene(), source);
    const auto [key, value, is_inverse, time] = length_of_source(scene, source);
    if (value == nullptr) {
        return "";
    }
    const nmbc::Lattice& lattice = simulation.chain().lattice();
    const double step = simulation.plan().time_step;
    const double own_end = scene.end;
    const double own_value = *value;
    const double own_time = time == nullptr ? 0 : *time;
    for (double factor = 1.25; factor < 1e3; factor *= 1.25) {
        *value = two_digits(is_inverse ? own_value / factor : own_value * factor, is_inverse);
        if (own_time > 0 && !is_inverse) {  // a sine has no part before its time
            *time =
                std::max(own_time,
                         two_digits(std::min(own_time * factor, enough_durations * *value), false));
        }
        const double over = end_of_source(scene, source);
        const bool is_in_run = over <= own_end;
        scene.end = is_in_run ? own_end : two_digits(std::max(over, own_end * factor), false);
        const auto spectra = source_spectra(scene, lattice, step);
        if (not_carried(spectra.front(), lattice, step / unit_of_time(scene)) <= most_not_carried &&
            absorbs(scene)) {
            std::vector<std::string> others;
            if (time != nullptr && *time != own_time) {
                others.push_back(fmt::format("{}.time = {:.2g}", source, *time));
            }
            if (!is_in_run) {
                others.push_back(fmt::format("time.end = {:.2g}", scene.end));
            }
            return fmt::format("; {} = {:.2g}{}{} would do", key, *value,
                               others.empty() ? "" : " with ", fmt::join(others, " and "));
        }
    }
    return fmt::format("; no {} within a factor of 1000 cures it", key);
}

/// One for each source that the lattice does not carry.
std::vector<std::string> warnings_of(const Simulation& simulation,
                                     const std::vector<SourceSpectrum>& sources, double step) {
    std::vector<std::string> warnings;
    for (const SourceSpectrum& source : sources) {
        const double share = not_carried(source, simulation.chain().lattice(), step);
        if (share > most_not_carried) {
            warnings.push_back(fmt::format(
                "{:.0f} % of what {} sends out is in waves so short that the lattice disperses "
                "them or turns them back{}",
                100 * share, source.name, what_would_do(simulation, source.name)));
        }
    }
    return warnings;
}

/// What nothing is predicted of.
std::string what_is_unknown(const Scene& scene, const Boundary& end) {
    return is_damped(scene)        ? "of a damped lattice"
           : has_profile(end.kind) ? fmt::format("of a {} of more than {} nodes", name_of(end.kind),
                                                 widest_told_layer(lattice_of(scene)))
                                   : fmt::format("of an end that is {}", name_of(end.kind));
}

double energy_of(const std::vector<SourceSpectrum>& sources) {
    double energy = 0;
    for (const SourceSpectrum& source : sources) {
        energy += source.spectrum.energy();
    }
    return energy;
}

/// Whether its parts are, too.
bool is_known(double energy) {
    constexpr double least = 1e-280;
    return energy > least && std::isfinite(energy);
}

/// Of the ends, where it is not.
std::string of_unknown_energy(const Scene& scene) {
    return is_physical(scene.left.kind) && is_physical(scene.right.kind)
               ? ""
               : "nothing is predicted: the energy that the sources send out is 0, or too little "
                 "or too much for doubles";
}

}  // namespace

Prospect prospect_of(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    const nmbc::Lattice& lattice = simulation.chain().lattice();
    const double step = simulation.plan().time_step / unit_of_time(scene);
    const auto sources = source_spectra(scene, lattice, simulation.plan().time_step);
    Prospect prospect;
    const double sent = energy_of(sources);
    if (!sources.empty() && !is_known(sent)) {
        prospect.ends = of_unknown_energy(scene);
        return prospect;
    }
    prospect.warnings = warnings_of(simulation, sources, step);
    Returned returned;
    std::string unknown;
    bool has_artificial = false;
    std::map<double, double> known;  // by wave number, of one end or two like ones
    for (const auto side : {nmbc::End::left, nmbc::End::right}) {
        const Boundary& end = side == nmbc::End::left ? scene.left : scene.right;
        if (is_physical(end.kind)) {
            continue;
        }
        has_artificial = true;
        const Energies arriving = arriving_at(side, simulation, sources);
        const auto reflected_energy = sent_back(side, simulation, sources, arriving);
        if (!reflected_energy) {
            unknown = what_is_unknown(scene, end);
            continue;
        }
        if (!(end == scene.left) || end.kind == BoundaryKind::extended) {
            known.clear();
        }
        const auto known_or_found = [&](double xi) {
            stop_if_interrupted();
            const auto [found, is_new] = known.try_emplace(xi, 0.0);
            return found->second = is_new ? (*reflected_energy)(xi) : found->second;
        };
        Returned alone;
        alone.add(arriving, known_or_found);
        returned.add(arriving, known_or_found);
        const std::string amplified = alone.amplified_in_words();
        if (!amplified.empty() && prospect.objection.empty()) {
            prospect.objection = fmt::format("{} on the {} {}", heading_of(end),
                                             side == nmbc::End::left ? "left" : "right", amplified);
        }
    }
    if (has_artificial) {
        prospect.ends = unknown.empty()
                            ? returned.in_words()
                            : "nothing is predicted " + unknown + ": nmbcrun verify measures it";
        prospect.sends_much_back = unknown.empty() && returned.is_much(sent);
    }
    return prospect;
}

bool absorbs(const Scene& scene) {
    try {
        const Prospect prospect = prospect_of(Simulation(scene));
        return prospect.objection.empty() && !prospect.sends_much_back;
    } catch (const SceneError&) {
        return false;
    } catch (const Unstable&) {
        return false;
    }
}

}  // namespace nmbcrun
