// SPDX-License-Identifier: MIT
#include "generator/coupling/equilibrium.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <stdexcept>

#include "generator/coupling/assembly.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Elements of this length that a horizon touches.
std::size_t elements_within(const Rational& horizon, const Rational& length) {
    return (-floor(-horizon / length)).convert_to<std::size_t>();
}

/// A unit bar from 0 to 1 with its layers; media change at 1/2.
Mesh unit_bar(const Medium& left, const Medium& right) {
    const Rational h(1, unit_bar_elements);
    const std::size_t half =
        unit_bar_elements / 2 + elements_within(std::max(left.horizon, right.horizon), h);
    Mesh mesh = mesh_of({h, h, left, right}, half, half);
    for (Rational& node : mesh.nodes) {
        node += Rational(1, 2);
    }
    return mesh;
}

std::vector<bool> held_outside(const Mesh& mesh, const Rational& from, const Rational& to) {
    std::vector<bool> held;
    for (const Rational& node : mesh.nodes) {
        held.push_back(node <= from || node >= to);
    }
    return held;
}

/// The force of u = x on a node.
LogNumber force_of_patch(const Mesh& mesh, CouplingForm form, std::size_t node) {
    LogNumber force;
    const auto rows = exact_rows(mesh, form, node, node);
    for (const auto& [other, stiffness] : rows.front()) {
        force += mesh.nodes[other] * stiffness;
    }
    return force;
}

VectorXd places(const Mesh& mesh) {
    VectorXd x(Index(mesh.nodes.size()));
    for (Index i = 0; i < x.size(); ++i) {
        x[i] = nearest_double(mesh.nodes[std::size_t(i)]);
    }
    return x;
}

}  // namespace

VectorXd equilibrium(const Mesh& mesh, CouplingForm form, const std::vector<bool>& is_held,
                     VectorXd u, const VectorXd& loads) {
    std::vector<int> place(is_held.size(), -1);  // among the free nodes
    int count = 0;
    for (std::size_t node = 0; node < is_held.size(); ++node) {
        if (!is_held[node]) {
            place[node] = count++;
        }
    }
    const SparseMatrix all = stiffness_of(mesh, form);
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd forces = VectorXd::Zero(count);
    for (Index row = 0; row < all.rows(); ++row) {
        const int own = place[std::size_t(row)];
        if (own < 0) {
            continue;
        }
        forces[own] += loads[row];
        for (SparseMatrix::InnerIterator entry(all, row); entry; ++entry) {
            const int other = place[std::size_t(entry.col())];
            if (other < 0) {
                forces[own] -= entry.value() * u[entry.col()];
            } else {
                entries.emplace_back(own, other, entry.value());
            }
        }
    }
    Eigen::SparseMatrix<double> of_free(count, count);
    of_free.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(of_free);
    if (lu.info() != Eigen::Success) {
        throw std::domain_error("the bar has no one equilibrium");
    }
    const VectorXd solved = lu.solve(forces);
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (place[node] >= 0) {
            u[Index(node)] = solved[place[node]];
        }
    }
    return u;
}

double displacement_at_load(const Rational& horizon) {
    const Medium medium{1, horizon};
    const Mesh mesh = unit_bar(medium, medium);
    VectorXd loads = VectorXd::Zero(Index(mesh.nodes.size()));
    const Index middle = loads.size() / 2;
    loads[middle] = 1;
    return equilibrium(mesh, CouplingForm::pairs, held_outside(mesh, 0, 1),
                       VectorXd::Zero(loads.size()), loads)[middle];
}

double material_interface_error(const Rational& horizon, CouplingForm form) {
    const Mesh mesh = unit_bar({1, horizon}, {2, horizon});
    // The flux k u' is 4/3 everywhere.
    const VectorXd local = places(mesh).unaryExpr(
        [](double x) { return x < 0.5 ? 4 * x / 3 : 2.0 / 3 + 2 * (x - 0.5) / 3; });
    const VectorXd u =
        equilibrium(mesh, form, held_outside(mesh, 0, 1), local, VectorXd::Zero(local.size()));
    return (u - local).lpNorm<Eigen::Infinity>();
}

double patch_error(const Halves& halves, CouplingForm form) {
    const Rational reach = std::max(halves.left.horizon, halves.right.horizon);
    const auto elements = [&reach](const Rational& length) {
        return std::size_t(patch_elements) +
               std::max<std::size_t>(elements_within(reach, length), 1);
    };
    const Mesh mesh = mesh_of(halves, elements(halves.left_length), elements(halves.right_length));
    const std::vector<bool> held = held_outside(mesh, -patch_elements * halves.left_length,
                                                patch_elements * halves.right_length);
    bool is_exact = true;
    for (std::size_t node = 0; node < held.size() && is_exact; ++node) {
        is_exact = held[node] || force_of_patch(mesh, form, node) == LogNumber{};
    }
    if (is_exact) {
        return 0;
    }
    const VectorXd x = places(mesh);
    const VectorXd u = equilibrium(mesh, form, held, x, VectorXd::Zero(x.size()));
    return (u - x).lpNorm<Eigen::Infinity>();
}

}  // namespace nmbcgen
