#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# tools/scripts/paper-2d: its tables have the rows of their page, beside what runs leave; pictures, and what it
# refuses. A program that leaves always as much stands in for nmbcrun: plane_sides has what that leaves.
# Usage: run_paper_2d.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
page=$2/docs/evidence/paper-2d.md
program=$2/tools/scripts/paper-2d

cat >nmbcrun <<'PROGRAM'
#!/usr/bin/env bash
while [ $# -gt 0 ]; do
    case $1 in
        --out) folder=$2 ;;
        output.name=*) name=${1#*=} ;;
        boundary.*.kind=*) kind=${1##*=} ;;
    esac
    shift
done
printf '# a comment\ntime,kinetic,total\n0,0,2\n1,1,1e-3\n' >"$folder/$name.csv"
case ${kind-passive} in
    nmbc) left=1e-03 ;;
    passive) left=2e-03 ;;
    extended) left=3e-03 ;;
esac
echo "energy left  $left of the peak"
PROGRAM
chmod +x nmbcrun

for table in table3 table4 table5; do
    try $table --nmbcrun ./nmbcrun --plot $table.svg
    expect_exit 0
    expect_no_stderr
    expect_file $table.svg
    expect "the rows of the page, with what runs leave" diff \
        <(awk -v heading="## Table ${table#table}:" '/^## / { here = index($0, heading) == 1 } here' "$page" |
            sed -n 's/^\(|[ 0-9]*|[ 0-9.]*|[^|]*|\).*/\1/p') \
        <(sed -n 's/^\(|[ 0-9]*|[ 0-9.]*|[^|]*|\)  *1e-03 |  *2e-03 |  *3e-03 |$/\1/p' "$scratch/stdout")
done

refuses 2 "which table?"
refuses 2 "no such table: 'table6'" table6
refuses 2 "one table at a time, not table4, too" table3 table4
refuses 2 "there is no program nowhere/nmbcrun" table3 --nmbcrun nowhere/nmbcrun
refuses 2 "--plot needs a file that ends in .svg" table3 --plot fig15.png
finish
