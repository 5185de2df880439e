#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# chart and advise of plane scenes, and what a quiet run shows while sides are designed.
# Usage: run_plane_advise.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/plane_pulse.toml
band=$2/tools/scenes/plane_band.toml

# chart: what is stable by construction, what grows; passive sides are on the front.
small=(--set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=8 --set model.G=0.25 --long-run 5000 --out results)
try chart "$scene" "${small[@]}"
expect_exit 0
expect_no_stderr
expect "passive sides on the front" grep -q '^\* passive ' "$scratch/stdout"
expect "each row of the picture's data" awk -F, '
    NR == 1 { header = $0 }
    { at[$1] = $0; error[$1] = $6; run[$1] = $10 }
    END { exit !(NR == 21 && header == "boundary,kind,layer,profile,target,error,energy_left,step_cost,run_cost,long_run,on_front" && error["extended"] == 0 && error["pml 20"] < error["pml 5"] && error["pml 20"] < error["sponge 20"] &&
          run["passive"] == "by construction" && run["NMBC2"] == "grows" && error["fixed"] > error["passive"]) }' results/plane_pulse_chart.csv
expect "fixed and free sides are on no front" awk -F, \
    '($2 == "fixed" || $2 == "free") && $11 == 1 { exit 1 }' results/plane_pulse_chart.csv
expect "a picture" test -s results/plane_pulse_chart.svg
rm -r results
try chart "$scene" --set boundary.kind=fixed --out results
expect_exit 2
expect_stderr "a chart compares artificial sides, or the closures of sides where the body ends, sbp, kernel and free: there is none"
expect "no chart" test ! -e results
try chart "$scene" "${small[@]}" --set time.end=1e9
expect_exit 2
expect_stderr "at most 100000000 are allowed"
expect "no folder" test ! -e results
try chart "$scene" "${small[@]}" --set boundary.left.kind=free
expect_exit 0
expect_stderr 'left out: pml 40: beside a perfectly matched layer there are'
rm -r results

# advise: the cheapest sides that are stable by construction; and a dimension that the scene does not need.
small=(--set 'domain.nodes=[30, 24]' --set 'initial.centre=[15, 12]' --set initial.width=6 --set time.end=8 --set model.G=0.25)
try advise "$scene" "${small[@]}" --tolerance 0.03
expect_exit 0
expect_no_stderr
expect_stdout_with "advice     passive"
expect_stdout_with "settings   --set boundary.kind=passive"
expect_stdout_with "not stable by construction"
try advise "$scene" "${small[@]}" --set boundary.kind=free --tolerance 0.03
expect_exit 2
expect_stderr "there is nothing to advise"
try advise "$band" --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed --tolerance 0.1
expect_exit 0
expect_stdout_with "1 of the 20 nodes there gives the same u to roundings"
expect_stdout_with "is for scenes of the chain of these"
advised=$(sed -n 's/^settings *//p' "$scratch/stdout")
try run "$band" --quiet --set time.step=0.05 --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed
expect_exit 0
eval "try run \"\$band\" --quiet --set time.step=0.05 --set output.name=strip --set boundary.bottom.kind=fixed --set boundary.top.kind=fixed $advised"
expect_exit 0
# Roundings of 500 steps, of energies that fall to 1e-9 of the peak.
expect "a twentieth of each energy" awk -F, '
    /^#/ || FNR == 1 { next }
    /^[a-z]/ { next }
    FILENAME != first { if (!first) first = FILENAME }
    FILENAME == first { total[$1] = $5; if ($5 > peak) peak = $5; next }
    { ++rows; off = $5 * 20 - total[$1]; if (off < 0) off = -off; if (off > 1e-12 * peak) exit 1 }
    END { exit !(rows > 10) }' results/plane_band.csv results/strip.csv
# A load on the whole of a side is as even, one across it is not.
cat >even.toml <<'SCENE'
model = { family = "nopd2d", radius2 = 1, nu = 0.25, G = 1 }
domain = { nodes = [12, 20] }
boundary = { kind = "periodic", bottom = { kind = "sbp" }, top = { kind = "sponge", layer = 5 } }
load.push = { kind = "velocity", side = "bottom", component = "y", amplitude = 1e-3, rise = 5, until = 10 }
time = { end = 30 }
SCENE
try advise even.toml --tolerance 0.5
expect_exit 0
expect_stdout_with "1 of the 12 nodes there gives the same u to roundings"
expect_stdout_with "--set 'domain.nodes=[1, 20]'"
rm even.toml
for quiet in "" --quiet; do
    try run "$scene" "${small[@]}" --tolerance 0.03 --out advised $quiet
    expect_exit 0
    expect_stdout_line "advice     --set boundary.kind=passive"
done

# The bar counts what the measuring of costs takes, too, a quarter of the time here: it does not wait at its end. About
# 120 bars in 12 s; two may be late by chance where a fast machine shows a tenth of them.
measured=(advise "$band" --tolerance 0.1 --set "'domain.nodes=[10, 60]'" --set "'drive.centre=[5, 30]'" --set time.end=10)
tried="${measured[*]} on a terminal"
script -qec "stty cols 80; TERM=xterm '$program' ${measured[*]}" /dev/null | tr '\r' '\n' | grep -a ' left' >"$scratch/stdout"
expect "few bars beyond 95 %" awk 'match($0, /[0-9]+ %/) { bars++; late += substr($0, RSTART, RLENGTH) + 0 > 95 }
    END { exit !(bars > 10 && late < bars / 7 + 2) }' "$scratch/stdout"

# A design of some seconds, of which a quiet run shows nothing.
quiet=(run "$2/tools/scenes/plane_box.toml" --quiet --set model.radius2=9 --set time.end=1)
tried="${quiet[*]} on a terminal"
script -qec "TERM=xterm '$program' ${quiet[*]}" /dev/null >"$scratch/stdout"
expect "its last lines" grep -q '^ledger drift' "$scratch/stdout"
expect "no progress" test "$(grep -c 'designing passive sides' "$scratch/stdout")" -eq 0
finish
