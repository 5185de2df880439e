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
expect "a header line" grep -qx \
    'time,kinetic,strain,stabilisation,total,staggered,damped,ledger,work,left_end,right_end,drift' \
    results/bar1d.csv
expect "10 rows for 100 steps" test "$(wc -l <results/bar1d.csv)" -eq 11
expect "the last row at t - dt/2" grep -q '^1.99,' results/bar1d.csv
# kinetic + strain + stabilisation = total, in every row
expect "the energies add up" awk -F, 'NR > 1 && ($2 + $3 + $4 - $5)^2 > (1e-14 * $5)^2 { exit 1 }' \
    results/bar1d.csv

try run "$scene" "${short[@]}" --quiet --out elsewhere --set output.name=again
expect_exit 0
expect "four lines only" test "$(wc -l <"$scratch/stdout")" -eq 4
expect_same results/bar1d.csv elsewhere/again.csv

# The ledger: what is there was put in and has not left, through the ends or by damping; to 1e-13 of
# the peak (2744 steps of 500 nodes, where the roundings of some 10 operations add up).
try run "$scene" --quiet --set output.every=1
expect_exit 0
expect "the ledger adds up" awk -F, '
    NR > 1 && $5 > peak { peak = $5 }
    NR > 1 { drift = $12 < 0 ? -$12 : $12; if (drift > worst) worst = drift
             rest = $8 - ($9 - $10 - $11 - $7) - $12; if (rest^2 > (1e-15 * peak)^2) exit 1 }
    END { exit !(worst > 0 && worst < 1e-13 * peak && $10 > 0.49 * peak && $11 > 0.49 * peak) }' \
    results/bar1d.csv
expect "and is reported" grep -qE '^ledger drift [0-9.]+e-1[45] of the peak$' "$scratch/stdout"
expect "what went out" grep -qE '^went out     4\.9[0-9]*e-01 at the left end, 4\.9[0-9]*e-01 at the right one$' \
    "$scratch/stdout"

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
# A given step is taken as it is, but for a drive that takes less.
try run "$scene" "${short[@]}" --set drive.duration=0.001
expect_exit 2
expect_stderr "drive.duration is 0.001, not longer than a time step of 0.02"
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

lacks() { ! LC_ALL=C grep -q "$1" "$2"; }
# Ten million nodes, for two steps.
try run "$scene" --quiet --set domain.nodes=10000000 --set time.end=0.04
expect_exit 0
try run "$scene" --set title='"\u001b[2J"' "${short[@]}"
expect_stdout_line 'scene     \x1b[2J'
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
refuses 2 "a run of 250000 steps is too long for an \"exact\" end, which is made for 200000 at most" \
    "$scene" --set boundary.kind=exact --set time.end=5000
refuses 4 "NMBC2 is not stable at n = 2, G = 1, cfl = 0.0668: a mode at that end grows as exp(" \
    "$scene" --set boundary.left.kind=exact --set boundary.right.order=2 --set model.G=1
refuses 4 "NMBC1 is certified against a pml end at no time step at n = 2, G = 1; cfl = 0.0668" \
    "$scene" --set boundary.left.kind=pml --set boundary.left.layer=10 --set model.G=1
setting 2 "must not be 0" drive.amplitude=0
setting 2 "whole number from 1 to 100000000, not 0" domain.nodes=0
setting 2 "whole number from 1 to 100000000, not 100000001" domain.nodes=100000001
refuses 2 "boundary.layer must be a whole number from 1 to 10000000, not 100000000" \
    "$scene" --set boundary.kind=sponge --set boundary.layer=100000000
# What a scene has in it does not command the terminal.
setting 2 'must be "midpoint" or "explicit", not "\x1b[2J\u009b31m"' 'boundary.ghosts="\u001b[2J\u009b31m"'
setting 2 'boundary.\x1b]0;title is not a key of a scene' $'boundary.\e]0;title=1'
expect "no control character" lacks $'[\x01-\x09\x0b-\x1f\x7f]' "$scratch/stderr"
refuses 5 "cannot read /dev/zero: it is not a regular file" "$scene" --set force.history=csv \
    --set force.centre=250 --set force.file=/dev/zero
setting 2 "steps; at most 1e15" time.step=1e-300
for bad in a/b .. ../a a..b '"a\nb"' '"\u001b[2J"' '""'; do
    setting 2 "output.name must be a file name" "output.name=$bad"
