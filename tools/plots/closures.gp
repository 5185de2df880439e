# SPDX-License-Identifier: MIT
# Error of a bar between true surfaces over its number of nodes:
#     gnuplot -c tools/plots/closures.gp closures.csv closures.svg
# The CSV is that of tools/scripts/paper-closures.
if (ARGC != 2) {
    printerr "usage: gnuplot -c closures.gp CSV OUT.svg"
    exit status 2
}
set terminal svg size 560,400 font "sans,12" background "white"
set output ARG2
set datafile separator ","
set logscale xy
set xlabel "nodes"
set ylabel "error at 0.4 ms, % of the start"
set format y "10^{%L}"
set grid
set key outside top center vertical
set xrange [16:1000]
set xtics (20, 40, 100, 200, 400, 800)
of(closure, quadrature) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' '%s'", closure, quadrature, ARG1)
plot of("snm", "printed") using 3:6 with linespoints pt 4 lc rgb "#b2182b" title "surface node, printed quadrature", \
     of("snm", "corrected") using 3:6 with linespoints pt 6 lc rgb "#ef8a62" title "surface node, corrected", \
     of("mirror", "corrected") using 3:6 with linespoints pt 7 lc rgb "#2166ac" title "mirror"
