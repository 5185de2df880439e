#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# A boundary condition that does not exist: exit code 3, one line with the reason and what to do
# instead, nothing on stdout, nothing written. Usage: run_nmbcgen_no_boundary.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project

# does_not_exist ORDER HORIZON G REASON..: in each format, and with --stdout.
does_not_exist() {
    local request=(--order "$1" --horizon "$2" --G "$3")
    shift 3
    local way
    for way in "--format=header" "--format=json" "--stdout"; do
        try "${request[@]}" "$way"
        expect_exit 3
        expect_stderr_lines 1
        expect_no_stdout
        expect_nothing_written
        for text in "does not exist" "$@"; do
            expect_stderr "$text"
        done
    done
}

# The paper's admissible condition: at G = 0 (49) is singular for N >= 2n.
for horizon in 1 2 3; do
    for more in 0 1 2; do
        does_not_exist $((2 * horizon + more)) "$horizon" 0 "G = 0" "block of the Pade table" \
            "every order N >= $((2 * horizon))" "Use an order below $((2 * horizon))"
    done
    try --order $((2 * horizon - 1)) --horizon "$horizon" --G 0 --stdout
    expect_exit 0
done
does_not_exist 2 1 0/5 "G = 0"
does_not_exist 2 1 0.0 "G = 0"

# Matching points.
for case in "0:3,pi/2:1 1 0 group velocity is zero" "0:7,1/2:1 1 0 equations are singular" \
    "0:3,1/2:1 1 0 pole"; do
    read -r points horizon G reason <<<"$case"
    try --match "$points" --horizon "$horizon" --G "$G" --stdout
    expect_exit 3
    expect_stderr_lines 1
    expect_no_stdout
    expect_stderr "$reason"
done

# NMBC1 gains an order.
for case in "1 1" "2 208/85" "3 405/98"; do
    read -r horizon G <<<"$case"
    does_not_exist 2 "$horizon" "$G" "G = $G" "NMBC1 meets its conditions already" singular \
        "Use order 1"
    does_not_exist 3 "$horizon" "$G" "G = $G" "(z-1)^2 times NMBC1" "C(1) = 0" "Use order 1"
    try --order 4 --horizon "$horizon" --G "$G" --stdout
    expect_exit 0
done

does_not_exist 2 2 128/85 "pole" "G = 128/85" "Use order 1"

# Damped: (z-1) and not (z-1)^2, as even Taylor coefficients appear; no block at G = 0, but one
# where the damped symbol is rational.
try --order 2 --horizon 1 --damping 1/10 --G 1
expect_exit 3
expect_stderr "damping 1/10 at G = 1: it would be (z-1) times NMBC1"
expect_stderr "(growth like t)"
try --order 2 --horizon 1 --damping 1/10 --G 0 --uncertified --stdout
expect_exit 0
try --order 3 --horizon 1 --damping 1 --G 2
expect_exit 3
expect_stderr "s is itself a rational function"
expect_stderr "every order N >= 3"

# In time steps: NMBC1 does not see them, and leapfrog itself has a longest step.
try --order 1 --horizon 1 --time-step 1/2
expect_exit 3
expect_stderr "NMBC1 is the same in time steps of any length"
for subcommand in "" reflect; do
    # shellcheck disable=SC2086  # a word or none
    try $subcommand --order 2 --horizon 1 --G 1/2 --time-step 1
    expect_exit 3
    expect_stderr "unstable in steps of 1 dX/c at G = 1/2: cfl = 1, which has to be below 1"
done
try reflect --order 2 --horizon 2 --stride 2 --damping 5 --G 0 --time-step 2
expect_exit 3
expect_stderr "at G = 0, tau = 5: cfl = 0.547"
try --order 2 --horizon 3 --G 1/2 --cfl 1/10000
expect_exit 3
expect_stderr "give --time-step"

# With a stride, G = 0 has no such block; with G left open the condition exists.
try --order 2 --horizon 1 --G 0 --stride 2 --stdout
expect_exit 0
try --order 2 --horizon 1 --stdout
expect_exit 0
expect_nothing_written

finish
