# SPDX-License-Identifier: MIT
"""A Gaussian pulse on 200 nodes, n = 1, G = 1/2, in units dX = c = 1, with an NMBC2 that is matched in
its steps of 1/2. Its table, nopd1d_n1_order2_dt1o2.py, has to be in PYTHONPATH:
docs/how-to/own-code.md says how to make it."""
import math
import nopd1d_n1_order2_dt1o2 as table

G, dt, nodes, ghosts = 0.5, 0.5, 200, 2
c, b = ([float(x) for x in values] for values in table.coefficients("1/2"))
own = c[0] - dt / 2 * b[0]
u = [math.exp(-((i - 102) / 10) ** 2) for i in range(nodes + 2 * ghosts)]
v = [0.0] * len(u)

for step in range(600):
    for i in range(ghosts, ghosts + nodes):  # the forces of this lattice, (39)
        second = u[i - 2] - 2 * u[i] + u[i + 2]
        fourth = u[i - 2] - 4 * u[i - 1] + 6 * u[i] - 4 * u[i + 1] + u[i + 2]
        v[i] += dt * (second / 2 - G * fourth) / 2
    for inwards in (1, -1):  # left end, right end
        for ghost in (1, 0) if inwards == 1 else (-2, -1):
            total = b[0] * u[ghost]
            for j in (1, 2):
                node = ghost + j * inwards
                total += b[j] * (u[node] + dt / 2 * v[node]) - c[j] * v[node]
            v[ghost] = total / own
    u = [x + dt * y for x, y in zip(u, v)]
print("largest displacement left: %.0e" % max(map(abs, u)))
