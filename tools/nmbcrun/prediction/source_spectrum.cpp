// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/prediction/source_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"
#include "tools/nmbcrun/sources/incoming_wave.hpp"
#include "tools/nmbcrun/sources/initial_fields.hpp"
#include "tools/nmbcrun/sources/nodes_within.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t spectrum_parts = 512;
constexpr double width_of_part = std::numbers::pi / spectrum_parts;
/// Waves that a pulse of 1/e of its height has at a distance of one width start as far out.
constexpr double wide = 2;

double omega_of(const nmbc::Lattice& lattice, double xi) {
    return std::sqrt(std::max(nmbc::omega_squared(lattice, xi), 0.0));
}

/// |sum_j f_j exp(-2 pi i q j / L)|^2, q = 0 .. L/2, L a power of 2 from twice the length on.
std::vector<double> powers_of(std::vector<double> field) {
    std::size_t length = 2;
    while (length < 2 * field.size()) {
        length *= 2;
    }
    field.resize(length);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    fft.fwd(spectrum, field);
    std::vector<double> powers;
    powers.reserve(spectrum.size());
    for (const std::complex<double>& each : spectrum) {
        powers.push_back(std::norm(each));
    }
    return powers;
}

/// The mean of powers_of() between two angles from 0 to pi, however close; 0 beyond pi.
class MeanPower {
  public:
    explicit MeanPower(const std::vector<double>& field) : powers_(powers_of(field)) {
        sums_.reserve(powers_.size() + 1);
        for (const double power : powers_) {
            sums_.push_back(sums_.back() + power);
        }
    }

    double between(double one, double other) const {
        const auto [low, high] = std::minmax(one, other);
        const auto entry = [&](double angle) {
            return std::size_t(std::lround(angle / std::numbers::pi * double(powers_.size() - 1)));
        };
        if (high > std::numbers::pi) {
            return 0;
        }
        const std::size_t first = entry(low);
        const std::size_t last = entry(high);
        return (sums_[last + 1] - sums_[first]) / double(last + 1 - first);
    }

  private:
    std::vector<double> powers_;
    std::vector<double> sums_{0};
};

/// weight(xi) |transform|^2 of the pulse, u or v at nodes that are dX apart.
Spectrum spectrum_of(const Pulse& pulse, double spacing,
                     const std::function<double(double xi)>& weight) {
    Pulse within = pulse;  // narrower ones have the same white spectrum, wider ones are in a part
    within.width = std::clamp(pulse.width, 0.1 * spacing, 1e6 * spacing);
    const Transform transform = transform_of(within, 0, spacing);
    const double half = transform.highest - pulse.wave_number;
    const double low = std::max(0.0, pulse.wave_number - half);
    constexpr double per_part = 4;
    const double samples = std::max(4000.0, per_part * (transform.highest - low) / width_of_part);
    const double step = (transform.highest - low) / samples;
    std::vector<double> energies(spectrum_parts);
    for (double i = 0.5; i < samples; ++i) {
        const double kappa = low + i * step;
        const double folded = std::abs(std::remainder(kappa, 2 * std::numbers::pi));
        const auto part = std::min(spectrum_parts - 1, std::size_t(folded / width_of_part));
        energies[part] += step * weight(folded) * std::norm(transform.value(kappa));
    }
    return Spectrum(std::move(energies));
}

/// Of a force in time, and when it begins.
struct ChangesSpectrum {
    Spectrum spectrum;
    double start = 0;  // as SourceSpectrum has it
};

/// The first of the changes before which there is less than 1e-6 of their squares.
std::size_t first_that_counts(const std::vector<double>& changes) {
    constexpr double negligible = 1e-6;
    const double all = std::inner_product(changes.begin(), changes.end(), changes.begin(), 0.0);
    double before = 0;
    std::size_t first = 0;
    while (first + 1 < changes.size() &&
           before + changes[first] * changes[first] <= negligible * all) {
        before += changes[first] * changes[first];
        ++first;
    }
    return first;
}

