#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs of plane scenes that are killed or stopped go on byte for byte, with what else is in their folders.
# Usage: run_plane_resume.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml

# A run that is killed, and one that is stopped, go on byte for byte.
common=(--set output.format=hdf5 --set output.snapshots=300 --set output.field=true --set 'output.probes=[[10, 10]]' --set output.checkpoint=0.1
    --set model.G=1 --set time.step=0.04 --set boundary.allow_unstable=true --set time.end=40 --quiet)
for sides in "boundary.left.kind=higdon" "boundary.kind=pml boundary.layer=10"; do
    kept=("${common[@]}")
    for one in $sides; do kept+=(--set "$one"); done
    try run "$scene" "${kept[@]}" --out whole
    expect_exit 0
    "$program" run "$scene" "${kept[@]}" --out stopped >"$scratch/stdout" 2>&1 &
    running=$!
    until [ -e stopped/plane_pulse.checkpoint ]; do sleep 0.01; done
    kill -KILL $running
    wait $running 2>/dev/null || true
    try run "$scene" --resume --out stopped "${kept[@]}" --set model.G=0.5
    expect_exit 2
    expect_stderr "there model.G is 1, here 0.5"
    # Nothing that it has kept is lost, or replaced by nothing, where its files are gone or the disk is full.
    first=$(echo stopped/plane_pulse_snapshots.new-*)/000000000.h5
    mv $first first.h5
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "$first is missing: the run cannot go on from its checkpoint"
    head -c 1000 first.h5 >$first
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "$first is too short"
    mv first.h5 $first
    probes=$(echo stopped/plane_pulse_probes.csv.new-*)
    cp "$probes" probes.csv
    printf 'x' | dd of="$probes" bs=1 conv=notrunc status=none
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "it was changed since the checkpoint"
    cp probes.csv "$probes"
    rm probes.csv
    expect "its snapshots stay" test -s $first
    code=0
    (
        ulimit -f 20
        exec "$program" run "$scene" "${kept[@]}" --set output.checkpoint=1e9 --resume --out stopped
    ) >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
    expect_exit 5
    expect_stderr "File too large. --resume goes on from stopped/plane_pulse.checkpoint"
    expect "its snapshots stay" test -s $first
    "$program" run "$scene" "${kept[@]}" --resume --out stopped >"$scratch/stdout" 2>&1 &
    running=$!
    sleep 0.3
    kill -TERM $running 2>/dev/null || true  # SIGINT is ignored in the background of a script
    wait $running || true
    if [ -e stopped/plane_pulse.checkpoint ]; then
        try run "$scene" "${kept[@]}" --resume --out stopped
        expect_exit 0
    fi
    expect "the same files, byte for byte" diff -r whole stopped
    expect_no_leftovers stopped
    try run "$scene" "${kept[@]}" --resume --out stopped
    expect_exit 5
    expect_stderr "there is no such file"
    rm -r whole stopped
done

# .. and with their own snapshots, where a run that starts anew has been killed behind their step: of a run that was
# stopped they are published, of one that was killed they still grow.
"$program" run "$scene" "${common[@]}" --out whole >"$scratch/stdout" 2>&1
for signal in TERM KILL; do
    "$program" run "$scene" "${common[@]}" --out stopped --set output.checkpoint=1e-9 >"$scratch/stdout" 2>&1 &
    running=$!
    until [ -e stopped/plane_pulse.checkpoint ] || ! kill -0 $running 2>/dev/null; do sleep 0.01; done
    kill -$signal $running
    wait $running 2>/dev/null || true
    expect "$signal: stopped on the way" test -e stopped/plane_pulse.checkpoint
    if [ $signal = KILL ]; then  # again, behind a snapshot that the checkpoint knows nothing of and an earlier end has not
        "$program" run "$scene" --resume --out stopped "${common[@]}" --set output.checkpoint=1e9 >"$scratch/stdout" 2>&1 &
        running=$!
        until compgen -G 'stopped/plane_pulse_snapshots.new-*/000000600.h5' >/dev/null || ! kill -0 $running 2>/dev/null; do
            sleep 0.01
        done
        kill -KILL $running
        wait $running 2>/dev/null || true
        cp -r stopped earlier
        try run "$scene" --resume --out earlier "${common[@]}" --set time.end=23.94
        expect_exit 0
        try run "$scene" --out alone "${common[@]}" --set time.end=23.94
        expect_exit 0
        expect "no snapshots beyond its end" diff -r alone earlier
        rm -r alone earlier
    fi
    "$program" run "$scene" "${common[@]}" --out stopped --set model.G=0.5 --set time.end=4000 --set output.checkpoint=1e9 \
        >"$scratch/stdout" 2>&1 &
    running=$!
    until compgen -G 'stopped/plane_pulse_snapshots.new-*/000001200.h5' >/dev/null; do sleep 0.01; done
    kill -KILL $running
    wait $running 2>/dev/null || true
    try run "$scene" --resume --out stopped "${common[@]}"
    expect_exit 0
    expect "$signal: its own files, byte for byte" diff -r whole stopped
    expect_no_leftovers stopped
    rm -r stopped
