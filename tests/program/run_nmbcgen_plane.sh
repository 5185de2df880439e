#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen recommend of the side of a plane lattice, and nmbcgen passive.
# Usage: run_nmbcgen_plane.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
page=$2

smallest=(--family nopd2d --radius2 1 --nu 1/4)
try recommend "${smallest[@]}" --G 0
expect_exit 0
expect_no_stderr
expect "the page's table" diff <(sed -n '/^```text/,/^```$/p' "$page" | sed '1d;$d') "$scratch/stdout"

# The published condition is stable there from G = .21 on.
grade() { expect "the grade $1 of $2" grep -qE "^$2 +$1 " "$scratch/stdout"; }
try recommend "${smallest[@]}" --G 1/20
grade passive passive
grade grows 'NMBC1 as printed, \(81\)'
try recommend "${smallest[@]}" --G 1/13
grade paired 'NMBC1 as printed, \(81\)'
expect "in short steps, and not opposite a fixed side" grep -qE '^NMBC1 as printed, \(81\) +paired +0\.[234] no fixed' "$scratch/stdout"
try recommend "${smallest[@]}" --G 1/5
grade contractive 'NMBC1 as printed, \(81\)'
grade contractive 'NMBC2 by component'
expect "nor does the box grow, in steps up to 0.9" grep -qE '^NMBC1 as printed, \(81\) +contractive +0\.9 any +1\.000 +none +none +none +0 ' "$scratch/stdout"
try recommend --family bond2d --radius2 2 --weights 1,1/2
expect_exit 0
grade passive passive
# A family without passive sides has what others have, on samples.
try recommend --family lps2d --radius2 2 --nu 1/4
expect_exit 0
expect_no_stderr
expect "no passive row" test "$(grep -c '^passive' "$scratch/stdout")" -eq 0
expect "what is recommended" grep -qE "for which no passive sides are designed" "$scratch/stdout"
expect "as no side is stable, what else" grep -qF "  instead    a lattice that goes on, or a layer with friction" "$scratch/stdout"
refuses 2 "--radius2: long S waves do not travel: nothing in this model resists them" recommend --family lps2d --radius2 1 --nu 1/4
# A row that is not there is named.
try recommend "${smallest[@]}" --G 0
expect_exit 0
expect_stdout_line "NMBC2 by component: none, at g = 0 its equations have no solution"
refuses 2 "passive sides are of nopd2d and bond2d; tables of lps2d" passive --family lps2d --radius2 1 --nu 1/4

# Conditions of one's own: Higdon's product is one of them.
try recommend "${smallest[@]}" --G 1/4 --absorb P:0,S:0
expect_exit 0
grade grows 'NMBC2 by component'
expect "the product is Higdon's" test 1 -eq \
    "$(sed -nE 's/^(Higdon, P and S|matched at P 0, S 0) +//p' "$scratch/stdout" | sort -u | wc -l)"
try recommend "${smallest[@]}" --G 1/4 --absorb P:30,S:60
grade contractive 'matched at P 30, S 60'
expect "little at 60 degrees" grep -qE '^matched at .* 0\.00[01]/0\.00[01] +[0-9./]+$' "$scratch/stdout"
# X:Y is a direction, as oblique has it: S:1:1 is S:45.
try recommend "${smallest[@]}" --G 1/4 --absorb S:45
sed 's/S 45/S/' "$scratch/stdout" >"$scratch/degrees"
try recommend "${smallest[@]}" --G 1/4 --absorb S:1:1
expect_exit 0
expect "the same" diff "$scratch/degrees" <(sed 's/S 45/S/' "$scratch/stdout")
for bad in P:90 P:0:1 X:3 P P:0,S:0,P:1 S:-3 P:0:0 ""; do
    try recommend "${smallest[@]}" --G 1/4 --absorb "$bad"
    expect_exit 2
    expect_stderr "--absorb: "
done
try recommend "${smallest[@]}" --G 1/4 --polarisation P --absorb P:0
expect_exit 2
expect_stderr "--absorb: is of all waves"

try passive "${smallest[@]}" --G 1/5
expect_exit 0
expect_no_stderr
cp "$scratch/stdout" "$scratch/once"
expect "JSON" python3 -c '
import json, sys
from fractions import Fraction
side = json.load(open(sys.argv[1]))
assert side["layers"] == 2
for weights in [side["strain_weights"], side["stabilisation_weights"], *side["masses"]]:
    assert len(weights) == 2 and all(Fraction(weight) > 0 for weight in weights)
