#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun: a good run, and every mistake of a scene, an override or the file system.
# Usage: run_nmbcrun.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
short=(--set time.end=2)

# A run: the table and the files on stdout, nothing on stderr, which is no terminal.
try run "$scene" "${short[@]}"
expect_exit 0
expect_no_stderr
expect_stdout_line "scene     bar of Nicely 2018, section 5"
expect_stdout_line "energies     results/bar1d.csv"
expect "a header line" grep -qx 'time,kinetic,strain,stabilisation,total,staggered,damped' \
    results/bar1d.csv
expect "10 rows for 100 steps" test "$(wc -l <results/bar1d.csv)" -eq 11
expect "the last row at t - dt/2" grep -q '^1.99,' results/bar1d.csv
# kinetic + strain + stabilisation = total, in every row
expect "the ledger adds up" awk -F, 'NR > 1 && ($2 + $3 + $4 - $5)^2 > (1e-14 * $5)^2 { exit 1 }' \
    results/bar1d.csv

try run "$scene" "${short[@]}" --quiet --out elsewhere --set output.name=again
expect_exit 0
expect "two lines only" test "$(wc -l <"$scratch/stdout")" -eq 2
expect_same results/bar1d.csv elsewhere/again.csv

# The field: the nodes that the energies count, at the same places in a longer chain, where
# nothing has come to the ends yet (1e-12 of the amplitude: rounding).
expect "no field unless asked for" test ! -e results/bar1d_field.csv
try run "$scene" "${short[@]}" --quiet --set output.field=true
expect_exit 0
expect_stdout_line "field        results/bar1d_field.csv"
try run "$scene" "${short[@]}" --quiet --set output.field=true --set boundary.kind=extended --set boundary.layer=30 \
    --set output.name=longer
expect_exit 0
expect "a header line" grep -qx 'node,x,u,v' results/bar1d_field.csv
expect "driven at node 250, at (57)" awk -F, '
    $1 == 250 { seen = $2 == 250 && ($3 / 0.0025 / (1 - cos(2 * 3.14159265358979 / 12.56)) - 1)^2 < 1e-18 }
    END { exit !(seen && NR == 501 && $1 == 500) }' results/bar1d_field.csv
expect "the same nodes" awk -F, '
    NR == FNR { u[$1] = $3; v[$1] = $4; next }
    FNR > 1 && (($3 - u[$1])^2 + ($4 - v[$1])^2 > (1e-12 * 0.005)^2) { exit 1 }' \
    results/bar1d_field.csv results/longer_field.csv
expect "the kinetic energy of the ledger" awk -F, '
    NR == FNR { kinetic = $2; next }
    FNR > 1 { sum += $4^2 / 2 }
    END { exit !((sum / kinetic - 1)^2 < 1e-18) }' results/bar1d.csv results/bar1d_field.csv
rm results/bar1d_field.csv results/longer*

# cfl instead of step
try run "$scene" "${short[@]}" --set time.cfl=0.5
expect_exit 0
expect "the cfl is reported" grep -q 'cfl = 0.5)' "$scratch/stdout"

# Neither: the largest certified cfl, 0.69 at n = 1, G = 0.
sed '/^step/d' "$scene" >"$scratch/automatic.toml"
try run "$scratch/automatic.toml" --set model.horizon=1 --quiet
expect_exit 0
try run "$scratch/automatic.toml" --set model.horizon=1 --set time.end=4
expect "the cfl of the table" grep -q 'cfl = 0.69): the largest certified for NMBC1' "$scratch/stdout"
# A drive shorter than 20 such steps: a twentieth of it.
try run "$scratch/automatic.toml" --set time.end=4 --set drive.duration=0.1
expect_exit 0
expect "20 steps of the drive" grep -qF ' steps of 0.005 ' "$scratch/stdout"
expect "what limits it" grep -qF '): a twentieth of drive.duration' "$scratch/stdout"
# A given step is taken as it is, and a drive that no step ends in is noticed.
try run "$scene" "${short[@]}" --set drive.duration=0.001
expect_exit 4
expect_stderr "there was no energy at any time"
expect_stderr "time step of 0.02 is too long for drive.duration = 0.001"
# Matched in time steps: these, whatever the drive says, and no others.
matched=(--set model.horizon=1 --set model.G=0.5 --set boundary.order=2 --set time.end=4
    --set boundary.matched_step=0.5)
