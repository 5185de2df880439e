# SPDX-License-Identifier: MIT
# The bar of tools/scenes/fig6_nopd.toml with one of the two forms of Nicely 2018, (59), for its
# outermost nodes, which no scene can have as printed:
#     awk -v form=printed -f tools/plots/edge_node.awk      3 u_0 - 4 u_2 + u_3, as printed
#     awk -v form=derived -f tools/plots/edge_node.awk      4 u_0 - 5 u_1 + u_3, from the energy
# Rows time and total energy, as nmbcrun's, until it has grown a hundredfold. A program of its own,
# so that it checks the "truncated" ends of nmbcrun too.
BEGIN {
    if (form == "printed") { of_0 = 3; of_1 = 0; of_2 = -4 }
    else if (form == "derived") { of_0 = 4; of_1 = -5; of_2 = 0 }
    else { print "edge_node.awk: needs -v form=printed or -v form=derived" >"/dev/stderr"; exit 2 }
    nodes = 500; E = 57.1464; c = sqrt(E); dt = 0.02; duration = 12.56; end = 54.88
    pi = atan2(0, -1)
    last = nodes + 1  # 0 and last are the ghost nodes
    for (i = 0; i <= last; i++) u[i] = v[i] = 0
    print "time,total"
    for (step = 1; step <= end / dt + 0.5; step++) {
        for (i = 2; i < nodes; i++) v[i] += dt * E / 4 * (u[i - 2] - 2 * u[i] + u[i + 2])
        v[1] += dt * E / 4 * (of_0 * u[0] + of_1 * u[1] + of_2 * u[2] + u[3])
        v[nodes] += dt * E / 4 * (of_0 * u[last] + of_1 * u[nodes] + of_2 * u[nodes - 1] + u[nodes - 2])
        t = step * dt
        # dt divides the duration: let go from rest, half a step of acceleration, v before it about 0
        if (t < duration + dt / 2)
            for (i = 248; i <= 252; i++) v[i] = (0.0025 * (1 - cos(pi * t / duration)) - u[i]) / dt
        else if (t < duration + 1.5 * dt)
            for (i = 248; i <= 252; i++) v[i] /= 2
        # (58), both sides at the middle of the step
        v[0] = (2 * c * (u[1] + dt / 2 * v[1] - u[0]) - v[1]) / (1 + c * dt)
        v[last] = (2 * c * (u[nodes] + dt / 2 * v[nodes] - u[last]) - v[nodes]) / (1 + c * dt)
        for (i = 0; i <= last; i++) { before[i] = u[i]; u[i] += dt * v[i] }
        if (step % 10) continue
        total = 0
        for (i = 1; i <= nodes; i++) {
            strain = (before[i + 1] + u[i + 1] - before[i - 1] - u[i - 1]) / 4
            total += v[i] ^ 2 / 2 + E * strain ^ 2 / 2
        }
        printf "%.6g,%.10g\n", t - dt / 2, total
        if (t <= duration && total > peak) peak = total
        if (t > duration && total > 100 * peak) exit
    }
}
