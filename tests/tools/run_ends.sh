#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Ends: which pairs are stable and run, and which are refused.
# Usage: run_ends.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/bar.bash"

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
# What is said to be the limit is none of the steps that are stable: rounded up, 0.9535 is below 0.954.
beside_sbp=(--set boundary.left.kind=sbp --set boundary.right.stride=2)
unstable "and none above cfl = 0.954 is stable. Give time.cfl = 0.92" \
    --set model.G=1.85 "${beside_sbp[@]}" --set time.cfl=0.99
# Where all steps up to the limit are certified, it is the limit that is named.
unstable "between these ends steps up to 0.236703 (cfl = 0.79) are stable. Give time.cfl = 0.79 or less" \
    --set model.G=1 "${beside_sbp[@]}" --set time.cfl=0.8
# What is named in the place of steps beyond the lattice's own is certified, too.
unstable "steps of 0.264567 (cfl = 2) are too long: these ends are certified in steps of 0.0912755 (cfl = 0.69), $(:
    )and none above cfl = 1 is stable. Give time.cfl = 0.69" \
    --set boundary.order=2 --set model.horizon=1 --set model.G=0.5 --set time.cfl=2
stable --set boundary.order=2 --set model.horizon=1 --set model.G=0.5 \
    --set "time.cfl=$(sed -n 's/.* Give time.cfl = \(.*\)$/\1/p' "$scratch/stderr")"
stable --set model.G=1 "${beside_sbp[@]}" --set time.cfl=0.7906
rm -r results
unstable "are stable, and none is certified" --set boundary.order=2 --set model.G=1 --set time.cfl=2
# A chain too short for the certificate of its ends.
sed '/^step/d' "$sourceless" >"$scratch/short.toml"
refuses 4 "The certificate of these ends, up to cfl = 0.69, holds from 9 nodes on" "$scratch/short.toml" --set domain.nodes=6 \
    --set model.G=1.9046 --set boundary.order=3 --set time.cfl=0.69 --set 'initial={shape = "gaussian", amplitude = 1e-3, width = 1, centre = 3}'
expect_stderr "in a chain of 6 nodes, so short that decaying waves reach the other end, it grows"

# What is certified in its place: for the pair another order and stride, or a shorter step.
unstable "Certified at this G: order 1, stride 2 up to cfl = 0.98; order 2, stride 2 up to cfl = 0.69;" \
    --set model.horizon=1 --set model.G=0.01 --set boundary.right.kind=fixed
expect_stderr 'boundary.kind = "passive" without order and stride.'
expect "the way out in a line of its own" grep -q '^To run it all the same: ' "$scratch/stderr"
# .. where none is, passive ends, or another G.
unstable 'Certified at this G: boundary.kind = "passive" without order and stride;' \
    --set boundary.left.kind=fixed
expect_stderr 'at model.G = "32/15", which suits long waves best: order 1, stride 2 up to'
unstable 'Certified at this G: boundary.kind = "passive" without order and stride;' \
    --set model.horizon=3 --set boundary.right.kind=fixed
expect_stderr 'at model.G = "27/7", which suits'
unstable "Certified for these ends is cfl = 0.69, time.step = 0.09127" \
    --set boundary.order=2 --set model.horizon=1 --set model.G=0.5 --set time.cfl=0.8

# Certified, and yet unstable in a chain of 9 nodes; 40 are enough.
short_chain=(--set model.horizon=3 --set boundary.order=3 --set boundary.stride=3 --set model.G=2
    --set drive.centre=5 --set drive.half_width=0.5 --set time.step=0.05)
unstable "in a chain of 9 nodes, so short" "${short_chain[@]}" --set domain.nodes=9

for nodes in 30 60; do
    stable --set boundary.kind=free --set domain.nodes=$nodes --set drive.centre=15
