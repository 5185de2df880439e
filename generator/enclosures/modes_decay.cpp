// SPDX-License-Identifier: MIT
#include "generator/enclosures/modes_decay.hpp"

#include <algorithm>
#include <complex>

#include "generator/enclosures/band_grade.hpp"
#include "generator/enclosures/by_halves.hpp"
#include "generator/enclosures/root_discs.hpp"
#include "generator/enclosures/weighted_sum.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Disc = RootDisc;

/// Im f(x) / Im x, also where x is real.
Interval slope_across(const EnclosedPolynomial& f, const ComplexInterval& x) {
    // Im x^k / Im x = 2 Re x times that of k-1, less |x|^2 times that of k-2
    const Interval twice = 2.0 * x.re;
    const Interval square_of_modulus = square(x.re) + square(x.im);
    Interval before = 0;
    Interval now = 1;
    Interval sum = 0;
    for (std::size_t k = 1; k < f.size(); ++k) {
        sum += f[k] * now;
        const Interval next = twice * now - square_of_modulus * before;
        before = now;
        now = next;
    }
    return sum;
}

Interval slope_across(const Expansion& f, const ComplexInterval& x) {
    return f.of([&](const EnclosedPolynomial& part) { return slope_across(part, x); });
}

/// The modes in w, where k = -1 is infinitely far away, or in v.
class Chart {
  public:
    enum class Variable { w, v };

    Chart(Variable variable, const EnclosedCondition& condition, const Interval& tau)
        : variable_(variable),
          condition_(condition),
          E_(polynomials().E),
          O_(polynomials().O),
          modes_({{polynomials().modes, 1}, {polynomials().modes_in_steps, tau}}) {}

    bool all_decay() const {
        const std::vector<Disc> discs = root_discs(
            modes_.enclosed(), [this](const ComplexInterval& z) { return modes_.at(z); });
        if (discs.empty()) {
            const EnclosedPolynomial& f = modes_.enclosed();
            return f.size() == 1 && !zero_in(f[0]);
        }
        return std::ranges::all_of(discs, [&](const Disc& disc) {
            const auto together = std::ranges::count(discs, disc.component, &Disc::component);
            if (together == 1 && disc.centre.imag() == 0) {
                return real_root_decays(disc);
            }
            return std::isfinite(disc.radius) && decay(disc);
        });
    }

  private:
    const ModePolynomials<Expansion>& polynomials() const {
        return variable_ == Variable::w ? condition_.in_w : condition_.in_v;
    }

    bool decay(const Disc& disc) const {
        if (decay_next_to_0(least_x(disc))) {
            return true;
        }
        const Disc in_x =
            variable_ == Variable::w
                ? inverse(enclose(Complex(1)) - enclose(disc.centre), disc.radius, 2, -1)
                : inverse(enclose(disc.centre), disc.radius, 1, 3);
        return decay(box_about(disc)) ||
               (std::isfinite(in_x.radius) && decay_in_x(box_about(in_x)));
    }

    /// |x| is no less there.
    Interval least_x(const Disc& disc) const {
        const ComplexInterval centre = enclose(disc.centre);
        return variable_ == Variable::w
                   ? 2.0 / (modulus(enclose(Complex(1)) - centre) + disc.radius) - 1.0
                   : 1.0 / (modulus(centre) + disc.radius) - 3.0;
    }

    /// factor/z + shift of all z within the radius of a centre.
    static Disc inverse(const ComplexInterval& centre, double radius, double factor, double shift) {
        const Interval power = square(centre.re) + square(centre.im) - square(Interval(radius));
        if (!(power.lower() > 0)) {
            return {0, HUGE_VAL};
        }
        const ComplexInterval image{factor * centre.re / power + shift,
                                    -factor * centre.im / power};
        const Complex middle{median(image.re), median(image.im)};
        return {middle, (factor * radius / power + modulus(image - enclose(middle))).upper()};
    }

    /// Whether Re sigma < 0 for all of these, were they modes.
    bool decay(const ComplexInterval& z) const {
        return is_positive(O_, E_, z, variable_ == Variable::w ? reach_in_w(z) : reach_in_v(z));
    }

    bool decay_in_x(const ComplexInterval& x) const {
        const ComplexInterval square_of_x = x * x;
        const Interval reach = (modulus({square_of_x.re - 1.0, square_of_x.im}) + 1.0 -
                                (square(x.re) + square(x.im))) /
                               2.0;
        return is_positive(condition_.O, condition_.E, x, reach);
    }

    /// Re O conj(E) - reach Im(O conj(E)) / Im z > 0
    static bool is_positive(const Expansion& O_of, const Expansion& E_of, const ComplexInterval& z,
                            const Interval& reach) {
        const ComplexInterval O = O_of.at(z);
        const ComplexInterval E = E_of.at(z);
        const Interval across = slope_across(O_of, z) * E.re - O.re * slope_across(E_of, z);
        return (O.re * E.re + O.im * E.im - reach * across).lower() > 0;
    }

    static Interval reach_in_w(const ComplexInterval& w) { return modulus(w) - w.re; }

    static Interval reach_in_v(const ComplexInterval& v) {
        const ComplexInterval vx{3.0 * v.re + 1.0, 3.0 * v.im};
        const auto square_of_modulus = [](const ComplexInterval& number) {
            return square(number.re) + square(number.im);
        };
        return (square_of_modulus(vx) - square_of_modulus(v) - modulus(vx * vx - v * v)) / 2.0;
    }

    /// Whether they do at all |x| from this on: |k| <= 1/(2|x| - 1) there, since k + 1/k = 2x.
    bool decay_next_to_0(const Interval& x) const {
        const Interval inverse = 2.0 * x.lower() - Interval(1);
        return inverse.lower() > 1 &&
               rate_is_below_0(condition_.C.enclosed(), condition_.B.enclosed(), condition_.stride,
                               1.0 / inverse);
    }

    /// Of a real root, which is alone in its disc: it decays, or travels.
    bool real_root_decays(const Disc& disc) const {
        const Interval z = disc.centre.real() + Interval(-disc.radius, disc.radius);
        // those that travel
        const double lowest = variable_ == Variable::w ? -HUGE_VAL : -0.5;
        const double highest = variable_ == Variable::w ? 0 : -0.25;
        const bool above = z.upper() <= highest ||
                           decay(ComplexInterval{{std::max(highest, z.lower()), z.upper()}, 0});
        const bool below = z.lower() >= lowest ||
                           decay(ComplexInterval{{z.lower(), std::min(lowest, z.upper())}, 0});
        return above && below;
    }

    Variable variable_;
    const EnclosedCondition& condition_;
    const Expansion& E_;
    const Expansion& O_;
    WeightedSum modes_;
};

}  // namespace

bool no_mode_grows(const EnclosedCondition& condition, const Interval& tau) {
    return holds_by_halves(tau, spread_of(condition.band), [&](const Interval& part) {
        return Chart(Chart::Variable::w, condition, part).all_decay() ||
               Chart(Chart::Variable::v, condition, part).all_decay();
    });
}

}  // namespace nmbcgen
