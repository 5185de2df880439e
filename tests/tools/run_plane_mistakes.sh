#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What is said of a plane scene before and after its run, verify, and every mistake of such a scene.
# Usage: run_plane_mistakes.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml
printed=(--set boundary.kind=nmbc --set boundary.as_printed=true --set boundary.allow_unstable=true --set time.step=0.05)

# What is said of steps that a source makes very short, of a force that the lattice does not carry,
# and of strains that are not small.
point=(run "$2/tools/scenes/plane_box.toml" --quiet --set 'domain.nodes=[20, 20]' --set 'force.centre=[10, 10]'
    --set output.probes=[] --set time.end=3 --set force.time=1 --set force.half_width=0 --set model.G=1)
try "${point[@]}" --set force.duration=5 --set force.time=0
expect_exit 0
expect_stderr "of what force sends out is in waves so short that the lattice disperses them"
try "${point[@]}" --set force.duration=1e-3 --set time.end=1.1
expect_exit 0
expect_stderr "1/20 of force.duration, are"
try "${point[@]}" --set force.duration=30 --set force.half_width=8 --set force.time=90 --set force.amplitude=1e-3 --set time.end=210
expect_exit 0
expect_no_stderr
try "${point[@]}" --set force.duration=30 --set force.half_width=8 --set force.time=0 --set force.amplitude=1e3
expect_exit 0
expect_stderr "at the end neighbours are up to"
expect_stderr "the model is of small strains"
# Of an initial field it is known before the run: 10 sqrt(2/e)/3 = 2.86 where a gaussian is steepest, less between two nodes.
try run "$scene" --quiet --set time.end=1 --set 'initial={shape = "gaussian", component = "x", amplitude = 10, width = 3, centre = [20, 20]}'
expect_exit 0
expect "it is told first" grep -qE "^nmbcrun: warning: at the start neighbours are up to 2.[0-9]* times dX further apart, or nearer, than at rest: the model is of small strains" "$scratch/stderr"
# Of one that reaches a side that lets waves out, too.
at_side='initial={shape = "gaussian", component = "x", amplitude = 1e-3, width = 10, centre = [1, 75]}'
try run "$scene" --quiet --set time.end=1 --set "$at_side"
expect_exit 0
expect_stderr "nmbcrun: warning: initial reaches the left side, with 1 of its largest value"
expect_stderr_lines 1
try run "$scene" --quiet --set time.end=1 --set "$at_side" --set boundary.left.kind=fixed
expect_exit 0
expect_no_stderr
# Likewise of a body at rest in a file; with velocities in it, the field may be going out.
{
    echo "x,y,ux,uy"
    for y in $(seq 1 30); do echo "1,$y,1e-3,0"; done
} >rest.csv
sed 's/uy/uy,vx,vy/; s/,0$/,0,-1e-3,0/' rest.csv >leaving.csv
from_file=(--quiet --set time.end=1 --set 'domain.nodes=[30, 30]')
try run "$scene" "${from_file[@]}" --set "initial={shape = \"csv\", file = \"$PWD/rest.csv\"}"
expect_exit 0
expect_stderr "nmbcrun: warning: initial reaches the left side, with 1 of its largest value"
try run "$scene" "${from_file[@]}" --set "initial={shape = \"csv\", file = \"$PWD/leaving.csv\"}"
expect_exit 0
expect "nothing is said of a field that goes out" bash -c '! grep -q "initial reaches" "$0"' "$scratch/stderr"
rm rest.csv leaving.csv
# And of a load that stays on where no side holds the body.
load='load.a={kind = "force", side = "left", component = "x", amplitude = 1e-3, rise = 1}'
try run "$scene" --quiet --set time.end=2 --set "$load"
expect_exit 0
expect_stderr "nmbcrun: warning: load.a stays on, and no side holds the body"
for held in --set\ boundary.right.kind=fixed --set\ load.a.until=1.5; do
    # shellcheck disable=SC2086  # two words
    try run "$scene" --quiet --set time.end=2 --set "$load" $held
    expect_exit 0
    expect_no_stderr
done
rm -r results

# verify: 4 % of the pulse comes back; sides so far off that nothing does.
try verify "$scene" --tolerance 0.05 --quiet
expect_exit 0
expect_stdout_with "within the tolerance"
try verify "$scene" --tolerance 0.01 --quiet
expect_exit 1
expect_stdout_with "above the tolerance"
try verify "$scene" --tolerance 1e-12 --quiet --set boundary.kind=extended
expect_exit 0

