#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Plane scenes: the pulse of Table 4 between every kind of side, the band of Table 3, what a run
# writes, verify, and every mistake of such a scene.
# Usage: run_plane.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml
band=$2/tools/scenes/plane_band.toml
printed=(--set boundary.kind=nmbc --set boundary.as_printed=true --set boundary.allow_unstable=true --set time.step=0.05)

expect_stdout_with() { expect "'$1' on stdout" grep -qF -- "$1" "$scratch/stdout"; }

# energy_left LEAST MOST ARGUMENT..: the run ends with that part of its peak.
energy_left() {
    local least=$1 most=$2
    shift 2
    try run "$@" --quiet
    expect_exit 0
    expect "no warning but of sides that feed" bash -c '! grep -v "strips between its sides grow" "$1"' - "$scratch/stderr"
    expect "energy left of $* between $least and $most" awk -v least="$least" -v most="$most" \
        '/^energy left/ { exit !($3 >= least && $3 <= most) }' "$scratch/stdout"
}
# The default; the lattice without sides, as a prototype found it; the paper's condition, likewise.
energy_left 2.9e-4 3.2e-4 "$scene"
energy_left 3.5e-5 3.7e-5 "$scene" --set boundary.kind=extended
energy_left 1.70e-3 1.75e-3 "$scene" "${printed[@]}"
energy_left 1.75e-3 1.80e-3 "$scene" "${printed[@]}" --set model.radius2=4 --set model.G=1
energy_left 2.6e-5 2.8e-5 "$scene" --set boundary.kind=higdon --set boundary.allow_unstable=true --set model.G=1
# Made for wide angles, it lets more of the waves that come head-on back.
energy_left 2.4e-4 2.7e-4 "$scene" --set boundary.kind=higdon --set boundary.absorb='["P:30", "S:60"]' \
    --set boundary.allow_unstable=true --set model.G=0.7853981633974483
# More layers, proved as well.
energy_left 9.5e-5 1.1e-4 "$scene" --set boundary.layer=4
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
# As nmbcgen recommend has it for this lattice.
expect_stdout_line "ends      about 0.004 of the energy of long waves (xi dX = 0.1) that reach passive sides head-on comes back, 0.02 at most up to 45 degrees, 0.07 at 60, more near corners"
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
expect_stderr "until time.end waves go 0.01 dX: do the units of material, domain and time belong together?"
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
# Two of them meet two passive sides: what comes back, 4.1 % of the pulse, is from the passive sides' own corner.
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

# A field that comes in from the layers beside the scene's nodes is no growth.
for kind in extended passive; do
    try run "$scene" --quiet --set domain.nodes='[40, 40]' --set boundary.left.kind=$kind --set initial.shape=gaussian \
        --set initial.centre='[-12, 20]' --set initial.width=4 --set time.end=6
    expect_exit 0
    expect_no_stderr
done

# Energy never rises beside passive sides, and the ledger closes.
try run "$scene" --quiet --set time.end=60 --set output.every=5 --set 'output.probes=[[75, 137], [1, 275]]' \
    --set output.field=true --set output.snapshots=200 --out out --plot
expect_exit 0
expect_no_stderr
for picture in energy.svg energy.png fields.png fields.gif field.png field_energy.png fields_energy.png; do
    expect_stdout_with "picture      out/plane_pulse_$picture"
    expect "$picture" test -s out/plane_pulse_$picture
done
expect "a film" grep -qa '^GIF89a' out/plane_pulse_fields.gif
# Rounded to four digits each (5e-5), and energy left is of the peak, which differs by 4e-4 of these 3e-5.
expect "what went out and what is left are all" awk '/^energy left/ { sum += $3 } /^went out/ { for (i = 3; i <= 9; i += 2) sum += $i }
    END { exit !((sum - 1) ^ 2 < 2e-4 ^ 2) }' "$scratch/stdout"
