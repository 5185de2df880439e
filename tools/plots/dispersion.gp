# SPDX-License-Identifier: MIT
# Frequency and group velocity against wave number, a column of panels for each horizon:
#     gnuplot -c tools/plots/dispersion.gp dispersion.csv docs/images/dispersion.svg
# The CSV is nmbcgen dispersion's; its horizons and its values of G are drawn, limits dashed.
if (ARGC != 2) {
    printerr "usage: gnuplot -c dispersion.gp CSV OUT.svg"
    exit status 2
}
csv = ARG1

set datafile separator comma
set datafile columnheaders

# The horizons and values of G there are, in the order of the file.
horizons = ""
Gs = ""
limits = 0
with(list, text) = strstrt(" " . list . " ", " " . text . " ") ? list : list . " " . text
stats csv using (horizons = with(horizons, strcol("horizon")), Gs = with(Gs, strcol("G")), \
                 limits = limits + (strcol("model") eq "limit"), 1) nooutput
columns = words(horizons)

set terminal svg size 100 + 400 * columns, 800 font "sans,15" background "white"
set output ARG2
set multiplot layout 2,columns columnsfirst \
    margins 70.0 / (100 + 400 * columns), 0.985, 0.075, 0.87 spacing 0.055, 0.06
set xrange [0:pi]
set xtics ("0" 0, "π/4" pi / 4, "π/2" pi / 2, "3π/4" 3 * pi / 4, "π" pi)
set border 3
set tics nomirror
set grid ytics linetype 1 linecolor "#cccccc" linewidth 0.5
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#0072b2" linewidth 2
set linetype 2 linecolor "#d55e00" linewidth 2
set linetype 3 linecolor "#009e73" linewidth 2
set linetype 4 linecolor "#cc79a7" linewidth 2
set linetype 5 linecolor "#e69f00" linewidth 2
set linetype 6 linecolor "#56b4e9" linewidth 2

shown(model, n, G) = strcol("model") eq model && strcol("horizon") eq n && strcol("G") eq G
name(model, G) = model eq "lattice" ? "G = " . G : "limit"

# The key is for the whole picture, above it; every panel has the same curves.
set key at screen 0.5, 0.985 center top maxrows 2 width -1
do for [c = 1:columns] {
    n = word(horizons, c)
    do for [field in "omega group_velocity"] {
        frequency = field eq "omega"
        set title frequency ? "horizon n = " . n : "" offset 0, -0.7
        set xlabel frequency ? "" : "ξ in 1/dX"
        set ylabel c > 1 ? "" : frequency ? "ω in c/dX" : "group velocity in c"
        set yrange [frequency ? 0 : *:*]
        unset arrow
        if (!frequency) { set arrow from 0, 0 to pi, 0 nohead linecolor "#444444" linewidth 1 }
        # At n = 1 and large G everything is steeper than c; elsewhere omega = c xi leaves the panel.
        stats csv using (strcol("horizon") eq n ? column(field) : NaN) nooutput
        top = frequency ? 1.05 * STATS_max : 1
        plot \
            for [g = 1:words(Gs)] csv using (column("xi")): \
                (shown("lattice", n, word(Gs, g)) ? column(field) : NaN) with lines linetype g \
                title c == 1 && frequency ? name("lattice", word(Gs, g)) : "", \
            for [g = 1:(limits ? words(Gs) : 0)] csv using (column("xi")): \
                (shown("limit", n, word(Gs, g)) ? column(field) : NaN) \
                with lines linetype g linewidth 1.2 dashtype 2 \
                title c == 1 && frequency ? name("limit", word(Gs, g)) : "", \
            [0:pi] (frequency && x > top ? NaN : frequency ? x : 1) \
                with lines linewidth 1 linecolor "#888888" dashtype 3 \
                title c == 1 && frequency ? "c" : ""
    }
}
unset multiplot
set output
