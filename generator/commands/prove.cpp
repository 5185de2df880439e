// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <tuple>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/formula.hpp"
#include "generator/enclosures/prove.hpp"
#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rounded_text.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/step_edges.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double farthest = 8;  ///< from the low end of a window that has no high one

std::string in_steps(double cfl) {
    return cfl > 0 ? fmt::format("in every step up to cfl {:g}", cfl) : "in continuous time";
}

/// Of a condition that is matched in it.
std::string in_own_step(const Specification& what) {
    return fmt::format("in its step of {} dX/c", to_string(what.time_step));
}

double own_step(const Specification& what) {
    return nearest_double(what.time_step);
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
        rounded_down(edge->cfl, 9) + (critical != nullptr
                                          ? ", critical: (dt/2)^2 " + half_step_squared(*critical)
                                          : fmt::format(", sampled to {:g}", edges_sampled_to));
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

std::string heading(const Specification& what, const Table& table) {
    return fmt::format("NMBC{}, stride {}, at horizon {}{}\n{:<12} {}\n", what.order, what.stride,
                       what.horizon,
                       what.stabilisation && has_stabilisation(table.model)
                           ? ", G = " + to_string(*what.stabilisation)
                           : "",
                       "lattice", table.model.description);
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

Prover prover_of(const Table& table) {
    try {
        return Prover(table);
    } catch (const std::invalid_argument&) {
        throw NotProvable(
            "there are proofs for undamped lattices only, and for conditions whose "
            "even and odd parts have no leading coefficient 0 at every G");
    }
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

    /// Below 0: of no step.
    double proved_cfl(Grade grade) const { return prover_.largest_cfl(about_, grade); }
    double sampled_cfl(Grade grade) { return edges_->range(grade).largest; }
    std::optional<StepEdge> edge(Grade grade) { return edges_->edge(grade); }
    const HalfSpace& half_space() const { return half_space_; }

  private:
    Prover prover_;
    nmbc::Window about_;
    HalfSpace half_space_;
    double own_step_;
    std::optional<StepEdges> edges_;
};

std::string at_one_G(const Specification& what, const Table& table, const Progress& progress) {
    const std::string place = has_stabilisation(table.model)
                                  ? fmt::format("G = {}", to_string(*what.stabilisation))
                                  : "at every G";
    AtOneG at(what, table);
    std::string text = heading(what, table);
    const auto in_one_step = [&](Grade grade) {
        return fmt::format("{} {}; sampled: {}", at.holds(grade) ? "proved" : "not proved",
                           in_own_step(what), at.is_sampled(grade) ? "stable" : "not stable");
    };
    const auto in_all_steps = [&](Grade grade) {
        const double proved = at.proved_cfl(grade);
        const double sampled = at.sampled_cfl(grade);
        return fmt::format("{}; sampled: {}",
                           proved < 0   ? "nothing proved"
                           : proved > 0 ? fmt::format("proved {}", in_steps(proved))
                                        : "proved in continuous time alone",
                           sampled > 0 ? fmt::format("cfl {:.2f}", sampled)
                                       : "none" + why_none(at.half_space(), grade));
    };
    std::size_t done = 0;
    for (const auto& [name, grade] :
         {std::pair("paired", Grade::paired), std::pair("contractive", Grade::contractive)}) {
        progress(done++, 2);
        text += fmt::format("{:<12} {}: {}\n", name, place,
                            at.is_stepped() ? in_one_step(grade) : in_all_steps(grade));
        text += at.is_stepped() ? "" : edge_line(at.edge(grade));
    }
    return text;
}

std::string of_window(const StabilityWindow& window, const char* grade_name,
                      const std::function<bool(const nmbc::Window&)>& holds, const ProofTask& task,
                      const Progress& progress) {
    const double low = window.low.inner;
    const double high = window.high ? window.high->inner : low + farthest;
    const double finest = task.finest.value_or((high - low) / 1000);
    const auto told = [&](double G) {
        constexpr double in_all = 1000;
        progress(std::size_t(in_all * (G - low) / std::max(high - low, finest)),
                 std::size_t(in_all));
    };
    const auto parts = parts_where(holds, {low, high}, finest, told);
    double proved = 0;
    std::string text = fmt::format(
        "{:<12} {:.6f} .. {}\n", grade_name, low,
        window.high ? fmt::format("{:.6f}", high) : fmt::format("(looked at up to {:g})", high));
    for (const nmbc::Window& part : parts) {
        proved += part.high - part.low;
        text += fmt::format("  proved     {:.6f} .. {:.6f}\n", std::ceil(part.low * 1e6) / 1e6,
                            std::floor(part.high * 1e6) / 1e6);  // not more than is proved
    }
    return text + fmt::format("  undecided  {:.6f} in all\n", high - low - proved);
}

}  // namespace

std::string proof_text(const Specification& what, const ProofTask& task, const Progress& progress) {
    Specification open = what;
    open.stabilisation.reset();
    const Table table = derive(open);
    if (what.stabilisation) {
        return at_one_G(what, table, progress);
    }
    const Prover prover = prover_of(table);
    if (!has_stabilisation(table.model)) {
        throw NotProvable("no G in this model: prove it at --G 0");
    }
    const Certificate certificate = certify(table);
    const bool is_stepped = own_step(what) > 0;
    std::string text =
        heading(what, table) + (is_stepped ? in_own_step(what) : in_steps(task.cfl)) + "\n";
    for (const auto& [name, grade, windows] :
         {std::tuple("paired", Grade::paired, &certificate.modal),
          std::tuple("contractive", Grade::contractive, &certificate.contractive)}) {
        const auto holds = [&, least = grade](const nmbc::Window& piece) {
            return is_stepped ? prover.holds_in_step(piece, own_step(what), least)
                              : prover.holds(piece, task.cfl, least);
        };
        for (const StabilityWindow& window : *windows) {
            text += of_window(window, name, holds, task, progress);
        }
    }
    return text;
}

std::string proof_json(const Specification& what, const Progress& progress) {
    Specification open = what;
    open.stabilisation.reset();
    AtOneG at(what, derive(open));
    const auto object_of = [&](Grade grade) -> Json {
        if (at.is_stepped()) {
            return {{"proved", at.holds(grade)}, {"sampled", at.is_sampled(grade)}};
        }
        const double proved = at.proved_cfl(grade);
        return {{"proved_cfl", proved < 0 ? Json() : Json(proved)},
                {"sampled_cfl", at.sampled_cfl(grade)},
                {"edge", edge_object(at.edge(grade))}};
    };
    Json object = {{"order", what.order},
                   {"horizon", what.horizon},
                   {"stride", what.stride},
                   {"G", to_string(*what.stabilisation)},
                   {"time_step", to_string(what.time_step)}};
    progress(0, 2);
    object["paired"] = object_of(Grade::paired);
    progress(1, 2);
    object["contractive"] = object_of(Grade::contractive);
    return object.dump(2) + "\n";
}

}  // namespace nmbcgen