expect "total falls, the ledger closes to rounding" awk -F, '/^#/ { next }
    /^time/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
    { rows++
      total = $column["total"]; out = $column["left_side"] + $column["right_side"] + $column["bottom_side"] + $column["top_side"]
      if (rows == 1) first = total
      if ($column["drift"] > 1e-12 * first || $column["drift"] < -1e-12 * first) bad = 1
      if (out < last_out || (rows > 1 && $column["ledger"] > last * (1 + 1e-12))) bad = 1
      last = $column["ledger"]
      last_out = out }
    END { exit bad || rows < 100 || total > 3e-4 * first }' out/plane_pulse.csv
expect "probes of two nodes" awk -F, '
    NR == 1 { bad = $0 != "time,ux_75_137,uy_75_137,vx_75_137,vy_75_137,ux_1_275,uy_1_275,vx_1_275,vy_1_275"; next }
    NF != 9 { bad = 1 } END { exit bad || NR < 100 }' out/plane_pulse_probes.csv
expect "a field that VTK readers take" python3 - out <<'PYTHON'
import os, re, struct, sys
folder = sys.argv[1]
series = open(f"{folder}/plane_pulse.pvd").read()
files = re.findall(r'timestep="([^"]+)" file="([^"]+)"', series)
assert len(files) == 4 and files[0][0] == "0", files
for path in [f"{folder}/{name}" for _, name in files] + [f"{folder}/plane_pulse_field.vti"]:
    data = open(path, "rb").read()
    header, _, rest = data.partition(b'<AppendedData encoding="raw">\n_')
    assert b'WholeExtent="0 149 0 274 0 0"' in header
    arrays = re.findall(rb'Name="(\w+)" NumberOfComponents="(\d)" format="appended" offset="(\d+)"', header)
    assert [name for name, _, _ in arrays] == [b"displacement", b"velocity", b"energy"]
    for _, components, offset in arrays:
        size, = struct.unpack_from("<Q", rest, int(offset))
        assert size == 150 * 275 * int(components) * 8, size
    assert rest[int(offset) + 8 + size:].startswith(b"\n</AppendedData>")
# The energies of all nodes, dX = 1, are those of the last row of the table, at the same time: two sums of 41 250 terms.
energy = struct.unpack_from(f"<{150 * 275}d", rest, int(offset) + 8)
rows = [line.split(",") for line in open(f"{folder}/plane_pulse.csv") if not line.startswith("#")]
total = float(rows[-1][rows[0].index("total")])
assert min(energy) >= 0 and abs(sum(energy) - total) < 1e-11 * total, (sum(energy), total)
first = open(f"{folder}/{files[0][1]}", "rb").read().partition(b'raw">\n_')[2]
u = struct.unpack_from("<3d", first, 8 + (136 * 150 + 74) * 24)  # node (75, 137), r = 1/2
assert u[0] == 0 and abs(u[1] - 0.0009998286624877785) < 1e-18 and u[2] == 0, u
PYTHON
try run "$scene" --quiet --set time.end=1 --set output.field=true --set output.snapshots=5 --set output.format=hdf5 --out out --plot
expect_exit 0
expect_no_stderr
expect_stdout_with 'no picture   of the snapshots: their format is not "vtk"'
expect_stdout_with 'no picture   of the field: its format is not "vtk"'
expect "no fields of the run before" test ! -e out/plane_pulse.pvd -a ! -e out/plane_pulse_field.vti
expect "node (75, 137) by its link" bash -c 'h5dump -d /displacement/000000000 -s 136,74,0 -c 1,1,3 -m %.17g out/plane_pulse.h5 |
    grep -q "(136,74,1): 0.00099982866248777[0-9]*,"'
expect "an XDMF of files that are there" python3 - out <<'PYTHON'
import os, sys, xml.etree.ElementTree as xml
folder = sys.argv[1]
grids = xml.parse(f"{folder}/plane_pulse.xdmf").getroot().findall("Domain/Grid/Grid")
assert [float(grid.find("Time").get("Value")) for grid in grids][0] == 0 and len(grids) > 1
for grid in grids:
    assert grid.find("Topology").get("Dimensions") == "1 275 150"
    for item in grid.findall("Attribute/DataItem"):
        assert os.path.exists(f"{folder}/{item.text.split(':')[0]}"), item.text