needs="NMBC2, stride 1, midpoint ghosts, matched in steps of 1/2 dX/c needs 0.06614173"
try run "$scratch/automatic.toml" "${matched[@]}" --set drive.duration=0.1
expect_exit 0
expect_no_stderr
expect "its own step" grep -qF 'cfl = 0.5): what the boundary is matched in' "$scratch/stdout"
try run "$scratch/automatic.toml" "${matched[@]}" --set time.step=0.4
expect_exit 2
expect_stderr "the time step is 0.4, but $needs"
try run "$scratch/automatic.toml" "${matched[@]}" --set boundary.matched_step=1/7
expect_exit 2
expect_stderr "no table for family nopd1d, horizon 1, order 2, stride 1, matched_step 1/7;"
try run "$scratch/automatic.toml" "${matched[@]}" --set boundary.ghosts='"explicit"'
expect_exit 2
expect_stderr "a boundary that is matched in time steps needs midpoint ghosts"
# n = 2, N = 3, s = 2: steps of 1 dX/c are cfl 0.625 at G = 2, more than is certified.
long_step=(--set model.horizon=2 --set model.G=2 --set boundary.order=3 --set boundary.stride=2
    --set boundary.matched_step=1 --set time.end=4)
try run "$scratch/automatic.toml" "${long_step[@]}"
expect_exit 4
expect_stderr "in steps of 1 dX/c is certified for G from 0.8635585299533011 to 1.866963556854298"
expect_stderr "To try it, give boundary.allow_unstable = true"
try run "$scratch/automatic.toml" "${long_step[@]}" --set boundary.allow_unstable=true
expect_exit 0
expect_stderr "not stable"
# Unlike ends: NMBC2 of stride 3 has 0.55 with its like, and less against a fixed end.
unlike=(--set model.horizon=3 --set boundary.order=2 --set boundary.stride=3 --set model.G=4
    --set time.end=4)
try run "$scratch/automatic.toml" "${unlike[@]}"
expect_exit 0
like=$(sed -n 's/.*cfl = \([0-9.]*\)).*/\1/p' "$scratch/stdout")
for side in left right; do
    try run "$scratch/automatic.toml" "${unlike[@]}" --set boundary.$side.kind=fixed
    expect_exit 0
    expect_no_stderr
    expect "the pair's own limit" grep -qF '): the largest certified for this pair' "$scratch/stdout"
    cfl=$(sed -n 's/.*cfl = \([0-9.]*\)).*/\1/p' "$scratch/stdout")
    expect "$cfl is less than $like by steps of 0.05" awk "BEGIN {
        steps = ($like - $cfl) / 0.05; exit !(steps > 0.5 && (steps - int(steps + 0.5))^2 < 0.01) }"
done
# A free end makes a chain of twice the length with like ends: their step holds.
try run "$scratch/automatic.toml" "${unlike[@]}" --set boundary.right.kind=free
expect_exit 0
expect "as like ends" grep -qF "cfl = $like): the largest certified for NMBC2" "$scratch/stdout"
try run "$scratch/automatic.toml" --set boundary.right.kind=fixed
expect_exit 4
expect_stderr "no time step is certified for this pair of ends: NMBC1 on the left and a fixed end"
try run "$scratch/automatic.toml" --set boundary.ghosts='"explicit"'
expect_exit 4
expect_stderr "no time step is certified for NMBC1, stride 1, explicit ghosts at G = 0: with midpoint ghosts, NMBC1 with"
try run "$scratch/automatic.toml" --set model.horizon=2 --set model.G=1 --set boundary.order=2
expect_exit 4
expect_stderr "at this G: NMBC1 with stride 1, NMBC1 with stride 2, NMBC2 with stride 2"

# The peak does not depend on what is written.
try run "$scene" --quiet
cp "$scratch/stdout" "$scratch/often"
try run "$scene" --quiet --set output.every=1000000
expect_same "$scratch/stdout" "$scratch/often"
rm -r results elsewhere

# refuses CODE TEXT ARGUMENT..: that exit code, that text, nothing written.
refuses() {
    local expected=$1 text=$2
    shift 2
    try run "$@"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_stderr_lines 3
    expect_no_stdout
    expect_nothing_written
}

setting() { refuses "$1" "$2" "$scene" --set "$3"; }
setting 2 "model.horizn is not a key of a scene; the nearest one is model.horizon" model.horizn=2
setting 2 "must be a whole number from 1 to 1000, not 0" model.horizon=0
setting 2 "must be a whole number from 1 to 1000, not 1.5" model.horizon=1.5
setting 2 "must be a whole number from 1 to 1000, not 'abc'" model.horizon=abc
setting 2 "no table for family nopd1d, horizon 7" model.horizon=7
setting 2 "must be a table" model=3
setting 2 "no table for family nopd9" model.family=nopd9
for bad in -1 nan inf true; do
    setting 2 "model.G must be a number not below 0" "model.G=$bad"
done
for bad in 1e400 '"-1"' '"1/0"' '"x"' '""'; do
    setting 2 "model.G must be an exact number not below 0" "model.G=$bad"
done
for bad in -1 nan 1e-30 '"1/0"' '"x"'; do
    setting 2 "model.damping must be an exact number not below 0" "model.damping=$bad"
