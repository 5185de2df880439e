#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The commands of docs/how-to/plane-waves.md, as they stand there: they run, and draw what the page
# has. Usage: run_plane_picture.sh NMBCGEN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
source=$2

try_document "$source/docs/how-to/plane-waves.md" "$source"
expect_file tables/nopd2d_r4_nu1o4_P_n2_order1.hpp
expect_picture docs/images/plane_dispersion.svg "$source"

program=$(command -v gnuplot)
try -c tools/plots/plane_dispersion.gp plane.csv
expect_exit 2
expect_stderr "usage: gnuplot -c plane_dispersion.gp CSV OUT.svg"

finish
