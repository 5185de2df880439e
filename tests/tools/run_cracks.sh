#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Bond-based scenes: cracks that grow, loads, what a run writes, and every mistake of such a scene.
# Usage: run_cracks.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
plate=$2/tools/scenes/crack_plate.toml
# A smaller one of the plate's glass, pulled harder: it breaks within 300 steps.
cat >small.toml <<'SCENE'
[model]
family = "bond2d"
radius2 = 9
alpha = [1, 1, 1, 1, 1, 1]
[material]
density = 2440
youngs_modulus = 72e9
[domain]
nodes = [80, 40]
spacing = 0.25e-3
[boundary]
kind = "free"
[boundary.right]
kind = "passive"
[fracture]
critical_stretch = 0.0015
cracks = [[0, 5.125e-3, 8e-3, 5.125e-3]]
keep = [[0, 0, 1, 0.8e-3], [0, 9.4e-3, 1, 1]]
[load.top]
kind = "traction"
side = "top"
component = "y"
amplitude = 40e6
[load.bottom]
kind = "traction"
side = "bottom"
component = "y"
amplitude = -40e6
[time]
end = 8e-6
step = 25e-9
[output]
every = 10
snapshots = 100
SCENE

try run small.toml --quiet --out whole
expect_exit 0
expect_no_stderr
cp "$scratch/stdout" "$scratch/report"
expect "bonds that broke, a crack that grew" awk '
    /^bonds  / { broken = $2 > 500 } /^crack  .* from \(0.008, 0.005125\)/ { grown = $5 > 5e-3 }
    END { exit !(broken && grown) }' "$scratch/stdout"
expect "the ledger closes, with the energy of what broke" awk -F, '/^#/ { next }
    /^time/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
    { work = $column["work"]; drift = $column["drift"]; released = $column["fracture"]
      if (drift > 1e-11 * work || drift < -1e-11 * work || released < last) bad = 1
      last = released }
    END { exit bad || released <= 0.01 * work }' whole/small.csv
expect "how it grew" awk -F, 'NR == 1 { bad = $0 != "time,broken,reach_1,X_1,Y_1,branches_1"; next }
    { if ($2 < broken || $3 < reach) bad = 1; broken = $2; reach = $3 } END { exit bad || NR < 30 }' whole/small_cracks.csv
expect "a plate that is the same upside down, bit for bit" python3 - whole <<'PYTHON'
import re, struct, sys
data = open(f"{sys.argv[1]}/small_field.vti", "rb").read()
header, _, rest = data.partition(b'<AppendedData encoding="raw">\n_')
def field(name, components):
    offset = int(re.search(rb'Name="%s"[^>]*offset="(\d+)"' % name, header)[1])
    return struct.unpack_from(f"<{80 * 40 * components}d", rest, offset + 8)
u, damage = field(b"displacement", 3), field(b"damage", 1)
assert max(damage) > 0.4 and min(damage) == 0
for y in range(40):
    for x in range(80):
        here, there = y * 80 + x, (39 - y) * 80 + x
        assert damage[here] == damage[there], (x, y)
        assert u[3 * here] == u[3 * there] and u[3 * here + 1] == -u[3 * there + 1], (x, y)
PYTHON

# Stopped on the way, and gone on.
try run small.toml --quiet --out parts --keep-checkpoint --set time.end=4e-6
expect_exit 0
try run small.toml --quiet --out parts --resume
expect_exit 0
for file in small.csv small_cracks.csv small_field.vti small.pvd; do expect_same "whole/$file" "parts/$file"; done

