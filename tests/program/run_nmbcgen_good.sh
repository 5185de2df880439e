#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# Requests that are met: what is written where, under which name, and what is printed.
# Usage: run_nmbcgen_good.sh NMBCGEN RUNTIME_FOLDER
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project

# writes PATH ARGUMENT..: exactly this file is written, and before a header that of its lattice;
# their paths are all that is printed.
writes() {
    writes_and expect_no_stderr "$@"
}

# The same of a condition that is not stable at its G: that is said.
writes_unstable() {
    writes_and warns "$@"
}
warns() {
    expect_stderr "nmbcgen: warning: NMBC"
    expect "one line on stderr" test "$(wc -l <"$scratch/stderr")" -eq 1
}

writes_and() { # EXPECTATION PATH ARGUMENT..
    local expectation=$1 path=$2 lattice
    shift 2
    lattice=$(sed -E 's/_order[0-9]+(_s[0-9]+)?//; s/(_dt[0-9o]+)?(_at(pi)?[0-9o]+x[0-9]+)*(_G[0-9o]+)?\.hpp$/.hpp/' <<<"$path")
    rm -rf generated/nmbc/tables out
    try "$@"
    expect_exit 0
    "$expectation"
    expect_file "$path"
    if [[ $path == *.hpp ]]; then
        expect_file "$lattice"
        expect "the paths and nothing else on stdout" test "$(cat "$scratch/stdout")" = "$lattice
$path"
        expect "two files" test "$(files_in .)" -eq 2
    else
        expect "the path and nothing else on stdout" test "$(cat "$scratch/stdout")" = "$path"
        expect "one file" test "$(files_in .)" -eq 1
    fi
}

default=generated/nmbc/tables
writes $default/nopd1d_n2_order3.hpp --order 3 --horizon 2
writes $default/nopd1d_n2_order3.json --order 3 --horizon 2 --format json
writes $default/nopd1d_n2_order3.hpp --order=3 --horizon=2 --format=header --family=nopd1d
writes out/nopd1d_n1_order2_s2.hpp --order 2 --horizon 1 --stride 2 --out out
writes out/nopd1d_n1_order2.hpp --order 2 --horizon 1 --stride 1 --out out
writes out/nopd1d_n1_order1_G1o2.hpp --order 1 --horizon 1 --G 1/2 --out out
cp out/nopd1d_n1_order1_G1o2.hpp "$scratch/half"
for G in 0.5 2/4 0.50 00.5 5/10; do
    writes out/nopd1d_n1_order1_G1o2.hpp --order 1 --horizon 1 --G "$G" --out out
    expect_same out/nopd1d_n1_order1_G1o2.hpp "$scratch/half"
done
writes out/nopd1d_n1_order2_tau1o10.hpp --order 2 --horizon 1 --damping 0.1 --out out --uncertified
writes out/nopd1d_n2_order2_s2_tau1o10_G1o2.json --order 2 --horizon 2 --stride 2 --G 1/2 \
    --damping 2/20 --out out --uncertified --format json
writes out/nopd1d_n1_order1.hpp --order 1 --horizon 1 --damping 0 --out out
writes out/nopd1d_n2_order2_s2_tau1o10_dt3o2.hpp --order 2 --horizon 2 --stride 2 --damping 1/10 \
    --time-step 1.5 --out out --uncertified
writes out/nopd1d_n1_order2.hpp --order 2 --horizon 1 --time-step 0 --out out
# At n = 1, G = 1/2, the atom chain, omega_max = 2 c/dX and dt = cfl dX/c.
writes out/nopd1d_n1_order2_dt3o5_G1o2.hpp --order 2 --horizon 1 --cfl 3/5 --G 1/2 --out out
# At G = 1, omega_max^2 = 8: dt = 0.3 sqrt(2) = 0.4242..
writes_unstable out/nopd1d_n1_order3_dt53o125_G1o1.hpp --order 3 --horizon 1 --cfl 0.6 --G 1 --out out
expect_stderr "NMBC3 at horizon 1, stride 1, steps of 53/125, G = 1 is not stable: a boundary mode grows"
# Waves at normal incidence of plane models are chains of their own.
plane=(--family nopd2d --radius2 4 --nu 1/4 --out out)
writes out/nopd2d_r4_nu1o4_P_n2_order2.hpp "${plane[@]}" --polarisation P --order 2
try --family nopd2d --radius2 4 --nu 0.25 --state stress --polarisation P --order 2 --stdout
expect "the command with the plane model's own options" grep -q \
    "Regenerate: nmbcgen --family nopd2d --radius2 4 --nu 1/4 --polarisation P --order 2$" "$scratch/stdout"
