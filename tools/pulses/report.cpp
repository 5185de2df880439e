// SPDX-License-Identifier: MIT
#include "tools/pulses/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nmbc/certificate.hpp>
#include <nmbc/lattice.hpp>
#include <optional>

#include "tools/pulses/choice.hpp"
#include "tools/pulses/fraction.hpp"
#include "tools/pulses/pulse.hpp"

namespace pulses {
namespace {

/// A horizon and a G, with what is compared there; nullptr: nothing certified.
struct Case {
    int horizon;
    std::string G_text;
    double G;
    const nmbc::MatchingTable* first;
    const nmbc::MatchingTable* higher;
};

std::vector<Case> cases(const Question& question) {
    std::vector<Case> all;
    for (const int horizon : question.horizons) {
        for (const std::string& text : question.values) {
            const double G = fraction(text).value();
            all.push_back({horizon, text, G, first_order(horizon, G),
                           higher_order(horizon, G, question.matched)});
        }
    }
    return all;
}

std::string name_of(const nmbc::MatchingTable& table) {
    return fmt::format("NMBC{}, s = {}{}", table.order, table.stride,
                       damping_of(table) > 0 ? fmt::format(", tau = {}", table.tau) : "");
}

/// Energies left below this are no more than roundings: 1e-16 of the velocities, of 500 nodes.
std::string energy(double left) {
    return left < 1e-24 ? "< 1e-24" : fmt::format("{:.1e}", left);
}

double time_step(const nmbc::Lattice& lattice, double cfl) {
    return 2 * cfl / nmbc::maximum_frequency(lattice);
}

/// The table for one half-width.
class Comparison {
  public:
    Comparison(double half_width, double most_cfl) : half_width_(half_width), most_cfl_(most_cfl) {}

    void add(const Case& at) {
        rows_ += fmt::format("| {} | {} |", at.horizon, at.G_text);
        const std::optional<double> first = add_first(at);
        const std::optional<double> higher = add_higher(at, first);
        if (first && higher) {
            ++compared_;
            below_ += *higher < *first ? 1 : 0;
        }
        rows_ += "\n";
    }

    std::string text() const {
        return fmt::format(
            "Half-width {:g} dX:\n\n"
            "| n | G | cfl | NMBC1 | order 2 or more | cfl | left | no ends, damped | no ends |\n"
            "|--:|--:|--:|--:|:--|--:|--:|--:|--:|\n{}\n"
            "Order 2 or more is below NMBC1 in {} of {}.\n",
            half_width_, rows_, below_, compared_);
    }

  private:
    double cfl_in(const Case& at, const nmbc::MatchingTable& table) const {
        const double matched = at.higher == nullptr ? 0 : step_of(*at.higher);
        return matched > 0 ? cfl_of(table, at.G, matched)
                           : std::min(most_cfl_, 0.95 * nmbc::certified_cfl(table, at.G));
    }

    std::optional<double> add_first(const Case& at) {
        if (at.first == nullptr || cfl_in(at, *at.first) > nmbc::certified_cfl(*at.first, at.G)) {
            rows_ += "  |  |";
            return std::nullopt;
        }
        const double cfl = cfl_in(at, *at.first);
        const double step = time_step(nmbc::make_lattice(*at.first, at.G), cfl);
        const double left = left_between_ends(*at.first, at.G, step, half_width_);
        rows_ += fmt::format(" {:.2f} | {} |", cfl, energy(left));
        return left;
    }

    /// Bold where it is not below `first`.
    std::optional<double> add_higher(const Case& at, std::optional<double> first) {
        if (at.higher == nullptr) {
            rows_ += "  |  |  |  |  |";
            return std::nullopt;
        }
        nmbc::Lattice lattice = nmbc::make_lattice(*at.higher, at.G);
        const double cfl = cfl_in(at, *at.higher);
        const double step = time_step(lattice, cfl);
        const double left = left_between_ends(*at.higher, at.G, step, half_width_);
        const std::string bold = first && left >= *first ? "**" : "";
        rows_ += fmt::format(" {} | {:.2f} | {}{}{} |", name_of(*at.higher), cfl, bold,
                             energy(left), bold);
        if (lattice.damping.empty()) {
            rows_ += "  |";
        } else {
            rows_ += fmt::format(" {} |", energy(left_in_long_chain(lattice, step, half_width_)));
            lattice.damping.clear();
        }
        rows_ += fmt::format(" {} |", energy(left_in_long_chain(lattice, step, half_width_)));
        return left;
    }

    double half_width_;
    double most_cfl_;
    std::string rows_;
    int compared_ = 0;
    int below_ = 0;
};

std::string losses(const std::vector<Case>& all) {
    std::string text;
    for (const Case& at : all) {
        if (at.higher == nullptr || damping_of(*at.higher) == 0) {
            continue;
        }
        constexpr double wavelength = 20;  // [dX], that of nmbcgen recommend
        const nmbc::Lattice lattice = nmbc::make_lattice(*at.higher, at.G);
        text += fmt::format("| {} | {} | {} | {:.1e} | {:.1e} |\n", at.horizon, at.G_text,
                            at.higher->tau, loss(lattice, wavelength, 1),
                            loss(lattice, wavelength, 100));
    }
    return text.empty() ? ""
                        : "\nEnergy that damping takes from a wave of 20 dX:\n\n"
                          "| n | G | tau | in 1 wavelength | in 100 |\n"
                          "|--:|--:|--:|--:|--:|\n" +
                              text;
}

}  // namespace

std::string report(const Question& question) {
    const std::vector<Case> all = cases(question);
    std::string text;
    for (const double half_width : question.half_widths) {
        Comparison comparison(half_width, question.cfl);
        for (const Case& at : all) {
            comparison.add(at);
        }
        text += (text.empty() ? "" : "\n") + comparison.text();
    }
    return text + losses(all);
}

}  // namespace pulses
