// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/scalar.hpp"
#include "generator/support/on_all_cores.hpp"

namespace stability_atlas {

using nmbcgen::Failure;
using nmbcgen::Grade;
using nmbcgen::HalfSpace;
using nmbcgen::Rational;
using nmbcgen::Specification;
using nmbcgen::Table;

namespace {

constexpr double highest_G = 6;
constexpr unsigned highest_order = 4;

std::vector<Specification> specifications(const std::vector<unsigned>& horizons) {
    std::vector<Specification> result;
    for (const unsigned horizon : horizons) {
        for (unsigned order = 1; order <= highest_order; ++order) {
            for (const unsigned stride : std::set{1U, horizon}) {
                result.push_back({"nopd1d", horizon, order, stride, std::nullopt});
            }
        }
    }
    return result;
}

void predict(const HalfSpace& half_space, Point& point) {
    if (half_space.E.size() == 0 || half_space.E[0] == 0) {  // C(1)
        point.failure = Failure::jordan_block;
        return;
    }
    const nmbcgen::ModalVerdict verdict = modal_verdict(half_space);
    point.failure = failure_of(verdict);
    point.growing_mode_rate = verdict.growth.real();
    if (verdict.failure == Failure::none || verdict.failure == Failure::amplified_wave) {
        point.supremum = verdict.supremum;
    }
    if (verdict.failure == Failure::none) {
        point.grade = stability_grade(half_space);
    }
}

bool contains(const nmbcgen::ExactWindow& window, double G) {
    const Rational value(G);
    return compare(window.low, value) <= 0 && (!window.high || compare(*window.high, value) >= 0);
}

bool contains(const nmbcgen::StabilityWindow& window, double G) {
    return window.low.inner <= G && (!window.high || G <= window.high->inner);
}

template <class Windows>
bool any_contains(const Windows& windows, double G) {
    return std::ranges::any_of(windows, [G](const auto& window) { return contains(window, G); });
}

Point point_at(const Table& table, const Method& method, double G) {
    Point point;
    point.G = G;
    point.in_scalar_window = any_contains(method.scalar, G);
    point.in_modal_window = any_contains(method.windows.modal, G);
    try {
        const HalfSpace half_space = make_half_space(table, Rational(G));
        predict(half_space, point);
        if (point.failure != Failure::jordan_block) {
            point.measured_growth = growth(half_space);
        }
    } catch (const std::domain_error&) {
        point.failure = Failure::pole;
    }
    return point;
}

}  // namespace

double growth(const HalfSpace& half_space) {
    constexpr double cfl = 0.05;
    constexpr double least = 1e-7;
    const double time_step = 2 * cfl / maximum_frequency(half_space);
    const nmbcgen::LatticeEnd end{.half_space = half_space};
    double rate = 0;
    for (const std::size_t nodes : {40U, 61U}) {
        const double radius = spectral_radius(end, end, nodes, time_step);
        rate = std::max(rate, std::log(radius) / time_step);
    }
    return rate < least ? 0 : rate;
}

std::size_t total_points(const std::vector<unsigned>& horizons, unsigned points) {
    return specifications(horizons).size() * points;
}

std::vector<Method> atlas(const std::vector<unsigned>& horizons, unsigned points,
                          const std::function<void(std::size_t)>& done) {
    std::vector<Table> tables;
    for (const Specification& specification : specifications(horizons)) {
        tables.push_back(nmbcgen::derive(specification));
    }
    std::vector<Method> methods(tables.size());
    std::mutex counting;
    std::size_t finished = 0;
    nmbcgen::on_all_cores(tables.size(), [&](std::size_t i) {
        const std::size_t index = tables.size() - 1 - i;  // the last ones take longest
        const Table& table = tables[index];
        Method& method = methods[index];
        method = {table.specification, scalar_windows(table), modal_windows(table), {}};
        for (unsigned step = 0; step < points; ++step) {
            method.points.push_back(point_at(table, method, highest_G * step / (points - 1)));
            const std::lock_guard lock(counting);
            done(++finished);
        }
    });
    return methods;
}

}  // namespace stability_atlas
