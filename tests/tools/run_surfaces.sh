#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# True surfaces of chains: what is given on them in time, and every mistake of such a scene.
# Usage: run_surfaces.sh NMBCRUN NMBCGEN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
nmbcgen=$2
pull=$3/tools/scenes/surface_pull.toml

refuses() { # CODE MESSAGE ARGUMENT..
    try run "${@:3}" --quiet --out refused
    expect_exit "$1"
    expect_stderr "$2"
    expect "no results of a refused scene" test ! -e refused
}

# The wave of a traction has the displacement int t dt/(rho c) = 1e-3 15 sqrt(pi) behind it.
try run "$pull" --quiet --set output.probes='[200]' --set time.end=400
expect_exit 0
expect_no_stderr
expect "u = -.026587 behind the wave" awk -F, 'END { exit !($2 < -.026586 && $2 > -.026588) }' results/surface_pull_probes.csv
try verify "$pull" --tolerance 2e-5
expect_exit 0
expect_no_stderr
# As much goes out at the right end as came in at the left one; displacements likewise.
for given in traction displacement; do
    try run "$pull" --quiet --set boundary.left.given=$given
    expect_exit 0
    expect "energy in at the left, out at the right" awk \
        '/^went out/ { exit !($3 < -.99 && $3 > -1.001 && $11 > .99 && $11 < 1.001) }' "$scratch/stdout"
done
# As a csv: what is linear between rows.
printf 'time,value\n0,0\n100,-1e-3\n200,0\n' >ramp.csv
try run "$pull" --quiet --set boundary.left.value='{ history = "csv", file = "'"$PWD"'/ramp.csv" }' \
    --set output.probes='[200]' --set time.end=600
expect_exit 0
expect "u = -.1 behind the ramp" awk -F, 'END { exit !($2 < -.09999 && $2 > -.10001) }' results/surface_pull_probes.csv

# A surface node ends chains of bonds.
"$nmbcgen" --family bond1d --horizon 3 --weights 3/2,1/4,1/18 --order 1 --format json --stdout >bonds.json
"$nmbcgen" --family bond1d --horizon 2 --weights 1,1 --order 1 --uncertified --format json --stdout >alike.json
cat >bonds.toml <<'TOML'
[model]
family = "bond1d"
horizon = 3
influence = ["3/2", "1/4", "1/18"]
tables = ["bonds.json"]
[domain]
nodes = 100
[boundary.left]
kind = "snm"
given = "displacement"
[boundary.right]
kind = "snm"
[initial]
shape = "gaussian"
amplitude = 0.01
centre = 50
width = 10
[time]
end = 5000
TOML
try run bonds.toml
expect_exit 0
expect_no_stderr
expect_stdout_line "left      surface node at a displacement of 0"
expect_stdout_line "right     surface node under a traction of 0"
expect "what a surface node allows" grep -q "what a surface node allows" "$scratch/stdout"
expect "the energy stays" awk '/^energy left/ { exit !($3 > .9 && $3 < 1.1) }' "$scratch/stdout"

# Surfaces on the outermost node: the same wave goes in, half a dX later.
for closure in sbp cut; do
    try run "$pull" --quiet --set boundary.left.kind=$closure --set output.probes='[200]' --set time.end=400
    expect_exit 0
    expect_no_stderr
    expect "u = -.026587 behind the wave of $closure" \
        awk -F, 'END { exit !($2 < -.026586 && $2 > -.026588) }' results/surface_pull_probes.csv
done
try verify "$pull" --tolerance 2e-5 --set boundary.left.kind=sbp
expect_exit 0
for given in traction displacement; do
    try run "$pull" --quiet --set boundary.left.kind=sbp --set boundary.left.given=$given
    expect_exit 0
    expect "energy in at the left, out at the right" awk \
        '/^went out/ { exit !($3 < -.99 && $3 > -1.001 && $11 > .99 && $11 < 1.001) }' "$scratch/stdout"