done
setting 2 "output.field must be true or false, not 1" output.field=1
for bad in 0 -1 1.5 true '"2"' nan; do
    setting 2 "output.snapshots must be a whole number from 1 to 100000000" "output.snapshots=$bad"
done
for bad in 0 -1 nan inf true '"2"' '[1]'; do
    setting 2 "output.checkpoint must be a positive number" "output.checkpoint=$bad"
done
setting 2 "output.probes must be a list of numbers, [1, 2.5], not 3" output.probes=3
setting 2 "output.probes must be a list of numbers, each a number; one of them is" 'output.probes=[1, "a"]'
for bad in nan inf 1e301 '[1]' true; do
    setting 2 "output.probes must be a list of numbers, each a number; one of them is" "output.probes=[$bad]"
done
for bad in 0.4 500.6 -3 1e+300; do
    setting 2 "output.probes has $bad, but the nodes are at 1 to 500" "output.probes=[$bad]"
done
setting 2 "output.probes has node 7 twice" 'output.probes=[7, 250, 7.3]'
setting 2 "--set needs KEY=VALUE" time.step
setting 2 "--set needs KEY=VALUE" =3
# What there is instead of a table that there is not.
setting 2 "there is nothing of this family and horizon, but chain1d with horizon 1, nopd1d with horizon 1, 2, 3, 4, 5" model.horizon=7
setting 2 "of this family and horizon there are nopd1d_n2_order1, nopd1d_n2_order2," boundary.order=9
expect "tables of another horizon are not listed" test "$(grep -c nopd1d_n1 "$scratch/stderr")" -eq 0
# The chain of atoms has one horizon and no G.
atoms=$2/tools/scenes/fig6_md.toml
refuses 2 "the lattice of family chain1d has no stabilisation: model.G must be absent or 0, not 0.5" \
    "$atoms" --set model.G='"1/2"'
refuses 2 "no table for family chain1d, horizon 2" "$atoms" --set model.horizon=2
for same in model.G=0 model.horizon=1; do
    try run "$atoms" "${short[@]}" --set "$same" --out "$scratch/atoms"
    expect_exit 0
done

# Sources: none, unfinished ones, keys that say nothing.
sourceless=$scratch/sourceless.toml
sed '/^\[drive\]/,/^$/d' "$scene" >"$sourceless"
refuses 2 "sourceless.toml: nothing starts or drives the scene: it needs at least one of the tables drive, initial," "$sourceless"
# source_of CODE TEXT KEY=VALUE..: the scene with these alone.
source_of() {
    local code=$1 text=$2 settings=()
    shift 2
    for setting; do settings+=(--set "$setting"); done
    refuses "$code" "$text" "$sourceless" "${settings[@]}"
}
source_of 2 "sourceless.toml: initial.shape is missing" initial.width=3
source_of 2 'initial.shape must be "gaussian", "ricker", "packet" or "csv", not "box"' initial.shape=box
source_of 2 "initial.amplitude is missing" initial.shape=gaussian
source_of 2 "initial.amplitude must not be 0" initial.shape=gaussian initial.amplitude=0
pulse=(initial.shape=gaussian initial.amplitude=1 initial.width=3 initial.centre=9)
source_of 2 "initial.width must be a positive number, not 0" "${pulse[@]}" initial.width=0
source_of 2 "initial.wave_number has no meaning for this shape" "${pulse[@]}" initial.wave_number=1
source_of 2 "initial.wave_number must be a number from 0 to pi, not 4" "${pulse[@]}" initial.shape=packet initial.wave_number=4
source_of 2 "initial.wave_number is missing" "${pulse[@]}" initial.shape=packet
source_of 2 'initial.direction must be "both", "right" or "left", not "up"' "${pulse[@]}" initial.direction=up
source_of 2 'initial.direction must be "both" of a velocity' "${pulse[@]}" initial.of=velocity initial.direction=left
source_of 2 "initial.file has no meaning for this shape" "${pulse[@]}" initial.file=a.csv
source_of 2 "initial.widht is not a key of a scene; the nearest one is initial.width" "${pulse[@]}" initial.widht=2
source_of 2 "must be from a tenth to 1e6 of domain.spacing, not 0.01 of it" "${pulse[@]}" initial.direction=right initial.width=0.01
source_of 2 "initial must be a table" initial=3
source_of 2 "initial.file is missing" initial.shape=csv
source_of 2 "initial.centre has no meaning for a csv" initial.shape=csv initial.file=a.csv initial.centre=3
source_of 5 "$scratch/nowhere.csv: No such file" initial.shape=csv initial.file=nowhere.csv
source_of 5 "Is a directory" initial.shape=csv initial.file=.
source_of 2 "force.history is missing" force.centre=9
source_of 2 "force.centre is missing" force.history=sine
force=(force.centre=9 force.amplitude=1)
source_of 2 "force.duration is missing" "${force[@]}" force.history=gaussian
source_of 2 "force.frequency is missing" "${force[@]}" force.history=sine
source_of 2 "force.duration has no meaning for this history" "${force[@]}" force.history=sine force.duration=1
source_of 2 "force.cycles has no meaning for this history" "${force[@]}" force.history=ricker force.cycles=1 force.duration=1 force.time=2
source_of 2 "force.centre and force.half_width select no node" force.centre=-9 force.amplitude=1 force.history=sine force.frequency=1
source_of 5 "nowhere.csv: No such file" "${force[@]}" force.history=csv force.file=nowhere.csv
wave=(incoming.shape=gaussian incoming.amplitude=1 incoming.width=9 incoming.arrival=5 incoming.end=left)
source_of 2 'incoming.end must be "left" or "right", not "both"' "${wave[@]}" incoming.end=both
source_of 2 "incoming.arrival must be a number not below 0" "${wave[@]}" incoming.arrival=-1
source_of 2 "at most 100000 are taken" "${wave[@]}" incoming.arrival=1e9 time.end=1e10
source_of 2 "a damped lattice has no wave that comes from afar" "${wave[@]}" model.damping=1/20 \
    boundary.order=2 boundary.stride=4
