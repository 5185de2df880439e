#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Table 2 of Nicely 2018: NMBC1 within a factor 2 of print for every horizon, and both rows as a
# prototype found them before the project began; its 'ideal' row is not the printed one either.
# Usage: run_table2.sh NMBCRUN SOURCE_FOLDER
set -euo pipefail
# Arguments first: they are told apart from a program that failed.
for bad in --bad /nowhere/nmbcrun "$1 again"; do
    code=0
    # shellcheck disable=SC2086  # the last one is two arguments
    "$2/tools/scripts/table2" $bad 2>/dev/null || code=$?
    [ "$code" -eq 2 ] || { echo "table2 $bad: exit code $code, not 2"; exit 1; }
done
"$2/tools/scripts/table2" --help | grep -q '^Usage: tools/scripts/table2'

table=$("$2/tools/scripts/table2" "$1")
echo "$table"
# 10 %: the earlier figures have one or two digits.
awk -F'|' '
    BEGIN {
        split("5.5e-4 2.7e-3 6.6e-3 1.3e-2 2.6e-2", first, " ")
        split("8e-6 6e-4 2.9e-3 5.6e-3 9.1e-3", ideal, " ")
    }
    $2 ~ /dX/ {
        rows++
        if ($4 / $3 > 2 || $4 / $3 < 0.5) { print "not within a factor 2:" $0; bad = 1 }
        if ($4 / first[rows] > 1.1 || $4 / first[rows] < 0.9) { print "NMBC1 row:" $0; bad = 1 }
        if ($6 / ideal[rows] > 1.1 || $6 / ideal[rows] < 0.9) { print "ideal row:" $0; bad = 1 }
    }
    END { if (rows != 5) { print rows " rows"; bad = 1 }; exit bad }' <<<"$table"