/// What a force gives the velocities of so many nodes [dX/c times v], by the angle by which a wave
/// turns meanwhile. change: from a time on, for so long.
ChangesSpectrum spectrum_of_changes(
    const Scene& scene, const nmbc::Lattice& lattice, double time_step, const ForceHistory& force,
    const std::string& column, double nodes,
    const std::function<double(const ForceInTime&, double time, double between)>& change) {
    const ForceInTime in_time(force, column);
    const double unit = unit_of_time(scene);
    constexpr double most = 1 << 20;
    double first = 0;
    double last = scene.end;
    if (force.history == History::sine) {  // the beginning of a long one has its band
        first = std::max(0.0, force.time);
        last = std::min({last, in_time.last(), force.time + most * time_step});
    } else if (last > most * time_step) {  // of long runs, that the pulse be met
        first = std::max(0.0, std::floor(in_time.first() / time_step) * time_step);
        last = std::min(last, in_time.last());
    }
    const double between =  // others that are as long are slow
        std::max(time_step, time_step * std::ceil((last - first) / time_step / most));
    std::vector<double> changes;
    for (double time = first; time <= last && in_time.drives(time); time += between) {
        changes.push_back(change(in_time, time, between));
    }
    const MeanPower power(changes);
    const auto angle = [&](double xi) {
        const double sine = omega_of(lattice, xi) * time_step / unit / 2;
        return 2 * std::asin(std::min(sine, 1.0)) * between / time_step;
    };
    std::vector<double> energies;
    for (std::size_t part = 0; part < spectrum_parts; ++part) {
        const double xi = middle_of(part, spectrum_parts);
        const double place = std::sin(nodes * xi / 2) / std::sin(xi / 2);
        energies.push_back(
            width_of_part * place * place *
            power.between(angle(xi - width_of_part / 2), angle(xi + width_of_part / 2)));
    }
    return {Spectrum(std::move(energies)), first + double(first_that_counts(changes)) * between};
}

ChangesSpectrum spectrum_of_force(const Scene& scene, const nmbc::Lattice& lattice,
                                  double time_step) {
    const auto change = [&](const ForceInTime& force, double time, double between) {
        return between * force.at(time) / scene.density * unit_of_time(scene);
    };
    const auto nodes =
        double(nodes_within(scene, scene.force->centre, scene.force->half_width).size());
    return spectrum_of_changes(scene, lattice, time_step, *scene.force, "force", nodes, change);
}

/// A traction t on a surface moves the bar as the force 2 t/dX on one node of a longer bar moves
/// each half of it; a displacement g as the traction rho c g'.
ChangesSpectrum spectrum_of_surface(const Scene& scene, const nmbc::Lattice& lattice,
                                    double time_step, const Boundary& end) {
    const double of_each_half = std::sqrt(0.5);
    const double of_traction = 2 * of_each_half / (scene.density * wave_speed(scene));
    const auto change = [&](const ForceInTime& value, double time, double between) {
        return end.given == nmbc::OnSurface::traction
                   ? of_traction * between * value.at(time)
                   : 2 * of_each_half * (value.at(time + between) - value.at(time));
    };
    return spectrum_of_changes(scene, lattice, time_step, *end.value, "value", 1, change);
}

Spectrum spectrum_of_file(const Scene& scene, const nmbc::Lattice& lattice, double time_step) {
    InitialFields fields =
        initial_fields(scene, lattice, parameters_of(scene, time_step), scene.nodes, 0);
    constexpr std::size_t most = 1 << 22;  // the left part of longer ones has to do
    fields.u.resize(std::min(scene.nodes, most));
    fields.v.resize(std::min(scene.nodes, most));
    const MeanPower of_u(fields.u);
    const MeanPower of_v(fields.v);
    std::vector<double> energies;
    for (std::size_t part = 0; part < spectrum_parts; ++part) {
        const double xi = middle_of(part, spectrum_parts);
        const double low = xi - width_of_part / 2;
        const double high = xi + width_of_part / 2;
        energies.push_back(width_of_part *
                           (std::pow(omega_of(lattice, xi), 2) * of_u.between(low, high) +
                            std::pow(unit_of_time(scene), 2) * of_v.between(low, high)));
    }
    return Spectrum(std::move(energies));
}

