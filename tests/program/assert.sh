# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Sourced by the run_ scripts, which get the path of the program as $1. Works in an empty folder
# of its own, removed at the end. The first expectation that does not hold ends the script with 1.
set -euo pipefail

program=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/work"
cd "$scratch/work"
checks=0
tried="(nothing yet)"

# try ARGUMENT..: runs the program, keeps its output, its errors and its exit code.
try() {
    tried="$(basename "$program") $*"
    code=0
    "$program" "$@" >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
}

fail() {
    echo "FAILED after: $tried"
    echo "  expected: $1"
    echo "  exit code: ${code:-none}"
    sed 's/^/  stdout: /' "$scratch/stdout" | head -20
    sed 's/^/  stderr: /' "$scratch/stderr" | head -20
    exit 1
}

# expect WHAT COMMAND..: the command succeeds.
expect() {
    local what=$1
    shift
    checks=$((checks + 1))
    "$@" || fail "$what"
}

expect_exit() { expect "exit code $1" test "$code" -eq "$1"; }
expect_no_stdout() { expect "nothing on stdout" test ! -s "$scratch/stdout"; }
expect_no_stderr() { expect "nothing on stderr" test ! -s "$scratch/stderr"; }
expect_stdout_line() { expect "the line '$1' on stdout" grep -qxF -- "$1" "$scratch/stdout"; }
expect_stdout_with() { expect "'$1' on stdout" grep -qF -- "$1" "$scratch/stdout"; }
expect_stderr() { expect "'$1' on stderr" grep -qF -- "$1" "$scratch/stderr"; }
expect_same() { expect "$1 and $2 are the same" cmp -s "$1" "$2"; }
expect_file() { expect "the file $1" test -s "$1"; }

# refuses CODE TEXT ARGUMENT..: that exit code, that text, nothing on stdout.
refuses() {
    local expected=$1 text=$2
    shift 2
    try "$@"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_no_stdout
}

# expect_stderr_lines N: from 1 to N lines of error.
expect_stderr_lines() {
    local lines
    lines=$(wc -l <"$scratch/stderr")
    expect "1 to $1 lines on stderr" test "$lines" -ge 1 -a "$lines" -le "$1"
}

# The working folder has no file: nothing was written.
expect_nothing_written() {
    expect "nothing written" test "$(files_in "$scratch/work")" -eq 0
}

files_in() { find "$1" -type f | wc -l; }

# try_document DOCUMENT SOURCE_FOLDER: runs the indented commands of a document as they stand there,
# in a working folder that looks like the source's, with build/bin/PROGRAM. $program is bash after.
try_document() {
    mkdir -p build/bin docs/images
    ln -s "$program" "build/bin/$(basename "$program")"
    ln -s "$2/tools" tools
    sed -n 's/^    //p' "$1" >commands
    program=$(command -v bash)
    try -e commands
    expect_exit 0
    expect_no_stderr
}

# expect_picture FILE SOURCE_FOLDER: the SVG is the committed one, byte by byte where gnuplot is the
# one that drew that; others lay out a little differently.
expect_picture() {
    expect_file "$1"
    expect "a whole picture" grep -q '</svg>' "$1"
    local made_by
    made_by=$(grep -o 'Produced by GNUPLOT [^<]*' "$2/$1")
    if grep -qF "$made_by" "$1"; then
        expect_same "$1" "$2/$1"
    fi
}

# No temporary file was left below a folder.
expect_no_leftovers() {
    expect "no temporary file left" test -z "$(find "$1" -name '*.new-*')"
}

finish() { echo "$checks expectations hold"; }
