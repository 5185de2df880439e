#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The commands of docs/explanation/dispersion.md, as they stand there: they run, and print and draw what the
# document has. Usage: run_dispersion_picture.sh NMBCGEN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
source=$2
document=$source/docs/explanation/dispersion.md

try_document "$document" "$source"
expect "two commands" test "$(grep -cE '^(build/bin/nmbcgen|gnuplot) ' commands)" -eq 2

expect_picture docs/images/dispersion.svg "$source"

# Another choice of curves, without limits.
build/bin/nmbcgen dispersion --horizon 4 --G 1/3,2 --samples 20 >other.csv
program=$(command -v gnuplot)
try -c tools/plots/dispersion.gp other.csv other.svg
expect_exit 0
expect_no_stderr
expect "its values of G in the key" grep -q 'G = 0.3333333333333333' other.svg
expect "no limit" test "$(grep -c 'limit' other.svg)" -eq 0
try -c tools/plots/dispersion.gp other.csv
expect_exit 2
expect_stderr "usage: gnuplot -c dispersion.gp CSV OUT.svg"

finish
