#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The time step of a run: given, certified, matched, or a twentieth of what the sources need.
# Usage: run_time_steps.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/bar.bash"

# cfl instead of step
try run "$scene" "${short[@]}" --set time.cfl=0.5
expect_exit 0
expect "the cfl is reported" grep -q 'cfl = 0.5)' "$scratch/stdout"

# Neither: the largest certified cfl, 0.69 at n = 1, G = 0.
try run "$automatic" --set model.horizon=1 --quiet
expect_exit 0
try run "$automatic" --set model.horizon=1 --set time.end=4
expect "the cfl of the table" grep -q 'cfl = 0.69): the largest certified for NMBC1' "$scratch/stdout"
# A drive shorter than 20 such steps: a twentieth of it.
try run "$automatic" --set time.end=4 --set drive.duration=0.1
expect_exit 0
expect "20 steps of the drive" grep -qF ' steps of 0.005 ' "$scratch/stdout"
expect "what limits it" grep -qF '): a twentieth of drive.duration' "$scratch/stdout"
# A given step is taken as it is, but for a drive that takes less.
try run "$scene" "${short[@]}" --set drive.duration=0.001
expect_exit 2
expect_stderr "drive.duration is 0.001, not longer than a time step of 0.02"
# Matched in time steps: these, whatever the drive says, and no others.
matched=(--set model.horizon=1 --set model.G=0.5 --set boundary.order=2 --set time.end=4
    --set boundary.matched_step=0.5)
needs="NMBC2, stride 1, midpoint ghosts, matched in steps of 1/2 dX/c needs 0.06614173"
try run "$automatic" "${matched[@]}" --set drive.duration=0.1
expect_exit 0
expect_stderr "in waves so short that the lattice disperses them or turns them back; drive.duration ="
expect "its own step" grep -qF 'cfl = 0.5): what the boundary is matched in' "$scratch/stdout"
try run "$automatic" "${matched[@]}" --set time.step=0.4
expect_exit 2
expect_stderr "the time step is 0.4, but $needs"
try run "$automatic" "${matched[@]}" --set boundary.matched_step=1/7
expect_exit 2
expect_stderr "no table for family nopd1d, horizon 1, order 2, stride 1, matched_step 1/7. "
try run "$automatic" "${matched[@]}" --set boundary.ghosts='"explicit"'
expect_exit 2
expect_stderr "a boundary that is matched in time steps needs midpoint ghosts"
try run "$automatic" --set boundary.order=1 --set boundary.matched_step=3/2
expect_exit 2
expect_stderr "NMBC1 is the same in time steps of any length: leave out boundary.matched_step"
expect "no command that nmbcgen would refuse" test "$(grep -c nmbcgen "$scratch/stderr")" -eq 0
# n = 2, N = 3, s = 2: steps of 1 dX/c are cfl 0.625 at G = 2, more than is certified.
long_step=(--set model.horizon=2 --set model.G=2 --set boundary.order=3 --set boundary.stride=2
    --set boundary.matched_step=1 --set time.end=4)
try run "$automatic" "${long_step[@]}"
expect_exit 4
expect_stderr "in steps of 1 dX/c is certified for G from 0.8635583711124968 to 1.8669546617692552"
expect_stderr "To try it, give boundary.allow_unstable = true"
try run "$automatic" "${long_step[@]}" --set boundary.allow_unstable=true
expect_exit 0
expect_stderr "not stable"
# On the edge, (dt/2)^2 = 1/16, a mode neither grows nor dies.
try run "$automatic" --set model.horizon=1 --set model.G=0.5 --set boundary.order=3 \
    --set time.end=4 --set time.cfl=0.5
expect_exit 4
expect_stderr "Certified for these ends is cfl = 0.48"
# Unlike ends: NMBC2 of stride 3 has 0.55 with its like, and less against a fixed end.
unlike=(--set model.horizon=3 --set boundary.order=2 --set boundary.stride=3 --set model.G=4
    --set time.end=4)
