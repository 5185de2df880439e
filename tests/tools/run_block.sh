#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# tools/scripts/paper-block: the table of its page, and what it refuses.
# Usage: run_block.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
bin=$(dirname "$program")
program=$2/tools/scripts/paper-block

try --bin "$bin"
expect_exit 0
expect_no_stderr
expect "the page's table" diff \
    <(sed -n 's/^| `\([a-z]*\)` | \([^ |]*\) | \([^ |]*\) | \([^ |]*\) | \([^ |]*\) | \([^ |]*\) | \([^ |]*\) |$/\1,\2,\3,\4,\5,\6,\7/p' "$2/docs/evidence/closures.md") \
    <(tail -n +2 "$scratch/stdout")

refuses 2 "there is no program nowhere/nmbcrun" --bin nowhere
refuses 2 "--bin needs a folder" --bin
refuses 2 "no such option: 'all'" all
finish
