#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The tables of the runtime's benchmark, from a program of known numbers; and one real measurement.
# Nothing is asked of a time.
# Usage: run_runtime_bench.sh RUNTIME_BENCH SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
runtime_bench=$program
program=$2/tools/bench/runtime

# known FOLDER: a runtime_bench that is as fast as its horizon says
known() {
    mkdir -p "$1"
    cat >"$1/runtime_bench" <<'PROGRAM'
#!/usr/bin/env python3
import json
rows = []
for n in (1, 2, 3):
    for real in ("double", "float"):
        rows.append({"name": f"memory/{n}/{real}/iterations:15/manual_time",
                     "gnodes": n + 0.25, "roofline": 0.9})
        for nodes in (500, 4000):
            rows.append({"name": f"cache/{n}/{nodes}/{real}/iterations:9", "gnodes": n + 0.125})
    for order in (1, 2, 3):
        rows.append({"name": f"boundary/{n}/{order}", "share": 0.01 * order, "step_ns": 300 + n})
print(json.dumps({"benchmarks": rows}))
PROGRAM
    chmod +x "$1/runtime_bench"
}

known "$scratch/known"
try "$scratch/known"
expect_exit 0
expect "speeds" grep -qE '^\| double \| +2 \| +2.12 \| +2.12 \| +2.25 \| +90 % \|$' "$scratch/stdout"
expect "boundaries" grep -qE '^\| +3 \| 1 % of 303 ns \| 2 % of 303 ns \| 3 % of 303 ns \|$' "$scratch/stdout"
expect "no threads without their program" bash -c "! grep -q Threads '$scratch/stdout'"

mkdir "$scratch/broken" "$scratch/other" "$scratch/partial"
printf '%s\n' '#!/bin/sh' 'echo out of order >&2' 'exit 3' >"$scratch/broken/runtime_bench"
printf '%s\n' '#!/bin/sh' 'echo hello' >"$scratch/other/runtime_bench"
printf '%s\n' '#!/bin/sh' "echo '{\"benchmarks\": []}'" >"$scratch/partial/runtime_bench"
chmod +x "$scratch"/*/runtime_bench
try "$scratch/broken"
expect_exit 1
expect_stderr "runtime_bench failed: out of order"
try "$scratch/other"
expect_exit 1
expect_stderr "is no bench of the runtime"
try "$scratch/partial"
expect_exit 1
expect_stderr "did not measure 'memory/1/double'"
try "$scratch/nothere"
expect_exit 2
expect_stderr "build the target runtime_bench first"
try --nonsense
expect_exit 2
expect_stderr "unrecognized arguments: --nonsense"

program=$runtime_bench
try '--benchmark_filter=^boundary/1/1/' --benchmark_format=json
expect_exit 0
expect "a share of a step" grep -qE '"share": -?[0-9.e-]+' "$scratch/stdout"
try --nonsense
expect_exit 2
finish
