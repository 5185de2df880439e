#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# tools/scripts/paper-influence: the table of its page, its picture, and what it refuses.
# Usage: run_paper_influence.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
bin=$(dirname "$program")
program=$2/tools/scripts/paper-influence

try --bin "$bin" --plot pulses.svg
expect_exit 0
expect_no_stderr
expect_file pulses.svg
expect "the page's table" diff \
    <(sed -n 's/^| \([0-9][a-z0-9 _,]*\) | \([0-9.]*\) | \([0-9.]*\) | \([0-9.]*\) |$/\1,\2,\3,\4/p' "$2/docs/how-to/influence.md") \
    <(tail -n +2 "$scratch/stdout")

refuses 2 "--plot needs a file that ends in .svg" --plot pulses.png
refuses 2 "there is no program nowhere/nmbcgen" --bin nowhere
refuses 2 "no such option: 'all'" all
finish
