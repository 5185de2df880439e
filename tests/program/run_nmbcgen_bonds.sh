#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen bonds, its page's tables, and its sets as lattices of other commands.
# Usage: run_nmbcgen_bonds.sh NMBCGEN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
page=$2/docs/how-to/optimised-bonds.md
evidence=$2/docs/evidence/paper-bonds.md

chain=(bonds --dimension 1 --horizon 3)
square=(bonds --dimension 2 --horizon 3 --method bz-ls)
try "${chain[@]}" --method galerkin
expect_exit 0
expect_no_stderr
expect "the page's set" diff <(sed -n '/^```text/,/^```$/p' "$page" | sed '1d;$d') "$scratch/stdout"
for table in table1 table2 chain-boundaries square-boundaries; do
    "$2/tools/scripts/paper-bonds" $table --nmbcgen "$program" | tail -n +3 >rows
    expect "the page's $table" test "$(grep -cxFf rows "$evidence")" -eq "$(grep -c . rows)"
done
expect "mistakes of the script" bash -c '
    for arguments in "" table3 "table1 table2" "table1 --nmbcgen" "table1 --nmbcgen nowhere"; do
        "$0" $arguments 2>/dev/null && exit 1
        [ $? -eq 2 ] || exit 1
    done' "$2/tools/scripts/paper-bonds"

# Closed forms have their values, and sets say what they are.
try "${chain[@]}" --method subdomain --format json --stdout
expect_exit 0
expect "JSON of a chain" python3 -c '
import json, sys
from math import pi, sqrt
set = json.load(open(sys.argv[1]))
assert [a["length"] for a in set["alpha"]] == [1, 2, 3]
for a in set["alpha"]:
    assert abs(eval(a["closed_form"].replace("^", "**").replace("1/", "1.0/")) - a["value"]) < 1e-13
    assert a["weight"] == a["value"]
assert set["stable"] and not set["positive"] and set["bound"] is None' "$scratch/stdout"
try "${square[@]}" --positive 1/2 --format json
expect_exit 0
expect "JSON of a square lattice" python3 -c '
import json, sys
set = json.load(open(sys.argv[1]))
assert [a["bond"] for a in set["alpha"]] == [[1, 0], [1, 1], [2, 0], [2, 1], [2, 2], [3, 0]]
assert all(a["value"] >= 0.5 for a in set["alpha"]) and set["positive"] and set["bound"] == "1/2"
assert set["alpha"][2]["closed_form"] == "1/2" and set["alpha"][0]["closed_form"] is None' "$scratch/stdout"

# The paper's methods in the plane: exact speeds, and a word where waves grow.
try bonds --dimension 2 --horizon 3 --method least-squares
expect_exit 0
expect "exact speeds" grep -q "P 1.000 1.000, S 1.000 1.000" "$scratch/stdout"
try bonds --dimension 2 --horizon 3 --method point
expect_exit 0
expect "waves that grow" grep -q "^warning   this lattice has waves that grow" "$scratch/stdout"

# What its line "options" says is the lattice of other commands, below 0 or not.
options() { "$program" "$@" | sed -n 's/^options *//p'; }
read -ra of_chain <<<"$(options "${chain[@]}" --method galerkin)"
try "${of_chain[@]}" --order 1 --require-stable --G 0 --stdout
expect_exit 0
try recommend "${of_chain[@]}"
expect_exit 0
expect "an undamped one is certified" grep -q '^NMBC[1-6], stride 1, tau = 0, ' "$scratch/stdout"
expect "it is stable with both ends alike" grep -q '^  certified  stable with both ends alike' "$scratch/stdout"
read -ra of_square <<<"$(options "${square[@]}")"
try dispersion "${of_square[@]}" --samples 2
expect_exit 0
try recommend "${of_square[@]}"
expect_exit 2
expect_stderr "For the waves of one polarisation at normal incidence add --polarisation P or S"
try recommend "${of_square[@]}" --polarisation P
expect_exit 0
try --family bond1d --horizon 3 --weights 1,-2,2 --order 1 --stdout
expect_exit 2
expect_stderr "with these weights the lattice has waves that grow"
try --family bond1d --horizon 2 --weights 1,-1 --order 1 --stdout
expect_exit 2
expect_stderr "long waves do not travel"
try dispersion --family bond2d --radius2 2 --weights 1,-1
expect_exit 2
expect_stderr "with these weights the lattice has waves that grow"
try --family nopd1d --horizon 2 --weights 1,-0.4 --order 1 --stdout
expect_exit 2
expect_stderr "nopd1d needs weights above 0"

