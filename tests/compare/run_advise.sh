#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun advise and run --tolerance: what is said, and that it can be run as it is said. What is
# advised is measured in exam_advise.cpp.
# Usage: run_advise.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
sed '/^step/d' "$scene" >"$scratch/bar.toml"
bar=("$scratch/bar.toml" --set model.G=1.85)

try advise "${bar[@]}" --tolerance 1e-3
expect_exit 0
expect_no_stderr
for what in 'of the ends and of the time step together' 'left out' \
    'NMBC4, stride 1                       not certified at this G' \
    'higdon, mbc                           not certified to be stable' \
    'stored fields                         nobody asked for them'; do
    expect "says: $what" grep -q -- "$what" "$scratch/stdout"
done
expect "ranked by cost, to 5 %" awk '/^meets/ { table = 1; next } /^cost/ { table = 0 }
    table { if ($NF < last - 0.1) exit 1; last = $NF; rows++ } END { exit !(rows >= 6) }' "$scratch/stdout"
settings=$(sed -n 's/^settings   //p' "$scratch/stdout")
# A boundary matched in time steps, whose step is the scene's, has another run to be compared with.
read -ra words <<<"$settings"
try verify "${bar[@]}" "${words[@]}" --tolerance 1e-3 --quiet
expect_exit 0

try run "${bar[@]}" --tolerance 1e-3 --quiet
expect_exit 0
expect "the advice first" grep -q '^advice     --set boundary.kind=' "$scratch/stdout"

# The scene's own step is kept, and then the ends alone count.
try advise "$scene" --set model.G=1.85 --tolerance 1e-5
expect_exit 0
expect "the ends alone" grep -q "in the scene's own time step" "$scratch/stdout"
expect "2744 steps in every row" awk '/^meets/ { table = 1; next } /^cost/ { table = 0 }
    table && !/ 0.091      2744 / { exit 1 }' "$scratch/stdout"

# Nothing gets to the ends: no boundary.
try advise "${bar[@]}" --tolerance 1e-2 --set time.end=20 --quiet
expect_exit 0
expect "no boundary" grep -q '^advice     no boundary (fixed)' "$scratch/stdout"

try advise "${bar[@]}" --tolerance 1e-15
expect_exit 2
expect_stderr "nothing meets the tolerance 1e-15"
try advise "${bar[@]}"
expect_exit 2
try run "${bar[@]}" --tolerance 1e-3 --resume
expect_exit 2
finish
