#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# nmbcgen optimise: what it prints, and that the command in it makes a certified table.
# Usage: run_nmbcgen_optimise.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project

# row TEXT: a row of the table begins so, whatever the columns' widths.
row() { expect "the row '$1'" grep -qE "^ *${1// / +}" "$scratch/stdout"; }

# recommended FILE: the command in the last line makes this table, certified.
recommended() {
    local made
    expect "a command in the last line" \
        grep -qE '^  command    nmbcgen ' <(tail -1 "$scratch/stdout")
    read -ra made < <(sed -n '$s/^  command    nmbcgen //p' "$scratch/stdout")
    try "${made[@]}" --require-stable
    expect_exit 0
    expect_file "generated/nmbc/tables/$1"
    rm -r generated/nmbc/tables
}

request=(optimise --order 2 --horizon 2 --G 1 --band 0.05..0.3)
try "${request[@]}"
expect_exit 0
expect_no_stderr
expect_stdout_line "NMBC2, stride 2, matched at 0:1,1/8:1,131/500:1, at horizon 2, G = 1"
expect_stdout_line "  reflected  2.4e-09 of the energy, mean over the band, 1.6e-08 at most"
expect_stdout_line "  standard   6.2e-08 with stride 2, 4.4e-07 at most"
expect_stdout_line "  certified  stable with both ends alike, in steps of cfl 0.75 or less"
row "1 - 1\.2e-10 8\.5e-10 - a boundary mode grows"
row "2 - 6\.2e-08 4\.4e-07 0\.75"
row "2 0:3,127/500:1 5\.1e-09 3\.4e-08 0\.75"
row "2 0:1,1/8:1,131/500:1 2\.4e-09 1\.6e-08 0\.75 the best"
for stride in 1 2 3 4; do
    expect "three rows of stride $stride" \
        test "$(grep -cE "^ +$stride  (-|0:)" "$scratch/stdout")" -eq 3
done
# The columns of numbers end where their titles do.
# shellcheck disable=SC2016  # the dollars are awk's
expect "a table that lines up" awk '
    /^stride / { titles = index($0, " certified") + 9 }
    titles && /^ +[0-9]+  / { if (substr($0, titles) !~ /^[0-9-](  |$)/) exit 1; rows++ }
    END { exit rows != 12 }' "$scratch/stdout"
cp "$scratch/stdout" "$scratch/first"
recommended nopd1d_n2_order2_s2_at1o8x1_at131o500x1_G1o1.hpp
for run in 1 2 3; do
    try "${request[@]}"
    expect_same "$scratch/stdout" "$scratch/first"
done

# One stride; damped; in time steps.
try optimise --order 2 --horizon 1 --G 1/2 --band 0.3..0.8 --time-step 1/2 --damping 1/20 --stride 1
expect_exit 0
expect "in long chains" grep -qF "in chains of 100 interior nodes and more, in these steps, of cfl 0.50" \
    "$scratch/stdout"
expect "of one stride" test "$(grep -cE "^ +[0-9]+  (-|0:)" "$scratch/stdout")" -eq 3
recommended nopd1d_n1_order2_tau1o20_dt1o2_at433o1000x1_at143o200x1_G1o2.hpp

# Steps by their cfl: NMBC1 is the same in them.
try optimise --order 1 --horizon 2 --G 1 --band 0.3..0.8 --cfl 1/2
expect_exit 0
expect_stdout_line \
    "mean, largest: reflected energy at 64 wave numbers between xi = 0.3 and 0.8/dX, in steps of 1131/1000 dX/c"
recommended nopd1d_n2_order1_dt1131o1000_at143o250x1_G1o1.hpp

# With a point next to pi, without which nothing is certified there.
try optimise --order 2 --horizon 2 --G 1/2 --band 0.3..0.8 --stride 1
expect_exit 0
expect_stdout_line "NMBC2, stride 1, matched at 0:1,629/1000:1,3131/1000:1, at horizon 2, G = 1/2"
row "1 0:1,629/1000:1,3131/1000:1 3\.1e-03 1\.2e-02 0\.57 the best"

# Along the edge of what is certified, where no point alone can move.
try optimise --order 2 --horizon 5 --G 4 --band 0.1..0.4 --stride 5
expect_exit 0
row "5 0:1,17/125:1,83/250:1 8\.8e-05 1\.0e-03 0\.46 the best"

# A standard condition does not exist there, others do.
try optimise --order 2 --horizon 1 --G 0 --band 0.05..3.1 --stride 1
expect_exit 0
row "1 - - - - no such condition"
expect_stdout_line "  standard   none is certified"

# Nothing is certified.
try optimise --order 2 --horizon 2 --G 1/2 --band 0.3..0.8 --stride 3
expect_exit 4
expect_no_stdout
expect_stderr "nothing of order 2 is certified at horizon 2, G = 1/2"
expect_stderr "a boundary mode grows"
expect "no command" test "$(grep -c "command" "$scratch/stderr")" -eq 0

# No such steps.
try optimise --order 2 --horizon 1 --G 1 --band 0.3..0.8 --time-step 100
expect_exit 3
expect_stderr "leapfrog itself is unstable"

# refused TEXT ARGUMENT..
refused() {
    local text=$1
    shift
    try optimise "$@"
    expect_exit 2
    expect_no_stdout
    expect_stderr_lines 2
    expect_stderr "$text"
}
all=(--order 1 --horizon 1 --G 1 --band 0.3..0.8)
refused "--order is required" --horizon 1 --G 1 --band 0.3..0.8
refused "--horizon (or --radius2) is required" --order 1 --G 1 --band 0.3..0.8
refused "optimise requires --G" --order 1 --horizon 1 --band 0.3..0.8
refused "--band is required" --order 1 --horizon 1 --G 1
for order in 0 9 99999999999 -1 1.5 nan ""; do
    refused "is not a whole number from 1 to 8" --horizon 1 --G 1 --band 0.3..0.8 --order "$order"
done
for stride in 0 101 -1 1,2 ""; do
    refused "is not a whole number from 1 to 100" "${all[@]}" --stride "$stride"
done
for band in 0.1 0.1..0.1 0.3..0.1 0..1 1..4 ..1 1.. nan..1 0.1..inf 1e308..1 0.1.2 ""; do
    refused "is not a band of wave numbers" --order 1 --horizon 1 --G 1 --band "$band"
done
refused "is narrower than 1e-06" --order 1 --horizon 1 --G 1 --band 1..1.0000001
refused "--match" "${all[@]}" --match 0:1,1:1
refused "--samples" "${all[@]}" --samples 3
for option in order horizon G band; do
    refused "--$option is given 3 times, where once is allowed" "${all[@]}" "--$option" 1 "--$option" 1
done
refused "--time-step and --cfl exclude each other: give one of them" "${all[@]}" --cfl 1/2 --time-step 1/2
refused "is not between 0 and 1" "${all[@]}" --cfl 1
refused "non-negative exact number" "${all[@]}" --damping nan
refused "--family" "${all[@]}" --family other
expect "nothing written" test "$(files_in .)" -eq 0
finish