assert 0 <= Fraction(side["null_lagrangian"]) <= Fraction(4, 5)
assert side["dashpot_speeds_squared"] == ["16/15", "2/5"]
assert [[len(row) for row in factor] for factor in side["dashpot_factors"]] == [[1, 2], [1, 2]]
head_on = side["reflected_energy"][0]
assert side["designed_up_to_degrees"] == 60
assert side["highest_eigenvalue"] >= side["highest_eigenvalue_interior"] > 0
assert head_on["angle"] == 0 and head_on["P"] < 0.005 and head_on["S"] < 0.02
' "$scratch/once"
kept=$NMBCGEN_CACHE
unset NMBCGEN_CACHE
try passive "${smallest[@]}" --G 1/5
expect "the same again" cmp "$scratch/once" "$scratch/stdout"
# Where glibc takes the functions of an older processor, too.
export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-FMA,-FMA4
for design in "--radius2 1 --nu 1/4 --G 1/5" "--radius2 4 --nu 1/4 --G 1/4" "--horizon 2 --G 1"; do
    read -ra design <<<"$design"
    try passive "${design[@]}"
    cp "$scratch/stdout" "$scratch/older"
    GLIBC_TUNABLES='' "$program" passive "${design[@]}" >"$scratch/newer"
    expect "the same on another machine: ${design[*]}" cmp "$scratch/older" "$scratch/newer"
done
unset GLIBC_TUNABLES
export NMBCGEN_CACHE=$kept

# NMBC2 by component is stable for the smallest family, G = 0.42 to 0.628, alone. --G is G/pi.
second=(--family nopd2d --nu 1/4 --polarisation P --order 2 --stdout --require-stable)
for g in 3/20 19/100; do
    try "${second[@]}" --radius2 1 --G "$g"
    expect_exit 0
done
for what in "1 1/8" "1 1/5" "1 1/4" "2 3/20" "4 3/20"; do
    read -r radius2 g <<<"$what"
    try "${second[@]}" --radius2 "$radius2" --G "$g"
    expect_exit 4
done
try "${second[@]}" --radius2 1 --G 3/20 --damping 1/10
expect_exit 4
expect_stderr "conditions of damped lattices are not examined for oblique waves"

# More layers: what is asked for is in the command of a header, and what is proved is the same.
# Waves below xi = 0.1 count no more than this one, and gain less.
try passive "${smallest[@]}" --G 1/5 --layers 4
expect_exit 0
cp "$scratch/stdout" "$scratch/four"
expect "less comes back at wide angles" python3 -c '
import json, sys
two, four = [{(one["angle"], one["xi"]): one for one in json.load(open(name))["reflected_energy"]} for name in sys.argv[1:]]
side = json.load(open(sys.argv[2]))
assert side["layers"] == 4 and side["designed_up_to_degrees"] == 70
for wave in "PS":
    assert all(four[60, xi][wave] < most * two[60, xi][wave] for xi, most in ((0.05, 0.75), (0.1, 0.4))), wave
    assert four[35, 0.1][wave] < 0.01, wave
    assert four[70, 0.1][wave] < 0.6 * two[70, 0.1][wave], wave
' "$scratch/once" "$scratch/four"
try passive "${smallest[@]}" --G 1/5 --layers 4 --header
expect_exit 0
expect "its command" grep -q -- "--G 1/5 --layers 4 --header" "$scratch/stdout"
expect "its name" grep -q "passive_nopd2d_r1_nu1o4_g1o5_q4{" "$scratch/stdout"

# An end of a chain: energies beside those of NMBC2, whose amplitudes at xi = 0.05, 0.1, 0.2, 0.5, 1
# are 5.2e-7, 8.3e-6, 1.3e-4, 5.5e-3, 1.0e-1 at n = 2, G = 1, s = 2.
try passive --horizon 2 --G 1
expect_exit 0
expect_no_stderr
cp "$scratch/stdout" "$scratch/once"
expect "JSON" python3 -c '
import json, sys
from fractions import Fraction
end = json.load(open(sys.argv[1]))
assert end["layers"] == 4 and end["highest_eigenvalue"] < 1.5 * end["highest_eigenvalue_interior"]
for weights in [end["strain_weights"], end["stabilisation_weights"], *end["masses"], end["dashpot_scales"]]:
    assert all(Fraction(weight) > 0 for weight in weights)
