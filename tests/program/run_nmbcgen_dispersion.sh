#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# nmbcgen dispersion: which rows in which order, and what is refused. What is in them:
# tests/dispersion. Usage: run_nmbcgen_dispersion.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

# Two rows a curve, at pi/2 and pi. n = 1: omega^2 = sin^2 + 2 G (1 - cos)^2.
try dispersion --horizon 1 --G 1/2,0 --samples 2
expect_exit 0
expect_no_stderr
expect_nothing_written
printf '%s\n' model,horizon,G,xi,omega,phase_velocity,group_velocity \
    lattice,1,0.5,1.5707963267948966,1.4142135623730951,0.9003163161571061,0.7071067811865476 \
    lattice,1,0.5,3.141592653589793,2,0.6366197723675814,0 \
    lattice,1,0,1.5707963267948966,1,0.6366197723675814,0 \
    lattice,1,0,3.141592653589793,0,0,-1 >"$scratch/expected"
expect_same "$scratch/stdout" "$scratch/expected"
try dispersion --family nopd1d --G=0.5,0/7 --horizon=1 --samples=2
expect_same "$scratch/stdout" "$scratch/expected"

# n varies slowest, then G, then the model; 200 wave numbers unless told otherwise.
try dispersion --horizon 3,1 --G 1,0 --limit
expect_exit 0
expect_no_stderr
cut -d, -f1-3 "$scratch/stdout" | uniq -c | awk '{ print $1, $2 }' >"$scratch/order"
printf '%s\n' "1 model,horizon,G" "200 lattice,3,1" "200 limit,3,1" "200 lattice,3,0" "200 limit,3,0" \
    "200 lattice,1,1" "200 limit,1,1" "200 lattice,1,0" "200 limit,1,0" >"$scratch/expected"
expect_same "$scratch/order" "$scratch/expected"
expect "xi = pi/200 .. pi, and finite numbers" awk -F, 'BEGIN { pi = atan2(0, -1) }
    NR == 1 { next }
    { i = (NR - 2) % 200 + 1; if (($4 - pi * i / 200) ^ 2 > 1e-28 || $0 ~ /nan|inf/) { print; bad = 1 } }
    END { exit bad || NR != 1601 }' "$scratch/stdout"
# 40 digits at most: the largest G there is, and a very small one.
try dispersion --horizon 99 --G "$(printf '9%.0s' {1..39}),0.$(printf '0%.0s' {1..37})1" --limit --samples 3
expect_exit 0
expect "twelve rows of finite numbers" awk -F, '/nan|inf/ { bad = 1 } END { exit bad || NR != 13 }' "$scratch/stdout"

# refuses TEXT ARGUMENT..
refuses() {
    local text=$1
    shift
    try dispersion "$@"
    expect_exit 2
    expect_stderr_lines 2
    expect_no_stdout
    expect_nothing_written
    expect_stderr "$text"
}
refuses "--horizon (or --radius2) is required" --G 1
refuses "dispersion requires --G" --horizon 1
for list in "" "," "1," ",1" "1,,2"; do
    refuses "--horizon: '$list' has an empty item" --G 1 --horizon "$list"
    refuses "--G: '$list' has an empty item" --horizon 1 --G "$list"
done
refuses "--horizon: '2,1,2' has the value 2 twice" --G 1 --horizon 2,1,2
refuses "--G: '1/2,1,0.5' has the value 0.5 twice" --horizon 1 --G 1/2,1,0.5
for bad in 0 -1 101 1.5 x " 2" "1;2" 1e1; do
    refuses "--horizon: '$bad' is not a whole number from 1 to 100" --G 1 --horizon "1,$bad"
done
for bad in -1 nan inf 1e308 x " 2" "1;2" 1/0; do
    refuses "--G: '$bad'" --horizon 1 --G "1/3,$bad"
done
refuses "--horizon is given 2 times, where once is allowed" --horizon 1 --horizon 2 --G 1
refuses "--G is given 2 times, where once is allowed" --horizon 1 --G 1 --G 2
for bad in 0 -1 1.5 1000001 nan "" 1,2; do
    refuses "--samples: '$bad' is not a whole number from 1 to 1000000" --horizon 1 --G 1 --samples "$bad"
