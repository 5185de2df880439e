#!/usr/bin/env bash
# Table 2 of Nicely 2018: NMBC1 within a factor 2 of print for every horizon, and the 'ideal' row
# as it was found before the project began (theory, section 6), which is not the printed one.
# Usage: run_table2.sh NMBCRUN SOURCE_FOLDER
set -euo pipefail
table=$("$2/tools/table2" "$1")
echo "$table"
# 10 %: the earlier figures have one or two digits.
awk -F'|' '
    BEGIN { split("8e-6 6e-4 2.9e-3 5.6e-3 9.1e-3", ideal, " ") }
    $2 ~ /dX/ {
        rows++
        if ($4 / $3 > 2 || $4 / $3 < 0.5) { print "not within a factor 2:" $0; bad = 1 }
        if ($6 / ideal[rows] > 1.1 || $6 / ideal[rows] < 0.9) { print "ideal row:" $0; bad = 1 }
    }
    END { if (rows != 5) { print rows " rows"; bad = 1 }; exit bad }' <<<"$table"
