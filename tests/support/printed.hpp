// SPDX-License-Identifier: GPL-2.0-or-later
/// Formulas written as the paper prints them, read by GiNaC.
#pragma once

#include <ginac/ginac.h>

#include <string>

#include "generator/table/exact.hpp"

namespace nmbcgen::test {

/// An identity of rational functions: the difference is zero in every symbol.
inline bool identical(const GiNaC::ex& left, const GiNaC::ex& right) {
    return (left - right).normal().expand().is_zero();
}

inline GiNaC::numeric to_ginac(const Rational& value) {
    return {value.str().c_str()};
}

/// Reads formulas over a fixed set of names, each a symbol or a value.
class Reader {
  public:
    explicit Reader(const GiNaC::symtab& names) : parser_(names, true) {}
    GiNaC::ex operator()(const std::string& formula) { return parser_(formula); }

  private:
    GiNaC::parser parser_;
};

}  // namespace nmbcgen::test
