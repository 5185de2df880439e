#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# tools/scripts/paper-closures: the table of its page, and what it refuses.
# Usage: run_closures.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
bin=$(dirname "$program")
program=$2/tools/scripts/paper-closures

try --nodes 100 --bin "$bin"
expect_exit 0
expect_no_stderr
expect "the page's table" diff \
    <(sed -n 's/^| \(printed\|corrected\) | `\(.*\)` | \(.*\) | \(.*\) | \(.*\) |$/\2,\1,100,\3,\4,\5/p' "$2/docs/evidence/closures.md" | head -n 4) \
    <(tail -n +2 "$scratch/stdout")
try --nodes 20 --step 1e-6 --bin "$bin" --plot bar.svg
expect_exit 0
expect_file bar.svg

try wu --bin "$bin"
expect_exit 0
expect_no_stderr
expect "the page's table of Wu" diff \
    <(sed -n 's/^| `\([a-z_]*\)` |[^|]*| \([^ |]*\) | \([^ |]*\) | \([^ |]*\) |$/\1,\2,\3,\4/p' "$2/docs/evidence/closures.md") \
    <(tail -n +2 "$scratch/stdout")

# end-a-body.md has these.
try cost --bin "$bin" --plot ends.svg
expect_exit 0
expect_no_stderr
expect_file ends.svg
for row in nopd1d,sbp,640,215040,0.410 bond1d,sbp,640,294400,0.0927 spline,kernel,640,263040,2.35 \
    nopd1d,cut,640,213760,1.65 fem,sbp,640,330880,0.00627; do
    expect "$row" grep -qx "$row" "$scratch/stdout"
done

refuses 2 "--nodes needs a multiple of 10" --nodes 15
refuses 2 "--nodes needs a multiple of 10" --nodes 0
refuses 2 "--nodes needs a multiple of 10" --nodes
refuses 2 "--step needs seconds, such as 2e-7" --step 1
refuses 2 "--plot needs a file that ends in .svg" --plot bar.png
refuses 2 "there is no program nowhere/nmbcgen" --bin nowhere
refuses 2 "no such option: 'all'" all
refuses 2 "with wu there is no '--plot'" wu --plot bar.svg
refuses 2 "with cost there is no '--nodes'" cost --nodes 20
finish
