// SPDX-License-Identifier: MIT
#include "generator/stability/modal_windows.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/modal.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

struct GradedSample {
    double G = 0;
    Grade grade = Grade::none;
};

/// Where the grade is asked for: ascending, from 0 on.
std::vector<double> sampled_values(const std::vector<double>& critical) {
    std::vector<double> splits{0};
    splits.insert(splits.end(), critical.begin(), critical.end());
    splits.push_back(2 * std::max(4.0, splits.back()));
    std::vector<double> values{0};
    const int parts = std::clamp(400 / int(splits.size()), 8, 24);
    for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
        for (int part = 0; part < parts; ++part) {
            const double fraction = (part + 0.5) / parts;
            values.push_back(splits[i] + (splits[i + 1] - splits[i]) * fraction);
        }
    }
    constexpr double farthest = 1000;
    for (double factor = 1; factor < farthest; factor *= 2) {
        values.push_back(splits.back() * factor);
    }
    return values;
}

/// Of a damped lattice: it changes smoothly with G, but near poles.
std::vector<double> sampled_values_damped(const std::vector<AlgebraicNumber>& poles) {
    constexpr int per_unit = 16;
    std::vector<double> values;
    for (int i = 0; i <= per_unit * highest_damped_G; ++i) {
        values.push_back(double(i) / per_unit);
    }
    for (const AlgebraicNumber& pole : poles) {
        for (const double distance : {1e-5, 1e-4, 1e-3, 1e-2, 3e-2}) {
            values.push_back(nearest_double(pole) - distance);
            values.push_back(nearest_double(pole) + distance);
        }
    }
    std::erase_if(values, [](double G) { return G < 0 || G > highest_damped_G; });
    std::ranges::sort(values);
    return values;
}

class Search {
  public:
    explicit Search(const Table& table)
        : table_(table),
          parts_(even_and_odd_parts(table)),
          poles_(poles(parts_)),
          jordan_values_(jordan_values(parts_)),
          damped_(!table.model.damping.empty()),
          critical_(damped_ ? std::vector<AlgebraicNumber>()
                            : modal_critical_values(table, parts_)) {
        const std::vector<double> values =
            damped_ ? sampled_values_damped(poles_) : sampled_values(critical());
        samples_.resize(values.size());
        on_all_cores(values.size(), [&](std::size_t i) {
            samples_[i] = {values[i], grade_at(values[i])};
        });
    }

    /// The windows of at least this grade.
    std::vector<StabilityWindow> windows(Grade least) const {
        std::vector<StabilityWindow> found;
        std::optional<Edge> low;
        if (samples_.front().grade >= least) {
            low = Edge{.where = to_algebraic_number(0), .inner = 0};
        }
        for (std::size_t i = 1; i < samples_.size(); ++i) {
            const bool opens = samples_[i].grade >= least;
            if (opens == low.has_value()) {
                continue;
            }
            const Edge edge = edge_between(samples_[i - 1].G, samples_[i].G, least, opens);
            if (opens) {
                low = edge;
            } else {
                found.push_back({*low, low->inner == 0 ? point_or(edge) : edge});
                low.reset();
            }
        }
        if (low && damped_) {
            found.push_back({*low, Edge{.where = to_algebraic_number(Rational(highest_damped_G)),
                                        .inner = highest_damped_G}});
        } else if (low) {
            found.push_back({*low, std::nullopt});
        }
        std::erase_if(found, is_sliver);
        found = without(jordan_values_, Failure::jordan_block,
                        without(poles_, Failure::pole, std::move(found)));
        if (damped_) {
            // Between a pole and a boundary mode near it there is no G that anybody would choose.
            std::erase_if(found, [](const StabilityWindow& window) {
                constexpr double narrowest = 0.05;
                return window.low.inner > 0 && window.high->inner - window.low.inner < narrowest;
            });
        }
        return found;
    }

    std::vector<double> critical() const {
        std::vector<double> values;
        for (const AlgebraicNumber& value : critical_) {
            values.push_back(nearest_double(value));
        }
        return values;
    }

  private:
    /// The upper edge of a window that begins at G = 0: where not even the bracket's width lies
    /// between them, the window is the point 0.
    static Edge point_or(Edge high) {
        if (high.inner < 2 * bracket_width) {
            high.where = to_algebraic_number(0);
            high.inner = 0;
        }
        return high;
    }

    /// At a pole there is no condition: that of the G just above stands for it.
    HalfSpace half_space_at(double G) const {
        constexpr double above = 1 + 1e-9;
        constexpr double least = 1e-9;
        try {
            return make_half_space(table_, Rational(G));
        } catch (const std::domain_error&) {
            return make_half_space(table_, Rational(std::max(G * above, least)));
        }
    }

    Grade grade_at(double G) const { return stability_grade(half_space_at(G)); }

    Edge edge_between(double left, double right, Grade least, bool opens) const {
        while (right - left > bracket_width) {
            const double middle = left + (right - left) / 2;
            ((grade_at(middle) >= least) == opens ? right : left) = middle;
        }
        // Where sup rho leaves 1 with a horizontal tangent it does so a little before it is seen.
        constexpr double unseen = 5e-7;
        const Bracket bracket{opens ? left : left - unseen, opens ? right + unseen : right};
        Edge edge{.where = bracket, .inner = opens ? bracket.high : bracket.low};
        if (const auto exact = exact_edge(left, right, opens)) {
            edge = {.where = *exact, .inner = inner_double(*exact, opens)};
        }
        if (stands_for_failure(edge, opens)) {
            return edge;
        }
        describe(edge, opens ? left : right, opens);
        return edge;
    }

