# SPDX-License-Identifier: GPL-2.0-or-later
# The bar of section 5, and what is said of runs of it, for the scripts that test nmbcrun.
# Usage, in a script with the arguments NMBCRUN SOURCE_FOLDER (absolute): source bar.bash
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
scene=$2/tools/scenes/bar1d.toml
short=(--set time.end=2)
# Without a time step of its own; without a source.
automatic=$scratch/automatic.toml
sed '/^step/d' "$scene" >"$automatic"
sourceless=$scratch/sourceless.toml
sed '/^\[drive\]/,/^$/d' "$scene" >"$sourceless"

# refuses CODE TEXT ARGUMENT..: that exit code, that text, nothing written.
refuses() {
    local expected=$1 text=$2
    shift 2
    try run "$@"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_stderr_lines 5
    expect_no_stdout
    expect_nothing_written
}

# stable ARGUMENT..: a short run without a word.
stable() {
    try run "$scene" "${short[@]}" "$@"
    expect_exit 0
    expect_no_stderr
}