done
# Passive ends are stable by construction, and need no table of a boundary: also at G = 0, beside any
# other end, and in steps of up to 0.9 of the interior's limit, which they are designed for.
stable --set boundary.kind=passive
expect_stdout_line "boundary  passive"
expect_stdout_line "stable    by construction"
# What it rests on that others are stable: like ends together, unlike ones each by itself.
proved="stable    proved of these ends far apart, at this G in these steps; sampled: that this is far enough"
stable --set boundary.order=2 --set boundary.stride=2 --set model.G=1
expect_stdout_line "$proved"
stable --set boundary.order=2 --set boundary.stride=2 --set model.G=1 --set boundary.right.kind=fixed
expect_stdout_line "$proved"
stable --set boundary.order=1 --set model.G=1
expect_stdout_line "$proved"
# Decaying waves cross a chain of 30 nodes.
stable --set boundary.order=1 --set model.G=1 --set domain.nodes=30 --set drive.centre=15
expect_stdout_line "stable    sampled: the eigenvalues of this chain"
# A surface node has no proof, whatever is opposite.
stable --set model.family=chain1d --set model.horizon=1 --set boundary.right.order=1 --set boundary.left.kind=snm
expect_stdout_line "stable    sampled (docs/reference/scene.md)"
stable --set boundary.order=2 --set boundary.stride=2 --set model.G=1 --set model.damping=1/100
expect_stdout_line "stable    proved of these ends far apart, at this G in these steps; sampled: that this is far enough"
stable --set boundary.kind=passive --set boundary.right.kind=fixed --set model.G=0
stable --set boundary.kind=passive --set boundary.right.kind=nmbc --set boundary.right.order=2 \
    --set boundary.right.stride=2 --set model.G=1
stable --set boundary.kind=passive --set model.horizon=3 --set time.cfl=0.9
rm -r results
refuses 2 'does not count for kind "passive", which has no keys of its own' "$scene" \
    --set boundary.kind=passive --set boundary.order=2
# Where there is no design no table is asked for.
for undesigned in model.damping=1/100 model.damping=1/7 model.family=bond1d; do
    refuses 2 'passive ends are designed for nopd1d of constant influence, undamped' \
        "$scene" --set boundary.kind=passive --set "$undesigned"
done
for command in "run" "verify --tolerance 1"; do
    # shellcheck disable=SC2086  # words
    try $command "$scene" --set boundary.right.kind=passive --set model.horizon=7
    expect_exit 2
    expect_stderr 'passive ends are designed for n up to 6, not 7'
done
refuses 2 'boundary.kind "truncated" and "passive" know model.family = "nopd1d" of constant model.influence without damping, no other lattice' \
    "$scene" --set boundary.kind=truncated --set model.damping=1/100 --set model.G=1 --set boundary.order=2 --set boundary.stride=2 \
    --set boundary.allow_unstable=true

stable --set boundary.kind=exact
expect_stdout_line "boundary  exact"
stable --set boundary.right.kind=exact --set model.horizon=1 --set model.G=1
expect_stdout_line "right     exact"
# It starts from rest.
rm -r results
early=(--set incoming.shape=gaussian --set incoming.amplitude=1 --set incoming.end=left
    --set boundary.kind=exact --set domain.nodes=100 --set model.G=1.85)
refuses 2 "the exact end on the right starts from rest, and something moves there at t = 0: give a later incoming.arrival" \
    "$sourceless" "${early[@]}" --set incoming.width=99 --set incoming.arrival=1
for side in left right; do
    centre=5
    [ $side = right ] && centre=495
    refuses 2 "the exact end on the $side starts from rest, and something moves there at t = 0: initial" \
        "$sourceless" --set boundary.kind=exact --set initial.shape=gaussian --set initial.of=velocity \
        --set initial.amplitude=1 --set initial.width=9 --set initial.centre=$centre
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

# What comes back is said before a run, and an end that sends back more than comes is refused.
try run "$2/tools/scenes/broadband.toml" --set output.name=said
expect_exit 0
expect "what comes back" grep -q '^ends      about 4e-06 of the energy that reaches them comes back, most at xi dX = 0.9' \
    "$scratch/stdout"
expect "and came back" grep -q '^energy left  3.669e-06 of the peak' "$scratch/stdout"
rm -r results
cat >"$scratch/steel.toml" <<'END'
[model]
horizon = 3
G = 0
[material]
density = 7850
youngs_modulus = 2.1e11
[domain]
nodes = 400
spacing = 0.0025
[force]
history = "ricker"
amplitude = 1e9
centre = 0.5
time = 1e-5
duration = 2e-6
[time]
end = 4e-4
END
refuses 4 "NMBC1, stride 1, midpoint ghosts on the left sends back up to 6.2 times the energy that comes" \
    "$scratch/steel.toml"
