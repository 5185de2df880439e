# SPDX-License-Identifier: MIT
# Error of a bar between true ends over what it costs:
#     gnuplot -c tools/plots/ends.gp cost.csv ends.svg
# The CSV is that of tools/scripts/paper-closures cost.
if (ARGC != 2) {
    printerr "usage: gnuplot -c ends.gp CSV OUT.svg"
    exit status 2
}
set terminal svg size 620,440 font "sans,12" background "white"
set output ARG2
set datafile separator ","
set logscale xy
set xlabel "nodes times steps"
set ylabel "error at t = 0.8, % of the start"
set format x "10^{%L}"
set format y "10^{%L}"
set grid
set key outside right center vertical
of(lattice, closure) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' '%s'", lattice, closure, ARG1)
plot of("nopd1d", "cut") using 4:5 with linespoints pt 4 lc rgb "#7f7f7f" title "cut, n = 2", \
     of("spline", "kernel") using 4:5 with linespoints pt 8 lc rgb "#b2182b" title "kernel, n = 2", \
     of("bond1d", "snm") using 4:5 with linespoints pt 6 lc rgb "#ef8a62" title "snm, bonds, n = 2", \
     of("bond1d", "mirror") using 4:5 with linespoints pt 5 lc rgb "#fdae61" title "mirror, bonds, n = 2", \
     of("bond1d", "sbp") using 4:5 with linespoints pt 11 lc rgb "#a6d96a" title "sbp, bonds, n = 2", \
     of("nopd1d", "mirror") using 4:5 with linespoints pt 7 lc rgb "#2166ac" title "mirror, n = 2", \
     of("nopd1d", "sbp") using 4:5 with linespoints pt 9 lc rgb "#1a9850" title "sbp, n = 2", \
     of("fem", "sbp") using 4:5 with linespoints pt 2 lc rgb "#000000" title "linear elements"
