#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2154  # assert.sh defines what is used here
# nmbcgen coupling: what its page shows, JSON, mistakes.
# Usage: run_nmbcgen_coupling.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

page=$(realpath "$2")
# shows N ARGUMENT..: the page's block N is what the command prints.
shows() {
    local number=$1
    shift
    try coupling "$@"
    expect_exit 0
    expect_no_stderr
    awk -v n="$number" '/^```$/ { inside = 0 } inside { print } /^```text$/ { inside = ++count == n }' "$page" >block
    expect "block $number of the page" diff block "$scratch/stdout"
}
shows 1 stencil --horizon 3/2
shows 2 cases
try coupling waves --horizon 3
expect_exit 0
expect_no_stderr
expect "the rows of the page" awk '
    NR == FNR { if (/^\| +0\.[0-9] \|/) row[$2] = $4 " " $6 " " $8 " " $10; next }
    $1 in row && NF == 5 { if (row[$1] != $2 " " $3 " " $4 " " $5) bad = 1; found++ }
    END { exit bad || found != 4 }' "$page" "$scratch/stdout"
expect "what of a packet comes back from behind" grep -qE '^rows  NMBC2 behind +1.34e-05 +1.34e-05$' "$scratch/stdout"

try coupling waves --horizon 3/2 --other-horizon 3/2 --other-length 2
expect_exit 0
expect "what the page says of coarse elements" grep -q '^0.5 *0.00220483' "$scratch/stdout"

try coupling stencil --horizon 100 --stdout
expect_exit 0
expect "no line that nobody reads" awk 'length > 1600 { exit 1 }' "$scratch/stdout"

# Beside a local bar, the row of the node where they meet: pairs, rows.
try coupling junction --horizon 1/2
expect_exit 0
expect_stdout_line "0       0        1.8333333333333333     11/6"
expect_stdout_line "0       1       -1.0277777777777777     -37/36"
expect_stdout_line "0       1       -0.94444444444444442    -17/18"

# Of one bar in two halves no row is another than inside.
try coupling junction --horizon 0
expect_exit 0
expect "no table without rows" grep -q "^pairs: none, each row is one of a bar's own$" "$scratch/stdout"
try coupling junction --horizon 3/2 --other-horizon 3/2
expect "no rows" awk '/^-?[0-9]/ { exit 1 }' "$scratch/stdout"

for part in "stencil --horizon 2" "junction --horizon 3/2 --other-horizon 3/4 --other-length 2" cases "waves --horizon 3/4 --other-length 4"; do
    read -ra arguments <<<"$part"
    try coupling "${arguments[@]}" --format json
    expect_exit 0
    expect_no_stderr
    cp "$scratch/stdout" "${arguments[0]}.json"
done
expect "JSON" python3 -c '
import json, math
from fractions import Fraction
stencil = json.load(open("stencil.json"))["stencil"]
assert stencil[0]["rational"] == "11/9" and stencil[0]["of_log"] == {"2": "-2/3"}
for entry in stencil:
    value = float(Fraction(entry["rational"])) + sum(
        float(Fraction(c)) * math.log(int(p)) for p, c in entry["of_log"].items())
    assert abs(value - entry["value"]) < 1e-15
# Of two bars: pairs are symmetric; no row of either form sees a shift, none of `rows` a strain.
junction = json.load(open("junction.json"))
assert junction["horizons"] == ["3/2", "3/4"] and junction["lengths"] == ["1", "2"]
for form in ("pairs", "rows"):
    assert [row["node"] for row in junction[form]] == [-2, -1, 0, 1]
    K = {(row["node"], e["column"]): e for row in junction[form] for e in row["entries"]}
    if form == "pairs":
        assert all(K[j, i]["value"] == e["value"] for (i, j), e in K.items() if (j, i) in K)
    for row in junction[form]:
        position = lambda node: node * (2 if node > 0 else 1)
        for moment in (0, 1) if form == "rows" else (0,):
            rational, logs = Fraction(0), {}
            for e in row["entries"]:
                factor = position(e["column"]) ** moment
                rational += factor * Fraction(e["rational"])
                for p, c in e["of_log"].items():
                    logs[p] = logs.get(p, 0) + factor * Fraction(c)
            assert rational == 0 and not any(logs.values()), (form, row["node"], moment)
cases = json.load(open("cases.json"))
# Seleson 2011 by our reading, to the digits known
for row, u in zip(cases["case_1"], (.611, .354, .280, .258), strict=True):
    assert abs(row["displacement"] - u) < 5e-4
for row, u in zip(cases["case_2"], (.0147, .0073, .0035), strict=True):
    assert abs(row["pairs"] - u) < 5e-5
tests = {(t["case"], *t["horizons"], *t["lengths"]): t for t in cases["patch_tests"]}
assert abs(tests[3, "3/2", "3/4", "1", "1"]["pairs"] - .178) < 5e-4
assert all(t["rows"] == 0 and (t["pairs"] == 0 or t["case"] == 3) for t in tests.values())
waves = json.load(open("waves.json"))
assert waves["horizons"] == ["3/4", "0"] and waves["lengths"] == ["1", "4"]
assert all(abs(sum(w["pairs"].values()) - 1) < 1e-9 for w in waves["waves"])
assert set(waves["packet"]["rows"]["measured"]) == {"reflected", "transmitted", "from_end"}'

refuses 2 "coupling needs one of the subcommands stencil, junction, cases, waves" coupling
refuses 2 "'foo' is not expected: coupling takes the subcommands stencil, junction, cases, waves" coupling foo
refuses 2 "--horizon is required" coupling stencil
refuses 2 "--horizon is required" coupling junction
refuses 2 "--horizon is required" coupling waves
refuses 2 "--horizon" coupling cases --horizon 2
refuses 2 "'101' is not a number from 0 to 100" coupling stencil --horizon 101
refuses 2 "'11' is not a number from 0 to 10" coupling waves --horizon 11
refuses 2 "'11' is not a number from 0 to 10" coupling junction --horizon 2 --other-horizon 11
refuses 2 "denominator up to 1000" coupling stencil --horizon 1.0001
refuses 2 "-1" coupling stencil --horizon -1
refuses 2 "nonsense" coupling stencil --horizon nonsense
refuses 2 "from 1/4 to 4" coupling waves --horizon 2 --other-length 0
refuses 2 "from 1/4 to 4" coupling waves --horizon 2 --other-length 5
refuses 2 "allowed: text, json" coupling cases --format csv

finish
