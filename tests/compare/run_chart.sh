#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun chart: its CSV and its pictures; and the pictures of a run. Nothing is said of times here.
# Usage: run_chart.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml

small=(--set model.horizon=1 --set model.G=0.5 --set domain.nodes=100 --set drive.centre=50)
csv=results/bar1d_chart.csv
header="boundary,kind,cfl,steps,certified,long_run,rate,step_cost,construction,$(:
    )total_cost,boundary_error,total_error,energy_left,on_step_front,on_front,layer_share,profile,target"
mkdir results
echo "$header" >$csv.new-1 # of a chart that was killed
echo 7 >$csv.new-2         # of somebody else
try chart "$scene" "${small[@]}" --set time.end=40 --long-run 4000
expect_exit 0
expect_no_stderr
expect "what killed charts leave goes" test ! -e $csv.new-1
expect_file $csv.new-2
rm $csv.new-2
expect "how long, in words" grep -qE '^takes        about [0-9.]+ (s|min) on ' "$scratch/stdout"
error_of() { # BOUNDARY CFL: its boundary error
    awk -F, -v boundary="$1" -v cfl="$2" '$1 == boundary && $3 == cfl { print $11 }' $csv
}
expect "a header line" grep -qx "$header" $csv
for kind in nmbc truncated higdon sponge pml extended exact fixed free; do
    for cfl in 0.1 0.2 0.4 0.8; do
        expect "$kind at cfl $cfl" grep -q ",$kind,$cfl," $csv
    done
done
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }
expect "exact is exact, to roundings" below "$(error_of exact 0.4)" 1e-13
expect "a wider layer is better" below "$(error_of 'pml 50' 0.4)" "$(error_of 'pml 5' 0.4)"
expect "NMBC2 beats NMBC1 in short steps" below "$(error_of 'NMBC2 s1' 0.1)" "$(error_of 'NMBC1 s1' 0.1)"
expect "NMBC2 beats the perfectly matched layer of 20 nodes" below "$(error_of 'NMBC2 s1' 0.4)" \
    "$(error_of 'pml 20' 0.4)"
expect "the edge effect" below "$(error_of 'NMBC1 s1' 0.4)" "$(error_of 'truncated 1' 0.4)"
expect "a fixed end sends all back" awk -F, '$1 == "fixed" && ($11 < 0.9 || $11 > 2.1) { exit 1 }' $csv
expect "what has no certificate says so" awk -F, \
    '($2 == "higdon" || $2 == "truncated") && $5 != 0 { exit 1 }' $csv
expect "a front of runs" awk -F, '$15 == 1 { front++ } END { exit !(front >= 2) }' $csv
expect "of what absorbs" awk -F, '($2 == "fixed" || $2 == "free") && ($14 == 1 || $15 == 1) { exit 1 }' $csv
expect_stdout_line "the cost of a pml is that of nmbcrun's own, which is programmed plainly"
# At cfl 0.4 it is the narrowest that lets nothing back: a node less does.
expect "an extended end no wider than the run needs" awk -F, \
    '$1 == "extended" && $3 == 0.4 && ($11 > 1e-12 || $16 < 1) { exit 1 }' $csv
for picture in svg png; do
    expect_stdout_line "picture      results/bar1d_chart.$picture"
done
expect "a whole picture" grep -q '</svg>' results/bar1d_chart.svg
expect "as PNG, too" test -s results/bar1d_chart.png

# A layer as it is tuned leaves what verify finds, and no more than with the profile and target that
# a scene has without.
IFS=, read -r profile target < <(awk -F, '$1 == "pml 20" && $3 == 0.4 { print $17 "," $18 }' $csv)
sed /^step/d "$scene" >bar.toml
error_with() { # SETTING..: of a layer of 20 nodes in the chart's steps
    "$program" verify bar.toml "${small[@]}" --set time.end=40 --set time.cfl=0.4 --tolerance 1 --quiet \
        --set boundary.kind=pml --set boundary.layer=20 "$@" | awk '/^error/ { print $2 }'
}
tuned=$(error_with --set "boundary.profile=$profile" --set "boundary.target=$target")
# The chart's steps are a little shorter, and it looks at a hundred times only.
expect "the error of a tuned layer" awk -v a="$(error_of 'pml 20' 0.4)" -v b="$tuned" \
    'BEGIN { exit !(a / b > 0.9 && a / b < 1.1) }'
