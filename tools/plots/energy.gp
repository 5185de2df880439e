# SPDX-License-Identifier: MIT
# The energy left in the chain against time, each curve over its own peak:
#     gnuplot -c share/nmbc/plots/energy.gp results/bar1d results/bar1d.csv NMBC1 [CSV TITLE ..]
# writes results/bar1d.svg and results/bar1d.png. The CSV files are nmbcrun's.
if (ARGC < 3 || ARGC % 2 == 0) {
    printerr "usage: gnuplot -c energy.gp OUT CSV TITLE [CSV TITLE ..] (writes OUT.svg and OUT.png)"
    exit status 2
}

set datafile separator comma
set datafile columnheaders

folder = system(sprintf("dirname '%s'", ARG0))
files = (ARGC - 1) / 2
array peak[files]
do for [i = 1:files] {
    file = ARGV[2 * i]
    call folder . "/csv.gp" "energy.gp" file "time=number total=number" "nmbcrun run"
    stats file using (column("total")) nooutput
    if (STATS_max <= 0) {
        printerr sprintf("energy.gp: no energy in %s", file)
        exit status 2
    }
    peak[i] = STATS_max
}

set xlabel "time (time unit)"
set ylabel "energy / peak energy"
set logscale y
set format x "%g"
set rmargin 4
set format y "10^{%T}"
set xrange [0:]  # energies are of half a step before, the first one, too
set yrange [:2]
set grid xtics ytics linetype 1 linecolor "#cccccc" linewidth 0.5
set border 3
set tics nomirror
set key top right noenhanced
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#0072b2" linewidth 2
set linetype 2 linecolor "#d55e00" linewidth 2
set linetype 3 linecolor "#009e73" linewidth 2
set linetype 4 linecolor "#cc79a7" linewidth 2
set linetype 5 linecolor "#e69f00" linewidth 2
set linetype 6 linecolor "#56b4e9" linewidth 2

do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size 800,500 font "sans,16" background "white"
    } else {
        set terminal pngcairo size 1600,1000 fontscale 2 linewidth 2 font "sans,12"
    }
    set output sprintf("%s.%s", ARG1, kind)
    plot for [i = 1:files] ARGV[2 * i] using (column("time")):(column("total") / peak[i]) \
         with lines title ARGV[2 * i + 1]
    set output
}