# A traction, the pressure that is the same, and a file with its course.
printf 'time,force\n0,1\n1,1\n' >steady.csv
try run small.toml --quiet --out pressure --set load.top.kind=pressure --set load.top.amplitude=-40e6
expect_exit 2
expect_stderr "load.top.component has no meaning for a pressure, which acts inwards"
sed 's/kind = "traction"/kind = "pressure"/; /^component/d; s/^amplitude = 40e6/amplitude = -40e6/' small.toml >small_pressure.toml
try run small_pressure.toml --quiet --out pressure --set output.name=small
expect_exit 0
expect_same whole/small_cracks.csv pressure/small_cracks.csv
try run small.toml --quiet --out file --set load.top.file=steady.csv --set load.bottom.file=steady.csv
expect_exit 0
expect_same whole/small_cracks.csv file/small_cracks.csv
# A velocity that is given: the top goes as far as it says.
try run small.toml --quiet --out velocity --set load.top.kind=velocity --set load.top.amplitude=2 --set load.top.rise=4e-6 \
    --set load.bottom.kind=velocity --set load.bottom.amplitude=-2 --set load.bottom.rise=4e-6 --set 'output.probes=[[10e-3, 10e-3]]'
expect_exit 0
expect "the way of 2 t, less what it took to rise" awk -F, 'END { way = 2 * ($1 - 2e-6); exit !($3 > way * 0.999 && $3 < way * 1.001) }' velocity/small_probes.csv

# Default steps in which a load's own way breaks no bond: what breaks had energy, as it has in short
# steps. In those of 1.488e-7 that are stable nothing had, and in 1/20 of the rise a quarter too much.
cat >pulled.toml <<'SCENE'
model = {family = "bond2d", radius2 = 9, alpha = [1, 1, 1, 1, 1, 1]}
material = {density = 2440, youngs_modulus = 72e9}
domain = {nodes = [120, 60], spacing = 0.5e-3}
boundary.kind = "free"
fracture.energy = 135
load.top = {kind = "velocity", side = "top", component = "y", amplitude = 25}
load.bottom = {kind = "velocity", side = "bottom", component = "y", amplitude = -25}
time.end = 1.5e-6
SCENE
sed 's/"velocity"/"displacement", rise = 1e-6/; s/25}/25e-6}/' pulled.toml >displaced.toml
printf 'time,force\n0,0\n1e-6,1\n1.5e-6,1\n' >course.csv
sed 's/rise = 1e-6/file = "course.csv"/' displaced.toml >course.toml
printf 'time,force\n0,1\n1,1\n' >held.csv
sed 's/"velocity"/"velocity", file = "held.csv"/' pulled.toml >held.toml
for scene in pulled displaced course held; do
    try run $scene.toml --out pulled
    expect_exit 0
    expect "no word of jumps" bash -c '! grep -q "critical stretch" "$1"' - "$scratch/stderr"
    expect "why the steps are short" grep -qE "^time  .* steps of 2.52552e-09 .*: load.(top|bottom) moves its nodes by at most a tenth of the critical stretch times dX in each" "$scratch/stdout"
    # All bonds of both rows broke.
    for load in load.top load.bottom; do
        expect_stderr "at the end bonds that hold join the nodes of $load to 0 % of the others: torn or cut off, they no longer load the body"
    done
    # 9.046 in steps of 1e-9; a bond that breaks a tenth of its stretch late has a fifth more at most.
    expect "the energy of short steps" awk '/^bonds  / { exit !($6 + 0 > 9.0 && $6 + 0 < 9.046 * 1.21) }' "$scratch/stdout"
    try run $scene.toml --out pulled --quiet --set time.step=1.488e-7
    expect_stderr "in one step load.top moves its nodes by 5.89 times the critical stretch times dX: bonds may break for that alone. Give time.step below 2.53e-08"
done
# Bonds that are kept, or hold, may be strained without limit; here the upper half is, and its load acts.
try run pulled.toml --out pulled --quiet --set 'fracture.keep=[[0, 25e-3, 1, 1]]' --set load.top.amplitude=25e3 --set time.step=2.5e-9
expect_exit 0
expect_stderr "at the end neighbours are up to 11.4 times dX further apart, or nearer, than at rest: the model is of small strains"
expect_stderr "join the nodes of load.bottom to 0 % of the others"
expect "the load on kept nodes acts" bash -c '! grep -q "join the nodes of load.top" "$1"' - "$scratch/stderr"
try run pulled.toml --out pulled --set 'load={pull = {kind = "force", side = "top", component = "y", amplitude = 1e14}}'
expect "in the first" grep -qE "^time  .*: load.pull moves its nodes by at most a tenth of the critical stretch times dX in the first" "$scratch/stdout"
try run small.toml --quiet --out pulled --set 'drive={component = "y", amplitude = 1e-5, duration = 1e-6, centre = [0.01, 0.005], half_width = [0.001, 0.0001]}'
expect_stderr "in one step drive moves its nodes by 2.09 times the critical stretch times dX"

