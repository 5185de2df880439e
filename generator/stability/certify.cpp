// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/certify.hpp"

#include "generator/exact/algebraic_number.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/modal_windows.hpp"
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
    const Grade grade = stability_grade(half_space);
    if (grade != Grade::none) {
        certificate.modal = {{edge, edge}};
        const auto step_with = [&](GhostLevel ghosts, Grade least) {
            const double cfl = largest_cfl(half_space, ghosts, least);
            return cfl > 0 ? std::vector{StableStep{edge.inner, edge.inner, cfl}}
                           : std::vector<StableStep>();
        };
        certificate.max_cfl = step_with(GhostLevel::midpoint, Grade::paired);
        if (!half_space.is_damped()) {
            certificate.max_cfl_explicit = step_with(GhostLevel::old, Grade::paired);
        }
        if (grade == Grade::contractive) {
            certificate.contractive = {{edge, edge}};
            certificate.max_cfl_contractive = step_with(GhostLevel::midpoint, Grade::contractive);
        }
    }
    return certificate;
}

}  // namespace

Certificate certify(const Table& table) {
    if (table.specification.stabilisation) {
        return certify_at(table, *table.specification.stabilisation);
    }
    ModalWindows modal = modal_windows(table);
    if (!table.model.damping.empty()) {
        std::vector<StableStep> steps =
            stable_steps(table, modal.modal, GhostLevel::midpoint, Grade::paired);
        return {.reflection = {},
                .poles = poles(even_and_odd_parts(table)),
                .modal = std::move(modal.modal),
                .contractive = {},
                .max_cfl = std::move(steps),
                .max_cfl_contractive = {},
                .max_cfl_explicit = {}};
    }
    std::vector<StableStep> steps =
        stable_steps(table, modal.modal, GhostLevel::midpoint, Grade::paired);
    std::vector<StableStep> contractive_steps =
        stable_steps(table, modal.contractive, GhostLevel::midpoint, Grade::contractive);
    std::vector<StableStep> explicit_steps =
        stable_steps(table, modal.modal, GhostLevel::old, Grade::paired);
    return {.reflection = scalar_windows(table),
            .poles = poles(even_and_odd_parts(table)),
            .modal = std::move(modal.modal),
            .contractive = std::move(modal.contractive),
            .max_cfl = std::move(steps),
            .max_cfl_contractive = std::move(contractive_steps),
            .max_cfl_explicit = std::move(explicit_steps)};
}

}  // namespace nmbcgen
