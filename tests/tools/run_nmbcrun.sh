#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What nmbcrun runs, prints and writes: a good run, files that cannot be written, runs that blow up.
# Usage: run_nmbcrun.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/bar.bash"

# A run: the table and the files on stdout, nothing on stderr, which is no terminal.
try run "$scene" "${short[@]}"
expect_exit 0
expect_no_stderr
expect_stdout_line "scene     bar of Nicely 2018, section 5"
expect_stdout_line "energies     results/bar1d.csv"
expect "a header line" grep -qx \
    'time,kinetic,strain,stabilisation,total,staggered,damped,ledger,work,left_end,right_end,drift' \
    results/bar1d.csv
# What it is of comes first, in comments: gnuplot and pandas (comment="#") read what follows.
expect "the version, the scene and the units" diff - <(sed -n 's/^# //p' results/bar1d.csv) <<END
$("$program" --version | sed 's/ /   /')
$(sed -nE '/^scene/,/^time/{/^ends/d;s/^time( .*) [0-9]+ steps of/step\1/;p}' "$scratch/stdout")
units     those of the scene, any consistent system; energies per cross-section area
END
expect "comments before the header alone" awk '/^#/ { if (rows) exit 1; next } { rows++ }' results/bar1d.csv
expect "10 rows for 100 steps" test "$(grep -vc '^#' results/bar1d.csv)" -eq 11
expect "the last row at t - dt/2" grep -q '^1.99,' results/bar1d.csv
# kinetic + strain + stabilisation = total, in every row
expect "the energies add up" awk -F, '/^[0-9]/ && ($2 + $3 + $4 - $5)^2 > (1e-14 * $5)^2 { exit 1 }' \
    results/bar1d.csv

# Pictures of an earlier run of that name go with its other files.
mkdir elsewhere
touch elsewhere/again_energy.png elsewhere/again_spacetime.png elsewhere/other_energy.png
try run "$scene" "${short[@]}" --quiet --out elsewhere --set output.name=again
expect_exit 0
expect "no pictures of an earlier run" test "$(echo elsewhere/*.png)" = elsewhere/other_energy.png
expect "four lines only" test "$(wc -l <"$scratch/stdout")" -eq 4
expect_same results/bar1d.csv elsewhere/again.csv

# A scene file's own name names the files as far as output.name could.
for name in .hidden $'a\x01\nb' "it's<&>" a..b; do
    cp "$scene" "$scratch/$name.toml"
    try run "$scratch/$name.toml" "${short[@]}" --quiet --out named
    expect_exit 0
done
expect "plain names" test "$(cd named && echo *)" = "_hidden.csv a._b.csv a__b.csv it_s___.csv"
expect "no hidden file" test "$(files_in named)" -eq 4
rm -r named

# The ledger: what is there was put in and has not left, through the ends or by damping; to 1e-13 of
# the peak (2744 steps of 500 nodes, where the roundings of some 10 operations add up).
try run "$scene" --quiet --set output.every=1
expect_exit 0
expect "the ledger adds up" awk -F, '
    /^[0-9]/ && $5 > peak { peak = $5 }
    /^[0-9]/ { drift = $12 < 0 ? -$12 : $12; if (drift > worst) worst = drift
             rest = $8 - ($9 - $10 - $11 - $7) - $12; if (rest^2 > (1e-15 * peak)^2) exit 1 }
    END { exit !(worst > 0 && worst < 1e-13 * peak && $10 > 0.49 * peak && $11 > 0.49 * peak) }' \
    results/bar1d.csv
expect "and is reported" grep -qE '^ledger drift [0-9.]+e-1[45] of the peak$' "$scratch/stdout"
expect "what went out" grep -qE '^went out     4\.9[0-9]*e-01 at the left end, 4\.9[0-9]*e-01 at the right one, of all that was put in$' \
    "$scratch/stdout"

# Of all that was put in, not of the peak: much leaves before a slow force has done its work.
try run "$sourceless" --quiet --set model.G=1.85 --set time.end=600 --set force.history=gaussian --set force.duration=60 \
    --set force.time=200 --set force.amplitude=1 --set force.centre=250 --set force.half_width=5
expect_exit 0
expect_stdout_line "went out     5.000e-01 at the left end, 5.000e-01 at the right one, of all that was put in"

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
expect_stderr "warning: there is no certificate for explicit ghosts"
expect_stderr "times the peak that it had while its sources acted"  # found long before anything overflows

# An initial field that reaches an end that lets waves out, unless it goes out there.
pulse=(run "$sourceless" --quiet "${short[@]}")
try "${pulse[@]}" --set 'initial={shape = "gaussian", amplitude = 1e-3, width = 10, centre = 5}'
expect_exit 0
expect_stderr "nmbcrun: warning: initial reaches the left end, with 0.9 of its largest value"
expect_stderr_lines 1
for quiet in 'direction = "left", centre = 5' 'centre = 40'; do
    try "${pulse[@]}" --set "initial={shape = \"gaussian\", amplitude = 1e-3, width = 10, $quiet}"
    expect_exit 0
    expect_no_stderr
done
try "${pulse[@]}" --set 'initial={shape = "gaussian", amplitude = 1e-3, width = 10, centre = 5}' \
    --set boundary.left.kind=free
expect_exit 0
expect_no_stderr

