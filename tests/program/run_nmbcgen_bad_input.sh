#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# Wrong arguments: exit code 2, two lines of error that name the option and say what is allowed,
# nothing on stdout, nothing written. Usage: run_nmbcgen_bad_input.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
mkdir -p generated/nmbc  # as in the project

# refuses NAMED.. -- ARGUMENT..: each NAMED text is on stderr.
refuses() {
    local named=()
    while [ "$1" != "--" ]; do
        named+=("$1")
        shift
    done
    shift
    try "$@"
    expect_exit 2
    expect_stderr_lines 3
    expect_no_stdout
    expect_nothing_written
    for text in "${named[@]}"; do
        expect_stderr "$text"
    done
    expect_stderr "nmbcgen --help"
}

for option in --order --horizon --stride; do
    # 4294967297 is 1 in 32 bits, 18446744073709551617 in 64.
    for bad in 0 -1 +1 010 01 101 1000 9999999999 4294967297 18446744073709551617 1.5 1e1 0x1 three \
        "" " 1" "1 " 1,2; do
        others=()
        for other in --order --horizon; do
            [ "$other" = "$option" ] || others+=("$other" 1)
        done
        refuses "$option" "'$bad'" "whole number from 1 to 100" -- "${others[@]}" "$option" "$bad"
        [ -z "$bad" ] ||
            refuses "$option" "'$bad'" "whole number" -- "${others[@]}" "$option=$bad"
    done
done

sixty=$(printf '7%.0s' {1..60})
for option in --G --damping --time-step; do
    for bad in nan inf -1 -1/2 +1 1e400 1/3/5 1.2.3 .5 5. / "" " 1" 0x1 1,5 one; do
        refuses $option "'$bad'" "non-negative exact number" "1/2" -- \
            --order 1 --horizon 1 $option "$bad"
    done
    refuses $option "'1e-3'" "an exponent is not allowed; an integer, a fraction p/q and a decimal are" -- \
        --order 1 --horizon 1 $option 1e-3
    refuses $option "'1/0'" "denominator 0" -- --order 1 --horizon 1 $option 1/0
    refuses $option "at most 40 digits" -- --order 1 --horizon 1 $option "$sixty"
    refuses $option "at most 40 digits" -- --order 1 --horizon 1 $option "1/$sixty"
    refuses "$option is given 2 times, where once is allowed" -- --order 1 --horizon 1 $option 1 $option 1
    refuses "$option needs a value" -- --order 1 --horizon 1 $option
done

for bad in "" nan -1 1e3 pipi pi/0 1/0 pi/1.5 0.01pi5 0.1pi.5; do
    refuses --match "'$bad' is not a wave number such as 6/5, 1.2 or 2pi/3" -- \
        --horizon 1 --G 1/2 --match "0:3,$bad:1"
done
for bad in "" "," "0:3," ",0:3" "0:3,,1:1"; do
    refuses --match "empty item" -- --horizon 1 --G 1/2 --match "$bad"
done
refuses --match "'0:3,1/2:1,1/3:1" "has more than 1000 items" -- --horizon 1 --G 1/2 \
    --match "0:3$(printf ',1/%d:1' {2..1001})"
refuses --match "makes the order 1000" -- --horizon 1 --G 1/2 --match "0:3$(printf ',1/%d:1' {2..1000})"
for bad in "0" "0:3,1"; do
    refuses --match "has no number of rows; give XI:ROWS" -- --horizon 1 --G 1/2 --match "$bad"
done
for bad in "0:3,1:0" "0:3,1:-1" "0:3,1:1:1" "0:3,1:" "0:3,1:202" "0:3,1:one"; do
    refuses --match "whole number from 1 to 201" -- --horizon 1 --G 1/2 --match "$bad"
done
# The double nearest to 3.1415926535897932385 is that of pi, which is less.
for bad in "0:3,4:1" "0:3,pi:1" "0:3,0pi:1" "0:3,355/113:1" "0:3,3.1415926535897932385:1"; do
    refuses --match "from 0 to below pi" -- --horizon 1 --G 1/2 --match "$bad"
done
refuses --match "'0:2'" "odd number of rows" -- --horizon 1 --G 1/2 --match 0:2
refuses --match "'0:3,0:5'" "given once" -- --horizon 1 --G 1/2 --match 0:3,0:5
refuses --match "needs 0:1 at least" -- --horizon 1 --G 1/2 --match 1:2
refuses --match "makes the order 0" -- --horizon 1 --G 1/2 --match 0:1
refuses --match "makes the order 101" -- --horizon 1 --G 1/2 --match 0:201,1:1
refuses --match "value 1:2 twice" -- --horizon 1 --G 1/2 --match 0:1,1:2,1:2
refuses --match "given twice: pi/3" -- --horizon 1 --G 1/2 --match 0:1,pi/3:1,2pi/6:2
refuses --match "given twice: 1" -- --horizon 1 --G 1/2 --match 0:1,1.0:1,1:2
refuses --match "requires --G" -- --horizon 1 --match 0:3,1:1
refuses "--order and --match exclude each other: give one of them" -- --horizon 1 --G 1/2 --match 0:3,1:1 --order 2
refuses "--horizon (or --radius2) is required" -- --G 1/2 --match 0:3,1:1
refuses --match --order -- reflect --horizon 1 --G 1/2

