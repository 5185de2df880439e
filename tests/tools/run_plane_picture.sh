#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The commands of docs/how-to/plane-waves.md, as they stand there: they run, and draw what the page
# has; the polar picture of docs/how-to/plane-sides.md. Usage: run_plane_picture.sh NMBCGEN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
nmbcgen=$1
source=$2

try_document "$source/docs/how-to/plane-waves.md" "$source"
expect_file results/tables/nopd2d_r4_nu1o4_P_n2_order1.hpp
expect_picture docs/images/plane_dispersion.svg "$source"
expect_picture docs/images/dispersion_surface.svg "$source"

# The polar picture of docs/how-to/plane-sides.md.
mkdir -p docs/images
program=$nmbcgen
try recommend --family nopd2d --radius2 1 --nu 1/4 --G 0 --csv
expect_exit 0
cp "$scratch/stdout" sides.csv
expect "a header and a row for each boundary, wave, xi and degree" awk -F, '
    NR == 1 { exit !($0 == "boundary,wave,xi,degrees,reflected") }' sides.csv
expect "rows" test "$(wc -l <sides.csv)" -eq $((1 + 4 * 2 * 3 * 90))
expect "printed (81) sends 0.058 of S waves back head-on" grep -q "^NMBC1 as printed (81),S,0.1,0,0.05779" sides.csv
try recommend --family nopd2d --radius2 1 --nu 1/4 --G 0 --polarisation P --csv
expect_exit 2
expect_stderr "without --polarisation"
try recommend --horizon 1 --G 0 --csv
expect_exit 2
program=$(command -v gnuplot)
try -c "$source/tools/plots/side_reflection.gp" sides.csv docs/images/side_reflection.svg
expect_exit 0
expect_picture docs/images/side_reflection.svg "$source"
try -c tools/plots/plane_dispersion.gp results/plane.csv
expect_exit 2
expect_stderr "usage: gnuplot -c plane_dispersion.gp CSV OUT.svg"

finish
