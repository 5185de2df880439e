#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A run that is killed or stopped anywhere and goes on from its checkpoint writes, byte for byte,
# what it writes without that; and no damage to a checkpoint or a disk goes unnoticed.
# Usage: run_resume.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
# Everything a run can write.
long=(--quiet --set time.end=700 --set domain.nodes=400 --set output.every=97
    --set output.snapshots=1501 --set 'output.probes=[7,250]' --set output.field=true
    --set model.G=1.1)
outputs=(bar1d.csv bar1d_probes.csv bar1d.h5 bar1d_field.csv)

expect_whole_run() { # FOLDER: as the run that was left alone, and nothing else
    for file in "${outputs[@]}"; do expect_same "whole/$file" "$1/$file"; done
    expect "the outputs only" test "$(files_in "$1")" -eq 4
}

try run "$scene" "${long[@]}" --out not/there --resume
expect_exit 5
expect_stderr "cannot go on from not/there/bar1d.checkpoint: there is no such file"
expect "no folder" test ! -e not
try run "$scene" "${long[@]}" --out whole
expect_exit 0
cp "$scratch/stdout" "$scratch/report"
expect "the outputs only" test "$(files_in whole)" -eq 4

# The checkpoint of a folder, another one whenever it is replaced, or the growing files there.
# shellcheck disable=SC2086  # a pattern
written() { stat -c %i "$1"/bar1d.${awaited:-checkpoint} 2>/dev/null || true; }

# start_and_stop SIGNAL FOLDER ARGUMENT..: ends the run at a random moment after its first
# checkpoint, or whatever is awaited. Its exit code is in $code: 0 where it was faster.
start_and_stop() {
    local signal=$1 folder=$2
    shift 2
    tried="run --out $folder $* (stopped by $signal)"
    local before
    before=$(written "$folder")
    "$program" run "$scene" "${long[@]}" --out "$folder" "$@" \
        >"$scratch/stdout" 2>"$scratch/stderr" &
    local run=$!
    while [ "$(written "$folder")" = "$before" ] && kill -0 "$run" 2>/dev/null; do
        sleep 0.01
    done
    sleep "0.0$((RANDOM % 4))"
    kill "-$signal" "$run" 2>/dev/null || true
    kill "-$signal" "$run" 2>/dev/null || true # as some that stop a program do: one of both counts
    code=0
    wait "$run" 2>/dev/null || code=$?
}
# stop_on_the_way SIGNAL FOLDER ARGUMENT..: the same, in a folder of nothing or, where it is `results`,
# what is `fresh`: again where the run was done before, as it is on a machine that has no time for this script.
stop_on_the_way() {
    for _ in {1..50}; do
        rm -rf "$2"
        if [ "$2" = results ]; then fresh; fi
        start_and_stop "$@"
        if [ "$code" -ne 0 ] && [ -e "$2/bar1d.checkpoint" ]; then return; fi
    done
    fail "a run that is stopped before its end"
}
# A checkpoint every ten steps: such a run is slow, and mostly found storing one.
busy=(--set output.checkpoint=1e-9)

# Killed or stopped again and again, at last it goes on to its end.
for signal in KILL TERM; do
    stop_on_the_way "$signal" "$signal" "${busy[@]}"
    expect "stopped on the way" test "$code" -gt 128
    start_and_stop "$signal" "$signal" "${busy[@]}" --resume
    for _ in 1 2 3; do
        if [ "$code" -eq 0 ]; then break; fi
        start_and_stop "$signal" "$signal" --set output.checkpoint=0.01 --resume
    done
    if [ "$code" -ne 0 ] && test ! -e "$signal/bar1d.checkpoint"; then
        echo "ended by $signal when all was done" # and yet written
        for file in "${outputs[@]}"; do expect_same "whole/$file" "$signal/$file"; done
        continue
    fi
    if [ "$code" -ne 0 ]; then try run "$scene" "${long[@]}" --out "$signal" --resume; fi
    expect_exit 0
    expect_whole_run "$signal"
    expect "the same last lines" diff <(sed "s/whole/$signal/" "$scratch/report") "$scratch/stdout"
done

stop_on_the_way TERM stopped "${busy[@]}"
expect_exit 130
expect_stderr "--resume goes on"
expect "energies up to there" awk -F, 'END { exit NF != 12 }' stopped/bar1d.csv
h5dump -d time stopped/bar1d.h5 >"$scratch/times" || fail "snapshots up to there"
expect "the first of them" grep -qE '\(0\): 0(,|$)' "$scratch/times"