PYTHON
# A piece of its field starts another run: node (75, 137) is (25, 37) there. What a run reads it does not replace.
sed '/^\[initial\]/,/^$/d' "$scene" >piece.toml
printf '[initial]\nshape = "hdf5"\norigin = [-49, -99]\nfile = "out/plane_pulse_field.h5"\n' >>piece.toml
piece=(run piece.toml --quiet --set 'domain.nodes=[50, 75]')
try "${piece[@]}" --set 'output.probes=[[25, 37]]' --set time.end=1
expect_exit 0
expect_no_stderr
h5dump -d /displacement -s 136,74,0 -c 1,1,3 -m %.17g out/plane_pulse_field.h5 >node
expect "the node's displacement" awk -F, '
    /\(136,74,1\)/ { sub(/.*: /, ""); there = $1 + 0 }
    /^0,/ { here = $3 + 0 }
    END { exit !(here != 0 && here == there) }' node results/piece_probes.csv
for read in plane_pulse_field.h5 plane_pulse_snapshots/000000005.h5; do
    try "${piece[@]}" --out out --set output.name=plane_pulse --set initial.file=out/$read
    expect_exit 2
    expect_stderr "the scene reads out/$read, which this run would replace or remove"
    expect_no_stdout
done
try "${piece[@]}" --out out --set initial.file=out/plane_pulse.h5
expect_exit 2
expect_stderr "out/plane_pulse.h5: 'displacement' is a group of datasets, where one dataset is needed"
rm -r out results piece.toml node

# A run that is killed, and one that is stopped, go on byte for byte.
common=(--set output.format=hdf5 --set output.snapshots=300 --set output.field=true --set 'output.probes=[[10, 10]]' --set output.checkpoint=0.1
    --set model.G=1 --set time.step=0.04 --set boundary.allow_unstable=true --set time.end=40 --quiet)
for sides in "boundary.left.kind=higdon" "boundary.kind=pml boundary.layer=10"; do
    kept=("${common[@]}")
    for one in $sides; do kept+=(--set "$one"); done
    try run "$scene" "${kept[@]}" --out whole
    expect_exit 0
    "$program" run "$scene" "${kept[@]}" --out stopped >"$scratch/stdout" 2>&1 &
    running=$!
    until [ -e stopped/plane_pulse.checkpoint ]; do sleep 0.01; done
    kill -KILL $running
    wait $running 2>/dev/null || true
    try run "$scene" --resume --out stopped "${kept[@]}" --set model.G=0.5
    expect_exit 2
    expect_stderr "there model.G is 1, here 0.5"
    # Nothing that it has kept is lost, or replaced by nothing, where its files are gone or the disk is full.
    first=$(echo stopped/plane_pulse_snapshots.new-*)/000000000.h5
    mv $first first.h5
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "$first is missing: the run cannot go on from its checkpoint"
    head -c 1000 first.h5 >$first
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "$first is too short"
    mv first.h5 $first
    probes=$(echo stopped/plane_pulse_probes.csv.new-*)
    cp "$probes" probes.csv
    printf 'x' | dd of="$probes" bs=1 conv=notrunc status=none
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "it was changed since the checkpoint"
    cp probes.csv "$probes"
    rm probes.csv
    expect "its snapshots stay" test -s $first
    code=0
    (
        ulimit -f 20
        exec "$program" run "$scene" "${kept[@]}" --set output.checkpoint=1e9 --resume --out stopped
    ) >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
    expect_exit 5
    expect_stderr "File too large. --resume goes on from stopped/plane_pulse.checkpoint"
    expect "its snapshots stay" test -s $first
    "$program" run "$scene" "${kept[@]}" --resume --out stopped >"$scratch/stdout" 2>&1 &
    running=$!
    sleep 0.3
    kill -TERM $running 2>/dev/null || true  # SIGINT is ignored in the background of a script
    wait $running || true
    if [ -e stopped/plane_pulse.checkpoint ]; then
        try run "$scene" "${kept[@]}" --resume --out stopped
        expect_exit 0
    fi
    expect "the same files, byte for byte" diff -r whole stopped
    expect_no_leftovers stopped
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "there is no such file"
    rm -r whole stopped
