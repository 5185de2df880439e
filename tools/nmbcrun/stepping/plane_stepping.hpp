// SPDX-License-Identifier: MIT
/// nmbc::Plane, whose steps are compiled once, for threads where there is OpenMP
/// (plane_stepping.cpp). All of nmbcrun includes this in the place of nmbc/plane.hpp.
#pragma once

#include <cstddef>
#include <limits>
#include <nmbc/plane.hpp>
#include <nmbc/sweep.hpp>

extern template class nmbc::BasicPlane<double>;
extern template class nmbc::detail::PlaneForce<double>;
extern template class nmbc::detail::BondForce<double>;

namespace nmbcrun {

/// While there is one, all steps are in the threads that call them: where these are many, and where
/// times are compared.
class InOneThread {
  public:
    InOneThread() { nmbc::detail::threaded_nodes = std::numeric_limits<std::size_t>::max(); }
    ~InOneThread() { nmbc::detail::threaded_nodes = before_; }
    InOneThread(const InOneThread&) = delete;
    InOneThread& operator=(const InOneThread&) = delete;

  private:
    std::size_t before_ = nmbc::detail::threaded_nodes;
};

}  // namespace nmbcrun