expect "better than untuned" below "$tuned" "$(error_with)"

# What cannot end a scene is left out, and named.
try chart "$2/tools/scenes/broadband.toml" --set time.end=4 --set domain.nodes=60 --set initial.centre=5 \
    --long-run 4000 --quiet
expect_exit 0
expect_stderr "left out: exact: "
expect "no such rows" test "$(grep -c '^exact' results/broadband_chart.csv)" -eq 0

# Pictures of a run; and the command where there is no gnuplot.
run=(run "$scene" "${small[@]}" --set time.end=40 --plot --quiet)
try "${run[@]}" --set output.field=true --set output.snapshots=20
expect_exit 0
expect_no_stderr
for picture in energy.svg energy.png spectrum.svg spectrum.png spacetime.png; do
    expect_stdout_line "picture      results/bar1d_$picture"
    expect_file "results/bar1d_$picture"
done
expect "the run" env PATH=/nowhere "$program" "${run[@]}" --set "output.name=it is" >"$scratch/stdout"
expect_stdout_line "to draw it   gnuplot -c $(dirname "$(dirname "$program")")/share/nmbc/plots/energy.gp $(:
    )'results/it is_energy' 'results/it is.csv' 'bar of Nicely 2018, section 5'"
# Where gnuplot fails the numbers are there all the same; one that is stopped stops the program.
mkdir failing stopping
printf '#!/bin/sh\nexit 1\n' >failing/gnuplot
printf '#!/bin/sh\nkill -TERM $PPID\nexit 1\n' >stopping/gnuplot
chmod +x failing/gnuplot stopping/gnuplot
for drawn in "${run[*]:0:2} --plot" "chart $scene --long-run 4000"; do
    # shellcheck disable=SC2086  # words
    PATH=$PWD/failing:$PATH try $drawn "${small[@]}" --set time.end=4 --quiet
    expect_exit 0
    expect_stderr "nmbcrun: warning: gnuplot failed"
    expect_stderr_lines 1
    # shellcheck disable=SC2086  # words
    PATH=$PWD/stopping:$PATH try $drawn "${small[@]}" --set time.end=4 --quiet
    expect_exit 130
    expect_stderr "stopped while it was drawn; the numbers are written"
done

# What cannot be drawn is not worked for.
mkdir -p alone/bin
cp "$program" alone/bin/nmbcrun
for drawn in "${run[*]:0:2} --plot" "${run[*]:0:2} --plot --tolerance 1e-2" "chart $scene" \
    "chart $2/tools/scenes/plane_pulse.toml" "run $2/tools/scenes/plane_pulse.toml --plot"; do
    # shellcheck disable=SC2086  # words
    try $drawn --quiet --out "it's"
    expect_exit 2
    expect_stderr "pictures are drawn in no folder with an apostrophe in its name, as --out it's has"
    expect "no folder" test ! -e "it's"
    # shellcheck disable=SC2086  # words
    program=alone/bin/nmbcrun try $drawn --quiet --out alone/results
    expect_exit 5
    expect_stderr "to draw with: nmbcrun has to stay in the bin beside its share/nmbc"
    expect "no folder" test ! -e alone/results
done

# A pole at the exact G that is meant is left out, too.
try chart "$scene" --set model.G=128/85 --set time.end=4 --long-run 4000 --quiet
expect_exit 0
expect_stderr "left out: NMBC2 s1: "

try chart "$scene" --long-run 10
expect_exit 2
try chart "$scene" --out /dev/null/here --long-run 4000
expect_exit 5
# What is refused leaves no folder.
try chart "$scene" --out refused/chart --quiet --set model.G=1 --set time.end=1e-9
expect_exit 4
expect_stderr "nothing moved at any time, so there is nothing to compare with"
expect "no folder" test ! -e refused
finish
