#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Planes without artificial sides beside the same body on a finer lattice: verify and chart.
# Usage: run_finer.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"

# error ARGUMENT..: what verify finds.
error() {
    "$program" verify "$@" --tolerance 100 --quiet | awk '/^error/ { print $2 }'
}

# A strip that a traction pulls at: the sum of waves int t dt/(rho c_P) that come back from both surfaces, c_P^2 = 1/(1 -
# nu^2), is known.
cat >strip.toml <<'TOML'
[model]
family = "nopd2d"
radius2 = 4
nu = 0.25
G = 0.5
[domain]
nodes = [6, 60]
[boundary]
kind = "periodic"
bottom.kind = "sbp"
top.kind = "sbp"
[load.pull]
kind = "traction"
side = "top"
component = "y"
amplitude = 1e-3
file = "pull.csv"
[time]
end = 150
cfl = 0.2
[output]
every = 1
TOML
awk 'BEGIN { print "time,force"; for (t = 0; t <= 60; t += 0.5) print t "," exp(-((t - 30) / 9)^2) }' >pull.csv
probes="output.probes=[$(printf '[1, %d], ' {1..60})]"
# true_error LINES ARGUMENT..: against these waves, at the nodes of the scene and all times; the surface is so many lines
# beyond them.
cat >true_error.py <<'PYTHON'
import csv, math, sys
beyond = float(sys.argv[1])
c = 1 / math.sqrt(1 - 0.25**2)
length = 59 + 2 * beyond
impulse = lambda t: 1e-3 * 9 * math.sqrt(math.pi) / 2 * (math.erf((t - 30) / 9) + math.erf(30 / 9)) if t > 0 else 0
def exact(y, t):
    y += beyond
    return 1 / c * sum(impulse(t - (length - y) / c - 2 * k * length / c) + impulse(t - (length + y) / c - 2 * k * length / c) for k in range(3))
rows = list(csv.reader(open("results/strip_probes.csv")))
places = [(i, int(name.split("_")[2]) - 1) for i, name in enumerate(rows[0]) if name.startswith("uy")]
worst = largest = 0
for row in rows[1:]:
    for i, y in places:
        u = exact(y, float(row[0]))
        worst = max(worst, abs(u - float(row[i])))
        largest = max(largest, abs(u))
print(worst / largest)
PYTHON
# The reference has a quarter of the error where that falls with dX^2, so what verify finds is from 3/4 of it (a hundredth
# more for the next order) to all of it, or more: it looks at the surfaces, too.
for case in sbp:5 free:0.5; do
    kind=${case%:*}
    sides=(--set boundary.bottom.kind="$kind" --set boundary.top.kind="$kind")
    try run strip.toml --quiet "${sides[@]}" --set "$probes"
    expect_exit 0
    expect_no_stderr
    found=$(error strip.toml "${sides[@]}")
    true_error=$(python3 true_error.py "${case#*:}")
    expect "an error between $kind sides of $true_error, not $found" awk -v found="$found" -v true_error="$true_error" \
        'BEGIN { exit !(found > 0.74 * true_error && found < 1.01 * true_error) }'
done
rm -r results

# A pulse in a body of 40 x 30, in which P, S and Rayleigh waves meet all sides and corners.
cat >body.toml <<'TOML'
[model]
family = "nopd2d"
radius2 = 4
nu = 0.25
G = 0.5
[domain]
nodes = [31, 21]
[boundary]
kind = "sbp"
[initial]
shape = "gaussian"
component = "x"
amplitude = 1e-3
centre = [11, 13]
width = 6
[time]
end = 60
TOML
# order LEAST MOST LINES ARGUMENT..: the error falls by a factor between these two from dX = 1 to 1/2, of sides that add
# so many lines.
order() {
    local least=$1 most=$2 lines=$3
    shift 3
    local dX errors=()
    for dX in 1 0.5; do
        errors+=("$(error body.toml "$@" --set domain.spacing=$dX \
            --set "$(awk -v d=$dX -v q="$lines" 'BEGIN { printf "domain.nodes=[%d, %d]", 40 / d - 2 * q + 1, 30 / d - 2 * q + 1 }')" \
            --set "$(awk -v d=$dX -v q="$lines" 'BEGIN { printf "initial.centre=[%g, %g]", 15 + (1 - q) * d, 17 + (1 - q) * d }')")")
    done
    expect "errors ${errors[*]} that fall by $least to $most" awk -v coarse="${errors[0]}" -v fine="${errors[1]}" -v least="$least" -v most="$most" \
        'BEGIN { exit !(coarse / fine > least && coarse / fine < most) }'
}
# 4 for the second order, 2 for the first; a fifth more or less at so few nodes.
order 3.2 4.8 5
spline=(--set model.radius2=2 --set 'model.influence="spline"')
order 1.6 2.4 4 "${spline[@]}" --set boundary.kind=kernel