# setting CODE TEXT KEY=VALUE..: refused, and nothing is written.
setting() {
    local expected=$1 text=$2 settings=()
    shift 2
    for one in "$@"; do settings+=(--set "$one"); done
    try run "$scene" "${settings[@]}"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_stderr_lines 3
    expect_no_stdout
    expect_nothing_written
}
for bad in -1 1/2 0.6 1; do
    setting 2 "--set model.nu does not fit: Poisson's ratio must be between -1 and 1/2, as of any isotropic solid, not " "model.nu=\"$bad\""
    setting 2 "between -1 and 1/2" "model.nu=\"$bad\"" 'model.state="plane strain"'
done
sed '/^nu/d' "$scene" >stiff.toml
refuses 2 "stiff.toml: model.nu is missing" run stiff.toml
expect "G is not taken for it" test "$(grep -c "meant for it" "$scratch/stderr")" -eq 0
rm stiff.toml
setting 2 "--set domain.nodes: initial.centre puts it outside of the plane, whose nodes are at 1 to 3 along x" 'domain.nodes=[3, 3]'
refuses 2 "--set domain.nodes: output.probes has [31, 59], but the nodes are at 1 to 3 along x" run "$2/tools/scenes/plane_box.toml" --set 'domain.nodes=[3, 3]'
setting 2 'model.influence must be "constant" or "spline"' 'model.influence="cubic"'
setting 2 "of a radius squared of 2, 8, 13, 20, .." 'model.influence="spline"' model.radius2=9
setting 2 "model.influence has length 2; 3 is needed, a number for each squared length of bonds, 1, 2, 4" 'model.influence=[1, 2]' model.radius2=4
setting 2 "model.influence" 'model.influence=[1, 0, 1]' model.radius2=4
setting 2 "model.influence has numbers that are more than 1e+300 times others" 'model.influence=[1e-300, 1, 1e100]' model.radius2=4
setting 2 "passive sides are designed for constant influence" 'model.influence="spline"' model.radius2=2
setting 2 "perfectly matched layers are for constant influence" 'model.influence="spline"' model.radius2=2 boundary.kind=pml boundary.layer=10 \
    boundary.allow_unstable=true
setting 2 "there is none with model.influence" 'model.influence="spline"' model.radius2=2 boundary.kind=nmbc boundary.order=2 boundary.allow_unstable=true
setting 2 'a side of kind "kernel" needs model.influence = "spline"' boundary.kind=kernel
setting 2 'beside sides of kind "sbp" there are none of kind "kernel"' boundary.kind=kernel boundary.left.kind=sbp model.radius2=2 'model.influence="spline"'
setting 2 "tau must be a number not below 0" model.damping=-1
setting 2 "model.damping must be an exact number" model.damping=abc
setting 2 "boundary.order must be 1 beside model.damping" model.damping=1/10 boundary.kind=nmbc boundary.order=2
setting 2 "model.damping must be 0 beside perfectly matched layers" model.damping=0.1 boundary.kind=pml boundary.layer=10 boundary.allow_unstable=true
setting 2 "model.nu must be an exact number, such as 0.25" 'model.nu="1/0"'
setting 2 "must be a sum of two squares" model.radius2=3
for bad in 0 101; do
    setting 2 "model.radius2 must be a whole number from 1 to 100" model.radius2=$bad
done
setting 2 "model.G must be a number not below 0, not -1" model.G=-1
# At radius 1 from (72): 2 pi/15 and 16 pi/45; others are those of docs/how-to/choose-G.md.
sed '/^G /d' "$scene" >stiff.toml
for G in 1:0.42:1.1 2:1.1:3 4:2.9:7.7 5:3.1:8.2 8:6.4:17 9:7:19; do
    IFS=: read -r radius S P <<<"$G"
    refuses 2 "model.G is missing: 0 is standard NOPD, some of whose short waves no side absorbs; $S makes the dispersion of long S waves least at this radius, nu and influence, $P that of P waves" \
        run stiff.toml --set model.radius2="$radius"
    expect "a row of the page" grep -q "^| $radius | *$S | *$P |" "$2/docs/how-to/choose-G.md"
