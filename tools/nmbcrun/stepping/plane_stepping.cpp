// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

template class nmbc::BasicPlane<double>;
template class nmbc::detail::PlaneForce<double>;
template class nmbc::detail::BondForce<double>;