# Fracture energy in place of a stretch: of the lattice, 1.026 times 12 E delta s0^2/(5 pi).
try run small.toml --quiet --out energy --set fracture.energy=93.4
expect_exit 2
expect_stderr "fracture.energy and fracture.critical_stretch say the same: give one"
sed 's/^critical_stretch = .*/energy = 95.26/' small.toml >by_energy.toml
try run by_energy.toml --out energy --set time.end=1e-6
expect_exit 0
expect "its stretch" grep -qE "bonds break at a stretch of 0.001500?[0-9]*: 95.26 per area along an axis" "$scratch/stdout"
sed 's/^critical_stretch = .*/energy = 1e9/' small.toml >tough.toml
try run tough.toml --quiet --out tough
expect_exit 0
expect "nothing breaks" grep -q "^bonds        0 broken" "$scratch/stdout"
expect "nothing grows" grep -q "has not grown" "$scratch/stdout"

# Cuts that go on have no ends there; a crack that meets another counts it, and its speed ends there.
try run small.toml --quiet --out pieces --set 'fracture.cracks=[[0, 0.005125, 0.004, 0.005125], [0.004, 0.005125, 0.008, 0.005125], [0.004, 0.005125, 0, 0.005125]]' --set time.end=1e-6
expect_exit 0
expect "one end" test "$(grep -c '^crack  ' "$scratch/stdout")" -eq 1
try run small.toml --quiet --out meets --set 'fracture.cracks=[[0, 0.005125, 0.008, 0.005125], [0.0105, 0.005125, 0.0135, 0.005125]]'
expect_exit 0
expect "it met another" grep -qE "from \(0.008, 0.005125\): 0.0(0[6-9]|1)[0-9]* long.*met another crack" "$scratch/stdout"
expect "no speed above c_P" awk '/of c_R/ { sub(/ of c_R.*/, ""); if ($NF > 1.6) bad = 1 } END { exit bad }' "$scratch/stdout"

# Weights below 0: refused, and what happens otherwise.
mixed=(--set 'model.alpha=[22.33336, 3.0, -9.78683, 4.69471, 0.5, -6.07170]')
try run small.toml --quiet "${mixed[@]}"
expect_stderr "with these weights the lattice has waves that grow"
expect_exit 2
mixed=(--set 'model.alpha=[22.33336, 11.20239, -9.78683, -6.07170, 3.04206, 4.69471]' --set boundary.right.kind=free --set time.step=15e-9)
try run small.toml --quiet "${mixed[@]}"
expect_exit 4
expect_stderr "cut off by a free side, its energy is no sum"
try run small.toml --quiet "${mixed[@]}" --set boundary.right.kind=passive
expect_exit 4
expect_stderr "a lattice with bond weights below 0 has no passive side"
mixed+=(--set boundary.allow_unstable=true)
try run small.toml --quiet "${mixed[@]}"
expect_exit 4
expect_stderr "bonds of weights below 0: where others break, its energy has no lower bound, and it explodes"
try run small.toml --quiet "${mixed[@]}" --out mixed --set fracture.allow_unstable=true
expect_exit 4
expect_stderr "the energy is below 0"
expect "so its head says" grep -q '^# stable    not proved: where bonds with weights below 0 end or break' mixed/small.csv