done

# .. and with their own snapshots, where a run that starts anew has been killed behind their step: of a run that was
# stopped they are published, of one that was killed they still grow.
"$program" run "$scene" "${common[@]}" --out whole >"$scratch/stdout" 2>&1
for signal in TERM KILL; do
    "$program" run "$scene" "${common[@]}" --out stopped --set output.checkpoint=1e-9 >"$scratch/stdout" 2>&1 &
    running=$!
    until [ -e stopped/plane_pulse.checkpoint ] || ! kill -0 $running 2>/dev/null; do sleep 0.01; done
    kill -$signal $running
    wait $running 2>/dev/null || true
    expect "$signal: stopped on the way" test -e stopped/plane_pulse.checkpoint
    if [ $signal = KILL ]; then  # again, behind a snapshot that the checkpoint knows nothing of and an earlier end has not
        "$program" run "$scene" --resume --out stopped "${common[@]}" --set output.checkpoint=1e9 >"$scratch/stdout" 2>&1 &
        running=$!
        until compgen -G 'stopped/plane_pulse_snapshots.new-*/000000600.h5' >/dev/null || ! kill -0 $running 2>/dev/null; do
            sleep 0.01
        done
        kill -KILL $running
        wait $running 2>/dev/null || true
        cp -r stopped earlier
        try run "$scene" --resume --out earlier "${common[@]}" --set time.end=23.94
        expect_exit 0
        try run "$scene" --out alone "${common[@]}" --set time.end=23.94
        expect_exit 0
        expect "no snapshots beyond its end" diff -r alone earlier
        rm -r alone earlier
    fi
    "$program" run "$scene" "${common[@]}" --out stopped --set model.G=0.5 --set time.end=4000 --set output.checkpoint=1e9 \
        >"$scratch/stdout" 2>&1 &
    running=$!
    until compgen -G 'stopped/plane_pulse_snapshots.new-*/000001200.h5' >/dev/null; do sleep 0.01; done
    kill -KILL $running
    wait $running 2>/dev/null || true
    try run "$scene" --resume --out stopped "${common[@]}"
    expect_exit 0
    expect "$signal: its own files, byte for byte" diff -r whole stopped
    expect_no_leftovers stopped
    rm -r stopped
done
rm -r whole

# What else is in the folder of snapshots stays there; where it is in their way nothing is lost.
beside=("$scene" --quiet --set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=2
    --set output.snapshots=5)
for format in vtk hdf5; do
    try run "${beside[@]}" --set output.format=$format --out whole
    expect_exit 0
    cp -r whole again
    mkdir again/plane_pulse_snapshots/views whole/plane_pulse_snapshots/views
    echo "a view" | tee again/plane_pulse_snapshots/view.pvsm again/plane_pulse_snapshots/views/1 \
        whole/plane_pulse_snapshots/view.pvsm >whole/plane_pulse_snapshots/views/1
    try run "${beside[@]}" --set output.format=$format --out again
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    first=$(echo again/plane_pulse_snapshots/000000000.*)
    rm "$first"
    mkdir "$first"
    touch "$first/kept"
    try run "${beside[@]}" --set output.format=$format --out again
    expect_exit 5
    expect_stderr "$first is in the way of again/plane_pulse_snapshots.new-"
    expect_stderr "--resume goes on from again/plane_pulse.checkpoint"
    expect "it stays" test -e "$first/kept" -a -e again/plane_pulse_snapshots/view.pvsm
    rm -r "$first"
    try run "${beside[@]}" --set output.format=$format --out again --resume
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    # A run whose checkpoint was kept takes its snapshots back from there.
    try run "${beside[@]}" --set output.format=$format --out again --keep-checkpoint
    expect_exit 0
    try run "${beside[@]}" --set output.format=$format --out again --resume
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    rm -r whole again
done
# A link to another folder of theirs goes, what it leads to stays but for snapshots.
try run "${beside[@]}" --out linked
expect_exit 0
mv linked/plane_pulse_snapshots elsewhere
touch elsewhere/view.pvsm
ln -s ../elsewhere linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked
expect_exit 0
expect "no link" test ! -L linked/plane_pulse_snapshots -a -s linked/plane_pulse_snapshots/000000000.vti
expect "its file alone" test "$(ls elsewhere)" = view.pvsm
# A file where that folder would be.
rm -r linked/plane_pulse_snapshots elsewhere
touch linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked
expect_exit 5
expect_stderr "cannot write linked/plane_pulse_snapshots: Not a directory. --resume goes on from linked/plane_pulse.checkpoint"
rm linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked --resume
expect_exit 0
expect "its snapshots" test -s linked/plane_pulse_snapshots/000000000.vti
# No run fails of what it cannot remove of others, neither on its way nor at its end.
mkdir -p linked/plane_pulse_snapshots.new-1/000000000.vti/views
touch linked/plane_pulse_snapshots.new-1/000000005.vti
try run "${beside[@]}" --out linked --set output.checkpoint=1e-9
expect_exit 0
expect_no_stderr
expect "what is no snapshot alone" test "$(ls linked/plane_pulse_snapshots.new-1)" = 000000000.vti
rm -r linked

