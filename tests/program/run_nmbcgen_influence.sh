#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen influence: what its page shows, JSON, mistakes.
# Usage: run_nmbcgen_influence.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
page=$2

try influence --power 3 --smoothing 1 --horizon 5
expect_exit 0
expect_no_stderr
blocks() { awk -v which="$1" '/^```text/ { block++; next } /^```$/ { block += 0.5 } block == which' "$page"; }
expect "the page's text" diff <(blocks 1) "$scratch/stdout"
read -ra lattice <<<"$(sed -n 's/^options *//p' "$scratch/stdout")"
try "${lattice[@]}" --order 1 --stdout
expect_exit 0
# Weights that are longer than an option may be are rounded: other commands take them.
try influence --power 20 --smoothing 4 --horizon 20
expect_exit 0
read -r -a options < <(sed -n 's/^options *//p' "$scratch/stdout")
try "${options[@]}" --order 1 --uncertified --format json --stdout
expect_exit 0
expect_no_stderr
try influence --power 1000 --smoothing 4 --horizon 20
expect_exit 0
expect "no line that nobody reads" awk 'length > 150 { exit 1 }' "$scratch/stdout"

try influence --power 3 --smoothing 4 --horizon 20 --format json --stdout
expect_exit 0
expect_no_stderr
expect "JSON" python3 -c '
import json, math, sys
from fractions import Fraction
influence = json.load(open(sys.argv[1]))
log = math.log(Fraction(influence["log_of"]))
values = {m["n"]: float(Fraction(m["rational"])) + float(Fraction(m["of_log"])) * log for m in influence["moments"]}
for m in influence["moments"]:
    expected = 2 / math.factorial(m["n"] + 1) * values[m["n"]] / values[1]
    assert abs(m["solid"] - expected) < 1e-12
weights = list(map(Fraction, influence["bond1d_weights"]))
assert len(weights) == 20 and weights[0] == 1 and weights[19] == Fraction(5, 24) ** 3 / 2
assert abs(influence["modulus_of_continuum_factor"] - .9854209) < 1e-7' "$scratch/stdout"

# Square and cubic lattices: both lines are lattices of every other command, and the same one at nu = 1/4 in space.
try influence --power 3 --smoothing 1 --radius2 3 --dimension 3
expect_exit 0
expect_no_stderr
expect "the page's options" diff <(blocks 2.5) "$scratch/stdout"
mapfile -t lattices < <(grep -o -- '--family .*' "$scratch/stdout")
expect "two lattices" test "${#lattices[@]}" -eq 2
for wave in P S; do
    for lattice in "${lattices[@]}"; do
        read -ra options <<<"$lattice"
        try "${options[@]}" --polarisation $wave --order 1 --format json --stdout --uncertified
        expect_exit 0
        cp "$scratch/stdout" "symbol_${options[1]}"
        try dispersion "${options[@]}" --angle 0,45 --samples 10
        expect_exit 0
    done
    expect "the same symbol but for weights rounded to 1e-12" python3 -c '
import json
from fractions import Fraction
symbols = [[Fraction(int(s["num"][0]), int(s["den"][0])) for s in json.load(open(name))["lattice"]["symbol"]]
           for name in ("symbol_lps3d", "symbol_bond3d")]
assert all(abs(a - b) < 1e-11 for a, b in zip(*symbols))
assert len(symbols[0]) >= len(symbols[1]) and all(abs(s) < 1e-11 for s in symbols[0][len(symbols[1]):])'
done
rm symbol_*
# In the plane they are alike at nu = 1/3, as plane stress is what is taken for granted.
try influence --power 3 --smoothing 1 --radius2 2
expect_exit 0
mapfile -t lattices < <(grep -o -- '--family .*' "$scratch/stdout")
for lattice in "${lattices[@]}"; do
    read -ra options <<<"$lattice"
    try taylor "${options[@]}" --polarisation P --order 3 --direction 0 --format json
    expect_exit 0
    cp "$scratch/stdout" "taylor_${options[1]}"
done
expect "the same waves, and no g" python3 -c '
import json
from fractions import Fraction
both = [json.load(open(f"taylor_{name}")) for name in ("lps2d", "bond2d")]
values = [[float(Fraction(int(a["num"][0]), int(a["den"][0]))) for a in one["taylor"]] for one in both]
assert all(abs(a - b) < 1e-11 for a, b in zip(*values, strict=True))
assert all(one["units"].endswith("E/density") for one in both)'
rm taylor_*
try influence --power 3 --smoothing 1 --radius2 13 --dimension 3
expect_exit 0
expect_stdout_line "options     (lps3d takes family radii up to 12, squared)"
refuses 2 "the bond (1, 1) is weaker than 1e-12 of the nearest" influence --power 1000 --smoothing 1 --radius2 2
try influence --power 2 --smoothing 1/2 --radius2 5 --format json
expect_exit 0
expect "weights of a square lattice" python3 -c '
import json, math, sys
from fractions import Fraction
influence = json.load(open(sys.argv[1]))
assert influence["classes"] == [[1, 0], [1, 1], [2, 0], [2, 1]]
for (i, j), lps, bond in zip(influence["classes"], influence["lps_weights"], influence["bond_weights"]):
    length = math.hypot(i, j)
    omega = (1.5 / (length + .5)) ** 2
    assert abs(Fraction(lps) - Fraction(omega / length)) < 2e-12
    assert abs(Fraction(bond) - Fraction(omega / length ** 3)) < 2e-12' "$scratch/stdout"
