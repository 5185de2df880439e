#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Plane scenes: the pulse of Table 4 between every kind of side, the band of Table 3.
# Usage: run_plane_sides.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml
band=$2/tools/scenes/plane_band.toml
printed=(--set boundary.kind=nmbc --set boundary.as_printed=true --set boundary.allow_unstable=true --set time.step=0.05)

# energy_left LEAST MOST ARGUMENT..: the run ends with that part of its peak.
energy_left() {
    local least=$1 most=$2
    shift 2
    try run "$@" --quiet
    expect_exit 0
    expect "no warning but of sides that feed" bash -c '! grep -v "strips or a box between its sides grow" "$1"' - "$scratch/stderr"
    expect "energy left of $* between $least and $most" awk -v least="$least" -v most="$most" \
        '/^energy left/ { exit !($3 >= least && $3 <= most) }' "$scratch/stdout"
}
# The default; the lattice without sides, as a prototype found it; the paper's condition, likewise.
energy_left 2.8e-4 3.0e-4 "$scene"
for left in 2:2.8e-4:3.0e-4 4:3.1e-4:3.4e-4 5:3.5e-4:3.8e-4 8:3.7e-4:4e-4 9:3.7e-4:4e-4; do
    IFS=: read -r radius2 least most <<<"$left"
    energy_left "$least" "$most" "$scene" --set model.radius2="$radius2"
done
# Without EdgeTask::light the search ends at a heavy edge, which leaves 6.4e-4.
energy_left 1.8e-4 2.2e-4 "$scene" --set model.radius2=4 --set model.G=2
energy_left 3.5e-5 3.7e-5 "$scene" --set boundary.kind=extended
energy_left 1.70e-3 1.75e-3 "$scene" "${printed[@]}"
energy_left 1.75e-3 1.80e-3 "$scene" "${printed[@]}" --set model.radius2=4 --set model.G=1
energy_left 2.6e-5 2.8e-5 "$scene" --set boundary.kind=higdon --set boundary.allow_unstable=true --set model.G=1
# Made for wide angles, it lets more of the waves that come head-on back.
energy_left 2.4e-4 2.7e-4 "$scene" --set boundary.kind=higdon --set boundary.absorb='["P:30", "S:60"]' \
    --set boundary.allow_unstable=true --set model.G=0.7853981633974483
# More layers, proved as well.
energy_left 7e-5 8.2e-5 "$scene" --set boundary.layer=8
# Searches that do not look at long waves closely end at resonators, which leave 6.6e-4.
energy_left 1.6e-4 1.8e-4 "$scene" --set model.radius2=5 --set model.G=0.25 --set boundary.layer=6
energy_left 0.9 1 "$scene" --set boundary.kind=free
energy_left 0.9 1 "$scene" --set boundary.kind=fixed
energy_left 0.9 1 "$scene" --set boundary.kind=sbp
energy_left 0.01 0.03 "$scene" --set boundary.kind=sponge --set boundary.layer=60
energy_left 3.5e-5 3.6e-5 "$scene" --set boundary.kind=pml --set boundary.layer=20 --set boundary.target=1e-4 \
    --set boundary.allow_unstable=true
energy_left 0.1 0.3 "$scene" --set boundary.left.kind=free --set boundary.top.kind=fixed
energy_left 1e-4 2e-3 "$band" --set model.G=0

