// SPDX-License-Identifier: MIT
#include "generator/stability/certify.hpp"

#include <limits>
#include <utility>

#include "generator/exact/algebraic_number.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/least_nodes.hpp"
#include "generator/stability/modal_windows.hpp"
#include "generator/stability/own_step.hpp"
#include "generator/stability/scalar.hpp"
#include "generator/stability/stable_steps.hpp"

namespace nmbcgen {
namespace {

Certificate certify_at(const Table& table, const Rational& G) {
    const HalfSpace half_space = make_half_space(table, G);
    const AlgebraicNumber exact = to_algebraic_number(G);
    const Edge edge{.where = exact, .inner = nearest_double(exact)};
    Certificate certificate;
    if (!half_space.is_damped() && scalar_reflection_is_bounded(half_space)) {
        certificate.reflection = {{exact, exact}};
    }
    StepGrades grades(half_space);
    const Grade grade = grades.in(0);
    if (grade != Grade::none) {
        certificate.modal = {{edge, edge}};
        const auto steps_of = [&](Grade least) {
            const auto [from, cfl] = stable_range(grades, least);
            return cfl > from ? std::vector{StableStep{{edge.inner, edge.inner}, cfl, from}}
                              : std::vector<StableStep>();
        };
        certificate.max_cfl = steps_of(Grade::paired);
        if (grade == Grade::contractive) {
            certificate.contractive = {{edge, edge}};
            certificate.max_cfl_contractive = steps_of(Grade::contractive);
        }
    }
    return certificate;
}

Certificate certify_open(const Table& table) {
    Certificate certificate;
    certificate.poles = poles(even_and_odd_parts(table));
    ModalWindows modal = modal_windows(table);
    StableSteps steps(table, modal.critical);
    certificate.max_cfl = steps.over(modal.modal, Grade::paired);
    if (table.model.damping.empty()) {
        certificate.reflection = scalar_windows(table);
        certificate.max_cfl_contractive = steps.over(modal.contractive, Grade::contractive);
    }
    certificate.modal = std::move(modal.modal);
    certificate.contractive = std::move(modal.contractive);
    return certificate;
}

/// Of a table at one G where G is not fixed: the certificate at every G >= 0.
void widen(Certificate& certificate) {
    for (ExactWindow& window : certificate.reflection) {
        window.high.reset();
    }
    for (auto* const windows : {&certificate.modal, &certificate.contractive}) {
        for (StabilityWindow& window : *windows) {
            window.high.reset();
        }
    }
    for (auto* const steps : {&certificate.max_cfl, &certificate.max_cfl_contractive}) {
        for (StableStep& step : *steps) {
            step.window.high = std::numeric_limits<double>::infinity();
        }
    }
}

}  // namespace

Certificate certify(const Table& table) {
    const Specification& what = table.specification;
    const bool same_at_every_G = !has_stabilisation(table.model);
    const bool open = !what.stabilisation && !same_at_every_G;
    Certificate certificate =
        open ? certify_open(table) : certify_at(table, what.stabilisation.value_or(0));
    if (what.time_step != 0) {
        cut_to_own_step(table, certificate);
    }
    if (!what.stabilisation && same_at_every_G) {
        widen(certificate);
    }
    certificate.least_nodes =
        what.damping > 0 ? least_damped_nodes : least_nodes(table, certificate);
    return certificate;
}

}  // namespace nmbcgen