# order 1, stride 1 amplifies this source there, too: it is not named
refuses 4 'Certified and absorbing at this G: boundary.kind = "passive" without order and stride;' \
    "$scratch/steel.toml"
expect_stderr 'at model.G = "27/7", which suits long waves best: order 1, stride 3 up to cfl = 0.82; order 2, stride 3 up to cfl ='
refuses 4 "of what force sends out is in waves so short that the lattice disperses them or turns them back; no force.duration within a factor of 1000 cures it" \
    "$scratch/steel.toml"
refuses 4 "lattice disperses them or turns them back; force.duration = 3.2e-06 with force.time = 1.3e-05 would do" \
    "$scratch/steel.toml" --set model.G=27/7
try run "$scratch/steel.toml" --set boundary.allow_amplifying=true
expect_exit 0
expect_stderr "nmbcrun: warning:"
expect "more than comes" grep -q '^ends      [1-9].* times the energy that reaches them comes back' "$scratch/stdout"
rm -r results
# What is named there does run.
try run "$scratch/steel.toml" --set boundary.kind=passive
expect_exit 0
rm -r results
# Steps that do not resolve a source, of which nothing is predicted then.
refuses 2 "force.duration is 1e-09, less than a time step of 3.74e-07: steps meet it by chance only. Give force.duration = 3.8e-07 or more" \
    "$scratch/steel.toml" --set model.horizon=2 --set model.G=32/15 --set boundary.kind=passive --set force.duration=1e-9 --set time.cfl=0.5
# Its few steps lie between two looks at the energy.
for time in 4e-5 4.05e-5; do
    try run "$scratch/steel.toml" --set model.horizon=2 --set model.G=1.5 --set domain.spacing=1e-3 \
        --set boundary.left.kind=free --set force.history=gaussian --set force.centre=1e-3 \
        --set force.time=$time --set force.duration=1e-7 --set time.cfl=0.25 --quiet \
        --set boundary.allow_amplifying=true
    expect_exit 0
done
try run "$scratch/steel.toml" --set model.G=27/7 --set force.duration=6e-6 --set force.time=4e-5
expect_exit 0
expect_no_stderr
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
    unstable "NMBC1 is certified against a $kind end at no time step at n = 2, G = 0; the step has cfl" \
        "${layer[@]}" --set boundary.left.kind=$kind
    unstable "NMBC2 is certified against a $kind end up to cfl = 0.69 only at n = 1, G = 0.5; the step has cfl" \
        "${layer[@]}" --set boundary.right.kind=$kind --set model.horizon=1 --set model.G=0.5 \
        --set boundary.order=2 --set time.cfl=0.8
    try run "$automatic" "${layer[@]}" --set boundary.kind=$kind --set time.end=4
    expect "just below the limit" grep -qF 'cfl = 0.99): just below' "$scratch/stdout"
    rm -r results
done
# Ends without a certificate run where they are allowed to, at a step that is given.
for kind in higdon truncated; do
    unstable "there is no certificate for a chain with a" --set boundary.right.kind=$kind
    refuses 4 "there is no certificate for this kind" "$automatic" \
        --set boundary.kind=$kind --set boundary.allow_unstable=true
    try run "$scene" "${short[@]}" --set boundary.kind=$kind --set boundary.allow_unstable=true
    expect_exit 0
    expect_stderr "nmbcrun: warning: there is no certificate for a chain with a"
    rm -r results
done
# The edge effect: a long wave comes back with 1/9 of its energy, and what NMBC1 leaves on top.
try run "$scene" --quiet --set model.horizon=1 --set boundary.kind=truncated \
    --set boundary.allow_unstable=true
expect "a ninth of the energy" awk '/^energy left/ { exit !($3 > 1 / 9 && $3 < 1 / 9 + 6e-4) }' \
    "$scratch/stdout"
rm -r results
refuses 2 "without damping" "$scene" --set boundary.kind=truncated --set boundary.allow_unstable=true \
    --set model.damping=1/100 --set boundary.order=2 --set boundary.stride=2

finish