# The energies so far can be read; what a run reads it does not replace, nor what is not its own.
mkdir scenes
cp "$scene" scenes/pushed.toml
printf 'time,force\n0,0\n1,2\n2,0\n' >scenes/pushed_probes.csv
pushed=(run scenes/pushed.toml --quiet --set output.probes=[] --set force.history=csv --set force.component=x
    --set force.half_width=2 --set force.centre=[20,20])
try "${pushed[@]}" --set force.file=pushed_probes.csv --out scenes
expect_exit 2
expect_stderr "the scene reads scenes/pushed_probes.csv, which this run would replace or remove"
expect_no_stdout
mv scenes/pushed_probes.csv scenes/history.csv
echo "of something else" >scenes/pushed_cracks.csv
"$program" "${pushed[@]}" --set force.file=history.csv --out scenes --set time.end=1000 >"$scratch/stdout" 2>&1 &
running=$!
until grep -qs '^[0-9]' scenes/pushed.csv.part; do sleep 0.05; done
kill -TERM $running
wait $running || true
expect "stopped" test -e scenes/pushed.checkpoint
expect "another's file stays" grep -q "of something else" scenes/pushed_cracks.csv
printf 'time,force\n0,0\n1,3\n2,0\n' >scenes/history.csv
try "${pushed[@]}" --set force.file=history.csv --out scenes --set time.end=1000 --resume
expect_exit 2
expect_stderr "is of another scene: there the checksum of scenes/history.csv is"
rm -r scenes

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
setting 2 "model.influence has numbers that are more than 1e+300 times others" 'model.influence=[1e-200, 1, 1e200]' model.radius2=4
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
setting 2 "steps; at most 1e15" time.end=1e300
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
setting 2 "output.name must be without" "output.name='a&b'"

# (81) is paired at G = 0.25 in steps up to 0.4 of the longest, which a scene takes. In longer ones it grows.
strip=("$scene" --quiet --set model.G=0.25 --set 'domain.nodes=[8, 40]' --set 'initial.centre=[4, 20]'
    --set initial.width=3 --set time.end=200 --set boundary.kind=nmbc --set boundary.as_printed=true
    --set boundary.allow_unstable=true --set boundary.bottom.kind=periodic --set boundary.top.kind=periodic)
try run "${strip[@]}" --set time.cfl=0.9 --out strip
expect_exit 4
expect_stderr "in steps of 0.103225 (cfl = 0.9) strips between its sides grow: not up to time.step = 0.0458776 (cfl = 0.399)"
expect_stderr "the energy has grown to"
for step in time.step=0.0458776 time.cfl=0.399; do
    try run "${strip[@]}" --set $step --set time.end=9 --out strip
    expect_exit 0
    expect "no strip grows" bash -c '! grep -q "strips between" "$1"' - "$scratch/stderr"
