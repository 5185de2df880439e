#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Instructions of a step, counted by callgrind: a loop that is no longer vectorised, or a boundary
# that allocates or divides, takes several times as many. The bounds are a tenth above what GCC 12
# makes of -O3 -march=x86-64-v3.
# Usage: run_instructions.sh STEPS_OF_A_CHAIN STEPS_OF_A_PLANE
# Exit code 77: cannot be counted here, and why.
set -euo pipefail
chain=$1
plane=$2
nodes=4000
few_steps=5
many_steps=15
failed=0

skip() {
    echo "skipped: $1"
    exit 77
}
command -v valgrind >/dev/null || skip "valgrind is not installed (apt-get install valgrind)"
grep -qw avx2 /proc/cpuinfo || skip "this processor has no AVX2, which the program is compiled for"

# count PROGRAM PRECISION .. STEPS: instructions of a whole run
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 |
        awk '/Collected/ { found = $4 } END { if (!found) exit 1; print found }'
}

# per_step PROGRAM PRECISION ..: of one step; the start of the program is in both runs
per_step() {
    local few many
    few=$(count "$@" "$few_steps")
    many=$(count "$@" "$many_steps")
    echo $(((many - few) / (many_steps - few_steps)))
}

# at_most WHAT COUNT PER BOUND: COUNT/PER, which is not to be above BOUND, nor below half of it
at_most() {
    local value
    value=$(awk "BEGIN { printf \"%.2f\", $2 / $3 }")
    echo "$1: $value instructions, at most $4"
    if ! awk "BEGIN { exit !($value <= $4 && $value > $4 / 2) }"; then
        echo "FAILED: $1: $value is above $4, or too little to be true"
        failed=1
    fi
}

# Four nodes at once (of float eight) take: 3 to drift (load, multiply-add, store); 6 to be kicked (u
# and 2 u, its own product and the sum, v and store) and 4 a pair of neighbours (load, add, 2 u off,
# multiply-add); 6 to count both loops. n = 1 has 2 pairs, 23 in all; n = 3 has 6.
one=$(per_step "$chain" double 1 0)
three=$(per_step "$chain" double 3 0)
at_most "a node-step, double, n = 1" "$one" "$nodes" 6.7
at_most "a node-step, double, n = 2" "$(per_step "$chain" double 2 0)" "$nodes" 8.7
at_most "a node-step, double, n = 3" "$three" "$nodes" 11.8
at_most "a node-step, float, n = 1" "$(per_step "$chain" float 1 0)" "$nodes" 3.4

# One end: 2n ghosts of 2N + 1 products with their loads, one store, and the loop over N terms.
at_most "a boundary update, n = 1, N = 1" $(($(per_step "$chain" double 1 1) - one)) 2 94
at_most "a boundary update, n = 1, N = 2" $(($(per_step "$chain" double 1 2) - one)) 2 116
at_most "a boundary update, n = 3, N = 1" $(($(per_step "$chain" double 3 1) - three)) 2 215

# Both components of a node of a plane of 500 x 500, and what four passive sides add to it, in
# hundredths: their 3n layers alone are nodes, 2.4 n % of the others.
few_steps=2
many_steps=4
for of_plane in "1 31.9 13.2" "4 52.4 17.5" "9 73.4 23.3"; do
    read -r radius_squared bound sides <<<"$of_plane"
    whole=$(per_step "$plane" double "$radius_squared" fixed)
    at_most "a node-step of a plane, delta^2 = $radius_squared" "$whole" 250000 "$bound"
    passive=$(per_step "$plane" double "$radius_squared" passive)
    at_most "four passive sides, delta^2 = $radius_squared, of a hundred of the plane's" \
        $((100 * (passive - whole))) "$whole" "$sides"
done
exit "$failed"
