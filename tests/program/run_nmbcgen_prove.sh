#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2154  # assert.sh defines what is used here
# nmbcgen prove: what its page shows, and mistakes. Usage: run_nmbcgen_prove.sh NMBCGEN TABLES
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
tables=$2

try prove --order 2 --horizon 1 --G 1/2
expect_exit 0
expect_no_stderr
expect "both grades to the sampled step" test "$(grep -c \
    'G = 1/2: proved in every step up to cfl 0.7; sampled: cfl 0.70' "$scratch/stdout")" -eq 2
expect "where its steps end" test "$(grep -cF \
    'edge: cfl 0.707106781, critical: (dt/2)^2 = 1/8 = 0.125; beyond it: growing boundary mode' "$scratch/stdout")" -eq 2
try prove --order 2 --horizon 1 --G 1/2 --format json
expect_exit 0
expect "fields" python3 - "$scratch/stdout" <<'PYTHON'
import json, sys
found = json.load(open(sys.argv[1]))
for grade in "paired", "contractive":
    assert found[grade]["proved_cfl"] == found[grade]["sampled_cfl"] == 0.7, found
    edge = found[grade]["edge"]
    assert edge["kind"] == "critical" and edge["half_step_squared"]["exact"] == "1/8", edge
    assert edge["beyond"] == "growing boundary mode", edge
    assert edge["cfl"] < 0.5 ** 0.5 < edge["cfl"] + 1e-14, edge
PYTHON
try prove --order 1 --horizon 1 --G 0 --format json
expect "no edge without steps" grep -qx '    "edge": null' "$scratch/stdout"
try prove --order 1 --horizon 1 --G 1/2 --format json
expect "the lattice's own" grep -qx '      "kind": "lattice",' "$scratch/stdout"
try prove --order 2 --horizon 1 --time-step 1/2 --G 1/2 --format json
expect "in its step" test "$(grep -cxE '    "(proved|sampled)": true,?' "$scratch/stdout")" -eq 4
try prove --order 1 --horizon 2 --G 1
expect "an edge of degree 3" grep -qF 'edge: cfl 0.825512078, critical: (dt/2)^2 = 0.' "$scratch/stdout"
expect_stdout_line "NMBC1, stride 1, at horizon 2, G = 1"
expect_stdout_line "lattice      1D non-ordinary peridynamics, constant influence, horizon 2 dX, stabilisation G"
expect_stdout_line "contractive  G = 1: nothing proved; sampled: none: waves of one frequency can come back larger"
try prove --order 2 --horizon 2 --G 1
expect_exit 0
expect_stdout_line "paired       G = 1: nothing proved; sampled: none: growing boundary mode"
try prove --order 1 --radius2 1 --nu 1/4 --polarisation S --G 1
expect_exit 0
expect "family, nu and polarisation" grep -qE '^lattice .*S waves.* nu = 1/4' "$scratch/stdout"
# 1/3 is no double: proved at both its neighbours
try prove --order 2 --horizon 1 --G 1/3
expect "a proof" grep -q 'paired       G = 1/3: proved in every step' "$scratch/stdout"
try prove --order 2 --horizon 1 --up-to 0.3
expect_exit 0
expect "a window" grep -Eq '^paired +0.250000 .. 1.000000$' "$scratch/stdout"
expect "a part of it" grep -Eq '^  proved +0.25[0-9]* .. ' "$scratch/stdout"
try prove --order 2 --horizon 1 --format json
expect_exit 0
expect "its parts" python3 - "$scratch/stdout" <<'PYTHON'
import json, sys
windows = json.load(open(sys.argv[1]))["ranges"]
assert [each["grade"] for each in windows] == ["paired", "contractive"], windows
for each in windows:
    assert each["G"] == [0.25, 1] and each["has_end"] and each["from"] == each["cfl"] == 0, each
    assert 0.25 < each["proved"][0][0] < 0.2503 and 0.999 < each["proved"][-1][1] <= 1, each
PYTHON

# Every certified step of the table.
try prove --order 2 --horizon 1 --steps
expect_exit 0
expect_stdout_line "in every certified step"
expect_stdout_line "paired       0.437500 .. 0.531250     cfl up to 0.69     100 % proved"
expect "most of all" bash -c '! grep cfl "$1" | grep -qv " \(99\|100\) % proved$"' - "$scratch/stdout"
try prove --order 2 --horizon 1 --steps --format json
expect "the steps of the committed table" python3 - "$scratch/stdout" "$tables/tables.json" <<'PYTHON'
import json, sys
found = json.load(open(sys.argv[1]))["ranges"]
table = next(
    t for t in json.load(open(sys.argv[2]))["tables"]
    if (t["lattice"], t["order"], t["stride"], t["time_step"]) == ("nopd1d_n1", 2, 1, "0"))