done
try run "${strip[@]}" --set time.cfl=2 --out strip
expect_exit 4
expect_stderr "strips between its sides do not grow up to 0.0458776 (cfl = 0.4). Give time.cfl = 0.4 or less"
try run "${strip[@]}" --out strip
expect_exit 0
# Narrower than the strips that are looked at elsewhere, a plane is one itself.
try run "$scene" --set model.G=0.5 --set 'domain.nodes=[2, 40]' --set 'initial.centre=[1, 20]' --set initial.width=3 --set time.end=1 \
    --set boundary.kind=higdon --set boundary.allow_unstable=true --set boundary.bottom.kind=periodic --set boundary.top.kind=periodic --out strip
expect_exit 0
expect_stdout_with ": 0.8 of what the lattice allows: in longer ones strips between its sides grow"
# Opposite a fixed side it grows in steps of any length, which the report says.
try run "${strip[@]:0:1}" "${strip[@]:2}" --set boundary.right.kind=fixed --set time.end=9 --out strip
expect "no step is steady" grep -q "strips between them grow in steps of any length" "$scratch/stdout"
try run "${strip[@]}" --set boundary.right.kind=fixed --set time.end=9 --out strip
expect_stderr ") strips between its sides grow, as in those of any length"
rm -r strip

# A field that the disk does not take leaves an earlier run's files as they were.
field=("$scene" --quiet --set time.end=1 --set output.field=true --out full)
try run "${field[@]}"
expect_exit 0
cp -r full before
code=0
(
    ulimit -f 20
    exec "$program" run "${field[@]}" --set initial.amplitude=5
) >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
expect_exit 5
expect_stderr "File too large"
expect "the earlier files" diff -r before full
rm -r before full

# Times and spacings with an exponent are drawn, too.
try run "$scene" --quiet --plot --out tiny --set initial.amplitude=1e-7 --set domain.spacing=1e-5 --set initial.centre='[75e-5, 137.5e-5]' \
    --set initial.width=60e-5 --set time.end=2e-5 --set output.snapshots=10
expect_exit 0
expect_no_stderr
expect "a film" test -s tiny/plane_pulse_fields.gif
expect "time begins at 0" awk '/<text><tspan font-family="sans" >-/ { bad = 1 } />5e-06</ { rows++ } END { exit bad || rows != 1 }' \
    tiny/plane_pulse_energy.svg
# No number is cut off at the left, and the axis has a name, which is longer than two numbers are high.
gnuplot -e "set table 'pixels.txt'; plot 'tiny/plane_pulse_fields.png' binary filetype=png using 1:2:3 with rgbimage"
expect "the axis along Y is whole" awk '!/^#/ && NF > 4 && $3 + $4 + $5 < 384 { cut += $1 < 3; if ($1 < 25) name[$2] }
    END { exit !(cut == 0 && length(name) > 50) }' pixels.txt

# A run that grows says so, and what was computed up to there is there.
try run "$scene" "${printed[@]}" --set time.end=400 --set model.radius2=2 --out grown
expect_exit 4
expect_stderr "times what it was at the start, at step"
expect "energies up to there" test -s grown/plane_pulse.csv

# chart: what is stable by construction, what grows; passive sides are on the front.
small=(--set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=8 --set model.G=0.25 --long-run 5000 --out results)
try chart "$scene" "${small[@]}"
expect_exit 0
expect_no_stderr
expect "passive sides on the front" grep -q '^\* passive ' "$scratch/stdout"
expect "each row of the picture's data" awk -F, '
    NR == 1 { header = $0 }
    { at[$1] = $0; error[$1] = $6; run[$1] = $10 }
    END { exit !(NR == 21 && header == "boundary,kind,layer,profile,target,error,energy_left,step_cost,run_cost,long_run,on_front" && error["extended"] == 0 && error["pml 20"] < error["pml 5"] && error["pml 20"] < error["sponge 20"] &&
          run["passive"] == "by construction" && run["NMBC2"] == "grows" && error["fixed"] > error["passive"]) }' results/plane_pulse_chart.csv
