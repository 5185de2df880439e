# SPDX-License-Identifier: MIT
# Pulses of chains by their influence, beside the local wave:
#     gnuplot -c tools/plots/influence.gp FOLDER OUT.svg
# FOLDER has the fields of tools/scripts/paper-influence.
if (ARGC != 2) {
    printerr "usage: gnuplot -c influence.gp FOLDER OUT.svg"
    exit status 2
}
set terminal svg size 620,360 font "sans,12" background "white"
set output ARG2
set datafile separator ","
set xlabel "x, in units of eps = 4 dX"
set ylabel "u at t = 220"
set xrange [720:830]
set yrange [-0.2:0.6]
set samples 1000
set grid
set key outside right center vertical
way = 220 * sqrt(9. / 5)
of(p) = sprintf("%s/%s_10_field.csv", ARG1, p)
plot exp(-((x - 500 - way) / 10) ** 2) / 2 with lines lw 4 lc rgb "#bdbdbd" title "local", \
     of("0") using ($1 / 4):3 with lines lw 1.5 lc rgb "#b2182b" title "p = 0", \
     of("3") using ($1 / 4):3 with lines lw 1.5 lc rgb "#ef8a62" title "p = 3", \
     of("20") using ($1 / 4):3 with lines lw 1.5 lc rgb "#2166ac" title "p = 20"
