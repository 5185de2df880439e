# SPDX-License-Identifier: MIT
# The spectra that tools/scripts/zero_energy_modes left in FOLDER, horizons 1 to 4:
#     gnuplot -c tools/plots/spectra.gp FOLDER OUT.svg
if (ARGC != 2) {
    printerr "usage: gnuplot -c spectra.gp FOLDER OUT.svg"
    exit status 2
}
folder = ARG1

set datafile separator comma
set datafile columnheaders

# omega(xi) of (41) at G = 0, in c/dX and up to its sign: 0 at the zero-energy modes.
omega(xi, n) = 6.0 / (n * (n + 1) * (2 * n + 1)) * sum [m = 1:n] m * sin(m * xi)

set terminal svg size 900,1100 font "sans,14" background "white"
set output ARG2
set multiplot layout 4,2 margins 0.09,0.985,0.055,0.93 spacing 0.09,0.05
set logscale y
set format y "10^{%T}"
set xrange [0:pi]
set border 3
set tics nomirror
set ytics 100
set mytics 1
set xtics ("0" 0, "π/4" pi / 4, "π/2" pi / 2, "3π/4" 3 * pi / 4, "π" pi)
set grid ytics linetype 1 linecolor "#cccccc" linewidth 0.5
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#888888" linewidth 1
set linetype 2 linecolor "#0072b2" linewidth 1.5
set linetype 3 linecolor "#d55e00" linewidth 1.5

# The key is for the whole picture, above it; every panel has the same curves.
set key at screen 0.5,0.99 center top maxrows 1 width -2 noenhanced
do for [n = 1:4] {
    unset arrow
    do for [i = 1:999] {
        if (omega(i * pi / 1000, n) * omega((i + 1) * pi / 1000, n) <= 0 || i == 999) {
            set arrow from first (i + 0.5) * pi / 1000, graph 0 to first (i + 0.5) * pi / 1000, graph 1 \
                nohead dashtype 3 linecolor "#444444"
        }
    }
    set xlabel n == 4 ? "wave number ξ [1/dX]" : ""
    do for [field in "u v"] {
        set yrange [1e-9:1e-2]
        set ylabel sprintf("amplitude of %s, n = %d", field eq "u" ? "u [dX]" : "v [dX / time unit]", n)
        name(stage) = sprintf("%s/n%d_%s_spectrum.csv", folder, n, stage)
        plot name("nmbc1_before") using 1:(column(field)) with lines linetype 1 \
                 title (n == 1 && field eq "u" ? "end of the drive" : ""), \
             name("nmbc1_after") using 1:(column(field)) with lines linetype 2 \
                 title (n == 1 && field eq "u" ? "t = 54.88, NMBC1" : ""), \
             name("recommended_after") using 1:(column(field)) with lines linetype 3 \
                 title (n == 1 && field eq "u" ? "t = 54.88, recommended" : "")
    }
}
unset multiplot
set output
