#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# Certificates: --require-stable, --uncertified, --cache.
# Usage: run_nmbcgen_stable.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project
unset NMBCGEN_CACHE

# unstable TEXT ARGUMENT..: exit code 4, the text on stderr, nothing written.
unstable() {
    local text=$1
    shift
    try --require-stable "$@"
    expect_exit 4
    expect_stderr "$text"
    expect "nothing on stdout" test ! -s "$scratch/stdout"
    expect "nothing written" test "$(files_in .)" -eq 0
}

# The paper's (54) holds at n = 2, N = 2, G = 1, and a boundary mode grows all the same.
unstable "a boundary mode grows, Re s = 18.1 c/dX" --order 2 --horizon 2 --G 1
expect_stderr "stride 1: 2.447059 to 3.774203"
expect_stderr "stride 2: 0.7141869 to 2.969934"
unstable "where backward waves travel" --order 2 --horizon 1 --G 0.1
unstable "sends out a wave of its own" --order 2 --horizon 1 --G 1.1
expect_stderr "stride 1: 0.25 to 1"
unstable "stride 1: 0.25 to 0.6666666; 2 and above" --order 3 --horizon 1 --G 0.8

try --require-stable --order 2 --horizon 2 --stride 2 --G 1
expect_exit 0
expect_file generated/nmbc/tables/nopd1d_n2_order2_s2_G1o1.hpp
rm -r generated/nmbc/tables

# Matched in time steps: these steps are to be certified, too.
unstable "G = 2 is not certified in these steps, of cfl 0.625: 0.28 is the largest one" --order 3 \
    --horizon 2 --stride 2 --time-step 1 --G 2
unstable "steps of 1/2, G = 1 is not stable" --order 2 --horizon 1 --G 1 --time-step 1/2
expect_stderr "stride 1: 0.25 to 0.875"

for other in "--all" "--check" "--uncertified --order 1 --horizon 1 --G 1" "--order 1 --horizon 1"; do
    # shellcheck disable=SC2086  # a list of words
    try --require-stable $other
    expect_exit 2
    expect_stderr "--require-stable"
done

# Without a certificate, and so that the table's own command makes it again.
try --uncertified --order 8 --horizon 2 --stdout
expect_exit 0
expect_stdout_line "// stable  not examined"
expect "the command" grep -q 'Regenerate: .* --order 8 --horizon 2 --uncertified$' "$scratch/stdout"

# A kept certificate is the one found anew; one that is cut short, or of another table, is not used.
try --order 3 --horizon 1 --stdout
cp "$scratch/stdout" "$scratch/fresh"
for state in empty kept truncated foreign damaged misspelt; do
    kept=cache/nopd1d_n1_order3.json
    case $state in
        truncated) head -c 700 $kept >short && mv short $kept ;;
        damaged) sed -i 's|"exact": "1/4"|"exact": "1/4x"|' $kept ;;
        misspelt) sed -i 's|"beyond": "resonance"|"beyond": "resonanze"|' $kept ;;
        foreign) sed -i 's/"value": 2.0/"value": 3.0/; s/"code": "./"code": "?/' $kept ;;
    esac
    try --order 3 --horizon 1 --stdout --cache cache
    expect_exit 0
    expect_same "$scratch/stdout" "$scratch/fresh"
    expect_file $kept
done
rm -r cache
try --order 1 --horizon 1 --cache /dev/null/cache
expect_exit 5
expect_stderr "/dev/null/cache"
expect "nothing written" test "$(files_in .)" -eq 0

finish
