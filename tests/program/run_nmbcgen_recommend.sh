#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# nmbcgen recommend: what it recommends, why the others lost, and that it can be had.
# Usage: run_nmbcgen_recommend.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project

# row TEXT: a row of the table begins so, whatever the columns' widths.
row() { expect "the row '$1'" grep -qE "^ *${1// / +}" "$scratch/stdout"; }

# Large steps favour NMBC1: docs/how-to/choose-a-boundary.md.
try recommend --horizon 2 --G 1
expect_exit 0
expect_no_stderr
expect_stdout_line "NMBC1, stride 2, tau = 0, steps of cfl 0.97, at horizon 2, G = 1"
expect_stdout_line "  settings   --set model.horizon=2 --set model.G=1 --set boundary.kind=nmbc --set boundary.order=1 --set boundary.stride=2 --set time.cfl=0.97"
expect_stdout_line "  opposite   its like; with a fixed or free end opposite, nmbcrun advise SCENE chooses"
expect "no table to make" test "$(grep -cE '^  (table|ready) ' "$scratch/stdout")" -eq 0
row "1 1 0 - 0\.82 0\.82 8\.7e-07 0\.0e\+00 smaller time step"
row "2 2 0 - 0\.75 0\.20 6\.2e-07 0\.0e\+00 smaller time step"
row "2 2 0 1697/1000 0\.87 0\.75 3\.7e-11 0\.0e\+00 smaller time step"
row "2 1 - - - - - - not certified with cfl 0\.25 or more"

try recommend --horizon 2 --G 1 --tolerance 1e-8
expect_exit 0
expect_stdout_line "NMBC2, stride 2, tau = 0, matched in steps of cfl 0.75, at horizon 2, G = 1"
row "1 2 0 - 0\.97 0\.97 6\.3e-07 0\.0e\+00 above the tolerance"
row "3 2 0 - 0\.37 0\.05 9\.3e-10 0\.0e\+00 smaller time step"
expect_stdout_line "  settings   --set model.horizon=2 --set model.G=1 --set 'model.tables=[\"nopd1d_n2_order2_s2_dt1697o1000_G1o1.json\"]' --set boundary.kind=nmbc --set boundary.order=2 --set boundary.stride=2 --set boundary.matched_step=1697/1000"
expect_stdout_line "  table      to be made beside the scene: nmbcgen --family nopd1d --order 2 --horizon 2 --stride 2 --time-step 1697/1000 --G 1 --format json --out FOLDER"
expect_stdout_line "  ready      NMBC3, stride 2, in steps of cfl 0.05, reflects 9.3e-10: --set model.horizon=2 --set model.G=1 --set boundary.kind=nmbc --set boundary.order=3 --set boundary.stride=2 --set time.cfl=0.05"
# What it recommends is certified when it is made by the command it prints.
read -ra made < <(sed -n 's/^  command    nmbcgen //p' "$scratch/stdout")
try "${made[@]}" --require-stable
expect_exit 0
expect_file generated/nmbc/tables/nopd1d_n2_order2_s2_dt1697o1000_G1o1.hpp
rm -r generated/nmbc/tables

# What is ready is certified in these steps, too.
try recommend --horizon 2 --G 1 --cfl 0.7
expect_exit 0
row "3 2 0 - 0\.37 0\.70 - 0\.0e\+00 not certified in such steps"
expect "nothing is ready" test "$(grep -c '^  ready ' "$scratch/stdout")" -eq 0

# In steps of one's own what counts is the reflection.
try recommend --horizon 2 --G 1 --cfl 0.2
expect_exit 0
expect_stdout_line "NMBC3, stride 2, tau = 0, matched in steps of cfl 0.20, at horizon 2, G = 1"
row "2 2 0 113/250 0\.76 0\.20 5\.1e-08 0\.0e\+00 more reflection"
try recommend --horizon 2 --G 1 --order 1 --cfl 0.99
expect_exit 3
expect_stderr "not certified in such steps"