# Half of a body beside a mirror is compared with dX/3, which leaves 8/9 of the error and not 3/4; the next order in dX
# is a few per cent here.
whole=(body.toml --set model.radius2=1 --set initial.component=y --set time.cfl=0.2)
of_half=$(error "${whole[@]}" --set 'domain.nodes=[18, 26]' --set 'initial.centre=[0.5, 13]' --set boundary.left.kind=mirror)
of_whole=$(error "${whole[@]}" --set 'domain.nodes=[36, 26]' --set 'initial.centre=[18.5, 13]')
expect "32/27 of the error $of_whole of the whole, not $of_half" awk -v half="$of_half" -v whole="$of_whole" \
    'BEGIN { ratio = half / whole * 27 / 32; exit !(ratio > 0.93 && ratio < 1.07) }'

# What is said of it.
try verify body.toml --tolerance 0.5
expect_exit 0
expect_no_stderr
expect_stdout_line "reference the same body, nodes dX/2 apart, 2 steps to one"
expect_stdout_line "plane     71 x 51 nodes, dX = 0.5, c_P = 1.0328, c_S = 0.632456"
expect_stdout_with "within the tolerance 0.5"
expect_stdout_with "of the peak; of the reference"
try verify body.toml --tolerance 0.1 --quiet
expect_exit 1
expect_stdout_with "above the tolerance 0.1"
# No closure: of the lattice's own dispersion.
for kind in mirror fixed periodic; do
    try verify body.toml --tolerance 0.06 --quiet --set model.radius2=1 --set boundary.kind=$kind
    expect_exit 0
done
# On a lattice without sums by parts free sides stay what they are.
sed 's/nopd2d/bond2d/; /^nu\|^G/d; s/^radius2.*/radius2 = 2\nweights = [1, 1]/' body.toml >bonds.toml
bonds=(--set boundary.kind=free --set initial.width=12)
try verify bonds.toml --tolerance 0.2 "${bonds[@]}"
expect_exit 0
expect_stdout_line "reference the same body, nodes dX/3 apart, 3 steps to one"
expect_stdout_line "plane     93 x 63 nodes, dX = 0.3333333333333333, c_P = 1.73205, c_S = 1.41421"
# Beside artificial sides it is asked for: a passive one adds to what the lattice and the closures do.
beside=(body.toml --set model.radius2=1)
lattice=$(error "${beside[@]}" --set boundary.left.kind=extended --finer)
all=$(error "${beside[@]}" --set boundary.left.kind=passive --finer)
side=$(error "${beside[@]}" --set boundary.left.kind=passive)
expect "no error of a side alone ($side) beyond their sum ($lattice, $all)" awk -v lattice="$lattice" -v all="$all" -v side="$side" \
    'BEGIN { exit !(lattice > 0 && side > 0 && all <= 1.1 * (lattice + side) && side <= 1.1 * (all + lattice)) }'

# What no other lattice has.
mkdir out
refuses 2 "--finer is for planes" verify "$2/tools/scenes/bar1d.toml" --tolerance 1 --finer
refuses 2 "a table fracture: where bonds break depends on dX" verify bonds.toml --tolerance 1 "${bonds[@]}" \
    --set fracture.critical_stretch=1
