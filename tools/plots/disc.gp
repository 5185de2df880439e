# SPDX-License-Identifier: MIT
# Damage of the particles of tools/scripts/disc-impact, from above:
#     gnuplot -c tools/plots/disc.gp particles.csv OUT.png TITLE
# The CSV has x and z in mm and the damage of each particle, the lowest first; one hides what is below it.
if (ARGC != 3) {
    printerr "usage: gnuplot -c disc.gp CSV OUT.png TITLE"
    exit status 2
}
csv = ARG1
call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "disc.gp" ARG1 "x_mm=number z_mm=number damage=number" "tools/scripts/disc-impact"
set datafile separator comma
stats csv using "x_mm" name "x" nooutput
stats csv using "z_mm" name "z" nooutput
reach(a, b) = ceil(1.02 * (a > b ? a : b))
edge = reach(reach(x_max, -x_min), reach(z_max, -z_min))

set terminal pngcairo size 900, 760 font "sans,14"
set output ARG2
set title ARG3
set size ratio -1
set xrange [-edge:edge]
set yrange [-edge:edge]
set xlabel "x in mm"
set ylabel "z in mm"
set tics out nomirror
set palette defined (0 "blue", 0.5 "yellow", 1 "red")
set cbrange [0:0.6]
set cbtics ("0" 0, "0.2" 0.2, "0.4" 0.4, "≥ 0.6" 0.6)
set cblabel "damage: share of bonds broken"
set style fill solid noborder
plot csv using "x_mm":"z_mm":(0.25):"damage" with circles linecolor palette notitle