done
rm stiff.toml
setting 2 "model.horizon is of a chain; a plane has model.radius2, its square" model.horizon=1
setting 2 "initial moves no node: its width is 1e-09" initial.width=1e-9
force=('force={amplitude = 1, component = "x", centre = [0.5, 0.25], half_width = 0.25, history = "sine", frequency = 1}')
setting 2 "force acts on no node of the scene: the nearest is at [1, 1], and force.half_width = 0.91 would select it" "${force[@]}"
setting 2 "force acts on no node of the scene: its nodes are at [1, 1] to [150, 275]" "${force[@]}" 'force.centre=[5, 1000]'
drive=('drive={amplitude = 1, component = "x", centre = [5.5, 0.5], half_width = [0.25, 4], duration = 9}')
setting 2 "drive acts on no node of the scene: the nearest is at [6, 1], and drive.half_width = [0.5, 4] would select it" "${drive[@]}"
setting 2 "drive acts on no node of the scene: its nodes are at [1, 1] to [150, 275]" "${drive[@]}" 'drive.centre=[-1, 2]'
setting 2 'must be "nopd2d"' model.family=nopd1d
setting 2 "must be a list [x, y], not one of length 3" "domain.nodes=[1, 2, 3]"
setting 2 "two whole numbers" "domain.nodes=[1.5, 2]"
setting 2 "whose product is at most 100000000" "domain.nodes=[100000, 100000]"
setting 2 'boundary.left.kind must be "passive", "fixed", "free"' boundary.left.kind=open
setting 2 "a periodic side opposite one that is not" boundary.left.kind=periodic
setting 2 "boundary.layer does not fit: a passive side of this family has 2 to 16 layers, not 1" boundary.layer=1
setting 2 "has passive sides of unlike boundary.layer" boundary.left.layer=4
setting 2 "boundary.order does not count for kind \"passive\"" boundary.order=3
setting 2 "needs boundary.layer" boundary.kind=sponge
setting 2 "boundary, with --set boundary.kind, has a pml: it needs boundary.layer, its nodes; it needs boundary.allow_unstable = true, as some such layers grow" boundary.kind=pml
setting 2 'boundary.left has a pml: beside a perfectly matched layer there are pml, fixed, extended, periodic and sponge sides, and none of kind "passive" (bottom, top); it needs boundary.left.layer and boundary.right.layer, its nodes; it needs boundary.allow_unstable = true' \
    boundary.left.kind=pml boundary.right.kind=pml
setting 2 "boundary.left has a sponge, which needs boundary.left.layer" boundary.left.kind=sponge boundary.layer=4
setting 4 "where their losses vary" boundary.kind=pml boundary.layer=10
setting 2 'and none of kind "passive" (right, bottom, top)' boundary.left.kind=pml boundary.left.layer=10 boundary.allow_unstable=true
setting 2 "as_printed, which is (81), beside another order" boundary.kind=nmbc boundary.as_printed=true boundary.order=2
setting 2 "there is no committed table of nopd2d_r1_nu1o4_P, order 3" boundary.kind=nmbc boundary.order=3 \
    boundary.allow_unstable=true
setting 4 "Passive sides are stable by construction" boundary.kind=nmbc
setting 4 "Passive sides are stable by construction" boundary.top.kind=higdon
for bad in '[]' '["P:1", "P:2", "S:3"]'; do
    setting 2 'must have one wave or two, such as ["P:30", "S:60"]' boundary.kind=higdon "boundary.absorb=$bad"
done
for bad in P P:90 Q:3 P:-1 P:nan; do
    setting 2 "has \"$bad\": a wave is P or S and the angle" boundary.kind=higdon "boundary.absorb=[\"$bad\"]"
done
setting 2 'boundary.absorb does not count for kind "passive"' 'boundary.absorb=["P:3"]'
setting 4 "are too long: what is stable between these sides is 0." time.step=1
setting 4 ". Give time.step = 0." time.step=1
setting 4 ". Give time.cfl = 0." time.cfl=2
setting 2 "both step and cfl" time.step=0.01 time.cfl=0.1
setting 2 "steps; at most 1e15" time.end=1e90
setting 2 "at most 100000000 are allowed" boundary.kind=extended time.end=1e6
setting 2 "at most 100000000 are allowed" boundary.kind=sponge boundary.layer=10000000
setting 2 "makes the wave speed sqrt(youngs_modulus / density)" material.density=1e-320
setting 2 "puts it outside of the plane" "initial.centre=[1000, 0]"
setting 2 "puts it outside of the plane" "initial.centre=[10, -50.5]" initial.width=10 initial.shape=gaussian
refuses 2 "force.time lets it begin at t = 1e+06, after time.end = 200" run "$2/tools/scenes/plane_box.toml" \
    --set force.time=1e6