factor, = [[[Fraction(entry) for entry in row] for row in rows] for rows in end["dashpot_factors"]]
sums = [sum(row[j] for row in factor if j < len(row)) for j in range(4)]
assert sum(one * one for one in sums) == Fraction(end["dashpot_scales"][0])
amplitudes = [one["energy"] ** 0.5 for one in end["reflected_energy"]]
assert all(found < most for found, most in zip(amplitudes, [2e-5, 3e-5, 6e-5, 2e-4, 1e-3])), amplitudes
' "$scratch/once"

# The chain of atoms: the closed form, whose amplitudes fall as xi^4.
try passive --family chain1d --horizon 1
expect_exit 0
expect_no_stderr
expect "JSON of the closed form" python3 -c '
import json, sys
end = json.load(open(sys.argv[1]))
assert end["family"] == "chain1d" and end["closed_form"]["bond"].startswith("k = sqrt(8 (sqrt(5) - 2))")
assert 4 < end["highest_eigenvalue"] < 8
amplitudes = [one["energy"] ** 0.5 for one in end["reflected_energy"]]
for found, known in zip(amplitudes, [5.5e-8, 8.7e-7, 1.4e-5, 5.4e-4, 8.6e-3]):
    assert abs(found / known - 1) < 0.02, amplitudes
' "$scratch/stdout"
try passive --family chain1d --horizon 1 --header
expect_exit 0
expect "a header" grep -q "inline const PassiveEnd passive_chain1d{" "$scratch/stdout"

# Made for steps of cfl 0.88, the same end sends back a tenth of that or less; as a header it is what
# tests/runtime compiles.
try passive --horizon 2 --G 1 --time-step 2
expect_exit 0
cp "$scratch/stdout" "$scratch/stepped"
expect "a design for the steps" python3 -c '
import json, sys
of_time, of_steps = [json.load(open(name)) for name in sys.argv[1:]]
assert of_steps["time_step"] == "2" and of_steps["highest_eigenvalue"] < 1
for continuous, stepped in zip(of_time["reflected_energy"], of_steps["reflected_energy"]):
    assert stepped["energy"] < 0.1 * continuous["energy"], stepped
' "$scratch/once" "$scratch/stepped"
try passive --family nopd2d --radius2 1 --nu 3/10 --G 1/4 --header
expect_exit 0
expect "the example's side" cmp "$scratch/stdout" "${page%/how-to/*}/example/passive_side.hpp"
try passive --family bond2d --radius2 2 --weights 1,1/2 --header
expect_exit 0
expect "its lattice" grep -qF ".made_for = bond2d(2, {1, 0.5})};" "$scratch/stdout"
expect "its command" grep -qF "// Made by nmbcgen passive --family bond2d --radius2 2 --weights 1,1/2 --header" "$scratch/stdout"
try passive --horizon 1 --G 1/2 --header
expect_exit 0
expect "the name" grep -q "inline const PassiveEnd passive_nopd1d_n1_G1o2{" "$scratch/stdout"

refuses 2 "recommend requires --G" recommend "${smallest[@]}"
refuses 2 "--order: is of the waves of one polarisation: --polarisation" recommend "${smallest[@]}" --G 1 --order 2
refuses 2 "it is no sum of two squares" recommend --family nopd2d --radius2 3 --nu 1/4 --G 1
refuses 2 "--nu: Poisson's ratio 1: an isotropic solid needs -1 < nu < 1/2" passive --family nopd2d --radius2 1 --nu 1 --G 1
refuses 2 "--nu: Poisson's ratio 1/2: an isotropic solid needs" passive --family nopd2d --radius2 1 --nu 1/2 --state strain --G 1
refuses 2 "sides of families above 25 take too long: give a --polarisation" \
    recommend --family nopd2d --radius2 26 --nu 1/4 --G 1
refuses 2 "sides of families above 25 take too long: take a smaller family" \
    passive --family nopd2d --radius2 26 --nu 1/4 --G 1