expect "fixed and free sides are on no front" awk -F, \
    '($2 == "fixed" || $2 == "free") && $11 == 1 { exit 1 }' results/plane_pulse_chart.csv
expect "a picture" test -s results/plane_pulse_chart.svg
rm -r results
try chart "$scene" --set boundary.kind=fixed --out results
expect_exit 2
expect_stderr "a chart compares artificial sides, or the closures of sides where the body ends, sbp, kernel and free: there is none"
expect "no chart" test ! -e results
try chart "$scene" "${small[@]}" --set time.end=1e9
expect_exit 2
expect_stderr "at most 100000000 are allowed"
expect "no folder" test ! -e results
try chart "$scene" "${small[@]}" --set boundary.left.kind=free
expect_exit 0
expect_stderr 'left out: pml 40: beside a perfectly matched layer there are'
rm -r results

# advise: the cheapest sides that are stable by construction; and a dimension that the scene does not need.
small=(--set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=8 --set model.G=0.25)
try advise "$scene" "${small[@]}" --tolerance 0.03
expect_exit 0
expect_no_stderr
expect_stdout_with "advice     passive"
expect_stdout_with "settings   --set boundary.kind=passive"
expect_stdout_with "not stable by construction"
try advise "$scene" "${small[@]}" --set boundary.kind=free --tolerance 0.03
expect_exit 2
expect_stderr "there is nothing to advise"
try advise "$band" --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed --tolerance 0.1
expect_exit 0
expect_stdout_with "1 of the 20 nodes there gives the same u to roundings"
expect_stdout_with "is for scenes of the chain of these"
advised=$(sed -n 's/^settings *//p' "$scratch/stdout")
try run "$band" --quiet --set time.step=0.05 --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed
expect_exit 0
eval "try run \"\$band\" --quiet --set time.step=0.05 --set output.name=strip --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed $advised"
expect_exit 0
# Roundings of 500 steps, of energies that fall to 1e-9 of the peak.
expect "a twentieth of each energy" awk -F, '
    /^#/ || FNR == 1 { next }
    /^[a-z]/ { next }
    FILENAME != first { if (!first) first = FILENAME }
    FILENAME == first { total[$1] = $5; if ($5 > peak) peak = $5; next }
    { ++rows; off = $5 * 20 - total[$1]; if (off < 0) off = -off; if (off > 1e-12 * peak) exit 1 }
    END { exit !(rows > 10) }' results/plane_band.csv results/strip.csv
# A load on the whole of a side is as even, one across it is not.
cat >even.toml <<'SCENE'
model = { family = "nopd2d", radius2 = 1, nu = 0.25, G = 1 }
domain = { nodes = [12, 20] }
boundary = { kind = "periodic", bottom = { kind = "sbp" }, top = { kind = "sponge", layer = 5 } }
load.push = { kind = "velocity", side = "bottom", component = "y", amplitude = 1e-3, rise = 5, until = 10 }
time = { end = 30 }
SCENE
try advise even.toml --tolerance 0.5
expect_exit 0
expect_stdout_with "1 of the 12 nodes there gives the same u to roundings"
expect_stdout_with "--set 'domain.nodes=[1, 20]'"
rm even.toml
for quiet in "" --quiet; do
    try run "$scene" "${small[@]}" --tolerance 0.03 --out advised $quiet
    expect_exit 0
    expect_stdout_line "advice     --set boundary.kind=passive"
done

# A design of some seconds, of which a quiet run shows nothing.
quiet=(run "$2/tools/scenes/plane_box.toml" --quiet --set model.radius2=9 --set time.end=1)
tried="${quiet[*]} on a terminal"
script -qec "TERM=xterm '$program' ${quiet[*]}" /dev/null >"$scratch/stdout"
expect "its last lines" grep -q '^ledger drift' "$scratch/stdout"
expect "no progress" test "$(grep -c 'designing passive sides' "$scratch/stdout")" -eq 0
finish