for bad in cone 1,x nan,1 "constant,1"; do
    refuses --weights "constant, conical, inverse, cubic" -- --order 1 --horizon 2 --weights "$bad"
done
refuses --weights "3 weights, where horizon 2 needs 2" -- --order 1 --horizon 2 --weights 1,2,3
refuses --weights "other than 0" -- --order 1 --horizon 2 --weights 1,0
refuses --weights "nopd1d needs weights above 0" -- --order 1 --horizon 2 --weights 1,-1
refuses --weights "empty item" -- --order 1 --horizon 2 --weights 1,,2
refuses --all --weights "exclude each other: give one of them" -- --all --weights conical
refuses --weights "3 weights, where horizon 2" -- dispersion --horizon 3,2 --G 1 --weights 1,2,3
refuses --limit "constant influence" -- dispersion --horizon 2 --G 1 --weights conical --limit
refuses --limit "no continuum limit" -- dispersion --family bond1d --horizon 2 --limit
# What the family does not have.
for request in "--family chain1d --horizon 2" "--family bond1d --horizon 2 --damping 1/10" \
    "--family bond1d --horizon 2 --damping 1/10 --time-step 1/2"; do
    # shellcheck disable=SC2086  # words are meant
    try --order 2 $request
    expect_exit 2
    expect_stderr_lines 1
    expect_nothing_written
done
try dispersion --horizon 1,2 --G 1 --family chain1d
expect_exit 2
expect_no_stdout
try closed-forms --order 2 --family bond1d
expect_exit 2
expect_stderr "family 'bond1d'"

refuses --family "'nopd7d'" "allowed: nopd1d" -- --order 1 --horizon 1 --family nopd7d
refuses --family "''" "allowed: nopd1d" -- --order 1 --horizon 1 --family ""
refuses --format "'xml'" "allowed: header, json, python, c, csv, latex" -- --order 1 --horizon 1 --format xml
refuses --format "'JSON'" "allowed: header, json" -- --order 1 --horizon 1 --format JSON
refuses --out "folder" -- --order 1 --horizon 1 --out ""

refuses "'--unknown' is not expected: nmbcgen takes --help, --version, " ", --horizon, " -- --unknown
refuses "'frob' is not expected: nmbcgen takes the subcommands reflect, prove, recommend, " -- frob
refuses "'--foo' is not expected: recommend takes --help, " ", --tolerance" -- \
    recommend --horizon 1 --G 1 --foo 0.5 --bar
refuses "'--foo' is not expected" -- bonds --foo 3
refuses "coupling needs one of the subcommands stencil, junction, cases, waves" -- coupling
refuses "'foo\x1b[2J\xff' is not expected" -- --order 1 --horizon 1 $'foo\e[2J\xff'
refuses "'nopd\x1b7d' is not a family" -- --order 1 --horizon 1 --family $'nopd\e7d'
refuses --unknown "not expected" -- --order 1 --horizon 1 --unknown
refuses -x "not expected" -- --order 1 --horizon 1 -x
refuses stray "not expected" -- --order 1 --horizon 1 stray

refuses "--order is given 2 times, where once is allowed" -- --order 1 --order 2 --horizon 1
refuses "--order is given 2 times, where once is allowed" -- --order 1 --order 1 --horizon 1
refuses "--horizon is given 3 times, where once is allowed" -- --order 1 --horizon 1 --horizon 1 --horizon 1

refuses "--horizon (or --radius2) is required" -- --order 1
refuses "--order (or --match) is required" -- --horizon 1
refuses "--order (or --match) and --horizon" "--all" "--check" -- --G 1
refuses "--order (or --match) and --horizon" "--all" "--check" --
refuses "--order (or --match) and --horizon" "--all" "--check" -- --stdout
refuses "--order needs a value" -- --horizon 1 --order
refuses "--order needs a value" -- --horizon 1 --order=