done
refuses "'nopd7d' is not a family" --family nopd7d --horizon 1 --G 1 --limit
refuses "--limit takes no value" --horizon 1 --G 1 --limit=3
refuses "not expected" --horizon 1 --G 1 --order 1
refuses "--G: '0,' has an empty item" --horizon 1 --G 0, 1

# Standard output that is closed, or full.
code=0
"$program" dispersion --horizon 1 --G 1 2>"$scratch/stderr" >&- || code=$?
expect_exit 5
expect_stderr "standard output"
code=0
"$program" dispersion --horizon 1 --G 1 2>"$scratch/stderr" >/dev/full || code=$?
expect_exit 5
expect_stderr "No space left"

# Plane models: P, then S, at each angle. delta = 1, G = 0: omega^2 = c_P^2 (sin^2 xi_x + sin^2 xi_y),
# c_P^2 = 16/15, c_S^2 = 2/5 (tests/families/exam_nopd2d_printed.cpp).
plane=(--family nopd2d --radius2 1 --nu 1/4)
try dispersion "${plane[@]}" --G 0 --angle 0,30 --samples 40
expect_exit 0
expect_no_stderr
expect "what (70) is where it is right" awk -F, '
    NR == 1 { bad = $0 != "model,wave,radius2,g,angle,xi,omega,phase_velocity,group_velocity,group_angle"; next }
    { rows += 1; alpha = $5 * atan2(0, -1) / 180; x = $6 * cos(alpha); y = $6 * sin(alpha)
      square = ($2 == "P" ? 16 / 15 : 2 / 5) * (sin(x) ^ 2 + sin(y) ^ 2)
      if ($1 != "lattice" || ($7 ^ 2 - square) ^ 2 > 1e-24 || ($7 / $6 - $8) ^ 2 > 1e-24) { print; bad = 1 }
      if ($7 < 1e-7) next
      gx = sin(2 * x); gy = sin(2 * y); size = ($2 == "P" ? 8 / 15 : 1 / 5) * sqrt(gx ^ 2 + gy ^ 2) / $7
      if (($9 - size) ^ 2 > 1e-20) { print; bad = 1 } }
    END { exit bad || rows != 160 }' "$scratch/stdout"
try dispersion "${plane[@]}" --G 0,1/2
expect "four angles, 200 wave numbers, two waves, two values of g" test "$(wc -l <"$scratch/stdout")" -eq 3201
try dispersion --family bond2d --radius2 2 --weights 1,1/2 --samples 1
expect_exit 0
refuses "--limit: bond2d states no continuum limit" --family bond2d --radius2 2 --weights 1,1/2 --limit

# The limit is the same at every angle, and travels along or against the wave vector.
try dispersion "${plane[@]}" --G 0,1/2 --angle 0..30/15 --limit --samples 5
expect_exit 0
expect "three angles, two models, two waves, two values of g" test "$(wc -l <"$scratch/stdout")" -eq 121
expect "no angle in the limit" awk -F, '
    $1 != "limit" { next }
    { which = $2 "," $4; turn = ($10 - $5 + 540) % 360
      if (($10 - $5) ^ 2 > 1e-16 && (turn - 0) ^ 2 > 1e-16) { print; bad = 1 }
      if ($5 == 0) at[which "," $6] = $7
      if ($5 == 0 && $6 < 0.7 && ($2 == "P" ? 16 / 15 : 2 / 5) < $8 ^ 2 && $4 == 0) { print; bad = 1 } }
    END { for (one in at) rows++; exit bad || rows != 20 }' "$scratch/stdout"
for bad in 30..0/5 0..90/0 0..90/x 0..90/0.1 0..181/5 ..90/5 0..90/; do
    refuses "--angle: '" "${plane[@]}" --G 0 --angle "$bad"
done
refuses "--angle: '181' is not an angle from -180 to 180 degrees" "${plane[@]}" --G 0 --angle 181
refuses "--angle: nopd1d is no plane family" --horizon 1 --G 0 --angle 1
refuses "--radius2 is required" --family nopd2d --horizon 1 --G 0
refuses "dispersion requires --G" "${plane[@]}"

finish