done
rm -r whole

# What else is in the folder of snapshots stays there; where it is in their way nothing is lost.
beside=("$scene" --quiet --set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=2
    --set output.snapshots=5)
for format in vtk hdf5; do
    try run "${beside[@]}" --set output.format=$format --out whole
    expect_exit 0
    cp -r whole again
    mkdir again/plane_pulse_snapshots/views whole/plane_pulse_snapshots/views
    echo "a view" | tee again/plane_pulse_snapshots/view.pvsm again/plane_pulse_snapshots/views/1 \
        whole/plane_pulse_snapshots/view.pvsm >whole/plane_pulse_snapshots/views/1
    try run "${beside[@]}" --set output.format=$format --out again
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    first=$(echo again/plane_pulse_snapshots/000000000.*)
    rm "$first"
    mkdir "$first"
    touch "$first/kept"
    try run "${beside[@]}" --set output.format=$format --out again
    expect_exit 5
    expect_stderr "$first is in the way of again/plane_pulse_snapshots.new-"
    expect_stderr "--resume goes on from again/plane_pulse.checkpoint"
    expect "it stays" test -e "$first/kept" -a -e again/plane_pulse_snapshots/view.pvsm
    rm -r "$first"
    try run "${beside[@]}" --set output.format=$format --out again --resume
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    # A run whose checkpoint was kept takes its snapshots back from there.
    try run "${beside[@]}" --set output.format=$format --out again --keep-checkpoint
    expect_exit 0
    try run "${beside[@]}" --set output.format=$format --out again --resume
    expect_exit 0
    expect "$format: all of it beside the snapshots" diff -r whole again
    rm -r whole again
done
# A link to another folder of theirs goes, what it leads to stays but for snapshots.
try run "${beside[@]}" --out linked
expect_exit 0
mv linked/plane_pulse_snapshots elsewhere
touch elsewhere/view.pvsm
ln -s ../elsewhere linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked
expect_exit 0
expect "no link" test ! -L linked/plane_pulse_snapshots -a -s linked/plane_pulse_snapshots/000000000.vti
expect "its file alone" test "$(ls elsewhere)" = view.pvsm
# A file where that folder would be.
rm -r linked/plane_pulse_snapshots elsewhere
touch linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked
expect_exit 5
expect_stderr "cannot write linked/plane_pulse_snapshots: Not a directory. --resume goes on from linked/plane_pulse.checkpoint"
rm linked/plane_pulse_snapshots
try run "${beside[@]}" --out linked --resume
expect_exit 0
expect "its snapshots" test -s linked/plane_pulse_snapshots/000000000.vti
# No run fails of what it cannot remove of others, neither on its way nor at its end.
mkdir -p linked/plane_pulse_snapshots.new-1/000000000.vti/views
touch linked/plane_pulse_snapshots.new-1/000000005.vti
try run "${beside[@]}" --out linked --set output.checkpoint=1e-9
expect_exit 0
expect_no_stderr
expect "what is no snapshot alone" test "$(ls linked/plane_pulse_snapshots.new-1)" = 000000000.vti
rm -r linked

# The energies so far can be read; what a run reads it does not replace, nor what is not its own.
mkdir scenes
cp "$scene" scenes/pushed.toml
printf 'time,force\n0,0\n1,2\n2,0\n' >scenes/pushed_probes.csv
pushed=(run scenes/pushed.toml --quiet --set output.probes=[] --set force.history=csv --set force.component=x
    --set force.half_width=2 --set force.centre=[20,20])
try "${pushed[@]}" --set force.file=pushed_probes.csv --out scenes
expect_exit 2
expect_stderr "the scene reads scenes/pushed_probes.csv, which this run would replace or remove"
expect_no_stdout
mv scenes/pushed_probes.csv scenes/history.csv
echo "of something else" >scenes/pushed_cracks.csv
"$program" "${pushed[@]}" --set force.file=history.csv --out scenes --set time.end=1000 >"$scratch/stdout" 2>&1 &
running=$!
until grep -qs '^[0-9]' scenes/pushed.csv.part; do sleep 0.05; done
kill -TERM $running
wait $running || true
expect "stopped" test -e scenes/pushed.checkpoint
expect "another's file stays" grep -q "of something else" scenes/pushed_cracks.csv
printf 'time,force\n0,0\n1,3\n2,0\n' >scenes/history.csv
try "${pushed[@]}" --set force.file=history.csv --out scenes --set time.end=1000 --resume
expect_exit 2
expect_stderr "is of another scene: there the checksum of scenes/history.csv is"
rm -r scenes
finish