expect "that the certificate is a chain's" grep -q \
    "^// stable  for waves at normal incidence, oblique ones may grow. reflection: " "$scratch/stdout"
writes_unstable out/nopd2d_r4_nu1o4_S_n2_order1_s2_G1o2.json "${plane[@]}" --polarisation S --order 1 \
    --stride 2 --G 1/2 --format json
writes out/nopd2d_r1_num1o3_strain_P_n1_order1.hpp --family nopd2d --radius2 1 --nu -1/3 \
    --state strain --polarisation P --order 1 --out out
writes out/bond2d_r2_w_1o1_1o4_S_n1_order2.hpp --family bond2d --radius2 2 --weights 1,0.25 \
    --polarisation S --order 2 --out out --uncertified
try recommend --family nopd2d --radius2 4 --nu 1/4 --polarisation P --G 1/2 --order 1
expect_exit 0
expect_stdout_line "             for waves at normal incidence; in the plane oblique waves may grow"
writes out/chain1d_n1_order2.hpp --family chain1d --order 2 --horizon 1 --out out
writes out/nopd1d_n2_w_1o1_1o2_order1.hpp --order 1 --horizon 2 --weights conical --out out
cp out/nopd1d_n2_w_1o1_1o2_order1.hpp "$scratch/weights"
for weights in 1,0.5 2/3,1/3 inverse; do
    writes out/nopd1d_n2_w_1o1_1o2_order1.hpp --order 1 --horizon 2 --weights "$weights" --out out
    expect_same out/nopd1d_n2_w_1o1_1o2_order1.hpp "$scratch/weights"
done
writes out/nopd1d_n2_order1.hpp --order 1 --horizon 2 --weights 3,3 --out out
writes out/nopd1d_n1_order4_at6o5x2_G1o2.hpp --match 0:5,1.2:2 --horizon 1 --G 1/2 --out out
writes out/nopd1d_n1_order3_at1o5x1_atpi1o3x1_G1o2.hpp --match pi/3:1,0.2:1,0:3 --horizon 1 --G 0.5 \
    --out out
writes out/nopd1d_n1_order2.hpp --order 2 --horizon 1 --out out
writes out/nopd1d_n1_order2_G1o2.hpp --match 0:5 --horizon 1 --G 1/2 --out out
cp out/nopd1d_n1_order2_G1o2.hpp "$scratch/order"
writes out/nopd1d_n1_order2_G1o2.hpp --order 2 --horizon 1 --G 1/2 --out out
expect_same out/nopd1d_n1_order2_G1o2.hpp "$scratch/order"
writes out/nopd1d_n1_order1_G2o1.json --order 1 --horizon 1 --G 2 --format json --out out
writes out/a/b/nopd1d_n1_order1.hpp --order 1 --horizon 1 --out out/a/b
writes "out/with space/nopd1d_n1_order1.hpp" --order 1 --horizon 1 --out "out/with space"
rm -rf generated/nmbc/tables out

# --stdout prints the very bytes of the file, and writes nothing.
for request in "--order 3 --horizon 2 --format c" "--order 3 --horizon 2 --format json" \
    "--order 2 --horizon 1 --stride 3 --G 7/5 --format python"; do  # the last is not stable
    # shellcheck disable=SC2086  # words are meant
    "$program" $request --out "$scratch/out" >"$scratch/path" 2>/dev/null
    # shellcheck disable=SC2086
    try $request --stdout
    expect_exit 0
    if [[ $request == *python* ]]; then warns; else expect_no_stderr; fi
    expect_same "$scratch/stdout" "$(cat "$scratch/path")"
    expect_nothing_written
done

# A header on stdout holds its lattice; two of them, and the committed ones, go together.
for order in 1 2; do
    "$program" --order $order --horizon 1 --G 7/5 --stdout >"nmbc$order.hpp"
done
"$program" --order 1 --horizon 1 --out nmbc/tables >/dev/null
for first in nmbc1.hpp nmbc/tables/nopd1d_n1_order1.hpp; do
    printf '%s\n' "#include <$first>" '#include <nmbc2.hpp>' \
        '#include <nmbc/tables/nopd1d_n1_order1.hpp>' \
        'static_assert(nmbc::generated::nopd1d_n1_order2_G7o5.lattice == &nmbc::generated::nopd1d_n1);' \
        >both.cpp
    tried="compiling $first and others"
    code=0
    "${CXX:-c++}" -std=c++20 -O2 -march=native -Wall -Wextra -Werror -fsyntax-only -I. -I "$2" both.cpp \
        2>"$scratch/stderr" || code=$?
    expect_exit 0
