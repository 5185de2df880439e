#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What a run of a plane scene writes: energies, probes, fields, pictures.
# Usage: run_plane_fields.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml

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
finish