done
setting 2 "model.damping must be a number, or one as a string" model.damping=true
for tau in 7/3 '"14/6"'; do
    setting 2 "order 1, stride 1, damping tau = 7/3; it knows the committed set" "model.damping=$tau"
done
setting 2 "damping tau = 3/10;" model.damping=0.3
setting 2 "damping tau = 2;" model.damping=2
setting 2 "must be \"midpoint\" or \"explicit\", not \"implicit\"" boundary.ghosts=implicit
setting 2 'boundary.left.kind must be "nmbc", "fixed", "free"' boundary.left.kind=open
setting 2 "boundary.allow_unstable must be true or false, not 1" boundary.allow_unstable=1
setting 2 "--set boundary.rigth.kind: boundary.rigth is not a key of a scene" boundary.rigth.kind=free
setting 2 "--set bogus.key: bogus is not a key of a scene" bogus.key=1
setting 2 "no table for family nopd1d, horizon 2, order 9" boundary.right.order=9
setting 2 "above the interior's limit" time.step=0.6
setting 2 "select no node" drive.centre=-99
setting 2 "must not be 0" drive.amplitude=0
setting 2 "whole number from 1 to 100000000, not 0" domain.nodes=0
setting 2 "steps; at most 1e15" time.step=1e-300
for bad in a/b .. ../a a..b '"a\nb"' '"\u001b[2J"' '""'; do
    setting 2 "output.name must be a file name" "output.name=$bad"
done
setting 2 "output.field must be true or false, not 1" output.field=1
setting 2 "--set needs KEY=VALUE" time.step
setting 2 "--set needs KEY=VALUE" =3
setting 3 "pole of a coefficient at G = 0" boundary.order=4
refuses 3 "C(1) = 0" "$scene" --set model.horizon=1 --set model.G=1 --set boundary.order=3
refuses 5 "No such file" nowhere.toml
refuses 5 "Is a directory" /
refuses 2 "SCENE is required"

# Ends that are not stable are refused before anything is written, by themselves ..
unstable() { refuses 4 "$1" "$scene" "${@:2}"; }
unstable "NMBC2 is not stable at n = 2, G = 1, cfl = 0.0668: a mode at that end grows as exp(" \
    --set boundary.order=2 --set model.G=1
unstable "allow_unstable" --set boundary.order=2 --set model.G=1
unstable "sends out a wave of xi dX = 1.9 by itself" \
    --set boundary.order=2 --set model.horizon=1 --set model.G=2
# .. together with their like (n = 2, stride 2: stable from G = 0.7142) ..
unstable "NMBC2 of stride 2 at both ends is not stable at n = 2, G = 0.5" \
    --set boundary.order=2 --set boundary.stride=2 --set model.G=0.5
# .. with another end, on either side ..
unstable "NMBC1 on the left and a fixed end on the right are not stable together at n = 1, G = 0.1" \
    --set model.horizon=1 --set model.G=0.1 --set boundary.right.kind=fixed
unstable "a fixed end on the left and NMBC1 on the right are not stable together" \
    --set boundary.left.kind=fixed --set boundary.right.order=1
# .. or at this time step: NMBC2 at n = 1, G = 1/2 is stable up to cfl = 0.70.
unstable "cfl = 0.8" --set boundary.order=2 --set model.horizon=1 --set model.G=0.5 --set time.cfl=0.8
unstable "cfl = 1" --set boundary.order=2 --set model.horizon=1 --set model.G=0.5 --set time.cfl=1

# Certified, and yet unstable in a chain of 9 nodes; 40 are enough.
short_chain=(--set model.horizon=3 --set boundary.order=3 --set boundary.stride=3 --set model.G=2
    --set drive.centre=5 --set drive.half_width=0.5 --set time.step=0.05)
unstable "in a chain of 9 nodes, so short" "${short_chain[@]}" --set domain.nodes=9

# Pairs that are stable run without a word.
stable() {
    try run "$scene" "${short[@]}" "$@"
    expect_exit 0
    expect_no_stderr
}
for nodes in 30 60; do
    stable --set boundary.kind=free --set domain.nodes=$nodes --set drive.centre=15
done
stable --set boundary.kind=fixed --set model.damping=0.0
expect_stdout_line "boundary  fixed"
stable --set boundary.right.kind=free
expect_stdout_line "left      NMBC1, stride 1, midpoint ghosts"
expect_stdout_line "right     free"
stable --set model.horizon=1 --set model.G=0.5 --set boundary.left.order=3 \
    --set boundary.right.kind=fixed
stable --set model.horizon=2 --set model.G=1 --set boundary.right.order=2 \
    --set boundary.right.stride=2 --set boundary.left.ghosts=midpoint