refused() { # CODE TEXT ARGUMENT..
    local code=$1 text=$2
    shift 2
    rm -rf results
    try run small.toml --quiet --out results "$@"
    expect_exit "$code"
    expect_stderr "$text"
    expect "nothing written" test ! -e results/small.csv
}
refused 2 "fracture.critical_stretch must be a positive number, not 0" --set fracture.critical_stretch=0
refused 2 "must be a positive number, not -0.001" --set fracture.critical_stretch=-1e-3
refused 2 "which is outside of the plane" --set 'fracture.cracks=[[0, 1, 8e-3, 1]]'
refused 2 "from a point to itself" --set 'fracture.cracks=[[1e-3, 1e-3, 1e-3, 1e-3]]'
refused 2 "must be a list of four numbers each, [[X1, Y1, X2, Y2], ..], not [1, 2]" --set 'fracture.cracks=[[1, 2]]'
refused 2 "which holds no node" --set 'fracture.keep=[[0, 0, 0.1e-3, 1]]'
refused 2 "model.alpha has length 2; 6 is needed, a number other than 0 for each of the bonds (1, 0), (1, 1), (2, 0), (2, 1), (2, 2), (3, 0)" --set 'model.alpha=[1, 1]'
refused 2 "model.alpha has 0 as number 6; 6 is needed, a number other than 0 for each of the bonds (1, 0)" --set 'model.alpha=[1, 1, 1, 1, 1, 0]'
refused 2 "a side of kind \"sbp\" is for nopd2d" --set boundary.left.kind=sbp
expect "no side is designed before that" bash -c '! grep -q design "$1" "$2"' - "$scratch/stderr" "$scratch/stdout"
refused 2 "model.alpha and model.weights say the same: give one" --set 'model.weights=[1, 1, 1, 1, 1, 1]'
refused 2 "the square of a whole number, not 8, which takes weights" --set model.radius2=8 --set 'model.alpha=[1, 1, 1, 1, 1]'
refused 2 "whose first point is not the lower left one" --set 'fracture.keep=[[1e-2, 1e-2, 0, 0]]'
refused 2 "has -1e+250, which is not a number of size 1e+100 at most" --set 'fracture.cracks=[[-1e250, 5e-3, 8e-3, 5e-3]]'
refused 2 "is before rise" --set load.top.rise=2 --set load.top.until=1
refused 2 "both say how one and the same node moves" --set load.top.kind=velocity --set 'load.other={kind = "velocity", component = "y", amplitude = 1, side = "top"}'
refused 2 "needs a side, or a centre and a half_width" --set 'load={top = {kind = "force", amplitude = 1, component = "y"}}'
refused 2 "bonds have nu = 1/4 in plane strain" --set model.nu=0.25
refused 2 "load.top.side is missing" --set load.top.side= --set 'load={top = {kind = "traction", amplitude = 1, component = "y"}}'
refused 2 "must be tables with names, such as [load.top]" --set load.rise=1
refused 2 "has no meaning for the nodes of a side" --set 'load.top.centre=[1, 1]'
refused 2 "load.top acts on no node of the scene" --set 'load={top = {kind = "velocity", amplitude = 1, component = "y", centre = [9, 9], half_width = [0, 0]}}'
refused 2 "must not be 0" --set load.top.amplitude=0
refused 2 "there is none of bond2d" --set boundary.right.kind=nmbc --set boundary.right.order=2 --set boundary.allow_unstable=true
refused 1 "no_such.csv" --set load.top.file=no_such.csv
try run "$2/tools/scenes/plane_pulse.toml" --set fracture.critical_stretch=1
expect_exit 2
expect_stderr 'needs bonds that can break: model.family = "bond2d"'

# Fig. 12 of Alebrahim 2022: a prototype of other make branches at 64.9 mm; a bond is 0.75 mm.
try run "$plate" --quiet --out plate --set time.end=28e-6
expect_exit 0
expect "the first branch" awk '/ branches at / { sub(/.*branches at \(/, ""); sub(/,.*/, ""); x = $0 - 0.125e-3 }
    END { exit !(x > 64.15e-3 && x < 65.65e-3) }' "$scratch/stdout"
expect "two ways alike" grep -qE "towards -([0-9]+), \1 degrees$" "$scratch/stdout"
finish
