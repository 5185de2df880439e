#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen closure snm and sbp: what its page shows, JSON, mistakes.
# Usage: run_nmbcgen_closure.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

try closure snm --horizon 2 --corrected
expect_exit 0
expect_no_stderr
block() { awk -v block="$1" '/^```text/ { ++n; next } /^```/ { inside = 0 } n == block && !done { print } /^```/ && n == block { done = 1 }' "$2" | sed '/^```/d'; }
expect "the page's rows" diff <(block 2 "$2") "$scratch/stdout"
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

try closure sbp --horizon 2
expect_exit 0
expect_no_stderr
expect "the page's operator" diff <(block 1 "$2") "$scratch/stdout"
read -ra lattice <<<"$(sed -n 's/^options *//p' "$scratch/stdout")"
try "${lattice[@]}" --order 1 --stdout
expect_exit 0
try closure sbp --horizon 3 --weights inverse --format json --stdout
expect_exit 0
expect "JSON" python3 -c '
import json, sys
from fractions import Fraction
closure = json.load(open(sys.argv[1]))
rows = [[Fraction(entry) for entry in row] for row in closure["rows"]]
assert closure["closure"] == "sbp" and closure["weights"] == ["1", "1/2", "1/3"]
assert closure["volumes"] == ["31/36", "25/36", "17/18"]
for i, row in enumerate(rows):
    assert sum(row) == 0 and sum(j * entry for j, entry in enumerate(row)) == Fraction(closure["volumes"][i])
    for j in range(3):
        assert row[j] + rows[j][i] == (-1 if i == j == 0 else 0)' "$scratch/stdout"

refuses 2 "METHOD is required" closure
refuses 2 "'mirror' is no closure whose rows are derived; allowed: snm, sbp" closure mirror --horizon 2
refuses 2 "--corrected is not of closure sbp" closure sbp --horizon 2 --corrected
refuses 2 "--weights is not of closure snm" closure snm --horizon 2 --weights 1,1
refuses 2 "--weights: 3 weights, where horizon 2 needs 2" closure sbp --horizon 2 --weights 1,1,1
refuses 2 "--weights: they must be above 0" closure sbp --horizon 2 --weights=-1,1
refuses 2 "a node near the end would have no volume" closure sbp --horizon 9 --weights 2,172562,2,97,8,2,13,2,34
refuses 2 "--horizon is required" closure snm
refuses 2 "'0' is not a whole number from 1 to 100" closure snm --horizon 0
refuses 2 "'101' is not a whole number from 1 to 100" closure snm --horizon 101
refuses 2 "allowed: text, json" closure snm --horizon 2 --format csv

finish