# A checkpoint with all its journals, for what follows.
fresh() { rm -rf results && cp -r stopped results; }
refused() { # CODE TEXT ARGUMENT..: and nothing in the folder has changed
    fresh
    "${damage[@]}"
    cp -r results before
    try run "$scene" "${long[@]}" --resume "${@:3}"
    expect_exit "$1"
    expect_stderr "$2"
    expect_stderr_lines 1
    expect_no_stdout
    expect "nothing changed" diff -r before results
    rm -r before
}
checkpoint=results/bar1d.checkpoint
size=$(stat -c %s stopped/bar1d.checkpoint)

damage=(true)
refused 2 "there model.G is 1.1, here 1.2" --set model.G=1.2
refused 2 "there boundary.left.order is not given, here 1" --set boundary.left.order=1
refused 2 "there output.every is 97, here 98" --set output.every=98
refused 2 "bar1d.checkpoint is at step " --set time.end=0.1
for length in 0 7 24 100 $((size - 1)); do
    damage=(truncate -s "$length" "$checkpoint")
    refused 5 "cannot go on from results/bar1d.checkpoint: it is "
done
for place in 3 12 20 30 $((size / 2)) $((size - 1)); do
    flip() {
        local byte='\377'
        if [ "$(od -An -tu1 -j "$place" -N 1 "$checkpoint")" -eq 255 ]; then byte='\0'; fi
        printf '%b' "$byte" | dd of="$checkpoint" bs=1 seek="$place" conv=notrunc status=none
    }
    damage=(flip)
    refused 5 "cannot go on from results/bar1d.checkpoint: it is "
done
damage=(rm "$checkpoint")
refused 5 "cannot go on from results/bar1d.checkpoint: there is no such file"
# A new run says that it ends what could have gone on.
fresh
try run "$scene" "${long[@]}" --quiet
expect_exit 0
expect_stderr "bar1d.checkpoint is of an earlier run, which --resume would have gone on with"
expect "no checkpoint is left" test ! -e "$checkpoint"
journal() { echo results/bar1d.csv.new-*; }
shorten() { truncate -s 10 "$(journal)"; }
damage=(shorten)
refused 5 "it has become shorter since the checkpoint"
edit() { printf 'x' | dd of="$(journal)" bs=1 seek=3 conv=notrunc status=none; }
damage=(edit)
refused 5 "it was changed since the checkpoint"
lose() { rm "$(journal)"; }
damage=(lose)
refused 5 "No such file"

# What does not change a result may differ: 1.1 or 1.10, the title, how often it is stored.
fresh
try run "$scene" "${long[@]}" --resume --set model.G=1.10 --set title=x --set output.checkpoint=9
expect_exit 0
expect_whole_run results

# To a later end: as a run to there that was left alone. Neither end is at a step of a row, so that
# the shorter run has a last one that the longer run does not have.
later=(--set time.end=750)
try run "$scene" "${long[@]}" "${later[@]}" --out longer
expect_exit 0
cp "$scratch/stdout" "$scratch/longer"
expect_as_longer() {
    expect_exit 0
    for file in "${outputs[@]}"; do expect_same "longer/$file" "results/$file"; done
    expect "the same last lines" diff <(sed "s/longer/results/" "$scratch/longer") "$scratch/stdout"
    expect "the outputs only" test "$(files_in results)" -eq 4
}
fresh
try run "$scene" "${long[@]}" "${later[@]}" --resume
expect_as_longer
rm -r results
try run "$scene" "${long[@]}" --keep-checkpoint
expect_exit 0
for file in "${outputs[@]}"; do expect_same "whole/$file" "results/$file"; done
try run "$scene" "${long[@]}" --resume --keep-checkpoint # at its end
expect_exit 0
for file in "${outputs[@]}"; do expect_same "whole/$file" "results/$file"; done
try run "$scene" "${long[@]}" "${later[@]}" --resume
expect_as_longer
# Not where the steps up to there depend on the end.
try run "$scene" --set boundary.kind=extended --set drive.centre=99 --set time.end=9 --quiet \
    --keep-checkpoint --out wide
expect_exit 0
try run "$scene" --set boundary.kind=extended --set drive.centre=99 --set time.end=10 --out wide --resume
expect_exit 2
expect_stderr "there the number of steps is 450, here 500"

# A run that starts anew leaves the old checkpoint alone until it has one of its own, and removes
# it when it is done.
fresh
try run "$scene" "${long[@]}" --set time.end=2 --set output.checkpoint=1e9
expect_exit 0
expect "nothing of the old run" test "$(files_in results)" -eq 4
awaited='csv.new-*' stop_on_the_way KILL results --set output.checkpoint=1e9
try run "$scene" "${long[@]}" --resume
expect_exit 0
for file in "${outputs[@]}"; do expect_same "whole/$file" "results/$file"; done
stop_on_the_way TERM results "${busy[@]}"
expect "a checkpoint of its own" test "$(cmp -s "stopped/bar1d.checkpoint" "$checkpoint"; echo $?)" -eq 1
expect "one run's journals" test "$(find results -name '*.new-*' | wc -l)" -eq 3
try run "$scene" "${long[@]}" --resume
expect_exit 0
expect_whole_run results

