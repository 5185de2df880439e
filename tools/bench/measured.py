# SPDX-License-Identifier: MIT
"""What the benches of the runtime have in common: their programs' counters, and tables."""
import json
import os
import subprocess
import sys

BIN = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))),
                   "build", "bin")


def fail(code, message):
    print(f"{os.path.basename(sys.argv[0])}: {message}", file=sys.stderr)
    sys.exit(code)


def program_of(parser, name):
    """The absolute path of a program, in the folder that is the parser's only argument."""
    parser.add_argument("folder", nargs="?", default=BIN,
                        help=f"where {name} and {name}_openmp are (default build/bin)")
    program = os.path.join(os.path.abspath(parser.parse_args().folder), name)
    if not os.access(program, os.X_OK):
        parser.error(f"no program {program} (build the target {name} first)")
    return program


def measured(program, only="."):
    """Counters by name of what a program measured."""
    try:
        process = subprocess.run([program, f"--benchmark_filter={only}", "--benchmark_format=json"],
                                 check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True)
        rows = json.loads(process.stdout)["benchmarks"]
        return {row["name"].split("/iterations")[0]: row for row in rows}
    except subprocess.CalledProcessError as failed:
        fail(1, f"{program} failed: {failed.stderr.strip()}")
    except (OSError, ValueError, KeyError, TypeError) as error:
        fail(1, f"{program} is no bench of the runtime: {error}")


def print_table(head, rows):
    widths = [max(2, *(len(row[i]) for row in [head, *rows])) for i in range(len(head))]
    for row in (head, ["-" * (width - 1) + ":" for width in widths], *rows):
        print("| " + " | ".join(cell.rjust(width) for cell, width in zip(row, widths)) + " |")
    sys.stdout.flush()