refuses 2 "force.time lets it end before the run begins" run "$2/tools/scenes/plane_box.toml" --set force.time=-41
setting 2 "initial.wave_number must be a number above 0, up to pi [1/dX], not 400" 'initial={shape = "packet", amplitude = 1, centre = [9, 9], width = 9, wave_number = 400, angle = 0, polarisation = "P"}'
setting 2 "initial.wave_number has no meaning for this shape" initial.wave_number=1
setting 2 "initial.component has no meaning for a packet" initial.shape=packet
setting 2 "initial.amplitude has no meaning for a file, which has its own u and v" initial.shape=hdf5
setting 2 "initial.file has no meaning for this shape" initial.file=a.csv
setting 2 "initial.origin has no meaning for this shape" 'initial.origin=[1, 1]'
setting 2 "must be a list of points" "output.probes=[1, 2]"
setting 2 "but the nodes are at 1 to 275 along y" "output.probes=[[1, 276]]"
setting 2 "is not a key of a scene" foo.bar=1
setting 2 "passive sides are designed for model.radius2 up to 25" model.radius2=26
setting 2 "domain.nodes must be" domain.nodes=10
setting 2 "output.name must be a file name" "output.name='a&b'"

# (81) is paired at G = 0.25 in steps up to 0.4 of the longest, which a scene takes. In longer ones it grows.
strip=("$scene" --quiet --set model.G=0.25 --set 'domain.nodes=[8, 40]' --set 'initial.centre=[4, 20]'
    --set initial.width=3 --set time.end=200 --set boundary.kind=nmbc --set boundary.as_printed=true
    --set boundary.allow_unstable=true --set boundary.bottom.kind=periodic --set boundary.top.kind=periodic)
try run "${strip[@]}" --set time.cfl=0.9 --out strip
expect_exit 4
expect_stderr "in steps of 0.103225 (cfl = 0.9) strips or a box between its sides grow: not up to time.step = 0.0458776 (cfl = 0.399)"
expect_stderr "the energy has grown to"
for step in time.step=0.0458776 time.cfl=0.399; do
    try run "${strip[@]}" --set $step --set time.end=9 --out strip
    expect_exit 0
    expect "no strip grows" bash -c '! grep -q "between its sides grow" "$1"' - "$scratch/stderr"
done
try run "${strip[@]}" --set time.cfl=2 --out strip
expect_exit 4
expect_stderr "strips and a box between its sides do not grow up to 0.0458776 (cfl = 0.4). Give time.cfl = 0.4 or less"
try run "${strip[@]}" --out strip
expect_exit 0
# Narrower than the strips that are looked at elsewhere, a plane is one itself.
try run "$scene" --set model.G=0.5 --set 'domain.nodes=[2, 40]' --set 'initial.centre=[1, 20]' --set initial.width=3 --set time.end=1 \
    --set boundary.kind=higdon --set boundary.allow_unstable=true --set boundary.bottom.kind=periodic --set boundary.top.kind=periodic --out strip
expect_exit 0
expect_stdout_with ": 0.8 of what the lattice allows: in longer ones strips or a box between its sides grow"
# Strips between sides of NMBC2 do not grow in 0.6 of the longest steps, and corners do.
try run "$scene" --set model.G=0.5 --set 'domain.nodes=[40, 60]' --set 'initial.centre=[20, 30]' --set time.end=1 --set boundary.kind=nmbc \
    --set boundary.order=2 --set boundary.allow_unstable=true --out strip
expect_exit 0
expect_stdout_with ": 0.4 of what the lattice allows: in longer ones strips or a box between its sides grow"
# Where sides allow shorter steps than the lattice does, a box is looked at in theirs.
try run "$scene" --set model.G=1 --set 'domain.nodes=[40, 60]' --set 'initial.centre=[20, 30]' --set time.end=1 \
    --set boundary.layer=4 --set boundary.left.kind=nmbc --set boundary.left.as_printed=true \
    --set boundary.allow_unstable=true --out strip
expect_exit 0
expect "nine tenths of what sides allow" bash -c '! grep -q "between" "$1"' - "$scratch/stdout"
# Opposite a fixed side it grows in steps of any length, which the report says.
try run "${strip[@]:0:1}" "${strip[@]:2}" --set boundary.right.kind=fixed --set time.end=9 --out strip
expect "no step is steady" grep -q "strips or a box between them grow in a tenth of it, too" "$scratch/stdout"
try run "${strip[@]}" --set boundary.right.kind=fixed --set time.end=9 --out strip
expect_stderr ") strips or a box between its sides grow, as in a tenth of the lattice's longest"
rm -r strip

# A run that grows says so, and what was computed up to there is there.
try run "$scene" "${printed[@]}" --set time.end=400 --set model.radius2=2 --out grown
expect_exit 4
expect_stderr "times what it was at the start, at step"
expect "energies up to there" test -s grown/plane_pulse.csv
finish