for order in 1 2; do
    for wave in P S; do
        try --family lps3d --radius2 3 --nu 3/10 --weights 1,1/2,1/3 --polarisation $wave --order $order --out made
        expect_exit 0
        expect_file "made/lps3d_r3_nu3o10_w_1o1_1o2_1o3_${wave}_n1_order$order.hpp"
        try --family lps2d --radius2 4 --nu 3/10 --polarisation $wave --order $order --out made
        expect_exit 0
        expect_file "made/lps2d_r4_nu3o10_${wave}_n2_order$order.hpp"
    done
done
try --family lps3d --radius2 3 --nu 3/10 --weights 2,2,2 --polarisation P --order 1 --out made
expect_exit 0
expect_file made/lps3d_r3_nu3o10_P_n1_order1.hpp
rm -r made

refuses 2 "--power is required" influence --smoothing 1 --horizon 2
refuses 2 "--smoothing is required" influence --power 1 --horizon 2
refuses 2 "the smoothing length must be above 0" influence --power 1 --smoothing 0 --horizon 2
refuses 2 "-1" influence --power 1 --smoothing -1 --horizon 2
refuses 2 "'-1' is not a whole number from 0 to 1000" influence --power -1 --smoothing 1 --horizon 2
refuses 2 "'1001' is not a whole number from 0 to 1000" influence --power 1001 --smoothing 1 --horizon 2
refuses 2 "'0' is not a whole number from 1 to 100" influence --power 1 --smoothing 1 --horizon 0
refuses 2 "allowed: text, json" influence --power 1 --smoothing 1 --horizon 2 --format csv
refuses 2 "--horizon (or --radius2) is required" influence --power 1 --smoothing 1
refuses 2 "it is no sum of three squares" influence --power 1 --smoothing 1 --radius2 7 --dimension 3
refuses 2 "it is no sum of two squares" influence --power 1 --smoothing 1 --radius2 3
refuses 2 "'4' is not a whole number from 2 to 3" influence --power 1 --smoothing 1 --radius2 3 --dimension 4

# refused CODE WHAT ARGUMENT..: of tables of these lattices.
refused() {
    local exit_code=$1 what=$2
    shift 2
    try "$@"
    expect_exit "$exit_code"
    expect_stderr "$what"
    expect "nothing on stdout" test ! -s "$scratch/stdout"
    expect_nothing_written
}
wave=(--polarisation P --order 1 --out made)
refused 2 "--nu is required" --family lps3d --radius2 3 "${wave[@]}"
refused 2 "--state: lps3d has no plane stress" --family lps3d --radius2 3 --nu 1/4 --state strain "${wave[@]}"
refused 2 "an isotropic solid needs -1 < nu < 1/2" --family lps3d --radius2 3 --nu 1/2 "${wave[@]}"
refused 2 "it is no sum of three squares" --family lps3d --radius2 7 --nu 1/4 "${wave[@]}"
refused 2 "--radius2: lps3d takes family radii up to 12" --family lps3d --radius2 13 --nu 1/4 "${wave[@]}"
refused 2 "3 weights are needed, all above 0" --family lps3d --radius2 3 --nu 1/4 --weights 1,1 "${wave[@]}"
refused 2 "3 weights are needed, all above 0" --family bond3d --radius2 3 --weights 1,1,-1 "${wave[@]}"
refused 2 "bond3d takes w_1,w_2,.." --family bond3d --radius2 3 "${wave[@]}"
refused 2 "--nu: bond3d has no Poisson's ratio" --family bond3d --radius2 3 --nu 1/4 --weights 1,1,1 "${wave[@]}"
refused 2 "has no stabilisation" --family lps2d --radius2 2 --nu 1/4 "${wave[@]}" --G 1
refused 2 "sides are of nopd2d, bond2d and lps2d" recommend --family lps3d --radius2 2 --nu 1/4
refused 2 "sides are of nopd2d and bond2d" passive --family lps2d --radius2 2 --nu 1/4
refused 2 "lps3d is no lattice of the plane" oblique --family lps3d --radius2 2 --nu 1/4 --absorb P:0
refused 4 "are not examined for oblique waves" --family lps3d --radius2 3 --nu 1/4 "${wave[@]}" --require-stable
refused 2 "--limit: lps2d states no continuum limit" dispersion --family lps2d --radius2 2 --nu 1/4 --limit

finish
