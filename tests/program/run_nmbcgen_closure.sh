#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen closure snm: what its page shows, JSON, mistakes.
# Usage: run_nmbcgen_closure.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

try closure snm --horizon 2 --corrected
expect_exit 0
expect_no_stderr
expect "the page's rows" diff <(sed -n '/^```text/,/^```$/p' "$2" | sed '1d;$d') "$scratch/stdout"
read -ra lattice <<<"$(sed -n 's/^options *//p' "$scratch/stdout")"
try "${lattice[@]}" --order 1 --stdout
expect_exit 0

try closure snm --horizon 3 --format json --stdout
expect_exit 0
expect_no_stderr
expect "JSON" python3 -c '
import json, sys
from fractions import Fraction
closure = json.load(open(sys.argv[1]))
assert closure["row"] == ["137/150", "11/150", "1/75"] and closure["load"] == "18/25"
assert closure["ghosts"] == [["2", "-1"], ["4", "-3"], ["6", "-5"]]
assert closure["quadrature"] == ["1", "1", "1/2"] and not closure["corrected"]
assert sum(map(Fraction, closure["row"])) == 1' "$scratch/stdout"

# refuses WHAT ARGUMENT..
refuses() {
    local what=$1
    shift
    try closure "$@"
    expect_exit 2
    expect_stderr "$what"
    expect "nothing on stdout" test ! -s "$scratch/stdout"
}
refuses "METHOD is required"
refuses "'mirror' is not a closure; allowed: snm" mirror --horizon 2
refuses "--horizon is required" snm
refuses "'0' is not a whole number from 1 to 100" snm --horizon 0
refuses "'101' is not a whole number from 1 to 100" snm --horizon 101
refuses "allowed: text, json" snm --horizon 2 --format csv

finish
