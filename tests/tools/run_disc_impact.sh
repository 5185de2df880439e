#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2034,SC2154  # assert.sh defines what is used here
# tools/scripts/disc-impact: what it refuses, and where there is LAMMPS a small disc.
# Usage: run_disc_impact.sh SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
program=$1/tools/scripts/disc-impact

refuses 2 "apt-get install lammps" --lammps nowhere/lmp
refuses 2 "--lammps needs a program" --lammps
refuses 2 "--diameter needs 10 to 99 mm" --diameter 100
refuses 2 "--time needs a multiple of 10 us" --time 15
refuses 2 "--plot needs a file that ends in .png" --plot disc.svg
refuses 2 "no such option: 'all'" all

if command -v lmp >/dev/null; then
    try --diameter 12 --time 20 --plot disc.png
    expect_exit 0
    expect_no_stderr
    expect_file disc.png
    expect "damage in time" test "$(grep -cE '^(0|10|20),0\.[0-9]{4},0\.[0-9]{4},[01]\.[0-9]{4}$' "$scratch/stdout")" -eq 3
    expect_stdout_line "0,0.0000,0.0000,0.0000"
    # The six layers of a disc of 24 spacings, and those in the middle break first.
    expect "two rings" awk -F, '/^(0\.\.5|5\.\.10),/ { all += $2; damage[++rings] = $3 }
        END { exit !(rings == 2 && all == 2646 && damage[1] > damage[2] && damage[2] > 0 && damage[1] < 1) }' "$scratch/stdout"
fi
finish
