#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs that are stopped, by which signal and when, and what they leave.
# Usage: run_stopped.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/bar.bash"

# Stopped on the way: the energies so far under their own name, and nothing else.
rm -rf results
"$program" run "$scene" --quiet --set time.end=1e8 >"$scratch/stdout" 2>"$scratch/stderr" &
for _ in {1..200}; do  # until it is under way
    compgen -G 'results/*.new-*' >/dev/null && break
    sleep 0.1
done
kill -TERM $!
code=0
wait $! || code=$?
expect_exit 130
expect_stderr "stopped at step"
expect_stderr "--resume goes on"
expect_stderr "e+09 steps of 508 nodes take about"
expect_file results/bar1d.csv
expect "and to go on from, a checkpoint and a growing file" test "$(files_in results)" -eq 3
expect "no lock, no link" test ! -e results/bar1d.lock -a ! -L results/bar1d.csv.part

# While a run goes on its energies can be read, and no other run takes its names.
rm -rf results
env --default-signal=HUP "$program" run "$scene" --set time.end=1e7 >"$scratch/stdout" \
    2>"$scratch/stderr" &
first=$!
for _ in {1..200}; do
    if grep -qs '^[0-9]' results/bar1d.csv.part; then break; fi
    sleep 0.1
done
expect "rows so far" grep -q '^[0-9]' results/bar1d.csv.part
expect "how long it takes, though stdout is no terminal" grep -qE '^time      [0-9]{9} steps of 0.02 .*, about [0-9]+ min at 5e\+08 node-steps a second$' "$scratch/stdout"
for resume in "" --resume; do
    # shellcheck disable=SC2086  # nothing, or the option
    try run "$scene" "${short[@]}" $resume
    expect_exit 5
    expect_stderr "cannot open results/bar1d.lock: it is held by process $first on "
    expect_stderr ": wait for it, or give another output.name or --out"
    expect_no_stdout
done
try run "$scene" "${short[@]}" --set output.name=other
expect_exit 0
# SIGHUP, as when a terminal is closed, is like SIGTERM.
tried="run, and SIGHUP"
kill -HUP $first
code=0
wait $first || code=$?
expect_exit 130
expect_file results/bar1d.checkpoint
# What is killed leaves files; the next run of that name removes them when it is done.
"$program" run "$scene" --set time.end=1e7 --set output.checkpoint=1e-9 >/dev/null 2>&1 &
sleep 0.5
kill -KILL $!
wait $! 2>/dev/null || true
touch results/bar1d_probes.csv.new-1 # of somebody else: no header
try run "$scene" "${short[@]}"
expect_exit 0
expect "the energies of two runs, and what is not its own" diff - <(ls results) <<<"bar1d.csv
bar1d_probes.csv.new-1
other.csv"

# Before the first step nothing is there to be kept: a signal ends the program at once. (An exact
# end for many steps takes a while to make.)
env --default-signal=INT "$program" run "$scene" --set boundary.kind=exact --set time.end=3900 \
    --out early >"$scratch/stdout" 2>"$scratch/stderr" &
sleep 0.3
kill -INT $!
code=0
wait $! || code=$?
expect_exit 130
expect "nothing written" test ! -e early

# While a scene is waited for, a signal ends the program.
mkfifo "$scratch/pipe"
"$program" run "$scratch/pipe" >"$scratch/stdout" 2>"$scratch/stderr" &
sleep 0.2
kill -TERM $!
code=0
wait $! || code=$?
expect_exit 130

finish
