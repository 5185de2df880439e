#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# The whole program, 20 times: the same bytes each time, however the system lays out memory.
# Usage: run_nmbcgen_determinism.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

switch=/proc/sys/kernel/randomize_va_space
if [ -r "$switch" ] && [ "$(cat "$switch")" -ne 0 ]; then
    echo "address randomisation is on ($(cat "$switch"))"
else
    echo "NOTE: address randomisation is off or unknown here: this run shows less than it could"
fi

for run in $(seq 20); do
    # Environment and working folder move the stack and the heap about, too.
    mkdir "folder$run"
    tried="nmbcgen --all, run $run"
    code=0
    (cd "folder$run" && PADDING=$(printf "%$((run * 997))s" "") TZ="UTC-$((run % 12))" \
        "$program" --all --out . >"$scratch/stdout" 2>"$scratch/stderr") || code=$?
    expect_exit 0
    expect "88 files" test "$(files_in "folder$run")" -eq 88
    expect "run $run is run 1, byte for byte" diff -r folder1 "folder$run"
done

# The order of directory entries and the locale do not matter either.
tried="nmbcgen --all in another locale"
LC_ALL=C.UTF-8 "$program" --all --out locale >/dev/null
expect "the same in another locale" diff -r folder1 locale

finish
