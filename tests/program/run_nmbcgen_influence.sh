#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen influence: what its page shows, JSON, mistakes.
# Usage: run_nmbcgen_influence.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

try influence --power 3 --smoothing 1 --horizon 5
expect_exit 0
expect_no_stderr
expect "the page's text" diff <(sed -n '/^```text/,/^```$/p' "$2" | sed '1d;$d') "$scratch/stdout"
read -ra lattice <<<"$(sed -n 's/^options *//p' "$scratch/stdout")"
try "${lattice[@]}" --order 1 --stdout
expect_exit 0
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

# refuses WHAT ARGUMENT..
refuses() {
    local what=$1
    shift
    try influence "$@"
    expect_exit 2
    expect_stderr "$what"
    expect "nothing on stdout" test ! -s "$scratch/stdout"
}
refuses "--power is required" --smoothing 1 --horizon 2
refuses "--smoothing is required" --power 1 --horizon 2
refuses "the smoothing length must be above 0" --power 1 --smoothing 0 --horizon 2
refuses "-1" --power 1 --smoothing -1 --horizon 2
refuses "'-1' is not a whole number from 0 to 1000" --power -1 --smoothing 1 --horizon 2
refuses "'1001' is not a whole number from 0 to 1000" --power 1001 --smoothing 1 --horizon 2
refuses "'0' is not a whole number from 1 to 100" --power 1 --smoothing 1 --horizon 0
refuses "allowed: text, json" --power 1 --smoothing 1 --horizon 2 --format csv

finish
