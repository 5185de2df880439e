# SPDX-License-Identifier: MIT
# The wave-number spectrum of a field that nmbcrun wrote:
#     awk -f tools/plots/spectrum.awk NAME_field.csv >spectrum.csv
# Rows xi (in 1/dX, 0 .. pi), u and v: the amplitude of the wave cos(xi X + phase) that fills the
# chain. The mean is removed and a Hann window laid over the chain, without which a wave cut off at
# an end would leak over the short ones. With -v plain=1 neither is done: half the sum of the
# squares, those at 0 and pi twice, is then the mean square of the field.
BEGIN { FS = ","; CONVFMT = "%.6g"; pi = atan2(0, -1); n = 0 }
NR == 1 && $0 != "node,x,u,v" {
    print "spectrum.awk: " FILENAME " is not a field of nmbcrun: node,x,u,v" >"/dev/stderr"
    failed = 1
    exit 2
}
NR > 1 { u[n] = $3; v[n] = $4; n++; mean_u += $3; mean_v += $4 }
END {
    if (failed) exit 2
    if (n < 2) { print "spectrum.awk: needs two nodes or more" >"/dev/stderr"; exit 2 }
    for (i = 0; i < n; i++) {
        turn[i] = cos(2 * pi * i / n)
        quarter[i] = sin(2 * pi * i / n)
        if (!plain) {
            window = (1 - cos(2 * pi * (i + 0.5) / n)) / 2
            u[i] = window * (u[i] - mean_u / n)
            v[i] = window * (v[i] - mean_v / n)
        }
    }
    print "xi,u,v"
    for (k = 0; 2 * k <= n; k++) {
        uc = us = vc = vs = 0
        for (i = 0; i < n; i++) {
            j = (i * k) % n
            uc += u[i] * turn[j]; us += u[i] * quarter[j]
            vc += v[i] * turn[j]; vs += v[i] * quarter[j]
        }
        # A wave shares itself between xi and -xi, which at 0 and pi are the same. The window's sum
        # is n/2.
        scale = (k == 0 || 2 * k == n ? 1 : 2) / (plain ? n : n / 2)
        print 2 * pi * k / n "," scale * sqrt(uc * uc + us * us) "," scale * sqrt(vc * vc + vs * vs)
    }
}