refuses 2 "bonds have one only, free" chart bonds.toml "${bonds[@]}" --out out
printf 'x,y,ux,uy\n10,10,1e-3,0\n' >start.csv
sed '/^\[initial\]/,/^width/d' body.toml >started.toml
printf '[initial]\nshape = "csv"\nfile = "start.csv"\n' >>started.toml
refuses 2 "initial.file has u at the nodes of this one only" verify started.toml --tolerance 1
load=(--set load.top.side=top --set load.top.component=y --set load.top.amplitude=1e-3 --set load.top.rise=20)
refuses 2 "load.top acts on a thinner line of nodes" verify body.toml --tolerance 1 "${load[@]}" --set load.top.kind=force
refuses 2 'side of kind "mirror" are others than those that load.top moves' verify body.toml --tolerance 1 "${load[@]}" \
    --set load.top.kind=displacement --set boundary.top.kind=mirror
refuses 2 "--finer compares with a finer lattice, and there is none of a scene with a table fracture" verify bonds.toml \
    --tolerance 1 --finer --set boundary.kind=extended --set fracture.critical_stretch=1
refuses 2 "too thin for the reference, whose sbp sides have 5 lines each" verify body.toml --tolerance 1 \
    --set boundary.kind=free --set 'domain.nodes=[3, 3]' --set 'initial.centre=[2, 2]'
for command in "verify body.toml --tolerance 1" "chart body.toml --out refused"; do
    read -ra words <<<"$command"
    refuses 2 "the reference, the same body on nodes dX/2 apart, has 1.44e+08 nodes; at most" "${words[@]}" \
        --set boundary.kind=free --set 'domain.nodes=[9000, 4000]'
done
# Steps that are too long: the one that is named is stable, and a hundredth more is not.
for key in step cfl; do
    try verify body.toml --tolerance 1 --set time.$key=3
    expect_exit 4
    longest=$(sed -n "s/.* Give time.$key = \(.*\) or less$/\1/p" "$scratch/stderr")
    try verify body.toml --tolerance 1 --set time.$key="$longest"
    expect_exit 0
    refuses 4 "or less" verify body.toml --tolerance 1 --set time.$key="$(awk -v longest="$longest" 'BEGIN { print longest + 1e-2 }')"
done
# What overflows is told as that.
refuses 4 "u is not finite at node" verify body.toml --tolerance 1 --quiet "${load[@]}" --set load.top.kind=traction \
    --set load.top.amplitude=1e100 --set material.density=1e-220 --set material.youngs_modulus=1e-220
# Loads on sides have their places on it.
for kind in traction velocity displacement; do
    try verify body.toml --tolerance 1 --quiet "${load[@]}" --set load.top.kind=$kind
    expect_exit 0
done

# chart: the closures of one body.
try chart body.toml "${spline[@]}" --out out
expect_exit 0
expect_no_stderr
expect_stdout_with "error: against the same body on a finer lattice"
expect "kernels err more, as a line of the first order" awk -F, \
    '{ error[$2] = $6; run[$2] = $10; front += $11 } END { exit !(NR == 4 && error["sbp"] > 0.01 && error["kernel"] > error["sbp"] && error["free"] > 0.01 && run["sbp"] == "by construction" && front >= 1) }' out/body_chart.csv
expect_file out/body_chart.svg
# It is what verify finds, in the steps of the chart.
expect "the error that verify finds" awk -F, -v found="$(error body.toml "${spline[@]}" --set time.step=0.4)" \
    '$2 == "sbp" { exit !(($6 / found - 1) ^ 2 < 1e-6) }' <("$program" chart body.toml "${spline[@]}" --set time.step=0.4 --quiet --out out >out/log && cat out/body_chart.csv)
try chart body.toml "${spline[@]}" --set time.step=1 --quiet --out out
expect_exit 0
expect_stderr "left out: kernel: steps of 1 are too long: beside it those below 0.7"
try chart body.toml --set boundary.left.kind=mirror --set model.radius2=1 --out out
expect_exit 0
expect_stderr "left out: free: the body is"
refuses 2 "there is none" chart body.toml --set boundary.kind=mirror --out refused
refuses 2 "no closure of this body can be compared. sbp: the body is 35.5 dX long along x" chart body.toml \
    --set boundary.right.kind=free --out refused
refuses 2 "--long-run is for sides that may feed energy in" chart body.toml --long-run 5000 --out refused
expect "no chart" test ! -e refused

finish