# From an initial field the peak counts from the start: what grows later is found.
try run "$2/tools/scenes/broadband.toml" --set boundary.order=2 --set boundary.stride=1 \
    --set boundary.allow_unstable=true
expect_exit 4
expect_stderr "times what it was at the start, most at node"
# No energy, and why.
try run "$sourceless" "${short[@]}" --set initial.shape=gaussian --set initial.amplitude=1 \
    --set initial.width=0.01 --set initial.centre=250.5
expect_exit 4
expect_stderr "there was no energy at any time, so nothing to compare with: initial lies outside of the bar or between two nodes, or"

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
    !/^[0-9]/ { next }
    NR == FNR { last = $6; next }
    { exit !(($6 / last - 1)^2 < 1e-24) }' "$scratch/scenes/fed.csv" results/more.csv

# What a run has read it does not replace or remove.
cp -r "$scratch/scenes" "$scratch/before"
try run "$scratch/scenes/fed.toml" "${short[@]}" --set initial.shape=csv \
    --set initial.file=fed_field.csv --out "$scratch/scenes"
expect_exit 2
expect_stderr "fed_field.csv, which this run would replace or remove"
expect_no_stdout
expect "nothing changed" diff -r "$scratch/before" "$scratch/scenes"

# Nor does it go on with a file that has changed.
history=("$scratch/scenes/fed.toml" "${short[@]}" --set force.history=csv --set force.file=history.csv
    --set force.centre=250 --out "$scratch/pushed")
try run "${history[@]}" --keep-checkpoint
expect_exit 0
printf 'time,force\n0,0\n1,3\n2,0\n' >"$scratch/scenes/history.csv"
try run "${history[@]}" --resume
expect_exit 2
expect_stderr "there the checksum of $scratch/scenes/history.csv is"

# The files of one run: what an earlier one of that name has published beside its energies goes.
everything=(--set output.field=true --set 'output.probes=[7]' --set output.snapshots=50)
unstable=(--set boundary.order=2 --set model.G=1 --set boundary.allow_unstable=true)
published() { # what is there after the two runs, the second with these arguments
    rm -rf results
    try run "$scene" "${short[@]}" "${everything[@]}"
    expect "four files" test "$(files_in results)" -eq 4
    cp -r results earlier
    echo 7 >results/bar1d_chart.csv # not of a run
    try run "$scene" "$@"
    ls results >"$scratch/published"
    if [ "$code" -ne 2 ]; then
        expect "other energies" test "$(cmp -s {earlier,results}/bar1d.csv; echo $?)" -eq 1
    fi
    rm -r earlier
}
expect_published() { expect "these files: $*" diff "$scratch/published" <(printf '%s\n' "$@"); }
published --set time.end=3
expect_exit 0
expect_published bar1d.csv bar1d_chart.csv
published --set time.end=3 --set 'output.probes=[8]'
expect_published bar1d.csv bar1d_chart.csv bar1d_probes.csv
published "${unstable[@]}"
expect_exit 4
expect_published bar1d.csv bar1d_chart.csv
published "${unstable[@]}" "${everything[@]}"
expect_exit 4
expect_published bar1d.csv bar1d.h5 bar1d_chart.csv bar1d_probes.csv
published --set time.end=-1
expect_exit 2
expect_published bar1d.csv bar1d.h5 bar1d_chart.csv bar1d_field.csv bar1d_probes.csv
# A scene may have such a name: its energies are no field.
rm -r results
for name in bar1d_field bar1d_probes bar1d; do
    try run "$scene" "${short[@]}" --set output.name="$name"
    expect_exit 0
done
for name in bar1d_field bar1d_probes; do expect_same results/bar1d.csv "results/$name.csv"; done

# Where nothing is read any more, as after head, that is an error of a file.
tried="run | true"
code=0
{ "$program" run "$scene" "${short[@]}" 2>"$scratch/stderr" || echo $? >"$scratch/code"; } | true
code=$(<"$scratch/code")
expect_exit 5
for option in --help --version "run --help"; do
    tried="$option >/dev/full"
    code=0
    # shellcheck disable=SC2086  # words
    "$program" $option >/dev/full 2>"$scratch/stderr" || code=$?
    expect_exit 5
done

# Progress is as wide as its terminal.
for columns in 80 40 12; do
    tried="run in $columns columns"
    script -qec "stty cols $columns; '$program' run '$scene' --set time.end=4000 --out narrow" /dev/null |
        tr '\r' '\n' | grep -a '%' >"$scratch/lines"
    expect "progress" test -s "$scratch/lines"
    expect "no line is cut" awk -v most="$columns" '/%/ { sub(/ .\[K$/, "") } length > most { exit 1 }' \
        "$scratch/lines"
done

# Energy that comes in is no negative way out.
try run "$2/tools/scenes/incoming.toml" --quiet
expect "said in words" grep -qE '^went out     -[0-9.e+-]+ \(energy came in\) at the left end, [0-9.e+-]+ at the right one, of all that was put in$' "$scratch/stdout"

# --set takes one word, and spaces around its =.
try run --set time.end=2 --set 'output.name = spaced' "$scene" --quiet
expect_exit 0
expect_file results/spaced.csv

# A scene that comes through a pipe is read.
try run /dev/stdin "${short[@]}" --quiet <"$scene"
expect_exit 0

# The shortest run is one step.
try run "$scene" --set time.end=1e-9
expect_exit 0

finish
