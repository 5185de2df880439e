#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun chart: its CSV and its picture. Nothing is said of times here.
# Usage: run_chart.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml

try chart "$scene" --set model.horizon=1 --set model.G=0.5 --set domain.nodes=200 \
    --set drive.centre=100 --set time.end=30 --endurance 4000
expect_exit 0
expect_no_stderr
csv=results/bar1d_chart.csv
error_of() { # BOUNDARY CFL: its boundary error
    awk -F, -v boundary="$1" -v cfl="$2" '$1 == boundary && $3 == cfl { print $11 }' $csv
}
expect "a header line" grep -qx "boundary,kind,cfl,steps,certified,fate,rate,step_cost,construction,$(:
    )total_cost,boundary_error,total_error,energy_left,on_step_front,on_front,layer_share" $csv
for kind in nmbc mbc higdon sponge pml extended exact fixed free; do
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
expect "the edge effect" below "$(error_of 'NMBC1 s1' 0.4)" "$(error_of 'mbc 1' 0.4)"
expect "a fixed end sends all back" awk -F, '$1 == "fixed" && ($11 < 0.9 || $11 > 2.1) { exit 1 }' $csv
expect "what has no certificate says so" awk -F, \
    '($2 == "higdon" || $2 == "mbc") && $5 != 0 { exit 1 }' $csv
expect "a front of runs" awk -F, '$15 == 1 { front++ } END { exit !(front >= 2) }' $csv

expect "a picture is drawn" gnuplot -c "$2/tools/plots/chart.gp" $csv "$scratch/chart"
expect "a whole picture" grep -q '</svg>' "$scratch/chart.svg"
expect "as PNG, too" test -s "$scratch/chart.png"

try chart "$scene" --endurance 10
expect_exit 2
try chart "$scene" --out /dev/null/here --endurance 4000
expect_exit 5
finish