refuses 2 "long S waves do not travel" passive --family bond2d --radius2 1 --weights 1
refuses 2 "need weights above 0. For the waves of one polarisation" recommend --family bond2d --radius2 4 --weights 1,1,-1/100
refuses 2 "need weights above 0" passive --family bond2d --radius2 4 --weights 1,1,-1/100
expect "passive proposes no option that it does not take" test "$(grep -c polarisation "$scratch/stderr")" -eq 0
refuses 2 "--radius2: nopd1d is no plane family" passive --family nopd1d --radius2 1 --G 1
refuses 2 "passive designs are of nopd1d, chain1d, nopd2d, bond2d" passive --family bond1d --horizon 1
refuses 2 "chain1d has neighbours at 1 alone" passive --family chain1d --horizon 2
refuses 2 "the end of chain1d is a closed form" passive --family chain1d --horizon 1 --time-step 1/2
refuses 2 "passive ends have constant influence" passive --horizon 2 --weights 1,1/2 --G 1
for horizon in 0 7; do
    refuses 2 "--horizon: '$horizon' is not a whole number from 1 to 6" passive --horizon $horizon --G 1
done
refuses 2 "--layers: is of a side of the plane" passive --horizon 2 --G 1 --layers 4
refuses 2 "--layers: a passive side of this family has 2 to 16 layers, not 1" passive "${smallest[@]}" --G 1 --layers 1
refuses 2 "--layers: a passive side of this family has 6 to 16 layers, not 17" \
    passive --family nopd2d --radius2 9 --nu 1/4 --G 1 --layers 17
refuses 2 "--layers" passive "${smallest[@]}" --G 1 --layers 4.5
refuses 2 "passive requires --G" passive --horizon 2
# Stable head-on, but not as a side, component by component; and what is stable as both.
waves=("${smallest[@]}" --polarisation P --order 1 --stdout --require-stable)
refuses 4 "strips between such sides grow, Re s = 0.021" "${waves[@]}" --G 0
refuses 4 "of 1200 wave vectors some are amplified, <= 1.100 times a reflection" "${waves[@]}" --G 1/10
expect_stderr "nmbcgen recommend --family nopd2d --radius2 1 --nu 1/4 --G 1/10 shows the sides there are"
refuses 4 "NMBC2 of S waves, stride 1, has no solution at g = 1/5" "${smallest[@]}" --polarisation P --order 2 --stdout --require-stable --G 1/5
# What is stable says what it is as a side, and on which samples.
try "${waves[@]}" --G 1/4 --format json
expect_exit 0
expect "a grade" python3 -c '
import json, sys
table = json.load(open(sys.argv[1]))
assert table["plane"]["grade"] == "contractive" and table["plane"]["evidence"] == "sampled", table["plane"]
assert table["plane"]["samples"].startswith("24 x 25 wave vectors, strips of 5, 9, 20, 31 layers with ")
assert table["plane"]["steps"] == 0.9 and table["plane"]["grows_opposite"] == [], table["plane"]
assert table["plane"]["samples"] in table["certificate"]' "$scratch/stdout"
try "${waves[@]}" --G 1/4
expect "a header has it, too" grep -q "as a side of the plane, with its like" <(tr -d '\n"' <"$scratch/stdout" | tr -s ' ')
# Corners grow where strips do not.
refuses 4 "boxes with corners between such sides grow, Re s = 0.047" \
    "${smallest[@]}" --polarisation P --order 2 --stdout --require-stable --G 67/500
next=(--family nopd2d --radius2 4 --nu 1/4)
try recommend "${next[@]}" --G 0
expect_exit 0
expect "the first is passive" grep -qE '^passive, on the 4 outermost layers' "$scratch/stdout"
expect "it is kept" grep -rq '"recommend nopd2d radius2 4 nu 1/4 stress g 0 ' "$NMBCGEN_CACHE"
expect "rates in strips and in the box" grep -qE '^NMBC1 by component +grows +- +- +<= 5\.145 +none +0\.049 +0\.043 +1/5 ' "$scratch/stdout"
try "${waves[@]}" --G 1/5
expect_exit 0
expect_no_stderr
refuses 3 "no passive design was found at G = 1: the lattice itself is stable in steps below 2.26" passive --horizon 2 --G 1 --time-step 5/2
refuses 2 "--time-step: '-1' is not a non-negative exact number" passive --horizon 2 --G 1 --time-step -1
refuses 2 "--horizon (or --radius2) is required" passive --G 1
finish
