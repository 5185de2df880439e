// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <utility>

#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_cfl = 0.99;  // of ends that do not limit it
constexpr double smallest_cfl = 0.01;
constexpr double smallest_of_many = 0.05;  // where there are other lattices
/// Of the tolerance: waves that add up to less are not followed.
constexpr double negligible = 1e-3;

/// Whether what a boundary sends back can meet a tolerance in shorter steps yet. Beside what it
/// sends back in continuous time the error is of second order in the steps or higher.
class InShorterSteps {
  public:
    explicit InShorterSteps(double tolerance) : tolerance_(tolerance) {}

    /// error: in steps of this cfl, which is less each time.
    bool may_meet(double cfl, double error) {
        const double square = cfl * cfl;
        const double slope = (last_error_ - error) / (last_square_ - square);
        const double in_time = last_square_ > 0 ? error - slope * square : 0;
        last_square_ = square;
        last_error_ = error;
        return in_time <= tolerance_ && error <= 100 * tolerance_;
    }

  private:
    double tolerance_;
    double last_square_ = 0;
    double last_error_ = 0;
};

}  // namespace

Search::Search(const Scene& scene, double tolerance, Reference reference, const Pause& pause,
               const Scope& scope)
    : scene_(scene),
      tolerance_(tolerance),
      reference_(reference),
      scope_(scope),
      lattice_(lattice_of(scene)),
      omega_max_(nmbc::maximum_frequency(lattice_)),
      unit_(unit_of_time(scene)),
      endless_(scene, pause),
      outgoing_(probing_waves()),
      reflection_error_(scene, outgoing_, negligible * tolerance, pause),
      interior_error_(scene, endless_, outgoing_, reference, pause) {}

std::optional<double> Search::given_cfl() const {
    return scene_.step ? *scene_.step / unit_ * omega_max_ / 2 : scene_.cfl;
}

Outgoing Search::probing_waves() {
    constexpr double probing_cfl = 0.05;
    Outgoing waves = endless_.outgoing(given_cfl().value_or(probing_cfl));
    waves.largest = std::max(waves.largest, largest_after(waves, Mirrors(scene_)));
    if (!(waves.largest > 0)) {
        throw SceneError("nothing moves in this scene, so there is no error to keep small");
    }
    return waves;
}

/// The next of cfl 0.99, 0.99 * 0.95, .. below, near enough to the longest for any use; or the
/// favoured one.
double Search::next_shorter(double cfl) const {
    constexpr double shorter = 0.95;
    const double below = cfl * (1 - 1e-9);
    double next = largest_cfl;
    while (next > below) {
        next *= shorter;
    }
    return scope_.favoured_cfl < below ? std::max(next, scope_.favoured_cfl) : next;
}

double Search::least_interior_error() {
    const double short_steps = given_cfl().value_or(smallest_of_many);
    double least = interior_error_of(short_steps, infinity);
    if (scope_.favoured_cfl > 0) {
        least = std::min(least, interior_error_of(scope_.favoured_cfl, infinity));
    }
    return least;
}

/// Infinite where a source is too short for such steps, but for those that the scene gives.
double Search::interior_error_of(double cfl, double enough) {
    try {
        return interior_error_.at(cfl, enough);
    } catch (const SceneError&) {
        if (given_cfl()) {
            throw;
        }
        return infinity;
    }
}

double Search::interior_error_at(double cfl) {
    if (given_cfl() && reference_ == Reference::lattice) {
        return 0;
    }
    const auto [known, is_new] = interior_errors_.try_emplace(cfl, 0.0);
    if (is_new) {
        known->second = interior_error_of(cfl, tolerance_);
        interior_meets_ = interior_meets_ || known->second * error_margin <= tolerance_;
    }
    return known->second;
}

Candidate Search::candidate(const std::string& name, const Boundary& boundary, double cfl) const {
    return {.name = name,
            .horizon = scene_.horizon,
            .G = scene_.G,
            .boundary = boundary,
            .cfl = cfl,
            .time_step = step_of(cfl) * unit_,
            .steps = steps_until(scene_.end, step_of(cfl) * unit_)};
}

/// Whether it meets the tolerance. boundary_error(): of its ends, asked for where they count.
template <class BoundaryError>
Search::Verdict Search::judge(Candidate& candidate, BoundaryError boundary_error) {
    candidate.interior_error = interior_error_at(candidate.cfl);
    if (candidate.interior_error * error_margin > tolerance_) {  // no end makes up for it
        return {
            false, infinity,
            fmt::format("their own error is above the tolerance at cfl = {:.3g}", candidate.cfl)};
    }
    candidate.boundary_error = boundary_error();
    return {
        candidate.error() * error_margin <= tolerance_, candidate.error(),
        fmt::format("predicted error {:.2g} at cfl = {:.3g}", candidate.error(), candidate.cfl)};
}

