#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2016,SC2154  # assert.sh defines what is used here
# nmbcgen oblique and taylor: what their page shows, JSON, a loop that uses it, mistakes.
# Usage: run_nmbcgen_oblique.sh NMBCGEN PAGE
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"
page=$2

# blocks N: the page's text of this number.
blocks() { python3 - "$page" "$1" <<'PYTHON'
import re, sys
print(re.findall(r"```text\n(.*?)```", open(sys.argv[1], encoding="utf-8").read(), re.S)[int(sys.argv[2])], end="")
PYTHON
}

smallest=(--family nopd2d --radius2 1 --nu 1/4)
try oblique "${smallest[@]}" --absorb P:30,S:60
expect_exit 0
expect_no_stderr
expect "the page's condition" diff <(blocks 0) "$scratch/stdout"
try taylor "${smallest[@]}" --polarisation P --order 2
expect_exit 0
expect_no_stderr
expect "the page's coefficients" diff <(blocks 1) "$scratch/stdout"

try oblique "${smallest[@]}" --absorb P:30,S:60 --decay 0 --format json
expect_exit 0
expect_no_stderr
cp "$scratch/stdout" condition.json
try oblique "${smallest[@]}" --absorb S:3:4 --format json
expect_exit 0
cp "$scratch/stdout" single.json
expect "exact coefficients" python3 -c '
import json
from fractions import Fraction as F
both, single = json.load(open("condition.json")), json.load(open("single.json"))
assert [f["b_squared"] for f in both["factors"]] == ["256/45", "32/5"]
assert single["factors"][0]["b_squared"] == str(4 * F(2, 5) / F(9, 25)) and single["decay"] == "0"
assert single["coefficients"] == [[["0", "1"], ["0", "-1"]], [["1", "0"], ["1", "0"]]]
assert both["coefficients"][2] == [["1", "0", "0", "0"], ["2", "0", "0", "0"], ["1", "0", "0", "0"]]
assert both["coefficients"][0][1] == ["0", "0", "0", "-2"]
b = [f["b"] for f in both["factors"]]
for rows, numbers in zip(both["coefficients"], both["numbers"]):
    for exact, number in zip(rows, numbers):
        value = sum(float(F(x)) * y for x, y in zip(exact, [1, b[0], b[1], b[0] * b[1]]))
        assert abs(value - number) < 1e-14
for f in both["factors"]:
    assert abs(f["speed"] - f["b"] / 2) < 1e-15'

# The page's loop, with the numbers above: layers of the lattice at one wave number k along the side, u = (u_x,
# u_y) exp(i k y). A P wave packet at 30 degrees leaves through the product; with NMBC1 by (81), the same
# at every angle, more of it comes back.
expect "a loop of one's own" python3 - <<'PYTHON'
import cmath, json, math
condition = json.load(open("condition.json"))
nu, dt, layers, ghosts = 0.25, 0.5, 180, 2
lam, mu = nu / (1 - nu * nu), 1 / (2 * (1 + nu))
xi, angle = 0.3, math.radians(30)
k_x, k = xi * math.cos(angle), xi * math.sin(angle)
g = 0.25
C = g * 12 / (2 * (1 - nu)) / 4  # g C_BB/m of radius 1

def gradient(u, I):
    return [(u[I + 1][a] - u[I - 1][a]) / 2 for a in (0, 1)], [1j * math.sin(k) * u[I][a] for a in (0, 1)]

def forces(u):
    """Of layers 2 .. n-3: stress and stabilisation of every node on its four bonds, (2), (9) to (12)."""
    state = {}
    for I in range(1, len(u) - 1):
        by_x, by_y = gradient(u, I)
        trace = by_x[0] + by_y[1]
        shear = mu * (by_y[0] + by_x[1])
        stress = [[lam * trace + 2 * mu * by_x[0], shear], [shear, lam * trace + 2 * mu * by_y[1]]]
        for bond, turned in (((1, 0), u[I + 1]), ((-1, 0), u[I - 1]),
                             ((0, 1), [cmath.exp(1j * k) * one for one in u[I]]),
                             ((0, -1), [cmath.exp(-1j * k) * one for one in u[I]])):
            state[I, bond] = [sum(stress[a][b] * bond[b] for b in (0, 1)) / 2 + C * (
                turned[a] - u[I][a] - by_x[a] * bond[0] - by_y[a] * bond[1]) for a in (0, 1)]
    result = {}
    for I in range(2, len(u) - 2):
        result[I] = [sum(state[I, bond][a] for bond in ((1, 0), (-1, 0), (0, 1), (0, -1))) -
                     state[I + 1, (-1, 0)][a] - state[I - 1, (1, 0)][a] -
                     cmath.exp(1j * k) * state[I, (0, -1)][a] - cmath.exp(-1j * k) * state[I, (0, 1)][a]
                     for a in (0, 1)]
    return result