expect_stdout_line "right     NMBC2, stride 2, midpoint ghosts"
stable --set model.horizon=5
stable "${short_chain[@]}" --set domain.nodes=40
# The wave reaches the ends at t = 33 or so, and the total swings by O(dt^2) only.
try run "$scene" --quiet --set boundary.kind=free --set model.G=1
expect "free ends keep the energy" awk '/^energy left/ { exit !($3 > 0.99) }' "$scratch/stdout"
rm -r results

# Mistakes in the file itself are named with their line.
sed 's/^density/densty/' "$scene" >"$scratch/misspelt.toml"
refuses 2 "misspelt.toml:11: material.densty is not a key" "$scratch/misspelt.toml"
sed '/^horizon/d' "$scene" >"$scratch/missing.toml"
refuses 2 "model.horizon is missing" "$scratch/missing.toml"
{
    cat "$scene"
    echo '[extra]'
} >"$scratch/extra.toml"
refuses 2 "extra is not a key of a scene" "$scratch/extra.toml"
sed '1i "model.G" = 3' "$scene" >"$scratch/quoted.toml"
refuses 2 "is one quoted name" "$scratch/quoted.toml"
sed 's/^step.*/&\ncfl = 0.5/' "$scene" >"$scratch/both.toml"
refuses 2 "has both step and cfl" "$scratch/both.toml"
printf 'a = = 1\n' >"$scratch/garbled.toml"
refuses 2 "garbled.toml:1:" "$scratch/garbled.toml"
: >"$scratch/empty.toml"
refuses 2 "model.horizon is missing" "$scratch/empty.toml"

# Tables in tables are on the stack, so there is an end to them; the deepest that is read.
deep=$(printf 'a.%.0s' {1..20000})
printf '%sa=1' "${deep:0:32764}" >"$scratch/deep.toml"
refuses 2 "model.horizon is missing" "$scratch/deep.toml"
printf '%sa=1' "${deep:0:32766}" >"$scratch/deep.toml"
refuses 2 "deep.toml: a scene has at most 32768 bytes" "$scratch/deep.toml"
refuses 2 "/dev/zero: a scene has at most 32768 bytes" /dev/zero
refuses 2 "is not a key of a scene" "$scene" --set "${deep:0:4094}a=1"
refuses 2 "a key and its value have at most 4096 bytes" "$scene" --set "${deep:0:4096}=1"
refuses 2 "a key and its value have at most 4096 bytes" "$scene" --set "title={${deep:0:4090}a=1}"
refuses 2 "title must be a string in quotes, not { a = { a = " "$scene" --set "title={${deep:0:4080}a=1}"
expect "it is quoted in part" test "$(wc -c <"$scratch/stderr")" -lt 200

# Files that cannot be written; a full disk is a limit of file size here.
refuses 5 "cannot" "$scene" "${short[@]}" --out /proc/nowhere
refuses 5 "cannot" "$scene" "${short[@]}" --out /dev/null/folder
(
    trap '' XFSZ
    ulimit -f 0
    code=0
    "$program" run "$scene" "${short[@]}" --quiet --out full >/dev/null 2>&1 || code=$?
    exit "$((code == 5 ? 0 : 1))"
) || fail "a full disk is noticed, exit code 5"
expect_no_leftovers full
rm -r full

# A run that blows up: exit code 4, with step, node and cause, and the energies up to there.
# (The paper's scalar criterion holds here.)
try run "$scene" --set boundary.order=2 --set model.G=1 --set boundary.allow_unstable=true
expect_exit 4
expect_stdout_line "scene     bar of Nicely 2018, section 5"
expect_stderr "nmbcrun: warning: NMBC2 is not stable at n = 2, G = 1, cfl = 0.0668: a mode"
expect_stderr "is not finite at step"
expect_stderr "not stable together, see the warning"
expect_file results/bar1d.csv
try run "$scene" --set model.horizon=1 --set model.G=0.5 --set boundary.order=2 \
    --set boundary.ghosts=explicit --set time.step=0.1 --set time.end=500 \
    --set boundary.allow_unstable=true
expect_exit 4
expect_stderr "NMBC2 with explicit ghosts is not stable at n = 1, G = 0.5, cfl = 0.756: a mode"
expect_stderr "times its peak while it was driven"  # found long before anything overflows

# Stopped on the way: the energies so far under their own name, and nothing else.
rm -rf results
"$program" run "$scene" --quiet --set time.end=1e7 >"$scratch/stdout" 2>"$scratch/stderr" &
for _ in {1..200}; do  # until it is under way
    compgen -G 'results/*.new-*' >/dev/null && break
    sleep 0.1
done
kill -TERM $!
code=0
wait $! || code=$?
expect_exit 130
expect_stderr "stopped at step"
expect_file results/bar1d.csv
expect "one file only" test "$(files_in results)" -eq 1

# The shortest run is one step.
try run "$scene" --set time.end=1e-9
expect_exit 0

finish
