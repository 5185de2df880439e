# SPDX-License-Identifier: MIT
# Energy over its peak in time, a panel for each radius of several G, or one for each side of several radii:
#     gnuplot -c tools/plots/energy_left.gp FOLDER "RADII2" "GS" OUT.svg
# FOLDER has the energies of tools/scripts/paper-2d, RADIUS2_G_SIDE.csv.
if (ARGC != 4) {
    printerr "usage: gnuplot -c energy_left.gp FOLDER RADII2 GS OUT.svg"
    exit status 2
}
radii = ARG2
values = ARG3
of(radius2, G, side) = sprintf("%s/%s_%s_%s.csv", ARG1, radius2, G, side)
sides = "printed passive"
names = "(81) passive"
by_radius = words(values) == 1
panels = by_radius ? words(sides) : words(radii)
colours = "#000000 #b2182b #ef8a62 #1a9850 #67a9cf #2166ac"
set terminal svg size 320 * panels, 380 font "sans,12" background "white"
set output ARG4
set datafile separator ","
set datafile columnheaders
set multiplot layout 1,panels
set logscale y
set format y "10^{%L}"
set yrange [1e-6:2]
set xlabel "t"
set ylabel "energy over its peak"
set grid
set key bottom left
set xtics 10
peak(file) = system(sprintf("awk -F, '/^time/ { for (i = 1; i <= NF; ++i) if ($i == \"total\") column = i; next } column && $column + 0 > peak { peak = $column + 0 } END { print peak }' '%s'", file)) + 0
if (by_radius) {
    do for [s = 1:words(sides)] {
        set title word(names, s) . " sides, G = " . values
        array most[words(radii)]
        do for [r = 1:words(radii)] { most[r] = peak(of(word(radii, r), values, word(sides, s))) }
        plot for [r = 1:words(radii)] of(word(radii, r), values, word(sides, s)) using "time":(column("total") / most[r]) \
            with lines lw 1.5 lc rgb word(colours, r) title "delta^2 = " . word(radii, r)
    }
} else {
    do for [r = 1:words(radii)] {
        set title "delta^2 = " . word(radii, r)
        array most[2 * words(values)]
        do for [g = 1:words(values)] {
            do for [s = 1:2] { most[2 * g - 2 + s] = peak(of(word(radii, r), word(values, g), word(sides, s))) }
        }
        plot for [g = 1:words(values)] of(word(radii, r), word(values, g), "printed") \
                 using "time":(column("total") / most[2 * g - 1]) with lines dt 2 lc rgb word(colours, g) notitle, \
             for [g = 1:words(values)] of(word(radii, r), word(values, g), "passive") \
                 using "time":(column("total") / most[2 * g]) with lines lw 1.5 lc rgb word(colours, g) title "G = " . word(values, g)
    }
}
unset multiplot
