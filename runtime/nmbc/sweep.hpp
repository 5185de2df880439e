// SPDX-License-Identifier: MIT
/// A sweep over the nodes of a body, in pieces for threads, and the one that all bodies have:
/// drift.
#pragma once

#include <algorithm>
#include <cstddef>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace nmbc::detail {

/// With OpenMP, nodes from which on its threads share a sweep (docs/evidence/speed.md has the
/// measurement). A variable, so that tests and measurements can have it otherwise.
inline std::size_t threaded_nodes = 16384;

// Files compiled with OpenMP and files without may be one program: theirs are different functions.
#ifdef _OPENMP
inline namespace in_threads {
#else
inline namespace in_one_thread {
#endif

/// How many pieces a sweep over so many nodes is shared in.
inline std::size_t pieces_of([[maybe_unused]] std::size_t nodes) {
#ifdef _OPENMP
    constexpr std::size_t piece_nodes = 16384;
    if (nodes >= threaded_nodes) {
        return std::max<std::size_t>(nodes / piece_nodes, 2);
    }
#endif
    return 1;
}

/// Likewise, one a thread at the most.
inline std::size_t pieces_for_threads(std::size_t nodes) {
#ifdef _OPENMP
    return std::min(pieces_of(nodes), static_cast<std::size_t>(omp_get_max_threads()));
#else
    return pieces_of(nodes);
#endif
}

/// Calls work(piece) for each of them.
template <class Work>
void in_threads_each(std::size_t pieces, const Work& work) {
#ifdef _OPENMP
#pragma omp parallel for schedule(static) if (pieces > 1)
#endif
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        work(piece);
    }
}

/// Calls work(first, last) for each piece of the nodes 0 .. nodes-1.
template <class Work>
void for_each_piece(std::size_t nodes, std::size_t pieces, const Work& work) {
    in_threads_each(pieces, [&](std::size_t piece) {
        work(nodes * piece / pieces, nodes * (piece + 1) / pieces);
    });
}

}  // namespace in_threads or in_one_thread

/// u += dt v on the nodes first .. last-1.
template <class Real>
void drift_nodes(Real dt, Real* __restrict u, const Real* __restrict v, std::size_t first,
                 std::size_t last) {
    for (std::size_t node = first; node < last; ++node) {
        u[node] += dt * v[node];
    }
}

}  // namespace nmbc::detail