done
# Between two, nothing goes out, and what the outermost nodes have is the body's.
sed '/^\[boundary.left.value\]/,/^$/d; s/^kind = .*/kind = "sbp"/' "$pull" >body.toml
cat >>body.toml <<'TOML'
[initial]
shape = "gaussian"
amplitude = 0.01
centre = 50
width = 10
TOML
try run body.toml
expect_exit 0
expect_stdout_line "boundary  summation by parts under a traction of 0"
expect "what an sbp end allows" grep -q 'what a "sbp" end allows' "$scratch/stdout"
expect "the energy stays" awk '/^energy left/ { exit !($3 > .98 && $3 < 1.001) }' "$scratch/stdout"
expect "nothing went out" awk '/^went out/ { exit !($3 * $3 < 1e-24 && $8 * $8 < 1e-24) }' "$scratch/stdout"
# A body between two is verified beside mirrors through the same nodes.
try verify body.toml --tolerance 1e-2 --set time.cfl=0.5
expect_exit 0
expect_no_stderr
expect_stdout_line "reference  mirror through the outermost node under a traction of 0; mirror through the outermost node under a traction of 0"
try verify body.toml --tolerance 1e-3 --set time.cfl=0.5 --set boundary.left.kind=cut
expect_exit 1
try verify body.toml --tolerance 1e-3 --set boundary.left.kind=mirror --set boundary.right.kind=mirror
expect_exit 2
expect_stderr "the series (7) of SNM 2023 covers: there is none"

# Bars of the bonds of SNM 2023 are verified beside its series (7): figures of docs/evidence/closures.md.
snm_bar() { # CORRECTED MODULUS: snm.toml
    local weights
    weights=$("$nmbcgen" closure snm --horizon 10 $1 | sed -n 's/^options .*--weights //p')
    "$nmbcgen" --family bond1d --horizon 10 --weights "$weights" --order 1 --uncertified --format json --stdout >snm.json
    cat >snm.toml <<TOML
[model]
family = "bond1d"
horizon = 10
influence = ["${weights//,/\", \"}"]
tables = ["snm.json"]
[material]
youngs_modulus = $2
density = 1
[domain]
nodes = 100
spacing = 0.01
[boundary]
kind = "snm"
[boundary.left]
given = "displacement"
[initial]
shape = "gaussian"
amplitude = 0.02
centre = 0.505
width = 0.1
[time]
step = 2e-7
end = 1e-4
TOML
}
series() { # ERROR, of which what verify prints differs by half of its last digit at most
    expect "$1 from the series" awk -v e="$1" '/^series \(7\)/ { found = ($3 / e - 1) ^ 2 < 3e-3 ^ 2 } END { exit !found }' "$scratch/stdout"
}
snm_bar "" 23.75e6
try verify snm.toml --tolerance 1
expect_exit 0
series 0.0936
snm_bar --corrected 25e6
try verify snm.toml --tolerance 1
expect_exit 0
expect_no_stderr
series 0.00179
# Between mirrors the series is what the tolerance is about.
mirrors=(--set boundary.kind=mirror)
try verify snm.toml "${mirrors[@]}" --tolerance 9.3e-4
expect_exit 0
series 0.000926
try verify snm.toml "${mirrors[@]}" --tolerance 9.2e-4
expect_exit 1
for ends in "traction traction" "displacement displacement" "traction displacement"; do
    try verify snm.toml "${mirrors[@]}" --set boundary.left.given="${ends% *}" --set boundary.right.given="${ends#* }" \
        --set time.end=4e-4 --tolerance 5e-3
    expect_exit 0
done
try verify snm.toml "${mirrors[@]}" --set boundary.kind=node_mirror --set initial.centre=0.5 --tolerance 1.1e-3
expect_exit 0