/// Of the drive alone, in units dX = c = 1, run until its nodes are let go.
Spectrum spectrum_of_drive(const Scene& scene, const nmbc::Lattice& lattice, double time_step) {
    constexpr double longest = 500;
    const double duration = std::min(scene.drive->duration / unit_of_time(scene), longest);
    const auto driven = nodes_within(scene, scene.drive->centre,
                                     scene.drive->half_width * scene.horizon * scene.spacing);
    Scene alone = scene;
    alone.density = 1;
    alone.youngs_modulus = 1;
    alone.spacing = 1;
    alone.nodes = std::max<std::size_t>(driven.size(), 1);
    alone.drive->duration = duration;
    alone.drive->centre = (double(alone.nodes) + 1) / 2;
    alone.drive->half_width = (double(alone.nodes) - 1) / 2 / scene.horizon;
    alone.initial.reset();
    alone.force.reset();
    alone.incoming.reset();
    alone.preload.reset();
    alone.left = {.kind = BoundaryKind::extended, .layer = std::size_t(duration) + 100};
    alone.right = alone.left;
    alone.end = 2 * duration;
    alone.cfl.reset();
    constexpr double short_step = 0.2;  // of the interior's limit
    alone.step = std::min({std::max(time_step / unit_of_time(scene),
                                    short_step * 2 / nmbc::maximum_frequency(lattice)),
                           duration / 2,
                           nmbc::interior_cfl(lattice) * 1.9 / nmbc::maximum_frequency(lattice)});
    Simulation simulation(alone);
    do {
        simulation.step();
    } while (simulation.is_driven(simulation.chain().time()) && !simulation.is_done());
    const Spectrum at_middles(simulation.chain(), spectrum_parts);
    std::vector<double> energies;
    for (std::size_t part = 0; part < spectrum_parts; ++part) {
        energies.push_back(width_of_part * at_middles.energy() * at_middles.share(part));
    }
    return Spectrum(std::move(energies));
}

}  // namespace

std::vector<SourceSpectrum> source_spectra(const Scene& scene, const nmbc::Lattice& lattice,
                                           double time_step) {
    std::vector<SourceSpectrum> spectra;
    const double dX = scene.spacing;
    const auto last_node = double(scene.nodes) - 1;
    const auto add = [&](const char* name, Spectrum spectrum, double centre, double half_width,
                         double start = 0) {
        spectra.push_back({name, std::move(spectrum),
                           std::clamp((centre - half_width) / dX - 1, 0.0, last_node),
                           std::clamp((centre + half_width) / dX - 1, 0.0, last_node), start});
    };
    const auto squared = [&](double xi) { return std::pow(omega_of(lattice, xi), 2); };
    if (scene.initial && scene.initial->kind == InitialKind::file) {
        spectra.push_back({"initial", spectrum_of_file(scene, lattice, time_step), 0, last_node});
    } else if (scene.initial) {
        const Initial& initial = *scene.initial;
        const double unit = unit_of_time(scene);
        const bool one_way =
            initial.kind == InitialKind::to_the_right || initial.kind == InitialKind::to_the_left;
        const auto weight = [&](double xi) {
            return initial.kind == InitialKind::velocity ? unit * unit
                                                         : (one_way ? 2 : 1) * squared(xi);
        };
        add("initial", spectrum_of(initial.pulse, dX, weight), initial.centre,
            wide * initial.pulse.width);
    }
    if (scene.drive) {
        const Drive& drive = *scene.drive;
        add("drive", spectrum_of_drive(scene, lattice, time_step), drive.centre,
            drive.half_width * scene.horizon * dX);
    }
    if (scene.force) {
        auto [spectrum, start] = spectrum_of_force(scene, lattice, time_step);
        add("force", std::move(spectrum), scene.force->centre, scene.force->half_width, start);
    }
    for (const auto& [name, end, node] : {std::tuple("boundary.left.value", &scene.left, 0.0),
                                          {"boundary.right.value", &scene.right, last_node}}) {
        if (end->value) {
            auto [spectrum, start] = spectrum_of_surface(scene, lattice, time_step, *end);
            spectra.push_back({name, std::move(spectrum), node, node, start});
        }
    }
    if (scene.incoming) {
        const double step = time_step / unit_of_time(scene);
        const auto weight = [&](double xi) {
            const double speed = std::abs(group_velocity(lattice, xi, step));
            return 2 * squared(xi) * std::pow(share_of_incoming(speed), 2);
        };
        const double node = scene.incoming->end == nmbc::End::left ? 0 : last_node;
        spectra.push_back({"incoming", spectrum_of(scene.incoming->pulse, dX, weight), node, node});
    }
    return spectra;
}

Spectrum spectrum_of_sources(const Scene& scene, const nmbc::Lattice& lattice, double time_step) {
    std::vector<double> energies(spectrum_parts);
    for (const SourceSpectrum& source : source_spectra(scene, lattice, time_step)) {
        for (std::size_t part = 0; part < spectrum_parts; ++part) {
            energies[part] += source.spectrum.energy() * source.spectrum.share(part);
        }
    }
    return Spectrum(std::move(energies));
}

}  // namespace nmbcrun
