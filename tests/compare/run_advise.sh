#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# nmbcrun advise and run --tolerance: what is said, and that it can be run as it is said. What is
# advised is measured in exam_advise.cpp.
# Usage: run_advise.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
sed '/^step/d' "$scene" >"$scratch/bar.toml"
bar=("$scratch/bar.toml" --set model.G=1.85)

try advise "${bar[@]}" --tolerance 1e-3
expect_exit 0
expect_no_stderr
for what in 'of the ends and of the time step together' 'left out: predicted errors times 1.1 have to be within the tolerance' \
    'NMBC4, stride 1                       not certified at this G' \
    'higdon, truncated                     not certified to be stable' \
    'stored fields                         nobody asked for them'; do
    expect "says: $what" grep -q -- "$what" "$scratch/stdout"
done
expect "ranked by cost, to 5 %" awk '/^meets/ { table = 1; next } /^cost/ { table = 0 }
    table { if ($NF < last - 0.1) exit 1; last = $NF; rows++ } END { exit !(rows >= 6) }' "$scratch/stdout"
settings=$(sed -n 's/^settings   //p' "$scratch/stdout")
# A boundary matched in time steps, whose step is the scene's, has another run to be compared with.
read -ra words <<<"$settings"
try verify "${bar[@]}" "${words[@]}" --tolerance 1e-3 --quiet
expect_exit 0

try run "${bar[@]}" --tolerance 1e-3 --quiet
expect_exit 0
expect "the advice first" grep -q '^advice     --set boundary.kind=' "$scratch/stdout"

# The scene's own step is kept, and then the ends alone count.
try advise "$scene" --set model.G=1.85 --tolerance 1e-5
expect_exit 0
expect "the ends alone" grep -q "in the scene's own time step" "$scratch/stdout"
expect "2744 steps in every row" awk '/^meets/ { table = 1; next } /^cost/ { table = 0 }
    table && !/ 0.091      2744 / { exit 1 }' "$scratch/stdout"

expect "why the steps are no longer" grep -q 'longer steps *the scene gives them' "$scratch/stdout"

# A physical end stays, and the other side's keys are its own.
try advise "${bar[@]}" --tolerance 1e-3 --set boundary.right.kind=free
expect_exit 0
settings=$(sed -n 's/^settings   //p' "$scratch/stdout")
expect "settings of the left end alone" grep -qE '^--set boundary.left.kind=(passive|nmbc --set boundary.left.order=.*) --set time' \
    <<<"$settings"
read -ra words <<<"$settings"
try verify "${bar[@]}" --set boundary.right.kind=free "${words[@]}" --tolerance 1e-3 --quiet
expect_exit 0
try run "${bar[@]}" --set boundary.right.kind=free --tolerance 1e-3
expect_exit 0
expect_stdout_line "right     free"
try advise "${bar[@]}" --tolerance 1e-3 --set boundary.kind=fixed --quiet
expect_exit 0
expect "the step alone" grep -qE '^settings   --set time.cfl=0.[0-9]+$' "$scratch/stdout"

# Nothing gets to the ends: no boundary.
try advise "${bar[@]}" --tolerance 1e-2 --set time.end=20 --quiet
expect_exit 0
expect "no boundary" grep -q '^advice     no boundary (fixed)' "$scratch/stdout"

# Horizon and G left open: against the wave equation.
cat >"$scratch/open.toml" <<'END'
[model]
horizon = "auto"
G = "auto"
[domain]
nodes = 160
[initial]
shape = "gaussian"
amplitude = 1
width = 10
centre = 80
[time]
end = 220
END
try advise "$scratch/open.toml" --tolerance 1e-4
expect_exit 0
expect_no_stderr
for what in 'against the wave equation' 'longer steps' 'horizon 5 .* dispersion and steps make an error of'; do
    expect "says: $what" grep -q -- "$what" "$scratch/stdout"
done
expect "at most a dozen rows, and a line at most for each horizon left out" awk '
    /^meets/ { table = 1; next } /^cost/ { table = 0 } table { rows++ } /^  horizon/ { lines++ }
    END { exit !(rows >= 1 && rows <= 12 && lines >= 1 && lines <= 5) }' "$scratch/stdout"
settings=$(sed -n 's/^settings   //p' "$scratch/stdout")
expect "a lattice to set" grep -q -- '--set model.horizon=[1-5] --set model.G=' <<<"$settings"
read -ra words <<<"$settings"
try verify "$scratch/open.toml" "${words[@]}" --tolerance 1e-4 --quiet
expect_exit 0
try run "$scratch/open.toml" --tolerance 1e-2 --set model.horizon=2 --quiet
expect_exit 0
expect "the G first" grep -q '^advice     --set model.G=.* --set boundary.kind=' "$scratch/stdout"

# Any other command needs a lattice, and sources that are the same in any.
for command in run verify chart; do
    tolerance=()
    [ "$command" = verify ] && tolerance=(--tolerance 1e-2)
    try "$command" "$scratch/open.toml" "${tolerance[@]}"
    expect_exit 2
    expect_stderr 'model.horizon is "auto", which advise and run --tolerance choose'