done
rm -r nmbc both.cpp nmbc1.hpp nmbc2.hpp

# The banner's command makes the file again.
for request in "--order 2 --horizon 2 --stride 2 --G 3/4" \
    "--match 0:3,1/5:1,pi/3:1 --horizon 1 --G 1/2" \
    "--order 1 --horizon 3 --weights 1,2/3,1/3 --stride 2 --G 1" \
    "--order 2 --horizon 2 --stride 2 --damping 1/10 --time-step 3/4 --G 3/4 --uncertified"; do
    # shellcheck disable=SC2086
    "$program" $request --stdout >"$scratch/first"
    command=$(sed -n 's/.*Regenerate: nmbcgen //p' "$scratch/first")
    expect "the command in the banner" test "$command" = "--family nopd1d $request"
    # shellcheck disable=SC2086
    try $command --stdout
    expect_exit 0
    expect_same "$scratch/stdout" "$scratch/first"
done

# In the very steps a condition is matched in it reflects 1.6e-8 of the energy at xi = pi/6.
try reflect --order 2 --horizon 1 --G 1/2 --cfl 3/5 --samples 3
expect_exit 0
expect "little" awk -F, 'NR == 2 { exit !($7 < 1e-6) }' "$scratch/stdout"

# Nothing comes back at a matching point: 200 samples, the 64th at 127 pi/400.
try reflect --match 0:3,127pi/400:1 --horizon 2 --stride 2 --G 1 --samples 200
expect_exit 0
expect "nothing but roundings" awk -F, 'NR > 1 && $2 > 0.9974 && $2 < 0.9975 { n++; if ($7 > 1e-20) exit 1 }
    END { exit !n }' "$scratch/stdout"

# reflect without damping is as without the option.
try reflect --order 1 --horizon 1 --G 1 --samples 3
expect_exit 0
cp "$scratch/stdout" "$scratch/first"
try reflect --order 1 --horizon 1 --G 1 --samples 3 --damping 0
expect_same "$scratch/stdout" "$scratch/first"

# A family without stabilisation has no G, or 0.
for request in "--order 2 --horizon 2" "--match 0:3,1:1 --horizon 2" \
    "--order 1 --horizon 2 --require-stable" "--order 2 --horizon 2 --cfl 1/2 --G 0 --uncertified"; do
    # shellcheck disable=SC2086
    try --family bond1d $request --stdout
    expect_exit 0
done
try dispersion --family chain1d --horizon 1 --samples 3
expect_exit 0

# Outside the project no folder is made unasked.
rm -r generated
try --order 1 --horizon 1
expect_exit 2
expect_stderr "--out: a folder is needed: there is no generated/nmbc here"
expect_nothing_written

try --help
expect_exit 0
code=0
"$program" --help >/dev/full 2>"$scratch/stderr" || code=$?
expect_exit 5
expect_stderr "cannot write standard output"

try --version
expect_exit 0
expect "name and version" grep -qxE 'nmbcgen [0-9]+\.[0-9]+\.[0-9]+' "$scratch/stdout"
try --help
expect_exit 0
expect_no_stderr
for option in --family --order --horizon --weights --stride --damping --time-step --cfl --match --G --format --stdout --out --all --check; do
    expect "$option in the help" grep -qF -- "$option" "$scratch/stdout"
done
expect_nothing_written

# Some seconds of algebra: a line on a terminal from two seconds on, where it takes that long.
tried="--order 16 on a terminal"
began=$(date +%s%N)
script -qec "'$program' --order 16 --horizon 2 --uncertified --out slow" /dev/null >"$scratch/stdout"
if [ $(($(date +%s%N) - began)) -gt 3000000000 ]; then
    expect "how long by now" grep -qaE 'nmbcgen: deriving, 0 of 1, [0-9]+ s' "$scratch/stdout"
fi
rm -r slow

# The largest of the committed set, and the whole set: printed as written, one line a file.
try --order 4 --horizon 3 --stdout
expect_exit 0
try --all --out all
expect_exit 0
expect_no_stderr
expect "every file is printed once" test \
    "$(LC_ALL=C sort "$scratch/stdout")" = "$(find all -type f | LC_ALL=C sort)"
expect_stdout_line all/nopd1d_n3_order4.hpp
expect_stdout_line all/tables.hpp
expect_stdout_line all/tables.json
expect "65 tables of 21 lattices, tables.hpp and tables.json" test "$(files_in all)" -eq 88

finish
