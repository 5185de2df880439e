# SPDX-License-Identifier: MIT
# Frequency and group velocity against wave number, a column of panels for each horizon:
#     gnuplot -c tools/plots/dispersion.gp dispersion.csv docs/images/dispersion.svg
# The CSV is nmbcgen dispersion's; its horizons and its values of G are drawn, limits dashed.
if (ARGC != 2) {
    printerr "usage: gnuplot -c dispersion.gp CSV OUT.svg"
    exit status 2
}
csv = ARG1

call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "dispersion.gp" ARG1 "model horizon G xi omega group_velocity" "nmbcgen dispersion"
set datafile separator comma
set datafile columnheaders

# The horizons and values of G there are, in the order of the file.
horizons = ""
Gs = ""
models = 1
with(list, text) = strstrt(" " . list . " ", " " . text . " ") ? list : list . " " . text
stats csv using (horizons = with(horizons, strcol("horizon")), Gs = with(Gs, strcol("G")), \
                 models = strcol("model") eq "limit" ? 2 : models, 1) nooutput
columns = words(horizons)

set terminal svg size 100 + 400 * columns, 800 font "sans,15" background "white"
set output ARG2
set multiplot layout 2,columns columnsfirst \
    margins 100.0 / (100 + 400 * columns), 0.985, 0.09, 0.88 spacing 0.05, 0.07
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
set linetype 7 linecolor "#444444" linewidth 1.5 dashtype 3  # c
set linetype 8 linecolor "#444444" linewidth 1               # 0

shown(model, n, G) = strcol("model") eq model && strcol("horizon") eq n && strcol("G") eq G
name(m, G) = m == 1 ? "G = " . G : "limit, G = " . G

# The key is for the whole picture, above it; every panel has the same curves.
set key at screen 0.5, 0.985 center top maxrows 2 width -1
do for [c = 1:columns] {
    n = word(horizons, c)
    do for [field in "omega group_velocity"] {
        frequency = field eq "omega"
        set title (frequency ? "horizon n = " . n : "") offset 0, -0.7
        set xlabel (frequency ? "" : "ξ in 1/dX") offset 0, 0.3
        set ylabel (c > 1 ? "" : frequency ? "ω in c/dX" : "group velocity in c") offset 1
        unset arrow
        if (frequency) {
            stats csv using (strcol("horizon") eq n ? column(field) : NaN) nooutput
            top = 1.05 * STATS_max
            set yrange [0:top]
            set arrow from 0, 0 to (top < pi ? top : pi), (top < pi ? top : pi) nohead linetype 7
        } else {
            set yrange [*:*]
            set arrow from 0, 1 to pi, 1 nohead linetype 7
            set arrow from 0, 0 to pi, 0 nohead linetype 8
        }
        plot for [g = 1:words(Gs)] for [m = 1:models] csv using (column("xi")): \
                 (shown(word("lattice limit", m), n, word(Gs, g)) ? column(field) : NaN) \
                 with lines linetype g linewidth (2.8 - 0.8 * m) dashtype m \
                 title (c == 1 && frequency ? name(m, word(Gs, g)) : ""), \
             NaN with lines linetype 7 title (c == 1 && frequency ? "c" : "")
    }
}
unset multiplot
set output