for grade, key in ("paired", "max_cfl"), ("contractive", "max_cfl_contractive"):
    of_grade = [each for each in found if each["grade"] == grade]
    assert of_grade and len(of_grade) == len(table[key])
    for each, step in zip(of_grade, table[key]):
        length = sum(high - low for low, high in each["proved"])
        assert length > 0.99 * (each["G"][1] - each["G"][0]), each
        assert each["cfl"] == step["cfl"] and each["G"] == [step["low"], step["high"]], (each, step)
PYTHON
try prove --order 1 --horizon 3 --stride 2 --steps
expect "G = 0 by itself" grep -Eq '^paired +0.000000 .. 0.000000 +cfl up to 0.65 +0 % proved$' "$scratch/stdout"
try prove --order 2 --horizon 1 --time-step 1/2 --format json
expect "no cfl in its own step" grep -qx '      "cfl": null,' "$scratch/stdout"
try prove --order 2 --horizon 1 --damping 1/50 --steps
expect "from a step on" grep -Eq '^paired .* cfl 0.06 to 0.13 +100 % proved$' "$scratch/stdout"
try prove --family chain1d --horizon 1 --order 2
expect_exit 0
expect "without a G" grep -q '^paired       at every G: proved in every step' "$scratch/stdout"

# Damped: no mode of its half spaces grows.
try prove --order 2 --horizon 2 --stride 2 --damping 1/10 --G 1
expect_exit 0
expect_stdout_line "NMBC2, stride 2, at horizon 2, G = 1, tau = 1/10"
expect_stdout_line "paired       G = 1: proved in every step up to cfl 0.75; sampled: cfl 0.75"
expect "no grade of waves that keep their energy" bash -c '! grep -q contractive "$1"' - "$scratch/stdout"
try prove --order 2 --horizon 1 --damping 1/50 --G 9/200
expect "certified from a step on" grep -q 'G = 9/200: proved in every step from cfl 0.047 to 0.15; sampled: cfl 0.15' "$scratch/stdout"
try prove --order 2 --horizon 1 --damping 1/50 --G 9/200 --format json
expect "its fields" grep -qx '    "from": 0.047,' "$scratch/stdout"
try prove --order 2 --horizon 1 --damping 1/10
expect "windows of a damped lattice" grep -q '^  proved     1.000' "$scratch/stdout"

# What is undecided, by name.
try prove --order 1 --horizon 6 --G 3/4
expect "no proof, and why" grep -q \
    'G = 3/4: proved in every step up to cfl 0.55, then undecided whether waves are amplified; sampled: cfl 0.61' \
    "$scratch/stdout"

# Matched in a step: that one alone.
try prove --order 2 --horizon 1 --time-step 1/2 --G 1/2
expect_exit 0
expect "both grades in its step" test "$(grep -c \
    'G = 1/2: proved in its step of 1/2 dX/c; sampled: stable' "$scratch/stdout")" -eq 2
try prove --order 2 --horizon 1 --time-step 1/2 --G 3/2
expect "stable nowhere" test "$(grep -c \
    'G = 3/2: not proved in its step of 1/2 dX/c; sampled: not stable' "$scratch/stdout")" -eq 2
try prove --order 2 --horizon 1 --time-step 1/2
expect_exit 0
expect "which step" grep -qx 'in its step of 1/2 dX/c' "$scratch/stdout"
expect "a window of it" grep -Eq '^paired +0.25[0-9]* .. ' "$scratch/stdout"
expect "most of it" grep -Eq '^  undecided  0.0' "$scratch/stdout"
try prove --order 1 --horizon 1 --time-step 1/2
expect_exit 3
try prove --order 2 --horizon 1 --time-step 2 --G 1/2
expect_exit 3

for wrong in '--horizon 1' '--order 2' '--order 2 --horizon 1 --up-to 1' \
    '--order 2 --horizon 1 --up-to 0' '--order 2 --horizon 1 --finest x' \
    '--order 2 --horizon 1 --G 1 --up-to 0.5' '--all --order 2' '--all --G 1' '--all --up-to 0.5' '--all --format json' '' \
    '--order 2 --horizon 1 --time-step 1/2 --up-to 0.3' '--order 2 --horizon 1 --time-step -1' \
    '--order 2 --horizon 1 --steps --up-to 0.3' '--order 2 --horizon 1 --steps --G 1' \
    '--order 2 --horizon 1 --steps --time-step 1/2' '--order 2 --horizon 1 --cfl 0.3' '--order 2 --horizon 1 --G -1'; do
    # shellcheck disable=SC2086  # words
    try prove $wrong
    expect_exit 2
    expect_no_stdout
done
try prove --order 2 --horizon 1 --G 1/4
expect_exit 0
try prove --order 2 --horizon 2 --stride 1 --G 128/85
expect "a pole has no condition" test "$code" -eq 3