source_of 2 "preload.strain must be a number, not nan" preload.strain=nan
source_of 2 "domain.nodes is 1, but NMBC2, stride 1, midpoint ghosts needs at least 2" "${pulse[@]}" \
    boundary.order=2 model.G=1/2 model.horizon=1 domain.nodes=1
source_of 2 "the chain needs at least 4 interior nodes for these ends" "${pulse[@]}" \
    boundary.kind=free domain.nodes=3

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
stable --set boundary.kind=exact
expect_stdout_line "boundary  exact"
stable --set boundary.right.kind=exact --set model.horizon=1 --set model.G=1
expect_stdout_line "right     exact"
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

# Layers: with any end that adds no energy, at 0.99 of the interior's limit, and with an nmbc where
# that is certified for any such end.
layer=(--set boundary.layer=20)
for kind in sponge pml; do
    stable "${layer[@]}" --set boundary.kind=$kind
    expect "the heading" grep -q "^boundary  $kind of 20 nodes, profile 2, target 0.0" \
        "$scratch/stdout"
    for other in fixed free extended pml; do
        stable --set boundary.left.kind=$other "${layer[@]}" --set boundary.right.kind=$kind
    done
    stable "${layer[@]}" --set boundary.left.kind=$kind --set model.horizon=1 --set model.G=0.5
    rm -r results
    unstable "NMBC1 is certified against a $kind end at no time step at n = 2, G = 0; cfl" \
        "${layer[@]}" --set boundary.left.kind=$kind
    unstable "NMBC2 is certified against a $kind end up to cfl = 0.69 only at n = 1, G = 0.5; cfl" \
        "${layer[@]}" --set boundary.right.kind=$kind --set model.horizon=1 --set model.G=0.5 \
        --set boundary.order=2 --set time.cfl=0.8
    try run "$scratch/automatic.toml" "${layer[@]}" --set boundary.kind=$kind --set time.end=4
    expect "just below the limit" grep -qF 'cfl = 0.99): just below' "$scratch/stdout"
    rm -r results
done
# Ends without a certificate run where they are allowed to, at a step that is given.
for kind in higdon mbc; do
    unstable "there is no certificate for a chain with a" --set boundary.right.kind=$kind
    refuses 4 "there is no certificate for this kind" "$scratch/automatic.toml" \
        --set boundary.kind=$kind --set boundary.allow_unstable=true
    try run "$scene" "${short[@]}" --set boundary.kind=$kind --set boundary.allow_unstable=true
    expect_exit 0
    expect_stderr "nmbcrun: warning: there is no certificate for a chain with a"
    rm -r results
done
# The edge effect: a long wave comes back with 1/9 of its energy, and what NMBC1 leaves on top.
try run "$scene" --quiet --set model.horizon=1 --set boundary.kind=mbc \
    --set boundary.allow_unstable=true
expect "a ninth of the energy" awk '/^energy left/ { exit !($3 > 1 / 9 && $3 < 1 / 9 + 6e-4) }' \
    "$scratch/stdout"
