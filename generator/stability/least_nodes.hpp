// SPDX-License-Identifier: MIT
/// How long a chain has to be for waves that decay from one end not to matter at the other.
#pragma once

#include <stdexcept>

#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Chains of every length are found to grow in steps in which the ends are stable: roundings, where
/// a large G puts the waves too near together for doubles. what() says so.
struct NotCertifiable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The number of interior nodes from which on no chain of an undamped lattice between two like ends
/// was found to grow in the certified steps, and a quarter more for what lies between the samples;
/// at least what the lattice's forces and the condition reach. 0 where no step is certified.
/// Sampled: chains of every length up to 24 nodes, from there to 60 and to twice the longest that
/// grows in steps of 3 nodes or a tenth of the length, at the ends and at two values between them
/// of every row of pieces of G, in their largest steps, and in steps of cfl 0.05; then chains of
/// the number found, and of up to 3 nodes more, at both ends of every piece in its largest steps,
/// until none grows. Throws NotCertifiable where one of 400 nodes grows.
unsigned least_nodes(const Table& table, const Certificate& certificate);

}  // namespace nmbcgen