# What is known of sides before the run; what has come through an extended one has not gone out.
known=(run "$scene" --set time.end=1 --set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6)
try "${known[@]}"
expect_exit 0
expect_stdout_line "stable    by construction"
# At most at xi dX = 0.05, 0.1 and 0.2; nmbcgen recommend has 0.1.
expect_stdout_line "ends      about 0.002 of the energy of long waves (xi dX = 0.05 to 0.2) that reach passive sides head-on comes back, 0.02 at most up to 45 degrees, 0.07 at 60, more near corners"
try "${known[@]}" --set boundary.left.kind=extended --set boundary.right.kind=sponge --set boundary.right.layer=10 --set boundary.top.kind=fixed
expect_exit 0
expect_stdout_with "comes back, 0.02 at most up to 45 degrees, 0.07 at 60; nothing comes back from extended sides before time.end; nothing is predicted of sides of kind sponge: nmbcrun verify measures it"
expect "a dash" grep -qE '^went out     - left, [0-9.e+-]+ right, [0-9.e+-]+ bottom, 0\.000e\+00 top, of all that was put in$' "$scratch/stdout"
try "${known[@]}" --set boundary.kind=extended --set boundary.layer=2
expect_exit 0
expect_stdout_line "ends      all comes back from the far ends of extended sides, P waves 0.387 after they have passed the side"
try "${known[@]}" --set material.density=1e6 --set initial.width=2
expect_exit 0
expect_stderr "of what initial sends out is in waves so short that the lattice disperses them or turns them back; initial.width ="
expect_stderr "in time.end waves travel 0.01 dX: do the units of material, domain and time belong together?"
try "${known[@]}" --set boundary.allow_unstable=true
expect_exit 0
expect_stderr "boundary.allow_unstable does nothing: no side of this scene may feed energy in"
# What is shorter than steps that are given.
force=(--set 'force={history = "gaussian", component = "x", amplitude = 1, centre = [15, 12], time = 1, duration = 1e-9}')
try "${known[@]}" --set time.cfl=0.5 "${force[@]}"
expect_exit 2
expect_stderr "force.duration is 1e-09, less than a time step of 0.0685: steps meet it by chance only. Give force.duration = 0.069 or more, or time.step = 1e-09 or less"
try "${known[@]}" --set time.cfl=0.5 --set 'drive={component = "x", amplitude = 1, centre = [15, 12], half_width = [1, 1], duration = 0.2}'
expect_exit 2
expect_stderr "drive.duration is 0.2, less than 4 time steps of 0.0685"
try "${known[@]}" --set time.cfl=0.5 --set 'load.short={kind = "force", component = "x", amplitude = 1, centre = [15, 12], half_width = [1, 1], until = 0.06}'
expect_exit 2
expect_stderr "load.short.until is 0.06, less than a time step of 0.0685"
# What all sides but one have no use for is that one's.
try "${known[@]}" --set boundary.kind=fixed --set boundary.left.kind=sponge --set boundary.layer=10
expect_exit 0
try "${known[@]}" --set boundary.kind=extended --set boundary.layer=20
expect_exit 0
expect_stdout_line "ends      nothing comes back from extended sides before time.end"
try "${known[@]}" --set boundary.kind=pml --set boundary.layer=10 --set boundary.allow_unstable=true
expect_exit 0
expect_stdout_line "stable    not proved: sides of kind pml may feed energy in"
try "${known[@]}" --set boundary.kind=free
expect_exit 0
expect_stdout_line "stable    by construction"
expect "no ends to be known" test "$(grep -c '^ends' "$scratch/stdout")" -eq 0
for kind in "passive" "extended --set boundary.layer=20"; do
    # shellcheck disable=SC2086
    try "${known[@]}" --set model.damping=1/10 --set boundary.kind=$kind
    expect_exit 0
    expect_stdout_with "nothing is predicted of sides of kind ${kind%% *}"
done

# Pulled slowly at one side and held at the other, which lie on the outer ones of two lines beyond: u_y = sigma (Y +
# 1)/E, u_x = -nu sigma (X - 21/2)/E.
cat >pulled.toml <<'TOML'
[model]
family = "nopd2d"
radius2 = 1
nu = 0.3
G = 0.5
[domain]
nodes = [20, 10]
[boundary]
kind = "sbp"
[load.top]
kind = "traction"
side = "top"
component = "y"
amplitude = 1e-3
rise = 4000
[load.bottom]
kind = "velocity"
side = "bottom"
component = "y"
amplitude = 0
[time]
end = 4100
[output]
every = 1000
probes = [[20, 10]]
TOML
try run pulled.toml --quiet
expect_exit 0
expect_no_stderr
expect "an even strain" awk -F, 'END { x = -0.3e-3 * 9.5; y = 11e-3; exit !(($2 / x - 1) ^ 2 < 1e-5 && ($3 / y - 1) ^ 2 < 1e-5) }' \
    results/pulled_probes.csv
expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
# Likewise where 13 dX are made longer by as much.
try run pulled.toml --quiet --set load.top.kind=displacement --set load.top.amplitude=13e-3
expect_exit 0
expect_no_stderr
expect "an even strain" awk -F, 'END { x = -0.3e-3 * 9.5; y = 11e-3; exit !(($2 / x - 1) ^ 2 < 1e-5 && ($3 / y - 1) ^ 2 < 1e-5) }' \
    results/pulled_probes.csv
expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
# At larger radii it lies on the outermost of c + n lines, c = max(n, 2) + 1; the larger body swings longer.
for radius in 2:3 4:4 9:6; do
    try run pulled.toml --quiet --set model.radius2="${radius%:*}"
    expect_exit 0
    expect_no_stderr
    expect "an even strain at radius2 = ${radius%:*}" awk -F, -v beyond="${radius#*:}" \
        'END { x = -0.3e-3 * 9.5; y = (10 + beyond) * 1e-3; exit !(($2 / x - 1) ^ 2 < 1e-4 && ($3 / y - 1) ^ 2 < 1e-4) }' \
        results/pulled_probes.csv
    expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
done
# So it is where a spline is the influence, and fields have the nodes of these sides, 5 at each end along both axes;
# convex kernels keep no even strain.
try run pulled.toml --quiet --set model.radius2=8 --set 'model.influence="spline"' --set output.field=true
expect_exit 0
expect_no_stderr
expect "an even strain" awk -F, 'END { x = -0.3e-3 * 9.5; y = 14e-3; exit !(($2 / x - 1) ^ 2 < 1e-4 && ($3 / y - 1) ^ 2 < 1e-4) }' \
    results/pulled_probes.csv