/// In the longest of the steps in which it meets the tolerance. limit: in words.
/// error_at(cfl): of the boundary.
template <class ErrorAt>
void Search::add(const std::string& name, const Boundary& boundary, const nmbc::StableStep& steps,
                 const std::string& limit, ErrorAt error_at) {
    const auto given = given_cfl();
    if (given && !steps.allows(*given)) {
        leave_out(name,
                  fmt::format("certified {}up to cfl = {:.3g}, and the scene has {:.3g}",
                              steps.from > 0 ? fmt::format("from cfl = {:.3g} ", steps.from) : "",
                              steps.cfl, *given));
        return;
    }
    const double lowest =
        std::max(given.value_or(reference_ == Reference::lattice ? smallest_cfl : smallest_of_many),
                 steps.from);
    double best = infinity;
    InShorterSteps shorter(tolerance_ / error_margin);
    std::string why_not_longer = given ? "the scene gives them" : limit;
    for (double cfl = given.value_or(steps.cfl); cfl >= lowest; cfl = next_shorter(cfl)) {
        Candidate one = candidate(name, boundary, cfl);
        if (double(one.steps) > scope_.most_steps || one.steps > most_steps(boundary.kind)) {
            break;
        }
        one.why_not_longer = why_not_longer;
        const Verdict verdict = judge(one, [&] { return error_at(cfl); });
        if (verdict.meets) {
            result_.meet.push_back(std::move(one));
            return;
        }
        best = std::min(best, verdict.error);
        why_not_longer = verdict.reason;
        if (given || (verdict.error < infinity && !shorter.may_meet(cfl, one.boundary_error))) {
            break;
        }
    }
    leave_out(name, best < infinity ? fmt::format("predicted error {:.2g}", best)
                                    : "no steps that it may take are within the tolerance");
}

double Search::cfl_of_true_ends() const {
    return surface_limits(scene_, lattice_).least();
}

void Search::add_ends_of_the_lattice() {
    const auto none = [](double) { return 0.0; };
    const double interior = largest_cfl * nmbc::interior_cfl(lattice_);
    const nmbc::StableStep highest{{}, std::min(interior, cfl_of_true_ends())};
    const std::string limit =
        highest.cfl < interior ? "what the true end allows" : "just below the interior's limit";
    if (Mirrors(scene_).count() == 2) {
        add("its own ends, which are physical", scene_.left, highest, limit, none);
        return;
    }
    add("no boundary (fixed)", {.kind = BoundaryKind::fixed}, highest, limit,
        [&](double cfl) { return reflection_error_.of_fixed_ends(step_of(cfl)); });
    add("extended", {.kind = BoundaryKind::extended}, highest, limit, none);
    if (!scene_.incoming && !scene_.preload) {
        add("exact", {.kind = BoundaryKind::exact}, highest, limit, none);
    }
}

void Search::add_table(const nmbc::MatchingTable& table) {
    const Boundary boundary{
        .order = table.order, .stride = table.stride, .matched_step = std::string(table.time_step)};
    const std::string name =
        fmt::format("NMBC{}, stride {}{}", table.order, table.stride,
                    table.time_step == "0" ? std::string()
                                           : fmt::format(", in steps of {} dX/c", table.time_step));
    const nmbc::StableStep steps{
        {},
        largest_certified_cfl(with_artificial_ends(scene_, boundary), lattice_),
        nmbc::certified_steps(table, scene_.G).from};
    if (steps.cfl == 0) {
        leave_out(name, uncertified_file(scene_, table) != nullptr
                            ? "its table was written with --uncertified"
                        : Mirrors(scene_).count() > 0
                            ? "not certified at this G opposite the physical end"
                            : "not certified at this G");
        return;
    }
    if (scene_.nodes < std::size_t(table.least_nodes)) {
        leave_out(name, fmt::format("certified from {} nodes on", table.least_nodes));
        return;
    }
    const double matched = nmbc::detail::nearest_to_fraction(table.time_step);
    const double own_cfl = matched * omega_max_ / 2;
    if (matched > 0 && (given_cfl() || !steps.allows(own_cfl))) {
        leave_out(name, given_cfl() ? "its step is not the scene's" : "its step is not certified");
        return;
    }
    const auto error_at = [&](double cfl) { return reflection_error_.of(boundary, step_of(cfl)); };
    if (matched == 0) {
        add(name, boundary, steps, "none are certified", error_at);
        return;
    }
    Candidate one = candidate(name, boundary, own_cfl);
    one.why_not_longer = "it is matched in these";
    const Verdict verdict = judge(one, [&] { return error_at(own_cfl); });
    if (verdict.meets) {
        result_.meet.push_back(std::move(one));
    } else {
        leave_out(name, verdict.error < infinity
                            ? fmt::format("predicted error {:.2g} in its step", verdict.error)
                            : "the error of its step alone is above the tolerance");
    }
}

void Search::add_passive() {
    if (const std::string why_not = why_not_designed(scene_); !why_not.empty()) {
        leave_out("passive", why_not);
        return;
    }
    const double longest =
        std::max(std::min(DesignedEnd::largest_cfl, cfl_of_true_ends()), given_cfl().value_or(0));
    add("passive", {.kind = BoundaryKind::passive}, {{}, longest},
        "what passive ends are designed for", [&](double cfl) {
            try {
                return reflection_error_.of({.kind = BoundaryKind::passive}, step_of(cfl));
            } catch (const SceneError&) {  // no design for these steps
                return infinity;
            }
        });
}

void Search::leave_out(const std::string& name, const std::string& reason) {
    result_.left_out.push_back({name, reason});
}

Candidates Search::all() {
    add_ends_of_the_lattice();
    if (Mirrors(scene_).count() == 2) {
        return std::move(result_);
    }
    add_passive();
    for (const nmbc::MatchingTable* table : tables_of(scene_)) {
        add_table(*table);
    }
    return std::move(result_);
}

}  // namespace nmbcrun