    /// The critical value, of a damped lattice with C(1) = 0, an edge in [low, high] is: one that
    /// is as near as the bracket is wide, or one that makes the window smaller and lies so near
    /// that what is amplified between them cannot be told from 1.
    std::optional<AlgebraicNumber> exact_edge(double low, double high, bool opens) const {
        constexpr double width = 1e-6;
        constexpr double indistinct = 1e-4;
        std::optional<AlgebraicNumber> nearest;
        double distance = HUGE_VAL;
        for (const AlgebraicNumber& value : damped_ ? jordan_values_ : critical_) {
            const double candidate = nearest_double(value);
            const double from = low - (opens ? width : indistinct);
            const double to = high + (opens ? indistinct : width);
            const double apart = std::abs(candidate - (low + high) / 2);
            if (from <= candidate && candidate <= to && apart < distance) {
                nearest = value;
                distance = apart;
            }
        }
        return nearest;
    }

    /// Whether the edge is a pole or a Jordan block, which it then says.
    bool stands_for_failure(Edge& edge, bool opens) const {
        const auto* exact = std::get_if<AlgebraicNumber>(&edge.where);
        const auto holds = [exact](const std::vector<AlgebraicNumber>& values) {
            return std::ranges::any_of(values, [exact](const AlgebraicNumber& value) {
                return compare(value, *exact) == 0;
            });
        };
        if (exact != nullptr && holds(poles_)) {
            edge.beyond = Failure::pole;
        } else if (exact != nullptr && holds(jordan_values_)) {
            edge.beyond = Failure::jordan_block;
        }
        if (edge.beyond != Failure::none) {
            edge.inner = beside(*exact, opens);
        }
        return edge.beyond != Failure::none;
    }

    /// How stability fails outside of the edge. Not quite at it: there the amplified wave is only
    /// just so, and its wave number a matter of roundings.
    void describe(Edge& edge, double outside, bool opens) const {
        constexpr double farther = 1e-4;
        ModalVerdict verdict = verdict_at(std::max(0.0, outside + (opens ? -farther : farther)));
        if (verdict.failure == Failure::none) {
            verdict = verdict_at(outside);
        }
        if (verdict.failure == Failure::none) {
            return;  // it is stable there, of a lower grade
        }
        edge.beyond = failure_of(verdict);
        edge.wave_number = std::round(100 * verdict.wave_number) / 100;
    }

    ModalVerdict verdict_at(double G) const { return modal_verdict(half_space_at(G)); }

    /// The windows, cut in two wherever one of the values lies inside.
    static std::vector<StabilityWindow> without(const std::vector<AlgebraicNumber>& values,
                                                Failure failure,
                                                std::vector<StabilityWindow> windows) {
        for (const AlgebraicNumber& value : values) {
            for (std::size_t i = 0; i < windows.size(); ++i) {
                Edge& begin = windows[i].low;
                if (begin.inner == 0 && compare(value, 0) == 0) {
                    begin.inner = aside;
                    begin.beyond = failure;
                    break;
                }
                const bool inside =
                    windows[i].low.inner < inner_double(value, false) &&
                    (!windows[i].high || inner_double(value, true) < windows[i].high->inner);
                if (inside) {
                    const Edge low{.where = value, .inner = beside(value, true), .beyond = failure};
                    const Edge high{
                        .where = value, .inner = beside(value, false), .beyond = failure};
                    windows.insert(windows.begin() + std::ptrdiff_t(i + 1), {low, windows[i].high});
                    windows[i].high = high;
                    break;
                }
            }
        }
        return windows;
    }

    /// Where two extrema of the band change their order, the band between them, with amplified
    /// waves in it, is for a short while too narrow to be seen. G = 0 is the model without
    /// stabilisation, whatever its neighbours are.
    static bool is_sliver(const StabilityWindow& window) {
        constexpr double narrowest = 5e-3;
        return window.low.inner > 0 && window.high &&
               window.high->inner - window.low.inner < narrowest;
    }

    /// The nearest double not below the value, or not above it.
    static double inner_double(const AlgebraicNumber& value, bool above) {
        const double nearest = nearest_double(value);
        const auto order = compare(value, Rational(nearest));
        const bool outside = above ? order > 0 : order < 0;
        return outside ? std::nextafter(nearest, above ? HUGE_VAL : 0) : nearest;
    }

    /// Above the value, or below it, at a distance: right beside a pole, say, the coefficients of
    /// a table in doubles have lost all digits.
    static double beside(const AlgebraicNumber& value, bool above) {
        return nearest_double(value) * (above ? 1 + aside : 1 - aside);
    }

    static constexpr double bracket_width = 5e-7;
    static constexpr double aside = 1e-9;  ///< from an edge that is open, in parts of it

    const Table& table_;
    EvenAndOddParts parts_;
    std::vector<AlgebraicNumber> poles_;
    std::vector<AlgebraicNumber> jordan_values_;
    bool damped_;
    std::vector<AlgebraicNumber> critical_;
    std::vector<GradedSample> samples_;
};

}  // namespace

ModalWindows modal_windows(const Table& table) {
    if (table.specification.stabilisation) {
        throw std::invalid_argument("modal_windows: the table is for one value of G only");
    }
    const Search search(table);
    ModalWindows found{.modal = {}, .contractive = {}, .critical = search.critical()};
    on_all_cores(2, [&](std::size_t i) {
        (i == 0 ? found.modal : found.contractive) =
            search.windows(i == 0 ? Grade::paired : Grade::contractive);
    });
    return found;
}

}  // namespace nmbcgen
