// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/predicted_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/stability/half_space.hpp"
#include "generator/stability/reflection.hpp"
#include "tools/nmbcrun/simulation/exact_table.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {
namespace {

/// Whether waves of the band come to an end that is so many nodes away.
bool arrives(const Outgoing& outgoing, const WaveBand& band, std::size_t nodes) {
    return double(nodes) <= band.speed * outgoing.remaining;
}

/// What a band brings to both ends in time.
double arriving(const Outgoing& outgoing, const WaveBand& band) {
    return (arrives(outgoing, band, outgoing.from_left) ? band.to_left : 0) +
           (arrives(outgoing, band, outgoing.from_right) ? band.to_right : 0);
}

/// The amplitudes, where the interior begins, of all that an incident wave of unit amplitude is
/// sent back as.
double sent_back(const nmbcgen::Reflection& reflection, double xi, std::size_t ghosts) {
    const auto& outgoing = reflection.outgoing;
    const auto distance = [&](Eigen::Index column) {
        const std::complex<double> k = outgoing[std::size_t(column)].k;
        return std::abs(std::polar(1.0, xi) - k) * std::abs(std::polar(1.0, -xi) - k);
    };
    Eigen::Index incident = 0;
    for (Eigen::Index column = 1; column < reflection.matrix.cols(); ++column) {
        incident = distance(column) < distance(incident) ? column : incident;
    }
    double sum = 0;
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        const double inside = std::pow(std::abs(outgoing[o].k), double(ghosts));
        sum += std::abs(reflection.amplitudes(Eigen::Index(o), incident)) * inside;
    }
    return sum;
}

}  // namespace

/// Waves of the lattice, which all its boundaries share.
struct ReflectionError::Modes {
    std::optional<nmbcgen::HalfSpace> half_space;
    std::optional<nmbcgen::KnownModes> known;
};

ReflectionError::ReflectionError(const Scene& scene, const Outgoing& outgoing)
    : scene_(scene), outgoing_(outgoing), modes_(std::make_unique<Modes>()) {}

ReflectionError::~ReflectionError() = default;

double ReflectionError::of(const Boundary& boundary, double time_step) {
    const auto half_space =
        make_half_space(exact_table(table_of(scene_, boundary)), nmbcgen::Rational(scene_.G));
    if (!modes_->known) {
        modes_->half_space = half_space;
        modes_->known.emplace(*modes_->half_space);
    }
    const auto in_steps =
        stepped(half_space, time_step,
                boundary.ghosts == nmbc::GhostRule::midpoint ? nmbcgen::GhostLevel::midpoint
                                                             : nmbcgen::GhostLevel::old);
    double error = 0;
    for (const WaveBand& band : outgoing_.bands) {
        const double amplitude = arriving(outgoing_, band);
        if (amplitude > 1e-16 * outgoing_.largest) {
            const auto reflection =
                nmbcgen::reflection(in_steps, band.omega, modes_->known->at(band.omega));
            error += amplitude * sent_back(reflection, band.xi, in_steps.reach());
        }
    }
    return error / outgoing_.largest;
}

double ReflectionError::of_everything() const {
    double error = 0;
    for (const WaveBand& band : outgoing_.bands) {
        error += arriving(outgoing_, band);
    }
    return error / outgoing_.largest;
}

double time_error(const Outgoing& outgoing, std::size_t nodes, double time_step) {
    double error = 0;
    for (const WaveBand& band : outgoing.bands) {
        const double half = std::min(band.omega * time_step / 2, 1.0);
        const double late = std::abs(2 * std::asin(half) / time_step - band.omega);
        const double crossing = double(nodes) / std::max(band.speed, 1e-12);
        const double time = outgoing.duration + std::min(outgoing.remaining, crossing);
        error += (band.to_left + band.to_right) * std::min(2.0, late * time);
    }
    return error / outgoing.largest;
}

}  // namespace nmbcrun