refuses --all --order "exclude each other: give one of them" -- --all --order 1
refuses --all --horizon "exclude each other: give one of them" -- --all --horizon 1
refuses --all --stdout "exclude each other: give one of them" -- --all --stdout
refuses --all --G "exclude each other: give one of them" -- --all --G 1
refuses --all --damping "exclude each other: give one of them" -- --all --damping 1/10
refuses --check --damping "exclude each other: give one of them" -- --check --damping 0
refuses --all --time-step "exclude each other: give one of them" -- --all --time-step 1/2
refuses --all --cfl "exclude each other: give one of them" -- --all --cfl 1/2
refuses --cfl "requires --G" -- --order 2 --horizon 1 --cfl 1/2
refuses --cfl --time-step "exclude each other: give one of them" -- --order 2 --horizon 1 --G 1 --cfl 1/2 --time-step 1
for bad in 0 1 1.5; do
    refuses --cfl "'$bad'" "between 0 and 1" -- --order 2 --horizon 1 --G 1 --cfl $bad
done
refuses --cfl "'x'" "non-negative exact number" -- --order 2 --horizon 1 --G 1 --cfl x
refuses --G "requires --G" -- --order 1 --horizon 1 --require-stable
plane="--order 1 --family nopd2d"
refuses --radius2 "--radius2 is required" -- $plane --horizon 1
refuses --nu "--nu is required" -- $plane --radius2 1 --polarisation P
refuses --polarisation "is required: a table is of the P or the S waves" -- $plane --radius2 1 --nu 0
refuses --radius2 "no node of the square lattice is at a distance of 3 squared" "below is 2" -- \
    $plane --radius2 3 --nu 1/4 --polarisation P
refuses --radius2 "'101' is not a whole number from 1 to 100" -- $plane --radius2 101 --nu 1/4 --polarisation P
refuses --radius2 "'0'" -- $plane --radius2 0 --nu 1/4 --polarisation P
refuses --radius2 --horizon "exclude each other: give one of them" -- $plane --radius2 1 --horizon 1 --nu 1/4 --polarisation P
refuses --nu "Poisson's ratio 1: an isotropic solid needs -1 < nu < 1/2" -- \
    $plane --radius2 1 --nu 1 --polarisation P
refuses --nu "Poisson's ratio 1/2: an isotropic solid needs -1 < nu < 1/2" -- \
    $plane --radius2 1 --nu 1/2 --state strain --polarisation P
refuses --nu "Poisson's ratio 1/2: an isotropic solid needs -1 < nu < 1/2" -- \
    $plane --radius2 1 --nu 1/2 --polarisation P
refuses --nu "Poisson's ratio -1:" -- $plane --radius2 1 --nu -1 --polarisation P
refuses --polarisation "'SV'" "allowed: P, S" -- $plane --radius2 1 --nu 1/4 --polarisation SV
refuses --state "'plane'" "allowed: stress, strain" -- \
    $plane --radius2 1 --nu 1/4 --state plane --polarisation P
refuses --weights "nopd2d has constant influence" -- \
    $plane --radius2 1 --nu 1/4 --polarisation P --weights 1
refuses --radius2 "nopd1d is no plane family" -- --family nopd1d --order 1 --radius2 1
refuses --nu "is required" -- --order 1 --radius2 1 --polarisation P
plane="--order 1 --family bond2d --polarisation S"
refuses --weights "bond2d takes w_1,w_2,.." -- $plane --radius2 2
refuses --weights "2 weights are needed" "(1, 0), (1, 1)" -- $plane --radius2 2 --weights 1
refuses --polarisation "long S waves do not travel" -- $plane --radius2 1 --weights 1
refuses --nu "bond2d has no Poisson's ratio" -- $plane --radius2 2 --weights 1,1 --nu 1/3
refuses --state "bond2d has no plane stress or strain" -- \
    $plane --radius2 2 --weights 1,1 --state stress
refuses --G "recommend requires --G" -- recommend --horizon 1
refuses --G "reflect requires --G" -- reflect --horizon 1 --order 1
refuses --G "dispersion requires --G" -- dispersion --horizon 1
refuses --G "bond1d has no stabilisation: leave it out, or give 0" -- \
    --family bond1d --order 1 --horizon 1 --G 1/2
refuses --G "chain1d has no stabilisation" -- recommend --family chain1d --horizon 1 --G 1
refuses --G "chain1d has no stabilisation" -- dispersion --family chain1d --horizon 1 --G 0,1
refuses --order "options go behind the subcommand: nmbcgen recommend --order" -- \
    --order 3 recommend --horizon 1 --G 1
refuses --out "options go behind the subcommand: nmbcgen reflect --out" -- \
    --out x reflect --order 1 --horizon 1 --G 1
refuses --all --check "exclude each other: give one of them" -- --all --check
refuses --all --check "exclude each other: give one of them" -- --check --all
refuses --check --order "exclude each other: give one of them" -- --check --order 1
for given in --stdout=no --require-stable=3; do
    refuses "${given%=*} takes no value: give it alone, or leave it out" -- --order 1 --horizon 1 "$given"
done
refuses --stdout --out "exclude each other: give one of them" -- --order 1 --horizon 1 --stdout --out folder

finish
