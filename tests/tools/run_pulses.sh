#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The energy left of a pulse: numbers known otherwise, the table of docs/pulses.md, and bad
# arguments refused.
# Usage: run_pulses.sh PULSES SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"

# left COLUMN ROW: an energy of the last output; columns as Markdown, rows by "n | G".
left() {
    awk -F' *[|] *' -v column="$1" -v row="$2" \
        '$2 " | " $3 == row && NF > 10 { gsub(/[*]/, ""); print $column; exit }' "$scratch/stdout"
}
# near VALUE EXPECTED SHARE
near() { awk -v a="$1" -v b="$2" -v s="$3" 'BEGIN { exit !(a >= b * (1 - s) && a <= b * (1 + s)) }'; }

# A prototype found these before the project began, at cfl 0.4; they have one digit or two.
try --horizons 2 --G 1,3/2 --half-widths 10 --cfl 0.4
expect_exit 0
expect_no_stderr
expect "NMBC1, G = 1" near "$(left 5 '2 | 1')" 8e-8 0.1
expect "NMBC2, G = 1" near "$(left 8 '2 | 1')" 1.4e-8 0.1
expect "NMBC1, G = 3/2" near "$(left 5 '2 | 3/2')" 7e-10 0.1
expect "NMBC2, G = 3/2" near "$(left 8 '2 | 3/2')" 3e-11 0.1
expect_stdout_line "Order 2 or more is below NMBC1 in 2 of 2."

# Standard NOPD, n = 2: omega = 2 (sin xi + 2 sin 2 xi)/10 and sigma = -(C + S^2/10)/4. At xi =
# pi/10 that is a rate tau sigma = 2.4407e-4 at a group velocity of 0.83742: over 20 dX, 5.81e-3.
try --horizons 2 --G 0 --half-widths 20 --cfl 0.1
expect_exit 0
expect_stdout_line "| 2 | 0 | 1/20 | 5.8e-03 | 4.4e-01 |"

# Matched in time steps: all in these steps, and nothing where no such table is committed.
try --matched --horizons 2 --G 1,2 --half-widths 20
expect_exit 0
expect "NMBC2 in steps of 1 dX/c" grep -qE '^\| 2 \| 1 \| 0\.44 \| 1\.0e-11 \| NMBC2, s = 2 \| 0\.44 \| 2\.8e-19 \|' "$scratch/stdout"
expect_stdout_line "Order 2 or more is below NMBC1 in 2 of 2."

# Nothing certified: empty, not compared. NMBC1 is not at n = 2, G = 4; n = 5 has no higher order.
try --horizons 2,5 --G 4 --half-widths 20 --cfl 0.2
expect_exit 0
expect "no NMBC1" test -z "$(left 5 '2 | 4')"
expect "no higher order" test -z "$(left 8 '5 | 4')"
expect_stdout_line "Order 2 or more is below NMBC1 in 0 of 0."

# The last section of the page is what the program prints.
try
expect_exit 0
sed '1,/^## In the largest steps$/d' "$2/docs/pulses.md" | tail -n +2 >../page
expect "docs/pulses.md ends in the output of pulses" cmp ../page "$scratch/stdout"

# refuses TEXT ARGUMENT..
refuses() {
    local text=$1
    shift
    try "$@"
    expect_exit 2
    expect_stderr "$text"
    expect_stderr_lines 2
    expect_no_stdout
}
for G in -1 1e7 1e308 1/0 1/-2 x nan inf 1/2/3 1e999; do
    refuses "$G is no G: 0 to 1e+06, as in 1/4 or 0.25, is allowed" --G="$G"
done
refuses "--horizons" --horizons 6
refuses "--half-widths" --half-widths 1
refuses "--cfl" --cfl 0
refuses "'nan' is not a number from 0.01 to 1" --cfl nan
refuses "'nan' is not a number from 2 to 50" --half-widths nan
refuses "--cfl excludes --matched" --matched --cfl 0.5
refuses "again" again
if [ -e /dev/full ]; then
    code=0
    "$program" --horizons 1 --G 1 --half-widths 10 >/dev/full 2>"$scratch/stderr" || code=$?
    expect_exit 5
    expect_stderr "could not be written"
fi
expect_nothing_written
finish
