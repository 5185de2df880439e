// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/formula.hpp"
#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rounded_text.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/step_edges.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* name_of(Undecided undecided) {
    return undecided == Undecided::modes ? "modes" : "waves";
}

bool is_all(const ProvedSteps& proved, const StepRange& sampled) {
    return proved.cfl >= sampled.largest;
}

std::string of_steps(const ProvedSteps& proved, const StepRange& sampled) {
    const std::string undecided = proved.beyond == Undecided::modes
                                      ? "undecided whether a boundary mode grows"
                                      : "undecided whether waves are amplified";
    const bool is_left = sampled.largest > 0 && !is_all(proved, sampled);
    if (proved.cfl < 0) {
        return "nothing proved" + (is_left ? ": " + undecided : "");
    }
    const std::string open = is_left ? ", then " + undecided : "";
    if (sampled.from > 0) {
        return fmt::format("proved in every step from cfl {:g} to {:g}{}", sampled.from, proved.cfl,
                           open);
    }
    return (proved.cfl > 0 ? fmt::format("proved in every step up to cfl {:g}", proved.cfl)
                           : "proved in continuous time alone") +
           open;
}

/// So many grades done, and the next one up to a cfl.
void tell(const Progress& progress, std::size_t done, double cfl, std::size_t all) {
    constexpr std::size_t parts = 100;
    progress(parts * done + std::size_t(double(parts) * cfl), parts * all);
}

std::string half_step_squared(const AlgebraicNumber& square) {
    constexpr std::size_t longest = 8;
    const std::size_t degree = square.polynomial.degree();
    return degree <= longest ? value(square, "x", Notation::text)
                             : fmt::format("= {:.15g}, a root of a polynomial of degree {}",
                                           nearest_double(square), degree);
}

constexpr double edges_sampled_to = 1e-9;

bool is_of_lattice(const StepEdge& edge) {
    return edge.cfl > 1 - edges_sampled_to;
}

/// Where the steps of a grade end, a line of its own; nothing where there are none.
std::string edge_line(const std::optional<StepEdge>& edge) {
    if (!edge) {
        return "";
    }
    if (is_of_lattice(*edge)) {
        return fmt::format("{:<12} edge: cfl 1, the lattice's own\n", "");
    }
    const auto* critical = std::get_if<AlgebraicNumber>(&edge->where);
    const std::string where =
        critical != nullptr
            ? fmt::format("{:.9g}, critical: (dt/2)^2 {}", edge->cfl, half_step_squared(*critical))
            : fmt::format("{}, sampled to {:g}", rounded_down(edge->cfl, 9), edges_sampled_to);
    const std::string why =
        edge->beyond == Failure::none ? "" : fmt::format("; beyond it: {}", name_of(edge->beyond));
    return fmt::format("{:<12} edge: cfl {}{}\n", "", where, why);
}

Json edge_object(const std::optional<StepEdge>& edge) {
    if (!edge) {
        return nullptr;
    }
    if (is_of_lattice(*edge)) {
        return {{"kind", "lattice"}, {"cfl", 1.0}};
    }
    const Json beyond = edge->beyond == Failure::none ? Json() : Json(name_of(edge->beyond));
    if (const auto* critical = std::get_if<AlgebraicNumber>(&edge->where)) {
        return {{"kind", "critical"},
                {"cfl", edge->cfl},
                {"half_step_squared", number_object(*critical)},
                {"beyond", beyond}};
    }
    const auto [low, high] = std::get<CflBracket>(edge->where);
    return {{"kind", "sampled"}, {"cfl", low}, {"bracket", {low, high}}, {"beyond", beyond}};
}

/// In continuous time, where no steps have a grade.
std::string why_none(const HalfSpace& half_space, Grade grade) {
    const ModalVerdict verdict = modal_verdict(half_space);
    if (verdict.failure != Failure::none) {
        return fmt::format(": {}", name_of(failure_of(verdict)));
    }
    return grade == Grade::contractive && !verdict.contractive
               ? ": waves of one frequency can come back larger"
               : "";
}

/// What is proved, and what is sampled, at one G: in the condition's own step, or in steps up to a
/// largest one.
class AtOneG {
  public:
    AtOneG(const Specification& what, const Table& table)
        : prover_(prover_of(table)),
          about_(window_about(*what.stabilisation)),
          half_space_(make_half_space(derive(what), *what.stabilisation)),  // or there is none
          own_step_(own_step(what)) {
        if (own_step_ == 0) {
            edges_.emplace(half_space_);
        }
    }

    bool is_stepped() const { return own_step_ > 0; }
    bool holds(Grade grade) const { return prover_.holds_in_step(about_, own_step_, grade); }
    bool is_sampled(Grade grade) const {
        return stability_grade(stepped(half_space_, own_step_)) >= grade;
    }

