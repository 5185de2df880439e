// SPDX-License-Identifier: GPL-2.0-or-later
/// The closed forms of appendix A of Nicely 2018, with the misprints that docs/evidence/errata.md
/// lists.
#pragma once

#include <string>

namespace nmbcgen::test {

// Standard NOPD, as printed.
inline const std::string standard_a3 = "c/30*dX^2*(-1+3*n+3*n^2)";
inline const std::string standard_a5 = "c/840*dX^4*(1-3*n+6*n^3+3*n^4)";
inline const std::string standard_a7_bracket = "dX^6*(-3+9*n-n^2-15*n^3+5*n^4+15*n^5+5*n^6)";

// Stabilised NOPD, as printed.
inline const std::string stabilised_a3 = "c*(-1+3*n*(1+n))*dX*(G*(1+n)*(1+2*n)+4*n^3*dX)/(120*n^3)";
inline const std::string stabilised_a5 =
    "c*dX^2*(-7*G^2*(-1+10*n^2+15*n^3+6*n^4)^2"
    " + 8*G*(-1+n)*n^3*(1+n)*(2+n)*(-1+2*n)*(1+2*n)*(3+2*n)*dX"
    " + 240*n^6*(1+3*n*(1+n)*(-1+n+n^2))*dX^2)/(201600*n^6)";
inline const std::string stabilised_a7 =
    "c*dX^3*(60*G^2*n^3*(1+n)^2*(1+2*n)^2*(1+n*(1+n)*(1+n*(1+n)*(-23+33*n*(1+n))))*dX"
    " - 56*G*n^6*(1+n)*(1+2*n)*(-9+n*(1+n)*(21+n*(1+n)*(-38+43*n*(1+n))))*dX^2"
    " + 960*n^9*(-3+n*(1+n)*(9+5*(-1+n)*n*(1+n)*(2+n)))*dX^3"
    " - 21*G^3*(-1+10*n^2+15*n^3+6*n^4)^3)/(72576000*n^9)";

}  // namespace nmbcgen::test