# Sets that grow say so, and give no steps; one with a zero is no lattice of other commands.
for grows in "1 3 1,-3,0" "1 3 0,0,0" "1 3 1.44,-1.6,0.75" "2 2 -1,-1,-1" "2 3 100,2,1,-0.98825,1/1000000,1/1000000"; do
    read -r dimension horizon alpha <<<"$grows"
    try bonds --dimension "$dimension" --horizon "$horizon" --alpha="$alpha"
    expect_exit 0
    expect "a set that grows says so" grep -q '^warning   this lattice has waves that grow' "$scratch/stdout"
    expect "no steps, no options" bash -c '! grep -qE "^(steps|options)" "$0"' "$scratch/stdout"
done
try "${square[@]}" --positive 0
expect_exit 0
expect "no options" grep -q '^refused   by other commands: a bond has the weight 0' "$scratch/stdout"

# The sign of the first weight is not lost.
try --family bond1d --horizon 3 --weights -1,-1,-1 --order 1 --stdout
expect_exit 2
expect_stderr "long waves do not travel"
try dispersion --family bond1d --horizon 3 --weights -0.1,2,3 --samples 2
expect_exit 0
for polarisation in P S; do
    try --family bond2d --radius2 5 --weights 100,7.9999,1,-1 --polarisation $polarisation --order 1 --stdout
    expect_exit 2
    expect_stderr "with these weights the lattice has waves that grow"
done

refuses 2 "--dimension is required" bonds
refuses 2 "--method (or --alpha) is required" bonds --dimension 1 --horizon 3
refuses 2 "'3' is not a whole number from 1 to 2" bonds --dimension 3 --horizon 3 --method galerkin
refuses 2 "is not a whole number from 1 to 20" bonds --dimension 1 --horizon 21 --method galerkin
refuses 2 "in 2 dimensions it is 2 to 5" bonds --dimension 2 --horizon 1 --method bz-ls
refuses 2 "of a chain point, subdomain, galerkin, least-squares, taylor; of a square lattice point, subdomain, galerkin, least-squares, bz-ls" bonds --dimension 1 --horizon 3 --method best
refuses 2 "not in 1 dimension; there: point, subdomain, galerkin, least-squares, taylor" bonds --dimension 1 --horizon 3 --method bz-ls
refuses 2 "not in 2 dimensions; there: point, subdomain, galerkin, least-squares, bz-ls" bonds --dimension 2 --horizon 3 --method taylor
refuses 2 "is of --method bz-ls" bonds --dimension 1 --horizon 3 --method point --positive 1/2
refuses 2 "is of --method bz-ls" bonds --dimension 2 --horizon 3 --method galerkin --positive 1/2
refuses 2 "is not a non-negative exact number" bonds --dimension 2 --horizon 3 --method bz-ls --positive -1
refuses 2 "3 coefficients, where horizon 3 needs 6" bonds --dimension 2 --horizon 3 --alpha 1,1,1
refuses 2 "--method and --alpha exclude each other: give one of them" bonds --dimension 1 --horizon 1 --alpha 1 --method point
refuses 2 "'x' is not an exact number" bonds --dimension 1 --horizon 1 --alpha x
refuses 2 "allowed: text, json" bonds --dimension 1 --horizon 1 --alpha 1 --format yaml
refuses 3 "singular at N = 5" bonds --dimension 2 --horizon 5 --method point
refuses 3 "no coefficients of 3 or more have the speeds of long waves" bonds --dimension 2 --horizon 3 --method bz-ls --positive 3

finish
