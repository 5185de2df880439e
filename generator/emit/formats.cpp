// SPDX-License-Identifier: MIT
#include <array>

#include "generator/emit/emit.hpp"

namespace nmbcgen {

std::span<const Format> formats() {
    static const std::array all{
        Format{"header", ".hpp", emit_header_with_lattice},
        Format{"json", ".json", [](const Table& table) { return emit_json(table); }},
        Format{"python", ".py", emit_python},
        Format{"c", ".h", emit_c},
        Format{"csv", ".csv", emit_csv},
        Format{"latex", ".tex", emit_latex},
    };
    return all;
}

}  // namespace nmbcgen
