#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Section 5 of the paper: the commands of docs/evidence/paper-1d.md, as they stand there, print its tables and
# draw its pictures; and what tools/scripts/paper-1d refuses.
# Usage: run_paper_1d.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
source=$2
document=$source/docs/evidence/paper-1d.md
nmbcrun=$program

# Arguments first: they are told apart from a program that failed.
program=$source/tools/scripts/paper-1d
# refuses CODE TEXT ARGUMENT..
refuses() {
    local expected=$1 text=$2
    shift 2
    try "$@"
    expect_exit "$expected"
    expect_stderr "paper-1d: "
    expect_stderr "$text"
    expect_no_stdout
    expect_nothing_written
}
for figure in fig4 fig12 7 FIG7 "" " " "fig6 fig7" .. 'fig7;ls' data; do
    refuses 2 "no such figure: '$figure'" --nmbcrun "$nmbcrun" "$figure"
    expect_stderr "Usage: tools/scripts/paper-1d"
done
refuses 2 "no such option: --figure" fig7 --figure
refuses 2 "no such option: -x" -x
for option in --out --nmbcrun; do
    refuses 2 "$option needs a path" fig7 $option
    refuses 2 "$option needs a path" fig7 $option ""
done
for nowhere in /nowhere/nmbcrun "$source" "$document"; do
    refuses 2 "there is no program $nowhere: build it first" fig7 --nmbcrun "$nowhere" --out results
done
try --help
expect_exit 0
expect_no_stderr
expect_stdout_line "Usage: tools/scripts/paper-1d [FIGURE..] [--out DIR] [--nmbcrun PATH] [--tables]"

# Without gnuplot, and without h5dump, which one picture needs.
mkdir "$scratch/bin"
for name in bash dirname sed awk cat cut paste tee wc mkdir; do
    ln -s "$(type -P "$name")" "$scratch/bin/$name"
done
program=$(command -v env)
bare=("PATH=$scratch/bin" "$source/tools/scripts/paper-1d" --nmbcrun "$nmbcrun" --out results)
refuses 2 "gnuplot is missing: install it (tools/scripts/setup), or take --tables" "${bare[@]}" fig7
ln -s "$(type -P true)" "$scratch/bin/gnuplot"
refuses 2 "h5dump is missing" "${bare[@]}" fig7 spacetime
rm "$scratch/bin/gnuplot"
try "${bare[@]}" --tables fig5
expect_exit 0
expect_no_stderr
expect "a table" grep -q 'dX' "$scratch/stdout"
if [ -e /dev/full ]; then
    code=0
    "$program" "${bare[@]}" --tables fig5 >/dev/full 2>"$scratch/stderr" || code=$?
    expect_exit 5
    expect_stderr "paper-1d: the table of fig5 could not be written"
fi
expect "no pictures" test -z "$(find results -name '*.svg' -o -name '*.png')"
rm -r results

# A folder that cannot be made, a program that fails, a folder of any name.
program=$source/tools/scripts/paper-1d
touch file
try fig7 --nmbcrun "$nmbcrun" --out file/results
expect_exit 5
expect_stderr "cannot make the folder file/results/data"
rm file
printf '#!/bin/sh\necho "as it is" >&2\nexit 4\n' >fails
chmod +x fails
try fig7 --nmbcrun ./fails --out results
expect_exit 4
expect_stderr "paper-1d: ./fails failed with exit code 4: as it is"
expect_no_stdout
try fig7 --nmbcrun fails --out results
expect_exit 4
expect_stderr "paper-1d: ./fails failed with exit code 4: as it is"
rm -r fails results
try fig5 --nmbcrun "$nmbcrun" --out "-it's \"a\" folder=1"
expect_exit 0
expect_no_stderr
expect_file "./-it's \"a\" folder=1/fig5.svg"
rm -r ./-it*

# The commands of the document, all figures and then Fig. 7 by itself; five seconds.
program=$nmbcrun
expect "a command for each figure" \
    test "$(grep -cE '^    tools/scripts/paper-1d (fig([5-9]|1[01])|spacetime)$' "$document")" -eq 8
