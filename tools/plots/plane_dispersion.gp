# SPDX-License-Identifier: MIT
# Phase and group velocity of P and S waves of a plane lattice against the wave number:
#     gnuplot -c tools/plots/plane_dispersion.gp plane.csv docs/images/plane_dispersion.svg
# The CSV is that of nmbcgen dispersion of a plane family; its angles are colours, its values of g
# dashes.
if (ARGC != 2) {
    printerr "usage: gnuplot -c plane_dispersion.gp CSV OUT.svg"
    exit status 2
}
csv = ARG1

call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "plane_dispersion.gp" ARG1 "model wave g angle xi" "nmbcgen dispersion of a plane family"
set datafile separator comma
set datafile columnheaders

# The angles and values of g there are, in the order of the file.
angles = ""
gs = ""
with(list, text) = strstrt(" " . list . " ", " " . text . " ") ? list : list . " " . text
stats csv using (angles = with(angles, strcol("angle")), gs = with(gs, strcol("g")), 1) nooutput

set terminal svg size 900, 800 font "sans,15" background "white"
set output ARG2
set multiplot layout 2,2 columnsfirst margins 0.1, 0.985, 0.09, 0.88 spacing 0.07, 0.07
set xrange [0:*]
set xtics ("0" 0, "π/2" pi / 2, "π" pi, "3π/2" 3 * pi / 2)
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
set linetype 7 linecolor "#444444" linewidth 1  # 0

shown(wave, angle, g) = strcol("wave") eq wave && strcol("angle") eq angle && strcol("g") eq g
degree(d) = sprintf("%g°, g = ", real(d))

# The key is for the whole picture, above it; every panel has the same curves.
set key at screen 0.5, 0.985 center top maxrows 2 width -1
do for [wave in "P S"] {
    do for [field in "phase_velocity group_velocity"] {
        first = wave eq "P" && field eq "phase_velocity"
        set title (field eq "phase_velocity" ? wave . " waves" : "") offset 0, -0.7
        set xlabel (field eq "phase_velocity" ? "" : "ξ in 1/dX") offset 0, 0.3
        set ylabel (wave eq "S" ? "" : (field eq "phase_velocity" ? "phase" : "group") . \
                    " velocity in √(E/ρ)") offset 1
        set yrange [0:*]
        plot for [a = 1:words(angles)] for [g = 1:words(gs)] csv using (column("xi")): \
                 (shown(wave, word(angles, a), word(gs, g)) ? column(field) : NaN) \
                 with lines linetype a dashtype g \
                 title (first ? degree(word(angles, a)) . sprintf("%.3g", real(word(gs, g))) : "")
    }
}
unset multiplot
set output