done
try run "$scratch/open.toml" --set model.horizon=1
expect_exit 2
expect_stderr 'model.G is "auto"'
refused() {  # refused WHAT --set KEY=VALUE ..
    local what=$1
    shift
    try advise "$scratch/open.toml" --tolerance 1e-2 "$@"
    expect_exit 2
    expect_stderr "$what"
}
drive=(--set drive.amplitude=1 --set drive.duration=20 --set drive.centre=80)
refused 'drive.half_width is in horizons: beside model.horizon = "auto" it has to be given as 0' \
    "${drive[@]}"
refused 'drive has to be the only source' "${drive[@]}" --set drive.half_width=0
refused 'model.damping must be 0 beside model.horizon = "auto"' --set model.damping=1/10
refused 'there is no family "nothing"' --set model.family=nothing
refused 'model.horizon must be a whole number' --set model.horizon=automatic
refused 'must be an exact number' --set model.G=automatic
try advise "$scratch/open.toml" --tolerance 1e-2 --set time.cfl=2
expect_exit 1
expect_stderr "horizon 1: steps of "
expect_stderr "(cfl = 1) are stable. Give time.cfl = 1 or less"
# A true end may allow less than the interior.
for given in "step=0.4:time.step = 0.272972" "cfl=0.9:time.cfl = 0.564"; do
    try advise "${bar[@]}" --set model.G=0 --set boundary.left.kind=sbp --set "time.${given%%:*}" --tolerance 1e-2
    expect_exit 4
    expect_stderr "are too long: between these ends steps up to"
    expect_stderr "are stable. Give ${given#*:} or less"
    expect_no_stdout
done

for command in advise run; do
    try "$command" "${bar[@]}" --tolerance 1e-15
    expect_exit 1
    expect_stderr "nothing meets the tolerance 1e-15"
    expect "a line for each" grep -q '^  higdon, truncated: not certified' "$scratch/stderr"
done

# Stopped: at once, wherever it is. One that is not done by then would take minutes.
notes_signals() {  # SIGTERM, bit 14 of those that the process catches; not the shell it was
    local caught
    [ "/proc/$1/exe" -ef "$program" ] || return 1
    caught=$(sed -n 's/^SigCgt:\t//p' "/proc/$1/status")
    ((16#$caught & 0x4000))
}
for seconds in 0 1; do
    "$program" advise "$scratch/bar.toml" --set model.horizon=auto --set model.G=auto \
        --set drive.half_width=0 --set domain.nodes=20000 --set drive.centre=10000 --tolerance 1e-3 \
        >"$scratch/stdout" 2>"$scratch/stderr" &
    for _ in {1..200}; do
        notes_signals $! && break
        sleep 0.1
    done
    sleep $seconds
    kill -TERM $!
    code=0
    wait $! || code=$?
    expect_exit 130
    expect_stderr "nmbcrun: stopped; nothing was "
done
# .. also while an exact end of so long a run is made, which takes some 20 s from a damped lattice: long after
# the signal on a machine five times as fast, too, and the answer has several seconds on a slow one ..
cat >"$scratch/damped.toml" <<'SCENE'
model = { horizon = 4, G = 3, damping = "1/50" }
domain = { nodes = 100 }
initial = { shape = "gaussian", centre = 50, width = 5, amplitude = 1 }
boundary = { kind = "exact" }
time = { end = 12000, cfl = 0.02 }
SCENE
tried="advise, and SIGINT after a second"
began=$(date +%s%N)
code=0
timeout --foreground -s INT 1 "$program" advise "$scratch/damped.toml" --tolerance 1e-3 \
    >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
expect "the signal's exit code" test $code -eq 124
expect "an answer long before it is made" test $(($(date +%s%N) - began)) -lt 6000000000
expect_stderr "nmbcrun: stopped; nothing was "
# .. and one that comes when the advice is there stops the run before it writes: nobody reads the
# advice until then.
mkfifo "$scratch/full"
exec 8<>"$scratch/full"
dd if=/dev/zero of="$scratch/full" oflag=nonblock bs=4096 count=100 2>/dev/null || true
env --default-signal=INT "$program" run "${bar[@]}" --tolerance 1e-3 --out early \
    >"$scratch/full" 2>"$scratch/stderr" &
run=$!
asleep=0
while [ $asleep -lt 3 ] && kill -0 $run; do
    sleep 0.2
    asleep=$(grep -q '^State:.S' /proc/$run/status && echo $((asleep + 1)) || echo 0)
done
tried="run --tolerance, and SIGINT when it has its advice"
kill -INT $run
cat <&8 >"$scratch/stdout" &
reader=$!
code=0
wait $run || code=$?
kill $reader
exec 8>&-
expect_exit 130
expect_stderr "nmbcrun: stopped; nothing was "
expect "nothing written" test ! -e early

try advise "${bar[@]}"
expect_exit 2
# What errs by all of max |u| is met by anything.
for command in advise run; do
    try "$command" "${bar[@]}" --tolerance 2
    expect_exit 2
    expect_stderr "'2' is not a number from 1e-16 to 1"
    expect_no_stdout
done
try run "${bar[@]}" --tolerance 1e-3 --resume
expect_exit 2
expect_stderr "nmbcrun: --resume and --tolerance exclude each other: give one of them"
try run "${bar[@]}" --out one --out other
expect_exit 2
expect_stderr "nmbcrun: --out is given 2 times, where once is allowed"
try run "${bar[@]}" --out
expect_exit 2
expect_stderr "nmbcrun: --out needs a value"
finish
