#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun verify: what it says and the code it ends with.
# Usage: run_verify.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
good=(--set model.horizon=1 --set model.G=0.5 --set boundary.order=2)

try verify "$scene" "${good[@]}" --tolerance 2e-6
expect_exit 0
expect_no_stderr
expect "the error, found to be 1.127e-06" grep -q \
    '^error        1.127e-06 in amplitude, of max |u|, at node 1, t = 33.64; within the tolerance 2e-06$' "$scratch/stdout"
expect "packets are reflected as predicted" awk '
    /^ +xi dX/ { table = 1; next }
    /^-:/ { table = 0 }
    table && $4 != "-" { rows++; if (($4 / $5 - 1)^2 > 1e-6) exit 1 }
    END { exit !(rows >= 4) }' "$scratch/stdout"

try verify "$scene" "${good[@]}" --tolerance 1e-6 --quiet
expect_exit 1
expect "two lines only" test "$(wc -l <"$scratch/stdout")" -eq 2
expect "above the tolerance" grep -q 'above the tolerance 1e-06$' "$scratch/stdout"

# Unlike ends; everything comes back from a free one.
try verify "$scene" "${good[@]}" --set boundary.right.kind=free --tolerance 1
expect_exit 0
expect "the free end reflects all" grep -Eq ' 1.000e\+00     1.000e\+00$' "$scratch/stdout"

# A physical end is part of the reference, too: what is left is what the absorber lets back.
try verify "$scene" "${good[@]}" \
    --set boundary.right.kind=fixed --set time.end=100 --tolerance 1e-4
expect_exit 0
expect "the fixed end stays" grep -q '^reference  extended until nothing returns; fixed$' "$scratch/stdout"
expect "half of the energy is in long waves" awk '$2 == "50.000" { exit !($1 < 0.1) }' "$scratch/stdout"
try verify "$scene" --set boundary.kind=free --tolerance 1
expect_exit 2
expect_stderr "both ends are physical"

# The reference itself.
for kind in extended exact; do
    try verify "$scene" --set boundary.kind=$kind --tolerance 1e-13
    expect_exit 0
done

# A wave comes in once, through however wide a layer. 1e-12: roundings of the sum of waves.
try verify "$2/tools/scenes/incoming.toml" --set boundary.kind=exact --tolerance 1e-12
expect_exit 0
expect "it has left" awk '/^energy left/ { exit !($3 < 1e-20 && $NF < 1e-20) }' "$scratch/stdout"

# The table of the page on passive ends, row by row.
page=$2/docs/how-to/passive-ends.md
for end in boundary.order=1 boundary.order=3 boundary.kind=passive; do
    try verify "$scene" --set model.G=1.85 --tolerance 1e-2 --set $end
    expect_exit 0
    row=$(awk '$1 ~ /^0\.[0-9]+$/ && $4 != "-" { printf " %.1e |", $4 }' "$scratch/stdout" | sed 's/e-0/e-/g')
    expect "the page's row of $end:$row" grep -qF "| \`$end\` |$row" "$page"
done

try verify "$scene"
expect_exit 2
expect_stderr "--tolerance is required"
for wrong in 0 -1 nan x; do
    try verify "$scene" --tolerance "$wrong"
    expect_exit 2
done
try verify nosuch.toml --tolerance 1
expect_exit 5
try verify "$scene" --set boundary.right.kind=fixed --tolerance 1
expect_exit 4
finish