try run "$automatic" "${unlike[@]}"
expect_exit 0
like=$(sed -n 's/.*cfl = \([0-9.]*\)).*/\1/p' "$scratch/stdout")
for side in left right; do
    try run "$automatic" "${unlike[@]}" --set boundary.$side.kind=fixed
    expect_exit 0
    expect_no_stderr
    expect "the pair's own limit" grep -qF '): the largest certified for this pair' "$scratch/stdout"
    cfl=$(sed -n 's/.*cfl = \([0-9.]*\)).*/\1/p' "$scratch/stdout")
    expect "$cfl is less than $like by steps of 0.05" awk "BEGIN {
        steps = ($like - $cfl) / 0.05; exit !(steps > 0.5 && (steps - int(steps + 0.5))^2 < 0.01) }"
done
# A free end makes a chain of twice the length with like ends: their step holds.
try run "$automatic" "${unlike[@]}" --set boundary.right.kind=free
expect_exit 0
expect "as like ends" grep -qF "cfl = $like): the largest certified for NMBC2" "$scratch/stdout"
try run "$automatic" --set boundary.right.kind=fixed
expect_exit 4
expect_stderr "no time step is certified for this pair of ends: NMBC1 on the left and a fixed end"
# Why not the first that was tried, which is what its like has.
expect_stderr "not stable together at n = 2, G = 0, cfl = 0.61: "
# Steps that a source wants shorter than any that a table's certificate looked at.
try run "$automatic" --set model.horizon=1 --set model.G=0.5 --set boundary.left.order=3 \
    --set boundary.right.kind=fixed --set time.end=0.5 --set drive.duration=0.001
expect_exit 0
expect "a twentieth of the drive" grep -qF '): a twentieth of drive.duration' "$scratch/stdout"
try run "$automatic" --set boundary.ghosts='"explicit"'
expect_exit 4
expect_stderr "no time step is certified for NMBC1, stride 1, explicit ghosts at G = 0: with midpoint ghosts, NMBC1 with"
try run "$automatic" --set model.horizon=2 --set model.G=1 --set boundary.order=2
expect_exit 4
expect_stderr "at this G: NMBC1 with stride 1, NMBC1 with stride 2, NMBC2 with stride 2"

# Without a step of its own the drive's twentieth holds for the others, too.
sed '/^step/d' "$sourceless" >"$scratch/stepless.toml"
force=(--set force.amplitude=1 --set force.centre=250 --set time.end=4)
wave=(--set incoming.end=right --set incoming.amplitude=1 --set incoming.arrival=1 --set time.end=4)
try run "$scratch/stepless.toml" "${force[@]}" --set force.history=sine --set force.frequency=100
expect "a twentieth of 1/100" grep -qE ' 8000 steps of 0.0005 .*: a twentieth of the period of force.frequency' "$scratch/stdout"
try run "$scratch/stepless.toml" "${force[@]}" --set force.history=ricker --set force.duration=0.1 \
    --set force.time=1
expect "a twentieth of force.duration" grep -qE ' steps of 0.005 .*: a twentieth of force.duration' "$scratch/stdout"
try run "$scratch/stepless.toml" "${wave[@]}" --set incoming.shape=gaussian --set incoming.width=1
expect "a twentieth of its time" grep -qF ': a twentieth of incoming.width / c' "$scratch/stdout"
try run "$scratch/stepless.toml" "${wave[@]}" --set incoming.shape=packet --set incoming.width=100 \
    --set incoming.wave_number=1
expect "a twentieth of its period" grep -qF ': a twentieth of the period of incoming.wave_number' "$scratch/stdout"
# A history from a file does not limit them: what is between two steps is missed, and that is said.
printf 'time,force\n0,0\n1,2\n1.001,0\n' >"$scratch/history.csv"
history=(--set force.history=csv --set force.file=history.csv --set force.centre=250 --set time.end=4)
for command in run verify; do
    try "$command" "$sourceless" "${history[@]}" --tolerance 1 --quiet
    expect_exit 0
    expect_stderr "history.csv has rows 0.001 apart, less than a time step of 0."
    expect_stderr "give time.step = 0.001 or less"
done
try run "$sourceless" "${history[@]}" --set force.half_width=99 --set time.step=0.001 --quiet
expect_exit 0
expect_no_stderr

finish
