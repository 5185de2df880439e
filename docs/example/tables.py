# SPDX-License-Identifier: MIT
"""What a boundary reflects, from its table alone: Python, standard library, no simulation.

    nmbcgen --order 2 --horizon 1 --format python --out .
    python3 tables.py
"""

import cmath
import math

import nopd1d_n1_order2 as table

# 1. A table holds a condition for every stabilisation G. Where it is certified stable with its like
# at the other end, and in which time steps, is in the table, too.
for low, high in table.MODAL:
    print(f"NMBC{table.ORDER}, n = {table.HORIZON}: certified for G from {low} to {high}")
G = "1/2"  # exact: text or Fraction, or a float, which is then taken to the last bit
print(f"G = {G}: steps up to cfl = dt omega_max/2 = {table.largest_cfl(0.5)}")

# 2. The coefficients of sum_j c_j v_j = sum_j b_j u_j, j counted inwards from the ghost node:
# c_j has no unit and b_j is in c/dX.
c, b = table.coefficients(G)
print("c =", *c)
print("b =", *b)

# 3. The lattice: omega^2 = symbol[0] + 2 sum_m symbol[m] cos(m xi), in units dX = c = 1.
symbol = [float(table.evaluate(entry, G)) for entry in table.SYMBOL]


def frequency(xi):
    terms = (2 * k * math.cos(m * xi) for m, k in enumerate(symbol) if m > 0)
    return math.sqrt(symbol[0] + sum(terms))


# 4. A wave exp(i (omega t + xi x)) that meets the left end, and R times one that goes back: put
# into the condition, they give R. (At G = 1/2 these are the only two waves of this frequency. In
# general there are others, and nmbcgen reflect knows them.)
def reflected(xi):
    def residual(z):
        return sum(
            (1j * frequency(xi) * float(c_j) - float(b_j)) * z ** (j * table.STRIDE)
            for j, (c_j, b_j) in enumerate(zip(c, b))
        )

    return abs(residual(cmath.exp(1j * xi)) / residual(cmath.exp(-1j * xi)))


# 5. So this is the spacing you need: at least so many nodes to the shortest wave that matters.
for nodes in (6, 10, 20, 40):
    print(f"{nodes:3} nodes to a wave: {reflected(2 * math.pi / nodes):.1e} of its amplitude returns")
