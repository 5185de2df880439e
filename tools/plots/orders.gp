# SPDX-License-Identifier: MIT
# The energy left of pulses against the order of the boundary, a panel for each table:
#     gnuplot -c tools/plots/orders.gp docs/images/orders.svg n1.md n2.md
# The tables are stability_atlas's (orders): points are runs, lines the prediction.
if (ARGC < 2) {
    printerr "usage: gnuplot -c orders.gp OUT.svg TABLE.."
    exit status 2
}
panels = ARGC - 1

# Markdown: an empty column, N, s, tau, then two of each half-width. What is "< 1e-30" is left out.
set datafile separator "|"
energy(i) = strstrt(strcol(i), "<") ? NaN : column(i)

set terminal svg size 60 + 400 * panels, 460 font "sans,15" background "white"
set output ARG1
set multiplot layout 1,panels margins 80.0 / (60 + 400 * panels), 0.985, 0.13, 0.84 spacing 0.03, 0
set logscale y
set format y "10^{%T}"
set yrange [1e-30:1]
set xrange [0.7:8.3]
set xtics 1
set border 3
set tics nomirror
set grid ytics linetype 1 linecolor "#cccccc" linewidth 0.5
set xlabel "order N" offset 0, 0.3
set key at screen 0.5, 0.985 center top maxrows 1
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#0072b2" linewidth 2 pointtype 7
set linetype 2 linecolor "#d55e00" linewidth 2 pointtype 5
set linetype 3 linecolor "#009e73" linewidth 2 pointtype 9
set linetype 4 linecolor "#cc79a7" linewidth 2 pointtype 13
set linetype 5 linecolor "#e69f00" linewidth 2 pointtype 11

do for [p = 1:panels] {
    table = ARGV[p + 1]
    heading = system(sprintf("head -n 1 '%s'", table))
    set title heading[:strlen(heading) - 1] offset 0, -0.7
    set ylabel (p == 1 ? "energy left / at the start" : "") offset 1
    if (p > 1) {
        set format y ""
    }
    widths = int(system(sprintf("awk -F'|' '/^\\| N/ { print (NF - 5) / 2 }' '%s'", table)))
    name(w) = system(sprintf("awk -F'|' '/^\\| N/ { print $%d }' '%s'", 3 + 2 * w, table))
    plot for [w = 1:widths] table using 2:(energy(4 + 2 * w)) with lines linetype w notitle, \
         for [w = 1:widths] table using 2:(energy(3 + 2 * w)) with points linetype w \
             title (p == 1 ? name(w) : "")
}
unset multiplot
