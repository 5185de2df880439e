# SPDX-License-Identifier: MIT
# The pictures of tools/scripts/paper-1d, a panel for each file of curves:
#     gnuplot -c tools/plots/panels.gp KIND OUT FILE.. (writes OUT.svg and OUT.png)
# KIND is energy, spectrum or profile. A file's first line is "# TITLE"; then, for each curve and with
# two empty lines between them, a line "NAME" in quotes and rows x y. All panels have the same curves.
kinds = "energy spectrum profile"
if (ARGC < 3 || strstrt(" " . kinds . " ", " " . ARG1 . " ") == 0) {
    printerr "usage: gnuplot -c panels.gp energy|spectrum|profile OUT FILE.. (writes OUT.svg and OUT.png)"
    exit status 2
}
panels = ARGC - 2
columns = panels < 3 ? panels : 3
rows = ceil(panels / real(columns))
heading(file) = system(sprintf("head -n 1 '%s'", file))[3:]
curves = int(system(sprintf("grep -c '^\"' '%s'", ARG3)))

if (ARG1 eq "energy") {
    x_name = "time t (time unit)"
    y_name = "energy / peak"
    set logscale y
    set format y "10^{%T}"
    # From a power of ten below all energies left, and up to ten peaks where one grows.
    lowest = 1
    highest = 1
    do for [p = 3:ARGC] {
        stats ARGV[p] using ($1 > 40 ? $2 : 1) nooutput
        lowest = STATS_min < lowest ? STATS_min : lowest
        stats ARGV[p] using 2 nooutput
        highest = STATS_max > highest ? STATS_max : highest
    }
    set xrange [0:55]
    set yrange [10 ** floor(log10(lowest)):highest > 2 ? 10 : 2]
    if (lowest > 0.1) {
        set ytics ("0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1)
    }
    set key bottom center
}
if (ARG1 eq "spectrum") {
    x_name = "wave number ξ [1/dX]"
    y_name = "power of u / largest power"
    set logscale y
    set format y "10^{%T}"
    set xrange [0:pi]
    set xtics ("0" 0, "π/4" pi / 4, "π/2" pi / 2, "3π/4" 3 * pi / 4, "π" pi)
    set yrange [1e-9:2]
    set key top right
}
if (ARG1 eq "profile") {
    x_name = "position X [dX]"
    y_name = "displacement u [10^{-3} dX]"
    set xrange [130:370]
    set yrange [0:*]
    set key top right
}

set border 3
set tics nomirror
set mytics 1
set grid ytics linetype 1 linecolor "#cccccc" linewidth 0.5
thickness = ARG1 eq "spectrum" ? 1.3 : 2
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#0072b2" linewidth thickness
set linetype 2 linecolor "#d55e00" linewidth thickness
set linetype 3 linecolor "#009e73" linewidth thickness
set linetype 4 linecolor "#cc79a7" linewidth thickness
set linetype 5 linecolor "#e69f00" linewidth thickness
set linetype 6 linecolor "#56b4e9" linewidth thickness
set linetype 7 linecolor "#000000" linewidth thickness
set key Left reverse samplen 2
if (panels > 1) {
    set ytics 100
    if (ARG1 eq "energy") {
        set xtics 20
    }
    set key at screen 0.5, 0.985 center top maxrows 1
}

width = columns == 1 ? 700 : 60 + 340 * columns
height = rows == 1 ? (panels == 1 ? 430 : 380) : 40 + 330 * rows
do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size width, height font "sans,15" background "white"
    } else {
        set terminal pngcairo size 2 * width, 2 * height fontscale 2 linewidth 2 font "sans,11"
    }
    set output sprintf("%s.%s", ARG2, kind)
    set multiplot layout rows, columns margins 80.0 / width, 1 - 20.0 / width, 60.0 / height, \
        1 - (panels == 1 ? 40.0 : 70.0) / height spacing 55.0 / width, 85.0 / height
    do for [p = 1:panels] {
        file = ARGV[p + 2]
        set title heading(file) offset 0, -0.5
        set xlabel (p > panels - columns ? x_name : "") offset 0, 0.3
        set ylabel (p % columns == 1 || columns == 1 ? y_name : "") offset 0.5
        plot for [i = 1:curves] file index i - 1 using 1:2 with lines linetype i \
             title (p == 1 ? columnheader(1) : "")
    }
    unset multiplot
    set output
}
