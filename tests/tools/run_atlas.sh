#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The stability atlas at a coarse resolution: prediction and measurement agree where they must, and
# bad arguments are refused.
# Usage: run_atlas.sh STABILITY_ATLAS SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
stability_atlas=$program
program=$2/tools/scripts/atlas

try "$stability_atlas" --horizon 2 --points 31 --out out
expect_exit 0
expect_no_stderr
expect_stdout_line out/atlas_n2.svg
for file in points.csv windows.csv atlas_n2.svg; do expect_file "out/$file"; done
expect "8 conditions at 31 values of G" test "$(wc -l <out/points.csv)" -eq 249

# Each condition is told apart by its figures: the counts say that the checks had something to hold.
expect "what is predicted is measured" awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    {
        measured = $at["measured_growth"]
        if ($at["in_modal_window"]) { inside++; if (measured != "0") { print; bad = 1 } }
        if ($at["failure"] == "growing boundary mode") {
            growing++
            # One step is a twentieth of the interior'"'"'s limit; faster modes than it resolves are
            # another matter, and so are waves that grow faster than the mode.
            rate = $at["growing_mode_rate"]
            if (measured <= 0) { print; bad = 1 }
            if (rate < 1 && measured < 0.95 * rate) { print; bad = 1 }
        }
        if ($at["supremum"] > 1.2) { amplified++; if (measured <= 0) { print; bad = 1 } }
        if (measured > 0 && $at["grade"] != "none") { print; bad = 1 }
    }
    END { exit bad || inside < 80 || growing < 50 || amplified < 5 }' out/points.csv

# The edges that theory knows: 208/85, 1032/1445.
expect "modal windows" grep -qx '2,2,1,modal,2.44705882,3.7742[0-9]*' out/windows.csv
expect "modal windows, stride 2" grep -qx '2,2,2,modal,0.714186851,2.9699[0-9]*' out/windows.csv
rm -r out

# refuses CODE TEXT ARGUMENT..
refuses() {
    local expected=$1 text=$2
    shift 2
    try "$stability_atlas" "$@"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_no_stdout
    expect_nothing_written
}
refuses 2 "--horizon" --horizon 5
refuses 2 "--points" --points 1
refuses 2 "--points needs a value" --points
refuses 2 "unknown option --G" --G 1
refuses 5 "/dev/null" --horizon 1 --points 2 --out /dev/null/folder

# What to choose, from the committed tables: NMBC2 with stride 2 at n = 2, bold as it is contractive.
program=$stability_atlas
try choices --horizon 2 --G 1,3
expect_exit 0
expect_stdout_line "| n | order | stride | tau | dt | G = 1 | G = 3 |"
expect "NMBC2, stride 2" grep -qxE '\| 2 \| 2 \| 2 \| 0 \|  \| \*\*0\.[0-9]{2}\*\* \|  \|' "$scratch/stdout"
for G in nan inf 1e308 abc ""; do
    try choices --G "$G"
    expect_exit 2
    expect_stderr "is not a number from 0 to 1e+06"
done
try choices --G -1
expect_exit 2
expect_stderr "--G"
finish