# A chart of true ends compares closures, each beside a mirror about its surface.
try chart snm.toml --quiet
expect_exit 0
expect_no_stderr
expect "closures of bonds" awk -F, 'NR > 1 { kinds[$2]++; if ($3 == 0.4) error[$2] = $11 }
    END { exit !(kinds["mirror"] == 4 && kinds["node_mirror"] == 4 && kinds["snm"] >= 3 && kinds["cut"] == 4 && kinds["sbp"] == 4 && length(kinds) == 5 &&
          error["mirror"] == 0 && error["node_mirror"] == 0 && error["snm"] < 0.02 && error["sbp"] < 0.02 && error["cut"] > 0.1) }' results/snm_chart.csv
expect_file results/snm_chart.svg
try chart body.toml --quiet --set boundary.kind=fixed --set boundary.left.kind=fixed --set boundary.right.kind=free
expect_exit 2
expect_stderr "both ends are fixed or free: a chart compares"
rm snm.toml snm.json

refuses 2 "convex kernels continue the influence of a cubic spline" body.toml --set boundary.left.kind=kernel
# Summation by parts of bonds, which keeps the energy; none may weigh less than 0.
try run bonds.toml --quiet --set boundary.left.kind=sbp --set boundary.right.kind=sbp
expect_exit 0
expect_no_stderr
expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
"$nmbcgen" --family bond1d --horizon 2 --weights 2,-1/10 --order 1 --uncertified --format json --stdout >less.json
refuses 2 'boundary.kind = "sbp": this end is for bonds none of which weighs less than 0' bonds.toml --set model.horizon=2 \
    --set model.influence='[2, "-1/10"]' --set model.tables='["less.json"]' --set boundary.left.kind=sbp --set boundary.right.kind=mirror
# The default step is the closure's limit, whatever its roundings, and the limit that is said can be given.
"$nmbcgen" --family bond1d --horizon 2 --weights 1,1/6 --order 1 --uncertified --format json --stdout >conical.json
conical=(bonds.toml --set model.horizon=2 --set 'model.influence=[1, "1/6"]' --set 'model.tables=["conical.json"]'
    --set boundary.left.kind=sbp --set boundary.right.kind=sbp --set time.end=100)
for spacing in 1 0.1 0.3 0.7; do
    scaled=(--set domain.spacing="$spacing" --set initial.centre="$(awk "BEGIN { print 50 * $spacing }")"
        --set initial.width="$(awk "BEGIN { print 10 * $spacing }")")
    try run "${conical[@]}" --quiet "${scaled[@]}"
    expect_exit 0
    try run "${conical[@]}" --quiet "${scaled[@]}" --set time.step=10
    expect_exit 4
    limit=$(sed -n 's/.*between these ends steps up to \([^ ]*\) .*/\1/p' "$scratch/stderr")
    try run "${conical[@]}" --quiet "${scaled[@]}" --set time.step="$limit"
    expect_exit 0
done
# advise and chart keep a true end, and its steps.
cat >held.toml <<'TOML'
[model]
horizon = 2
G = 1
[domain]
nodes = 200
[boundary]
kind = "passive"
left.kind = "sbp"
[force]
history = "gaussian"
amplitude = 1
centre = 100
time = 100
duration = 50
[time]
end = 400
TOML
try advise held.toml --tolerance 1e-2
expect_exit 0
try chart held.toml --quiet
expect_exit 0
expect "no steps that the closure does not allow" awk -F, 'NR > 1 { rows++; bad += $3 > 0.79 } END { exit bad || rows < 10 }' results/held_chart.csv
# A mirror under a traction reflects as a free end: NMBC is certified opposite it.
for kind in free mirror; do
    try run held.toml --quiet --set boundary.kind=nmbc --set boundary.order=1 --set boundary.left.kind=$kind
    expect_exit 0
    cp "$scratch/stdout" $kind.txt
