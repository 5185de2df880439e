#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The example in Python, with the table made for it.
# Usage: run_python.sh NMBCGEN SOURCE_FOLDER
set -euo pipefail
nmbcgen=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$source/docs/example/tables.py" "$work"
cd "$work"
"$nmbcgen" --order 2 --horizon 1 --format python --out .
python3 tables.py | tee output
diff - output <<'EXPECTED'
NMBC2, n = 1: certified for G from 0.25 to 1
G = 1/2: steps up to cfl = dt omega_max/2 = 0.69
c = 1 6 1
b = -4 0 4
  6 nodes to a wave: 5.2e-03 of its amplitude returns
 10 nodes to a wave: 6.3e-04 of its amplitude returns
 20 nodes to a wave: 3.8e-05 of its amplitude returns
 40 nodes to a wave: 2.4e-06 of its amplitude returns
EXPECTED