def close(old, new, b, at, source):
    """The page's step of one factor, e = 0, of component at[1] on ghost at[0]; source: w, or 0."""
    I, a = at
    return (source + (2 / dt - b) * old[I][a] + (2 / dt + b) * old[I - 1][a] -
            (2 / dt - b) * new[I - 1][a]) / (2 / dt + b)

def factor_of(old, new, b, at):
    """w of one factor between two levels, times 2."""
    I, a = at
    return ((2 / dt + b) * new[I][a] + (2 / dt - b) * new[I - 1][a] - (2 / dt - b) * old[I][a] -
            (2 / dt + b) * old[I - 1][a])

def left_over(factors):
    n = layers + 2 * ghosts
    c = math.sqrt(16 / 15)
    def potential(I, t):
        return cmath.exp(1j * (k_x * I - c * xi * t)) * math.exp(
            -((I - 85 - c * math.cos(angle) * t) / 25) ** 2)
    def packet(I, t):  # along kappa = (sin xi_x, sin xi_y), as P waves of this lattice are
        return [(potential(I + 1, t) - potential(I - 1, t)) / 2, 1j * math.sin(k) * potential(I, t)]
    before, now = ([packet(I, t) for I in range(n)] for t in (-dt, 0))
    start = sum(abs(one) ** 2 for layer in now for one in layer)
    for step in range(400):
        force = forces(now)
        after = [[0, 0] for _ in range(n)]
        for I in range(2, n - 2):
            after[I] = [2 * now[I][a] - before[I][a] + dt * dt * force[I][a] for a in (0, 1)]
        for I in range(n - ghosts, n):
            for a in (0, 1):
                w = 0
                if len(factors) == 2:  # the other factor, on the field w of this one
                    old = {J: {a: factor_of(before, now, factors[0], (J, a))} for J in (I - 1, I)}
                    new = {I - 1: {a: factor_of(now, after, factors[0], (I - 1, a))}}
                    w = close(old, new, factors[1], (I, a), 0)
                after[I][a] = close(now, after, factors[0], (I, a), w)
        before, now = now, after
    return sum(abs(one) ** 2 for layer in now for one in layer) / start

product = left_over([factor["b"] for factor in condition["factors"]])
published = left_over([2 * math.sqrt(16 / 15)])
assert product < 2e-5 and 0.003 < published < 0.0055, (product, published)
PYTHON

# A direction of one's own.
try taylor "${smallest[@]}" --polarisation S --order 1 --direction 3:4 --format json
expect_exit 0
expect "omega^2 = c^2 (sin^2 x + sin^2 y) at g = 0" python3 -c '
import json, sys
from fractions import Fraction as F
series = json.load(open(sys.argv[1]))
assert series["speed_squared"] == "2/5" and series["cosine_squared"] == "9/25"
a_3 = series["taylor"][1]
assert F(int(a_3["num"][0]), int(a_3["den"][0])) == (F(81, 625) + F(256, 625)) / 6' "$scratch/stdout"
try taylor --family bond2d --radius2 2 --weights 4,1 --polarisation P --order 1
expect_exit 0
try taylor --family bond2d --radius2 2 --weights 1,1 --polarisation P --order 1 --direction 45
expect_exit 0

refuses 3 "the speed of long waves depends on the angle in this model" \
    taylor --family bond2d --radius2 2 --weights 1,1 --polarisation P --order 1
refuses 3 "no root of a rational number" oblique --family bond2d --radius2 2 --weights 1,1 --absorb P:3:4
refuses 3 "do not travel" oblique --family bond2d --radius2 1 --weights 1 --absorb S:0
for bad in P:90 P:0:1 X:3 P P: "" P:0,S:0,P:0 P:35 P:-3 P:3:x P:0:0 P:1/2:1; do
    refuses 2 "--absorb: " oblique "${smallest[@]}" --absorb "$bad"
done
refuses 2 "10:7 for 35 degrees nearly" oblique "${smallest[@]}" --absorb P:35
refuses 2 "0, 30, 45 or 60 degrees" oblique "${smallest[@]}" --absorb P:91
refuses 2 "--absorb is required" oblique "${smallest[@]}"
refuses 2 "--decay: " oblique "${smallest[@]}" --absorb P:0 --decay -1
refuses 2 "--radius2 is required" oblique --absorb P:0
refuses 2 "--nu is required" oblique --radius2 1 --absorb P:0
refuses 2 "it is no sum of two squares" taylor --radius2 3 --nu 1/4 --polarisation P --order 1
refuses 2 "an isotropic solid needs -1 < nu < 1/2" taylor --radius2 1 --nu 1 --polarisation P --order 1
refuses 2 "--polarisation is required" taylor "${smallest[@]}" --order 1
refuses 2 "allowed: P, S" taylor "${smallest[@]}" --order 1 --polarisation X
refuses 2 "--direction: '35' is no direction" taylor "${smallest[@]}" --order 1 --polarisation P --direction 35
refuses 2 "'nopd1d' is not a plane family" taylor --family nopd1d --radius2 1 --order 1 --polarisation P
refuses 2 "from 1 to 12" taylor "${smallest[@]}" --order 13 --polarisation P

finish