rm -r results
refuses 2 "without damping" "$scene" --set boundary.kind=mbc --set boundary.allow_unstable=true \
    --set model.damping=1/100 --set boundary.order=2 --set boundary.stride=2

# Keys that do not count for the kind beside them.
idle() { refuses 2 "$1" "$scene" "${@:2}"; }
idle 'boundary.layer does not count for kind "fixed", which has no keys of its own' \
    --set boundary.kind=fixed "${layer[@]}"
idle 'boundary.right.stride does not count for kind "higdon", whose keys are order' \
    --set boundary.right.kind=higdon --set boundary.right.stride=2
idle 'boundary.target does not count for kind "nmbc", whose keys are order, stride' \
    --set boundary.kind=nmbc --set boundary.target=0.1
sed 's/^order.*/kind = "fixed"\n&/' "$scene" >"$scratch/idle.toml"
refuses 2 'idle.toml:26: boundary.order does not count for kind "fixed"' "$scratch/idle.toml"
stable --set boundary.order=1 --set boundary.right.kind=free
rm -r results
for value in 0 1 -1 nan \"x\"; do
    idle "boundary.target must be a number between 0 and 1, neither of them" \
        "${layer[@]}" --set boundary.kind=pml --set "boundary.target=$value"
done
idle "boundary.profile must be a number from 0 to 10, not 11" \
    "${layer[@]}" --set boundary.kind=pml --set boundary.profile=11
for kind in sponge pml; do
    idle "is of a kind that needs boundary.layer" --set boundary.right.kind=$kind
done
idle "the order of a higdon end is 1 to 10, not 11" --set boundary.kind=higdon \
    --set boundary.order=11 --set boundary.allow_unstable=true

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
refuses 2 "title must be a string in quotes, not {a = {a = " "$scene" --set "title={${deep:0:4080}a=1}"
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
expect_stderr "times its peak before its sources ended"  # found long before anything overflows

# From an initial field the peak counts from the start: what grows later is found.
try run "$2/tools/scenes/broadband.toml" --set boundary.order=2 --set boundary.stride=1 \
    --set boundary.allow_unstable=true
expect_exit 4
expect_stderr "times its peak before its sources ended"
# No energy, and why.
try run "$sourceless" "${short[@]}" --set initial.shape=gaussian --set initial.amplitude=1 \
    --set initial.width=1 --set initial.centre=-1000
expect_exit 4
expect_stderr "there was no energy at any time, so nothing to compare with: initial lies outside of the bar, or"
try run "$sourceless" "${short[@]}" --set force.history=gaussian --set force.amplitude=1 \
    --set force.centre=250 --set force.time=1000 --set force.duration=1
expect_exit 4
expect_stderr "a force or an incoming wave acts at no time of the run"

# Files of a scene are relative to its folder: a force, and the field that a run has left.
mkdir -p "$scratch/scenes"
cp "$sourceless" "$scratch/scenes/fed.toml"
printf 'time,force\n0,0\n1,2\n2,0\n' >"$scratch/scenes/history.csv"
try run "$scratch/scenes/fed.toml" "${short[@]}" --set force.history=csv --set force.file=history.csv \
    --set force.centre=250 --set output.field=true --out "$scratch/scenes"
expect_exit 0
try run "$scratch/scenes/fed.toml" "${short[@]}" --set initial.shape=csv \
    --set initial.file=fed_field.csv --set output.name=more
expect_exit 0
# The force over its two seconds, and at once: the first energy is the last one, half a step on.
expect "it starts with the energy it was left with" awk -F, '
    FNR == 1 { next }
    NR == FNR { last = $6; next }
    FNR == 2 { exit !(($6 / last - 1)^2 < 1e-24) }' "$scratch/scenes/fed.csv" results/more.csv
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
expect_stderr "--resume goes on"
expect_file results/bar1d.csv
expect "and to go on from, a checkpoint and a growing file" test "$(files_in results)" -eq 3

# The shortest run is one step.
try run "$scene" --set time.end=1e-9
expect_exit 0

# A whole number that no double is.
try run "$scene" --set material.youngs_modulus=9223372036854775807
expect_exit 2
expect_stderr 'material.youngs_modulus must be a positive number, not 9223372036854775807'
# An infinity deep in a value that is none.
try run "$scene" --set 'model.horizon=[[1], {d = inf}]'
expect_exit 2
expect_stderr 'model.horizon must be a whole number from 1 to 1000, not [[1], {d = inf}]'

finish
