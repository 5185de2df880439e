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

std::string at_one_G(const Specification& what, const Table& table, const Prover& prover,
                     const Progress& progress) {
    const Rational& G = *what.stabilisation;
    const std::string place =
        has_stabilisation(table.model) ? fmt::format("G = {}", to_string(G)) : "at every G";
    const nmbc::Window about = window_about(G);
    const HalfSpace half_space = make_half_space(derive(what), G);  // or there is none
    std::optional<StepEdges> edges;
    if (own_step(what) == 0) {
        edges.emplace(half_space);
    }
    std::string text = heading(what, table);
    const auto in_one_step = [&](Grade grade) {
        return fmt::format(
            "{} {}; sampled: {}",
            prover.holds_in_step(about, own_step(what), grade) ? "proved" : "not proved",
            in_own_step(what),
            stability_grade(stepped(half_space, own_step(what))) >= grade ? "stable"
                                                                          : "not stable");
    };
    const auto in_all_steps = [&](Grade grade) {
        const double proved = prover.largest_cfl(about, grade);
        const double sampled = edges->range(grade).largest;
        return fmt::format("{}; sampled: {}",
                           proved < 0   ? "nothing proved"
                           : proved > 0 ? fmt::format("proved {}", in_steps(proved))
                                        : "proved in continuous time alone",
                           sampled > 0 ? fmt::format("cfl {:.2f}", sampled)
                                       : "none" + why_none(half_space, grade));
    };
    std::size_t done = 0;
    for (const auto& [name, grade] :
         {std::pair("paired", Grade::paired), std::pair("contractive", Grade::contractive)}) {
        progress(done++, 2);
        text += fmt::format("{:<12} {}: {}\n", name, place,
                            edges ? in_all_steps(grade) : in_one_step(grade));
        text += edges ? edge_line(edges->edge(grade)) : "";
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
    const Prover prover = prover_of(table);
    if (what.stabilisation) {
        return at_one_G(what, table, prover, progress);
    }
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
    const Prover prover = prover_of(derive(open));
    const Rational& G = *what.stabilisation;
    const nmbc::Window about = window_about(G);
    const HalfSpace half_space = make_half_space(derive(what), G);  // or there is none
    std::optional<StepEdges> edges;
    if (own_step(what) == 0) {
        edges.emplace(half_space);
    }
    const auto object_of = [&](Grade grade) -> Json {
        if (!edges) {
            return {{"proved", prover.holds_in_step(about, own_step(what), grade)},
                    {"sampled", stability_grade(stepped(half_space, own_step(what))) >= grade}};
        }
        const double proved = prover.largest_cfl(about, grade);
        return {{"proved_cfl", proved < 0 ? Json() : Json(proved)},
                {"sampled_cfl", edges->range(grade).largest},
                {"edge", edge_object(edges->edge(grade))}};
    };
    Json object = {{"order", what.order},
                   {"horizon", what.horizon},
                   {"stride", what.stride},
                   {"G", to_string(G)},
                   {"time_step", to_string(what.time_step)}};
    progress(0, 2);
    object["paired"] = object_of(Grade::paired);
    progress(1, 2);
    object["contractive"] = object_of(Grade::contractive);
    return object.dump(2) + "\n";
}

}  // namespace nmbcgen