expect "all nodes from (-4, -4) on" grep -qa 'WholeExtent="0 29 0 19 0 0" Origin="-4 -4 0"' results/pulled_field.vti
try run pulled.toml --quiet --set model.radius2=8 --set 'model.influence="spline"' --set boundary.kind=kernel --set domain.nodes='[20, 20]' --set output.format=hdf5 \
    --set output.field=true
expect_exit 0
expect_no_stderr
expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
expect "strains less than the even one, by a part of the volume that its surface has too much" awk -F, \
    'END { even = 16e-3; exit !($3 / even > 0.9 && $3 / even < 0.99) }' results/pulled_probes.csv
expect "all nodes from (-6, -6) on" bash -c 'h5dump -a /nodes results/pulled_field.h5 | grep -qF "X = (i - 6) dX, Y = (j - 6) dX"'
# Two of them meet two passive sides: what comes back, 4.0 % of the pulse, is from the passive sides' own corner.
sed '/^\[load/,$d' pulled.toml >mixed.toml
cat >>mixed.toml <<'TOML'
right.kind = "passive"
top.kind = "passive"
[initial]
shape = "gaussian"
component = "x"
amplitude = 1e-3
centre = [12, 12]
width = 5
[time]
end = 150
TOML
sed -i 's/^nodes.*/nodes = [40, 40]/; s/^radius2.*/radius2 = 4/; s/^nu.*/nu = 0.25/; s/^G.*/G = 0.5/' mixed.toml
try verify mixed.toml --tolerance 0.042 --quiet
expect_exit 0
expect_stdout_with 'at node (40, 40)'
try run mixed.toml --quiet --set boundary.right.kind=free
expect_exit 0
expect "the ledger closes" awk '/^ledger drift/ { exit !($3 < 1e-12) }' "$scratch/stdout"
rm mixed.toml
try run pulled.toml --quiet --out refused --set model.radius2=26
expect_exit 2
expect_stderr 'sides of kind "sbp" are for model.radius2 up to 25, not 26'
sed 's/nopd2d/bond2d/; /^nu\|^G/d; s/^radius2.*/radius2 = 2\nweights = [1, 1]/' pulled.toml >bonds.toml
try run bonds.toml --quiet --out refused
expect_exit 2
expect_stderr 'a side of kind "sbp" is for nopd2d: of bonds, an even strain'
try run bonds.toml --quiet --out refused --set boundary.kind=kernel
expect_exit 2
expect_stderr 'a side of kind "kernel" is for nopd2d: bonds have no gradients'
rm pulled.toml bonds.toml

# A quarter between mirrors: u_x is odd about neither, and even about both.
cat >whole.toml <<'TOML'
[model]
family = "nopd2d"
radius2 = 4
nu = 0.25
G = 0.5
[domain]
nodes = [40, 40]
[boundary]
kind = "free"
[initial]
shape = "gaussian"
amplitude = 1e-3
component = "x"
centre = [20.5, 20.5]
width = 6
[time]
step = 0.4
end = 60
[output]
every = 20
TOML
try run whole.toml --quiet
expect_exit 0
quarter=(--set domain.nodes='[20, 20]' --set initial.centre='[0.5, 0.5]' --set boundary.left.kind=mirror
    --set boundary.left.odd=true --set boundary.bottom.kind=mirror)
try run whole.toml --quiet --out quarter "${quarter[@]}"
expect_exit 0
expect_no_stderr
expect "a quarter of the energies" awk -F, '/^[0-9]/ { if (FNR == NR) whole[$1] = $5; else { rows++; bad += ($5 * 4 / whole[$1] - 1) ^ 2 > 1e-22 } }
    END { exit !(rows >= 7 && !bad) }' results/whole.csv quarter/whole.csv
try run whole.toml --out quarter "${quarter[@]}"
expect_stdout_with "odd mirror"
try run whole.toml --quiet --out refused --set boundary.left.kind=free --set boundary.left.odd=true
expect_exit 2
expect_stderr 'boundary.left.odd does not count for kind "free"'
rm -r whole.toml quarter

# A field that comes in from the layers beside the scene's nodes is no growth. A passive side's layers are few.
for kind in extended passive; do
    try run "$scene" --quiet --set domain.nodes='[40, 40]' --set boundary.left.kind=$kind --set initial.shape=gaussian \
        --set initial.centre='[-12, 20]' --set initial.width=4 --set time.end=6
    expect_exit 0
    if [ $kind = extended ]; then
        expect_no_stderr
    else
        expect_stderr "initial reaches the left side, with 1 of its largest value on the outermost nodes"
        expect_stderr_lines 1
    fi
done
finish
