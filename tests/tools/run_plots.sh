#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The scripts of tools/plots refuse what is no CSV of theirs, in one line and without a picture.
# Usage: run_plots.sh SOURCE_FOLDER
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
plots=$program/tools/plots
program=$(command -v gnuplot)

# refuses TEXT SCRIPT ARGUMENT..
refuses() {
    local text=$1 script=$2
    shift 2
    try -c "$plots/$script" "$@"
    expect_exit 2
    expect_stderr "$text"
    expect_stderr_lines 1
    expect_no_stdout
    expect "no picture" test -z "$(find . -name 'picture*')"
}

echo "hello world" >words.csv
printf 'strain,kinetic\n1,2\n' >other.csv
head -c 1000 /dev/zero >zeros.csv
: >empty.csv
for file in words zeros empty other; do
    refuses "energy.gp: $file.csv is no CSV of nmbcrun run: it has no column time total" \
        energy.gp picture "$file.csv" title
    refuses "$file.csv is no CSV of nmbcrun chart" chart.gp "$file.csv" picture
    refuses "$file.csv is no CSV of nmbcrun chart of a plane" plane_chart.gp "$file.csv" picture title
    refuses "$file.csv is no CSV of nmbcgen recommend --csv" side_reflection.gp "$file.csv" picture
    refuses "disc.gp: $file.csv is no CSV of tools/scripts/disc-impact" disc.gp "$file.csv" picture title
    for script in dispersion.gp plane_dispersion.gp dispersion_surface.gp; do
        refuses "$script: $file.csv is no CSV of nmbcgen dispersion" "$script" "$file.csv" picture
    done
done
printf '# of a run\ntime,kinetic,total\n' >short.csv
refuses "energy.gp: short.csv has no rows" energy.gp picture short.csv title
refuses "energy.gp: cannot read nowhere.csv" energy.gp picture nowhere.csv title
refuses "directory" energy.gp picture . title
refuses "energy.gp: no name with an apostrophe: it's.csv" energy.gp picture "it's.csv" title
sed '$a 1,2,3\n2,1,two' short.csv >text.csv
refuses 'energy.gp: text.csv:4: total is "two", which is no number' energy.gp picture text.csv title
sed '$a 1,2,3\n2' short.csv >cut.csv
refuses 'energy.gp: cut.csv:4: total is "", which is no number' energy.gp picture cut.csv title
printf '1,2,3\n2,1,2\n' >>short.csv
try -c "$plots/energy.gp" picture short.csv title
expect_exit 0
expect_file picture.svg

rm picture.*
# Planes: a field without snapshots is none, and probes are where their columns say.
refuses "fields.gp: no snapshots of nmbcrun in empty.csv" fields.gp picture empty.csv title
refuses "fields.gp: no field of nmbcrun in nowhere_field.vti" fields.gp picture nowhere_field.vti title
printf 'time,ux_3_9,uy_3_9,vx_3_9,vy_3_9,ux_10_275,uy_10_275,vx_10_275,vy_10_275\n0,0,0,0,0,0,0,0,0\n' >run_probes.csv
try -e "load '$plots/probes.gp'; set table 'places'; eval 'plot NaN notitle' . probes('run', 0.5)"
expect_exit 0
expect "a circle and its rim at each probe" test "$(awk '$3 == "i" { print $1, $2 }' places | tr '\n' ' ')" = \
    "1.5 4.5 5 137.5 1.5 4.5 5 137.5 "
try -e "load '$plots/probes.gp'; print probes('nowhere', 0.5)"
expect_exit 0
expect "nothing where there are none" test -z "$(tr -d '\n' <"$scratch/stderr")"
finish
