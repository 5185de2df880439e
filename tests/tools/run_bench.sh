#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The benchmark of the generator at its smallest orders: the shape of its tables, and that answers
# are checked. Nothing is asked of a time.
# Usage: run_bench.sh GENERATOR_BENCH SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
generator_bench=$program
program=$2/tools/bench/generator
time='([0-9.e-]+ s|> [0-9.]+ s)'

# An answer that does not solve (49) ends the program with 1, whoever gives it.
try "$generator_bench" --limit 5 --up-to 2
expect_exit 0
for system in Maxima PARI/GP SymPy; do
    expect "$system is told of" grep -qE "(^|; )$system: ([0-9.]+|not installed)" "$scratch/stdout"
done
expect "both orders, each solved by nmbc" test "$(grep -cE '^\| +[12] \| +[0-9.e-]+ s \|' "$scratch/stdout")" -eq 2
expect "G open" test "$(grep -cE "^\|  8 \| +[123] \| every G \| +$time \|" "$scratch/stdout")" -eq 3
expect "G given" test "$(grep -cE "^\| 16 \| +[123] \| +9/7 \| +$time \|" "$scratch/stdout")" -eq 3
# The columns of each of the two tables line up.
expect "lines of one length" test "$(awk '/^\|/ { print length }' "$scratch/stdout" | sort -u | wc -l)" -le 2
expect_nothing_written

# A program with a wrong answer: c_1 = 3 in the place of 1.
printf '%s\n' '#!/bin/sh' 'echo seconds 1' 'printf "value %s\n" 1 3 -14/3 14/3' >"$scratch/wrong"
printf '%s\n' '#!/bin/sh' 'echo no such file >&2' 'exit 1' >"$scratch/broken"
chmod +x "$scratch/wrong" "$scratch/broken"
try "$scratch/wrong" --up-to 1
expect_exit 1
expect_stderr "nmbc is wrong at N = 1: row 1 of (49) does not hold"
# One that fails is named, and is no end of the others.
try "$scratch/broken" --up-to 1
expect_exit 0
expect_stderr "broken failed, and is out: no such file"
expect "its place in the table" grep -qE '^\|  1 \| failed \|' "$scratch/stdout"

# fails CODE TEXT ARGUMENT..: and leaves no file.
fails() {
    refuses "$@"
    expect_nothing_written
}
for limit in 0 nan inf 1e308 -1 "" abc; do
    fails 2 "argument --limit: '$limit' is not above 0" --limit="$limit"
done
for order in 0 33 1e1 2,,3 ""; do
    fails 2 "argument --up-to: '$order' is not an order from 1 to 32" --up-to="$order"
done
fails 2 "--limit: expected one argument" --limit
fails 2 "unrecognized arguments: --nonsense" --nonsense
fails 2 "no program nothere (build it first)" nothere

program=$generator_bench
fails 2 "subcommand is required"
fails 2 "--order" solve --order 0
fails 2 "--horizon" derive --order 1 --horizon 2,,3
finish
