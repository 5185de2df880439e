// SPDX-License-Identifier: MIT
#include "generator/coupling/scattering.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/coupling/assembly.hpp"
#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

/// Energy flux of a unit wave: mass times amplitude squared times nodes per time.
double flux(const PlaneMode& mode, double length) {
    return length * mode.group_velocity;
}

}  // namespace

LateralChain bar_chain(const Rational& length, const Medium& medium) {
    const std::vector<LogNumber> stencil = uniform_stencil(medium.horizon / length);
    const Rational unit = medium.stiffness / (length * length);  // k/h over the mass h
    const int reach = int(stencil.size()) - 1;
    LateralChain chain;
    for (int m = -reach; m <= reach; ++m) {
        const double entry = nearest_double(unit * stencil[std::size_t(std::abs(m))]);
        chain.stiffness.emplace_back(Eigen::MatrixXd::Constant(1, 1, entry));
        chain.damping.emplace_back(Eigen::MatrixXd::Zero(1, 1));
    }
    return chain;
}

Junction::Bar Junction::bar_of(const Rational& length, const Medium& medium,
                               const Rational& farthest) {
    Bar bar;
    bar.chain = bar_chain(length, medium);
    bar.reach = Index(bar.chain.reach());
    bar.length = nearest_double(length);
    bar.own = floor(farthest / length).convert_to<Index>() + 2 + bar.reach;
    return bar;
}

Junction::Junction(const Halves& halves, CouplingForm form)
    : left_(bar_of(halves.left_length, halves.left,
                   std::max(halves.left.horizon, halves.right.horizon))),
      right_(bar_of(halves.right_length, halves.right,
                    std::max(halves.left.horizon, halves.right.horizon))) {
    // So many elements that all rows are whole.
    const Index first = 2 * left_.own + left_.reach;
    const Index last = 2 * right_.own + right_.reach;
    const Mesh mesh = mesh_of(halves, std::size_t(first), std::size_t(last));
    const Eigen::MatrixXd K = stiffness_of(mesh, form);
    const Eigen::VectorXd masses = masses_of(mesh);
    const Index rows = left_.own + right_.own + 1;
    rows_ = masses.segment(first - left_.own, rows).cwiseInverse().asDiagonal() *
            K.block(first - left_.own, first - left_.own - left_.reach, rows,
                    rows + left_.reach + right_.reach);
}

Scattering Junction::from_left(double xi) const {
    const ArrivingWave wave = arriving_wave(left_.chain, xi);
    const std::vector<PlaneMode>& out_left = wave.outgoing;
    const PlaneMode& arriving = out_left[std::size_t(wave.column)];  // its mirror image
    const std::vector<PlaneMode> out_right = outgoing_plane_modes(right_.chain, wave.omega);
    if (out_right.empty()) {
        throw std::domain_error("waves at the edge of a band cannot be told from each other");
    }

    // Unknown: amplitudes on the left, displacements between, amplitudes on the right. Waves are 1
    // on the innermost node that is a sum of waves.
    const Index columns = rows_.cols();
    MatrixXcd shapes = MatrixXcd::Zero(columns, rows_.rows());
    MatrixXcd incident = MatrixXcd::Zero(columns, 1);
    const Index of_waves = 2 * left_.reach;  // nodes of the left that are a sum of waves
    for (Index node = 0; node < of_waves; ++node) {
        const auto away = double(of_waves - 1 - node);
        incident(node, 0) = std::pow(1.0 / arriving.z, away);
        for (Index mode = 0; mode < left_.reach; ++mode) {
            shapes(node, mode) = std::pow(out_left[std::size_t(mode)].z, away);
        }
    }
    const Index between = columns - of_waves - 2 * right_.reach;
    shapes.block(of_waves, left_.reach, between, between).setIdentity();
    for (Index node = 0; node < 2 * right_.reach; ++node) {
        for (Index mode = 0; mode < right_.reach; ++mode) {
            shapes(of_waves + between + node, left_.reach + between + mode) =
                std::pow(out_right[std::size_t(mode)].z, double(node));
        }
    }
    MatrixXcd dynamic = rows_.cast<std::complex<double>>();
    dynamic.middleCols(left_.reach, rows_.rows()).diagonal().array() -= wave.omega * wave.omega;
    const MatrixXcd solved = solution_of(dynamic * shapes, -dynamic * incident);

    Scattering result;
    const double brought = flux(arriving, left_.length);
    for (Index mode = 0; mode < travelling_count(out_left); ++mode) {
        result.reflected +=
            std::norm(solved(mode, 0)) * flux(out_left[std::size_t(mode)], left_.length) / brought;
    }
    for (Index mode = 0; mode < travelling_count(out_right); ++mode) {
        result.transmitted += std::norm(solved(left_.reach + between + mode, 0)) *
                              flux(out_right[std::size_t(mode)], right_.length) / brought;
    }
    return result;
}

}  // namespace nmbcgen