done
expect "the same" diff <(sed '/^left/d' free.txt) <(sed '/^left/d' mirror.txt)
rm held.toml
# Of a damped bar the ledger knows what the damping took: 934 steps of 400 nodes leave roundings.
for kind in sbp cut node_mirror; do
    try run "$pull" --quiet --set model.damping=1/20 --set boundary.left.kind=$kind --set boundary.right.kind=fixed
    expect_exit 0
    expect "$kind: a ledger that closes" awk '/^ledger drift/ { exit !($3 < 1e-13) }' "$scratch/stdout"
done
refuses 2 'boundary.kind = "kernel": this end is for lattices of one strain a node, such as nopd1d; sbp and cut are for bonds, too; "mirror" ends any lattice' \
    bonds.toml --set boundary.left.kind=kernel
refuses 2 'preload is not known beside an end of kind "sbp"' body.toml --set preload.strain=0.01
refuses 2 "needs at least 8 interior nodes" body.toml --set domain.nodes=7 --set initial.centre=4

refuses 4 "between these ends steps up to" bonds.toml --set time.cfl=0.999
refuses 4 "(cfl = 1.5) are too long: between these ends steps up to" "$pull" --set time.cfl=1.5
expect_stderr "(cfl = 1) are stable. Give time.cfl = 1 or less"
refuses 4 "no certificate for a surface node where several waves have one frequency" bonds.toml \
    --set model.horizon=2 --set model.influence='[1, 1]' --set model.tables='["alike.json"]'
refuses 2 'a surface node ends chains of bonds, such as bond1d, and model.family is nopd1d: take "mirror"' "$pull" \
    --set boundary.left.kind=snm
refuses 2 'boundary.left.value does not count for kind "fixed"' "$pull" --set boundary.left.kind=fixed
refuses 2 'boundary.left.given must be "traction" or "displacement", not "stress"' "$pull" --set boundary.left.given=stress
refuses 2 'boundary.right.given does not count for kind "passive"' "$pull" --set boundary.right.given=traction
refuses 2 "boundary.left.value.amplitude must not be 0" "$pull" --set boundary.left.value.amplitude=0
refuses 2 "boundary.left.value.time lets it begin at t = " "$pull" --set boundary.left.value.time=1e6
refuses 2 "boundary.left.value.time lets it end before the run begins" "$pull" --set boundary.left.value.time=-1e3
refuses 2 "boundary.left.value.centre" "$pull" --set boundary.left.value.centre=3
refuses 5 "cannot read" "$pull" --set boundary.left.value='{ history = "csv", file = "missing.csv" }'
sed '/value/,/^$/d' "$pull" >still.toml
refuses 2 "or a value on a surface" still.toml
try advise "$pull" --tolerance 1e-3
expect_exit 2
expect_stderr "nothing is advised for a scene with a value on a surface"
try run "$pull" --quiet --set boundary.left.value.duration=1 --set time.end=200
expect_stderr "what boundary.left.value sends out is in waves so short that the lattice disperses them"

# A rough start up to the surfaces. Near cfl 1 the energy at whole steps swings; a body that is stable runs all the same,
# and nothing goes out.
awk 'BEGIN { print "node,u,v"; for (i = 1; i <= 40; ++i) print i "," sin(i * i) ",0" }' >rough.csv
cat >rough.toml <<'SCENE'
model = { horizon = 2, G = 1 }
domain = { nodes = 40 }
initial = { shape = "csv", file = "rough.csv" }
time = { end = 1e4 }
SCENE
for kind in free mirror node_mirror sbp; do
    try run rough.toml --quiet --set boundary.kind=$kind
    expect_exit 0
    expect "$kind: nothing goes out" grep -q "^went out     0.000e+00 at the left end, 0.000e+00 at the right one" "$scratch/stdout"
    expect "$kind: a drift of roundings" grep -qE '^ledger drift ([0-9.]+e-1[1-9]|0.0e\+00) of the peak$' "$scratch/stdout"
done

finish
