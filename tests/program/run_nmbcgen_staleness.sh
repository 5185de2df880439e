#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# nmbcgen --check on a copy of the committed tables: it notices every way of being stale, names
# the file, and the command it prints mends it.
# Usage: run_nmbcgen_staleness.sh NMBCGEN COMMITTED_FOLDER
committed=$(realpath "$2")
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

fresh_copy() {
    rm -rf tables
    cp -r "$committed" tables
}

is_up_to_date() {
    try --check --out tables
    expect_exit 0
    expect_stderr "up to date"
    expect_no_stdout
}

# is_stale LINE..: each line is in the report, which ends with the mending command.
is_stale() {
    cp -r tables before
    try --check --out tables
    expect_exit 1
    expect_no_stdout
    for line in "$@"; do
        expect_stderr "$line"
    done
    expect_stderr "nmbcgen --all --out tables"
    expect "--check changes nothing" diff -r before tables
    rm -r before
}

# Runs the command that the last report printed.
mend() {
    local arguments
    arguments=$(sed -n 's/.*To write them anew: nmbcgen //p' "$scratch/stderr")
    # shellcheck disable=SC2086  # words are meant
    try $arguments
    expect_exit 0
}

fresh_copy
is_up_to_date

# One changed byte in a table, shown with the line as it is and as it should be.
sed -i 's/"576 -170"/"576 -171"/' tables/nopd1d_n2_order2.hpp
is_stale "differs: nopd1d_n2_order2.hpp" \
    '-    {"576 -171", "-128 85"},' '+    {"576 -170", "-128 85"},'
mend
is_up_to_date
expect "mended to the committed set" diff -r "$committed" tables

# A byte more, a byte less, another kind of line end: at the end of the file nothing shows.
printf '\n' >>tables/nopd1d_n1_order1.hpp
is_stale "differs: nopd1d_n1_order1.hpp"
mend
truncate -s -1 tables/nopd1d_n1_order1.hpp
is_stale "differs: nopd1d_n1_order1.hpp"
mend
sed -i 's/$/\r/' tables/tables.hpp
is_stale "differs: tables.hpp"
mend
: >tables/tables.hpp
is_stale "differs: tables.hpp"
mend
is_up_to_date

# Missing files.
rm tables/nopd1d_n3_order4.hpp
is_stale "missing: nopd1d_n3_order4.hpp"
mend
rm tables/tables.json tables/tables.hpp
is_stale "missing: tables.json" "missing: tables.hpp"
mend
rm -r tables
mkdir tables
is_stale "missing: nopd1d_n1_order1.hpp" "missing: tables.hpp" "missing: tables.json"
mend
expect "mended to the committed set" diff -r "$committed" tables

# tables.json of another day.
sed -i 's/"stride": 1/"stride": 2/' tables/tables.json
is_stale "differs: tables.json"
mend
sed -i '$d' tables/tables.json
is_stale "differs: tables.json"
mend
is_up_to_date

# The header of a lattice is one of the set; other files beside the set do not matter.
sed -i 's/"4 -15"/"4 -16"/' tables/nopd1d_n2.hpp
is_stale "differs: nopd1d_n2.hpp" '-    {"4 -16", "100"},' '+    {"4 -15", "100"},'
mend

# Other files beside the set are named, and may stay.
"$program" --order 2 --horizon 1 --G 1/2 --uncertified --out tables >/dev/null
echo "something" >tables/notes.txt
is_up_to_date
expect_stderr "not of the committed set, and not compared: nopd1d_n1_order2_G1o2.hpp, notes.txt"

finish