grep -vE '^    tools/scripts/paper-1d (fig([5689]|1[01])|spacetime)$' "$document" >shorter.md
try_document shorter.md "$source"
rm shorter.md
sed -n '/^## Fig. 5/,$p' "$document" | grep '^|' >tables
awk '/^## table2/ { skip = 1 } /^## spacetime/ { skip = 0 } /^\|/ && !skip' "$scratch/stdout" >printed
expect "four tables" test "$(grep -c '^|:--' tables)" -eq 4
expect "seven tables and then that of Fig. 7" test "$(grep -c '^|:--' printed)" -eq 8
expect "Fig. 7 by itself" diff <(grep -A 6 '^| horizon |.*one such end' tables) <(tail -n 7 printed)
expect "every row of the document is printed" diff /dev/null <(grep -vxFf printed tables)
# Of Figs. 5, 9 and 10 the document has the numbers in words.
expect "the largest u" grep -q '^| 3 dX .* 5.130e-03 |$' printed
expect "where peaks are" grep -qF ' 1.293, 2.224, 3.142 |' printed
expect "three small peaks" grep -qF '| 2.6e-04, 1.2e-04, 9.6e-05 | ' printed
expect "no peaks from 0.03 on" grep -qE '^\| 3 dX .* 3, up to 1.3e-05 \| +none \| +none \| +none \| +none \|$' printed
expect "the chain of atoms with explicit ghosts" grep -q '^energy left  1.073e-05 ' "$scratch/stdout"
expect "that is what the document has" grep -qF 'leaves 1.1e-05.' "$document"
for figure in fig5 fig6 fig7 fig8 fig9 fig10 fig11; do
    expect_picture "docs/images/paper-1d/$figure.svg" "$source"
    expect_file "results/paper-1d/$figure.png"
done
expect_file docs/images/paper-1d/spacetime.png

# What the text beside the tables says of them.
expect "one end: half of what two leave, and those a ninth" awk -F'|' '
    /^\| NOPD, MBC1  / { two = $4 }
    /NMBC1 left/ { one = $4 }
    # R = 1/3 at long waves; 1 % is what short ones make of it.
    END { exit !(one / two > 0.49 && one / two < 0.51 && two * 9 > 0.99 && two * 9 < 1.01) }' tables
expect "more is reflected the larger the horizon" awk -F'|' '
    NF == 6 && /more than above|at least 5.7e-2/ { rows++; if ($4 <= last) bad = 1; last = $4 }
    END { exit bad || rows != 5 }' tables

# Longer runs with ends that are not stable.
program=$nmbcrun
grows() { # SETTING..
    local settings=()
    for setting in "$@"; do
        settings+=(--set "$setting")
    done
    try run "$source/tools/scenes/fig11.toml" --quiet --out long --set model.horizon=2 \
        --set boundary.allow_unstable=true "${settings[@]}"
    expect_exit 4
    expect_stderr "the energy has grown to 10"
}
grows model.G=2 time.end=500
grows model.G=6 boundary.order=1 time.end=5000

# The space-time picture of other runs, and what it refuses.
program=$(command -v gnuplot)
script=$source/tools/plots/spacetime.gp
try -c "$script" u one results/paper-1d/data/spacetime_mbc.h5 "a title"
expect_exit 0
expect_no_stderr
expect_file one.png
for bad in "" u "w out run.h5 title" "u out run.h5" "u out run.h5 title run.h5"; do
    # shellcheck disable=SC2086  # several arguments, or none
    try -c "$script" $bad
    expect_exit 2
    expect_stderr "usage: gnuplot -c spacetime.gp"
done
for bad in nowhere.h5 results/paper-1d/data/fig6_md.csv; do
    try -c "$script" u out "$bad" title
    expect_exit 2
    expect_stderr "no two snapshots of nmbcrun in $bad"
done
expect "no picture of these" test ! -e out.png

for bad in "" energy "energy out" "time out file"; do
    # shellcheck disable=SC2086
    try -c "$source/tools/plots/panels.gp" $bad
    expect_exit 2
    expect_stderr "usage: gnuplot -c panels.gp"
done
for bad in "" form= form=other; do
    code=0
    awk -v "${bad:-x=}" -f "$source/tools/plots/edge_node.awk" \
        >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
    expect_exit 2
    expect_stderr "edge_node.awk: needs -v form=printed or -v form=derived"
    expect_no_stdout
done
finish
