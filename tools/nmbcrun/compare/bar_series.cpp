// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/bar_series.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "generator/closures/surface_node.hpp"
#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"

namespace nmbcrun {
namespace {

/// Whether u = 0 is given there; nothing where the end is none of the series'.
std::optional<bool> is_odd(const Boundary& end) {
    if ((!is_free(end) && !is_surface(end.kind)) || end.value) {
        return std::nullopt;
    }
    return !is_free(end) && end.given == nmbc::OnSurface::displacement;
}

/// Beyond its outermost node [dX].
double surface_beyond(const Boundary& end) {
    const bool is_on_node = is_surface(end.kind) && nmbc::ends_on_node(closure_of(end.kind));
    return is_on_node ? 0 : 0.5;
}

/// Of the bonds of SNM 2023, relative to the first one's.
std::vector<std::string> bonds(unsigned horizon, bool corrected) {
    std::vector<nmbcgen::Rational> weights = nmbcgen::surface_node(horizon, corrected).quadrature;
    std::vector<std::string> texts;
    for (unsigned k = 1; k <= horizon; ++k) {
        texts.push_back(nmbcgen::to_string(nmbcgen::Rational(weights[k - 1] / (weights[0] * k))));
    }
    return texts;
}

/// v of (1), where the scene's bonds are those of (2).
std::optional<double> speed_of_bar(const Scene& scene) {
    const auto m = unsigned(scene.horizon);
    if (scene.family != "bond1d" || m < 2 || m > nmbcgen::largest_closure_horizon) {
        return std::nullopt;
    }
    if (scene.weights == bonds(m, true)) {
        return wave_speed(scene);
    }
    if (scene.weights == bonds(m, false)) {
        return wave_speed(scene) / std::sqrt(1 - 0.5 / m);
    }
    return std::nullopt;
}

/// omega/v of (1).
double frequency(double k, double delta) {
    constexpr unsigned halvings = 15;
    constexpr double digits = 1e-13;
    const auto inside = [k](double xi) {
        const double sine = std::sin(k * xi / 2);
        return xi > 0 ? 2 * sine * sine / (xi * xi) : k * k / 2;
    };
    return std::sqrt(2 / delta *
                     boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                         inside, 0.0, delta, halvings, digits));
}

}  // namespace

std::optional<BarSeries> BarSeries::of(const Scene& scene) {
    const bool starts_at_rest = scene.initial && scene.initial->kind == InitialKind::displacement;
    const bool is_left_alone =
        !scene.drive && !scene.force && !scene.incoming && !scene.preload && !is_damped(scene);
    const auto speed = speed_of_bar(scene);
    if (!starts_at_rest || !is_left_alone || !speed || !is_odd(scene.left) ||
        !is_odd(scene.right)) {
        return std::nullopt;
    }
    return BarSeries(scene, *speed);
}

BarSeries::BarSeries(const Scene& scene, double speed) : begins_odd_(*is_odd(scene.left)) {
    const double before = surface_beyond(scene.left);
    const double length =
        (double(scene.nodes) - 1 + before + surface_beyond(scene.right)) * scene.spacing;
    const auto start = [&](double x) {  // X = dX is the first node
        const double X = x + (1 - before) * scene.spacing;
        return value_at(scene.initial->pulse, X - scene.initial->centre, scene.spacing);
    };
    for (std::size_t node = 0; node < scene.nodes; ++node) {
        nodes_.push_back((double(node) + before) * scene.spacing);
        size_ += std::pow(start(nodes_.back()), 2);
    }
    size_ = std::sqrt(size_);
    // By the trapezoidal rule, which is as good as exact of a pulse that is gone at the ends.
    const std::size_t points = 16 * scene.nodes;
    std::vector<double> samples;
    for (std::size_t i = 0; i <= points; ++i) {
        const double weight = i == 0 || i == points ? 0.5 : 1;
        samples.push_back(weight * start(length * double(i) / double(points)) / double(points));
    }
    const double delta = scene.horizon * scene.spacing;
    const bool ends_alike = begins_odd_ == *is_odd(scene.right);
    double largest = 0;
    constexpr double negligible = 1e-14;
    constexpr std::size_t in_a_row = 8;  // some vanish by symmetry
    std::size_t small = 0;
    for (std::size_t m = ends_alike && begins_odd_ ? 1 : 0; m < scene.nodes && small < in_a_row;
         ++m) {
        const double k = (double(m) + (ends_alike ? 0 : 0.5)) * std::numbers::pi / length;
        double mean = 0;
        for (std::size_t i = 0; i <= points; ++i) {
            mean += samples[i] * shape(k, length * double(i) / double(points));
        }
        terms_.push_back({k, speed * frequency(k, delta), k > 0 ? 2 * mean : mean});
        const double size = std::abs(terms_.back().amplitude);
        largest = std::max(largest, size);
        small = size <= negligible * largest ? small + 1 : 0;
    }
}

double BarSeries::shape(double wave_number, double x) const {
    return begins_odd_ ? std::sin(wave_number * x) : std::cos(wave_number * x);
}

double BarSeries::error(std::span<const double> u, double time) const {
    double squares = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
        double exact = 0;
        for (const auto& [k, omega, amplitude] : terms_) {
            exact += amplitude * shape(k, nodes_[node]) * std::cos(omega * time);
        }
        squares += std::pow(u[node] - exact, 2);
    }
    return std::sqrt(squares) / size_;
}

}  // namespace nmbcrun