# Two at once: a run may not go on from files that another one has open, and locked.
fresh
for file in "$checkpoint" "$(journal)"; do
    exec 9<>"$file"
    flock -n 9 || fail "a lock"
    try run "$scene" "${long[@]}" --resume
    expect_exit 5
    expect_stderr "a run that goes on has it open"
    exec 9>&-
done
expect "nothing changed" diff -r stopped results

# Nothing was published: what was there is as it was.
expect_nothing_published() {
    for file in bar1d.csv bar1d_probes.csv bar1d.h5; do expect_same "stopped/$file" "results/$file"; done
    expect "no field" test ! -f results/bar1d_field.csv
}
goes_on_to_the_end() {
    try run "$scene" "${long[@]}" --resume
    expect_exit 0
    expect_whole_run results
}

# A full disk, as a limit of file size, on the way and at the end: a checkpoint goes on later.
try_full_disk() { # BLOCKS ARGUMENT..: of 1024 bytes a file
    tried="run ${*:2} on a disk of $1 blocks a file"
    code=0
    (
        ulimit -f "$1"
        exec "$program" run "$scene" "${long[@]}" --set output.checkpoint=1e9 "${@:2}"
    ) >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
    expect_exit 5
    expect_stderr "File too large"
    expect_stderr_lines 1
}
below_h5=$(($(stat -c %s whole/bar1d.h5) / 1024)) # its journal is that much smaller
for blocks in 1 20 60; do
    fresh
    try_full_disk "$blocks" --resume
    expect_stderr "--resume goes on from results/bar1d.checkpoint"
    expect_same stopped/bar1d.checkpoint "$checkpoint"
    expect_nothing_published
    goes_on_to_the_end
done
fresh
rm "$checkpoint" results/*.new-*
cp -r results before
try_full_disk 20
expect_stderr "nothing is kept of this run"
expect "nothing changed" diff -r before results
rm -r before
# While the files are published the checkpoint is stored in their place: it is at the last step.
for resume in "" --resume; do
    fresh
    if [ -z "$resume" ]; then rm "$checkpoint" results/*.new-*; fi
    # shellcheck disable=SC2086  # nothing, or the option
    try_full_disk "$below_h5" $resume
    expect_stderr "cannot write results/bar1d.h5: File too large. --resume goes on from results/bar1d.checkpoint"
    expect "another checkpoint" test "$(cmp -s stopped/bar1d.checkpoint "$checkpoint"; echo $?)" -eq 1
    expect "the growing files only" test "$(find results -name '*.new-*' | wc -l)" -eq 3
    expect_nothing_published
    try_full_disk "$below_h5" --resume # again, without a step
    expect_nothing_published
    goes_on_to_the_end
done

# Likewise where a folder gets in the way during the run.
tried="run, and a folder of the name of its field"
for _ in {1..50}; do
    fresh
    rm "$checkpoint" results/*.new-*
    "$program" run "$scene" "${long[@]}" >"$scratch/stdout" 2>"$scratch/stderr" &
    while [ -z "$(awaited='csv.new-*' written results)" ] && kill -0 $! 2>/dev/null; do sleep 0.01; done
    if mkdir results/bar1d_field.csv 2>/dev/null; then break; fi
    wait $! # which was faster
done
code=0
wait $! || code=$?
expect_exit 5
expect_stderr "bar1d_field.csv: a folder of that name is in the way. --resume goes on"
expect_nothing_published
rmdir results/bar1d_field.csv
goes_on_to_the_end

# In the way from the start: no step is taken, and nothing changes.
for name in bar1d{.csv,_probes.csv,_field.csv,.h5,.checkpoint}; do
    for way in "mkdir" "mkfifo --resume"; do
        read -r make resume <<<"$way"
        fresh
        rm -f "results/$name"
        "$make" "results/$name"
        ls -lR --full-time results >"$scratch/before"
        # shellcheck disable=SC2086  # nothing, or the option
        try run "$scene" "${long[@]}" $resume
        expect_exit 5
        expect_stderr "cannot write results/$name: "
        expect_stderr "of that name is in the way"
        expect_stderr_lines 1
        expect_no_stdout
        expect "nothing changed" diff "$scratch/before" <(ls -lR --full-time results)
    done
done
finish