    /// From the same step on as those that are sampled.
    ProvedSteps proved_steps(Grade grade, const std::function<void(double)>& told) {
        const StepRange sampled = edges_->range(grade);
        ProvedSteps proved = prover_.proved_steps(about_, grade, sampled.from, told);
        if (half_space_.is_damped()) {  // in longer ones round trips of chains grow
            proved.cfl = sampled.largest > 0 ? std::min(proved.cfl, sampled.largest) : -1;
        }
        return proved;
    }
    StepRange sampled_steps(Grade grade) { return edges_->range(grade); }
    std::optional<StepEdge> edge(Grade grade) { return edges_->edge(grade); }
    const HalfSpace& half_space() const { return half_space_; }

  private:
    Prover prover_;
    nmbc::Window about_;
    HalfSpace half_space_;
    double own_step_;
    std::optional<StepEdges> edges_;
};

/// The grades that are sought, each with its name.
std::vector<std::pair<const char*, Grade>> grades_of(const Specification& what) {
    std::vector<std::pair<const char*, Grade>> found{{"paired", Grade::paired}};
    if (what.damping == 0) {
        found.emplace_back("contractive", Grade::contractive);
    }
    return found;
}

}  // namespace

Table with_open_G(const Specification& what) {
    Specification open = what;
    open.stabilisation.reset();
    return derive(open);
}

Prover prover_of(const Table& table) {
    try {
        return Prover(table);
    } catch (const std::invalid_argument&) {
        throw NotProvable(
            "there are proofs for conditions only whose even and odd parts have no leading "
            "coefficient 0 at every G");
    }
}

std::string proof_heading(const Specification& what, const Table& table) {
    const std::string at_G = what.stabilisation && has_stabilisation(table.model)
                                 ? ", G = " + to_string(*what.stabilisation)
                                 : "";
    const std::string damped = what.damping > 0 ? ", tau = " + to_string(what.damping) : "";
    return fmt::format("NMBC{}, stride {}, at horizon {}{}{}\n{:<12} {}\n", what.order, what.stride,
                       what.horizon, at_G, damped, "lattice", table.model.description);
}

double own_step(const Specification& what) {
    return nearest_double(what.time_step);
}

std::string in_own_step(const Specification& what) {
    return fmt::format("in its step of {} dX/c", to_string(what.time_step));
}

std::string proof_at_G(const Specification& what, const Progress& progress) {
    const Table table = with_open_G(what);
    const std::string place = has_stabilisation(table.model)
                                  ? fmt::format("G = {}", to_string(*what.stabilisation))
                                  : "at every G";
    AtOneG at(what, table);
    std::string text = proof_heading(what, table);
    const auto grades = grades_of(what);
    std::size_t done = 0;
    const auto told = [&](double cfl) { tell(progress, done, cfl, grades.size()); };
    const auto in_one_step = [&](Grade grade) {
        return fmt::format("{} {}; sampled: {}", at.holds(grade) ? "proved" : "not proved",
                           in_own_step(what), at.is_sampled(grade) ? "stable" : "not stable");
    };
    const auto in_all_steps = [&](Grade grade) {
        const StepRange sampled = at.sampled_steps(grade);
        const ProvedSteps proved = at.proved_steps(grade, told);
        return fmt::format("{}; sampled: {}", of_steps(proved, sampled),
                           sampled.largest > 0 ? fmt::format("cfl {:.2f}", sampled.largest)
                                               : "none" + why_none(at.half_space(), grade));
    };
    for (const auto& [name, grade] : grades) {
        text += fmt::format("{:<12} {}: {}\n", name, place,
                            at.is_stepped() ? in_one_step(grade) : in_all_steps(grade));
        text += at.is_stepped() ? "" : edge_line(at.edge(grade));
        ++done;
    }
    return text;
}

std::string proof_at_G_json(const Specification& what, const Progress& progress) {
    AtOneG at(what, with_open_G(what));
    const auto grades = grades_of(what);
    std::size_t done = 0;
    const auto told = [&](double cfl) { tell(progress, done, cfl, grades.size()); };
    const auto object_of = [&](Grade grade) -> Json {
        if (at.is_stepped()) {
            return {{"proved", at.holds(grade)}, {"sampled", at.is_sampled(grade)}};
        }
        const StepRange sampled = at.sampled_steps(grade);
        const ProvedSteps proved = at.proved_steps(grade, told);
        return {{"from", sampled.from},
                {"proved_cfl", proved.cfl < 0 ? Json() : Json(proved.cfl)},
                {"undecided", is_all(proved, sampled) ? Json() : Json(name_of(proved.beyond))},
                {"sampled_cfl", sampled.largest},
                {"edge", edge_object(at.edge(grade))}};
    };
    Json object = {{"order", what.order},
                   {"horizon", what.horizon},
                   {"stride", what.stride},
                   {"G", to_string(*what.stabilisation)},
                   {"time_step", to_string(what.time_step)}};
    for (const auto& [name, grade] : grades) {
        object[name] = object_of(grade);
        ++done;
    }
    return object.dump(2) + "\n";
}

}  // namespace nmbcgen
