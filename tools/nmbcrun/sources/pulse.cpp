// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/pulse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

double value_at(const Pulse& pulse, double distance, double spacing) {
    const double s = distance / pulse.width;
    const double envelope = pulse.amplitude * std::exp(-s * s);
    switch (pulse.shape) {
        case Shape::ricker:
            return (1 - 2 * s * s) * envelope;
        case Shape::packet:
            return std::cos(pulse.wave_number * distance / spacing) * envelope;
        case Shape::gaussian:
            break;
    }
    return envelope;
}

Transform transform_of(const Pulse& pulse, double middle, double spacing) {
    const double width = pulse.width / spacing;
    if (width < 0.1 || width > 1e6) {
        throw SceneError(fmt::format(
            "the width of a wave that goes one way must be from a tenth to 1e6 of domain.spacing, "
            "not {:.6g} of it",
            width));
    }
    // exp(-42) = 6e-19 at p = width xi / 2 = 6.5; a ricker's factor of 2 p^2 is gone at 7.
    const double highest = 14 / width;
    const auto gaussian = [width, size = pulse.amplitude * width * std::sqrt(std::numbers::pi)](
                              double xi) { return size * std::exp(-std::pow(xi * width / 2, 2)); };
    const auto placed = [middle](auto real) {
        return [middle, real](double xi) { return std::polar(1.0, -xi * middle) * real(xi); };
    };
    switch (pulse.shape) {
        case Shape::ricker:
            return {placed([gaussian, width](double xi) {
                        return 2 * std::pow(xi * width / 2, 2) * gaussian(xi);
                    }),
                    highest};
        case Shape::packet:
            return {placed([gaussian, k = pulse.wave_number](double xi) {
                        return (gaussian(xi - k) + gaussian(xi + k)) / 2;
                    }),
                    highest + pulse.wave_number};
        case Shape::gaussian:
            break;
    }
    return {placed(gaussian), highest};
}

double extent_of(const Pulse& pulse, double spacing) {
    constexpr double widths = 6.5;  // exp(-42), times the 84 of a ricker
    return widths * pulse.width / spacing;
}

}  // namespace nmbcrun
