#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The pages that are followed word for word: their commands run, and print what the pages say. Numbers
# are not compared, as roundings differ from machine to machine, but those that the text rests on.
# Usage: run_tutorial.sh SOURCE_FOLDER FOLDER_OF_PROGRAMS CXX
set -euo pipefail
source=$1 programs=$2 compiler=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin" "$scratch/work"
ln -s "$compiler" "$scratch/bin/g++"
PATH=$scratch/bin:$PATH
cd "$scratch/work"
mkdir build
ln -s "$programs" build/bin
ln -s "$source/"{runtime,generated,docs} .
cp -r "$source/tools" .  # a scene names files relative to itself

# Pages leave the project's own folder as it was, but for `results`.
rest() { find . -mindepth 1 -maxdepth 1 ! -name results ! -name commands | sort; }
rest >"$scratch/rest"

# shape FILE: without numbers and the width of columns.
shape() { sed -E 's/-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/#/g; s/[ -]*#/ #/g; s/ +/ /g; s/ $//' "$1"; }

for page in tutorial/first-run tutorial/own-loop how-to/half-bar how-to/own-tables how-to/own-code \
    how-to/match-inside-a-band how-to/optimised-bonds how-to/choose-a-boundary; do
    # Indented lines are commands; installing and building is behind us.
    sed -n '/^```/,/^```$/!s/^    //p' "$source/docs/$page.md" | grep -v '^\./tools/quickstart' >commands
    code=0
    bash -e commands >"$scratch/output" 2>"$scratch/errors" || code=$?
    if [ "$code" -ne 0 ] || [ -s "$scratch/errors" ]; then
        echo "docs/$page.md: its commands end with $code"
        cat "$scratch/errors"
        exit 1
    fi
    if ! diff "$scratch/rest" <(rest); then
        echo "docs/$page.md: its commands leave that outside of results"
        exit 1
    fi
    sed -n '/^```text/,/^```$/p' "$source/docs/$page.md" | grep -v '^```' >"$scratch/page"
    if ! grep -vxFf <(shape "$scratch/output") <(shape "$scratch/page") >"$scratch/other"; then
        continue
    fi
    echo "docs/$page.md: these lines are not printed:"
    cat "$scratch/other"
    exit 1
done
bash -e <<'COMMANDS'
results/steel_bar | grep -qx 'middle of the bar: 43.65 um'
awk -F, 'END { exit !($2 > 43.645e-6 && $2 < 43.655e-6) }' results/steel_probes.csv
COMMANDS
echo "all commands run"
