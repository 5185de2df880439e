# SPDX-License-Identifier: MIT
# Phase and group velocity of P and S waves of a plane lattice over a quarter of the zone:
#     gnuplot -c tools/plots/dispersion_surface.gp surface.csv docs/images/dispersion_surface.svg
# The CSV is that of nmbcgen dispersion of a plane family at one g with --angle 0..90/STEP; rows of a
# limit are left out. Lines are of equal frequency.
if (ARGC != 2) {
    printerr "usage: gnuplot -c dispersion_surface.gp CSV OUT.svg"
    exit status 2
}
csv = ARG1

call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "dispersion_surface.gp" ARG1 "model wave angle xi" "nmbcgen dispersion of a plane family"
# Rays become the rows of a grid: an empty line between two.
rays(wave) = "< awk -F, -v wave=" . wave . " '$1 == \"lattice\" && $2 == wave {" . \
             " if (rows++ && $5 != last) print \"\"; last = $5; print }' '" . csv . "'"

set datafile separator comma
set terminal svg size 900, 840 font "sans,15" background "white"
set output ARG2
set multiplot layout 2,2 columnsfirst margins 0.07, 0.93, 0.11, 0.955 spacing 0.13, 0.1
set size ratio 1
set xrange [0:pi]
set yrange [0:pi]
set cbrange [0:*]
set xtics ("0" 0, "π/2" pi / 2, "π" pi)
set ytics ("0" 0, "π/2" pi / 2, "π" pi)
set border 3
set tics nomirror
# Viridis, at five points.
set palette defined (0 "#440154", 1 "#3b528b", 2 "#21918c", 3 "#5ec962", 4 "#fde725")
set pm3d map corners2color mean
set contour base
set cntrlabel onecolor
set cntrparam levels 10
unset key
radians = pi / 180
do for [wave in "P S"] {
    do for [field = 8:9] {
        set title wave . (field == 8 ? ": phase" : ": group") . " velocity in √(E/ρ)" offset 0, -0.7
        set xlabel (field == 8 ? "" : "ξ_x in 1/dX") offset 0, 0.3
        set ylabel (wave eq "P" ? "ξ_y in 1/dX" : "") offset 1
        splot rays(wave) using ($6 * cos(radians * $5)):($6 * sin(radians * $5)):7:(column(field)) \
                  with pm3d nocontour, \
              rays(wave) using ($6 * cos(radians * $5)):($6 * sin(radians * $5)):7 \
                  with lines nosurface linecolor "white" linewidth 1
    }
}
unset multiplot
set output
