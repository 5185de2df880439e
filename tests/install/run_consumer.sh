#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A separate project (docs/example) builds and runs against the installed headers, with every
# package of the generator hidden from it.
# Usage: run_consumer.sh CMAKE BUILD_FOLDER SOURCE_FOLDER COMPILER
set -euo pipefail
cmake=$1 build=$2 source=$3 compiler=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# What a careful user compiles with.
warnings="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"

"$cmake" --install "$build" --prefix "$work/prefix" >"$work/install.log"
test -f "$work/prefix/include/nmbc/nmbc.hpp"
test -f "$work/prefix/include/nmbc/tables/tables.hpp"
if find "$work/prefix" -iname '*ginac*' -o -iname 'nmbcgen*' -o -name '*.json' | grep .; then
    echo "the installation holds more than the runtime and its tables" >&2
    exit 1
fi

# Headers of the same names that refuse to be included, found before the real ones.
for header in ginac/ginac.h cln/cln.h gmp.h boost/version.hpp Eigen/Core fmt/format.h \
    nlohmann/json.hpp CLI/CLI.hpp toml++/toml.h; do
    mkdir -p "$work/poison/$(dirname "$header")"
    echo '#error "the runtime must not need this"' >"$work/poison/$header"
done

"$cmake" -S "$source/docs/example" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS="-I$work/poison $warnings" -DCMAKE_CXX_FLAGS_RELEASE="-O2 -march=native" \
    >"$work/configure.log"
"$cmake" --build "$work/build" >"$work/build.log" || { cat "$work/build.log" >&2; exit 1; }

# NMBC2 lets the pulse out: it has left through both ends by t = 200, what was reflected by 400.
"$work/build/own_arrays" | tee "$work/output"
awk '/t = 100.0/ { start = $NF } END { exit !($NF < 1e-12 * start) }' "$work/output"

# What comes back, to the digit; 4e-13 is near to roundings.
"$work/build/steel_bar" | tee "$work/output"
grep -qx 'NMBC1, dt = 1.64e-06 s: 3e-09 of the energy came back' "$work/output"
grep -qx 'NMBC2, dt = 9.67e-07 s: [3-5]e-13 of the energy came back' "$work/output"

"$work/build/half_bar" | tee "$work/output"
grep -q '^refused: .*Opposite::any' "$work/output"
grep -qx 't = 800 dX/c: 2e-06 of the energy is left' "$work/output"
grep -qx 'half and whole bar differ by roundings' "$work/output"

"$work/build/plate" | tee "$work/output"
grep -q '^t =  80 us: .* 3.4e-04 of the largest$' "$work/output"

"$work/build/own_passive" | tee "$work/output"
grep -q '^after 200 steps 2.7e-06 of the energy is left' "$work/output"

"$work/build/own_plane" | tee "$work/output"
grep -qx 't = 1000: kinetic energy 2.5e-07 of the largest' "$work/output"

# Every header compiles alone: of the tables, which are written alike, every eighth, and the list of all.
headers() { find "$work/prefix/include" "$@" -name '*.hpp' | sort; }
{
    headers -not -path '*/tables/*'
    headers -path '*/tables/*' | awk 'NR % 8 == 1 || /tables\/tables.hpp$/'
} | while read -r header; do
    "$compiler" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -x c++ -I"$work/poison" \
        -I"$work/prefix/include" -include "$header" /dev/null
done