# Order 5 reflects ten decades less than all others there.
try recommend --horizon 2 --G 3 --cfl 0.5
expect_exit 0
expect_stdout_line "NMBC5, stride 2, tau = 0, matched in steps of cfl 0.50, at horizon 2, G = 3"
row "5 2 0 653/1000 0\.52 0\.50 2\.7e-17"
row "2 1 0 653/1000 0\.97 0\.50 1\.7e-07 0\.0e\+00 more reflection"

# The least of the ladder that certifies order 2 at G = 0, and what it costs.
try recommend --horizon 2 --G 0 --order 2 --tolerance 1e-4
expect_exit 0
expect_stdout_line "NMBC2, stride 4, tau = 1/20, matched in steps of cfl 0.85, at horizon 2, G = 0"
row "2 4 1/20 - 0\.75 0\.35"
expect "its damping" grep -qF -- "--set model.damping=1/20" "$scratch/stdout"
expect "100 nodes" grep -qF "in chains of 100 interior nodes and more" "$scratch/stdout"
expect_stdout_line "  loss       5.8e-03 of the energy"
try --order 2 --horizon 2 --stride 4 --damping 1/20 --G 0 --require-stable
expect_exit 0
expect_file generated/nmbc/tables/nopd1d_n2_order2_s4_tau1o20_G0o1.hpp
rm -r generated/nmbc/tables

# A band of longer waves reflects less.
try recommend --horizon 2 --G 1 --order 2 --band 0.05..0.1 --tolerance 1e-6
expect_exit 0
row "2 2 0 - 0\.75 0\.70"

# Of large G: waves near together, which roundings tell apart, or not.
try recommend --horizon 1 --G 1000
expect_exit 0
expect_stdout_line "NMBC5, stride 1, tau = 0, steps of cfl 0.99, at horizon 1, G = 1000"
try --order 5 --horizon 1 --G 10000
expect_exit 4
expect_nothing_written
expect_no_stdout
expect_stderr "no certificate: a chain of"

# Nothing reflects so little.
try recommend --horizon 2 --G 1 --order 2 --tolerance 1e-12
expect_exit 3
expect_no_stdout
expect_stderr "no certified boundary for horizon 2 at G = 1 reflects 1e-12 of the energy or less"
expect_stderr "above the tolerance"

# refused TEXT ARGUMENT..
refused() {
    local text=$1
    shift
    try recommend "$@"
    expect_exit 2
    expect_no_stdout
    expect_stderr "$text"
}
refused "--horizon (or --radius2) is required" --G 1
# A chain without stabilisation has nothing to damp.
try recommend --family chain1d --horizon 1 --order 2
expect_exit 0
expect "that no tau was tried" \
    grep -qF "not certified with cfl 0.25 or more; no tau was tried" "$scratch/stdout"
try recommend --horizon 2 --G 1 --order 5
expect_exit 3
expect_stderr "no certified boundary for horizon 2 at G = 1"
refused "recommend requires --G" --horizon 1
refused "is not a whole number from 1 to 100" --horizon 0 --G 1
for tolerance in 0 1 -1 nan inf 1e-4x ""; do
    refused "is not a number between 0 and 1" --horizon 1 --G 1 --tolerance "$tolerance"
done
for band in 0.1 0.1..0.1 0.3..0.1 0..1 1..4 ..1 1.. nan..1 0.1.2 ""; do
    refused "is not a band of wave numbers" --horizon 1 --G 1 --band "$band"
done
refused "--G" --horizon 1 --G -1
refused "is not a whole number from 1 to 8" --horizon 1 --G 1 --order 9
for cfl in 0 1 1.5; do
    refused "is not between 0 and 1" --horizon 1 --G 1 --cfl $cfl
done
for cfl in nan "" -1 x; do
    refused "non-negative exact number" --horizon 1 --G 1 --cfl "$cfl"
done
refused "'1/1000' is less than 0.01" --horizon 1 --G 1 --cfl 1/1000
refused "--family" --horizon 1 --G 1 --family other
expect "nothing written" test "$(files_in .)" -eq 0
finish
