# SPDX-License-Identifier: MIT
# What the sides of a plane lattice send back of a wave's energy against its angle, as a polar plot:
#     gnuplot -c tools/plots/side_reflection.gp sides.csv sides.svg
# The CSV is that of nmbcgen recommend --csv. Angles are from the normal, P waves above it and S waves
# below; the distance from the centre is the reflected energy, 10^-6 and less to 1 and more.
if (ARGC != 2) {
    printerr "usage: gnuplot -c side_reflection.gp CSV OUT.svg"
    exit status 2
}
csv = ARG1
call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "side_reflection.gp" ARG1 "boundary wave xi=number degrees=number reflected=number" "nmbcgen recommend --csv"
set datafile separator comma
set datafile columnheaders

# The boundaries and wave numbers there are, in the order of the file.
boundaries = ""
xis = ""
count = 0
last = ""
note(name) = (count = name eq last ? count : count + 1, boundaries = name eq last ? boundaries : boundaries . name . ";", last = name, 1)
with(list, text) = strstrt(" " . list . " ", " " . text . " ") ? list : list . " " . text
stats csv using (note(strcol("boundary")), xis = with(xis, strcol("xi")), 1) nooutput
array names[count]
do for [i = 1:count] { names[i] = system(sprintf("echo '%s' | cut -d';' -f%d", boundaries, i)) }

decades = 6.0
radius(energy) = energy > 10 ** -decades ? decades + log10(energy > 1 ? 1 : energy) : 0
turned(wave, y) = wave eq "P" ? y : -y
is_shown(i, xi, wave) = strcol("boundary") eq names[i] && strcol("xi") eq xi && strcol("wave") eq wave
# Told apart without colour vision too: Okabe and Ito's palette, and dashes.
array colours[6] = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00"]

panels = words(xis)
panel_x = 300.0
panel_y = 600.0
key_x = 230.0
total = panels * panel_x + key_x
set terminal svg size total, panel_y font "sans,14" background "white"
set output ARG2
set multiplot
set angles degrees
set size ratio -1
set xrange [0:1.12 * decades]
set yrange [-1.06 * decades:1.06 * decades]
unset border
unset xtics
unset ytics
set parametric
set trange [-90:90]
set samples 181
set tmargin at screen 0.93
set bmargin at screen 0.09
scale = sprintf("Distance from the centre: reflected over incident energy, logarithmic, from 10^{-%d} and less (centre) to 1 and more (rim). " . \
    "Degrees: from the normal.", int(decades))
do for [panel = 1:panels] {
    xi = word(xis, panel)
    set lmargin at screen ((panel - 1) * panel_x + 20) / total
    set rmargin at screen (panel * panel_x - 5) / total
    set title sprintf("xi = %s/dX", xi)
    unset label
    unset arrow
    if (panel == 1) {
        set label scale at screen 20.0 / total, 0.03 font ",13"
    }
    set label "P waves" at 0.1, 1.03 * decades font ",16"
    set label "S waves" at 0.1, -1.03 * decades font ",16"
    do for [degrees in "0 30 60 -30 -60"] {
        set arrow from 0, 0 to decades * cos(int(degrees)), decades * sin(int(degrees)) nohead linecolor "#dddddd" back
        set label sprintf("%d°", abs(int(degrees))) at 1.02 * decades * cos(int(degrees)), 1.02 * decades * sin(int(degrees)) \
            font ",11" textcolor "#666666"
    }
    do for [ring = 2:6:2] {
        set label (ring < 6 ? sprintf("10^{%d}", ring - 6) : "1") at (ring - 0.1) * cos(45), (ring - 0.1) * sin(45) right font ",10" textcolor "#666666"
    }
    if (panel == panels) {
        set key at screen 1, 0.5 right center samplen 2 font ",12" noautotitle noenhanced
    } else {
        unset key
    }
    plot for [ring = 2:6:2] ring * cos(t), ring * sin(t) with lines linewidth 0.5 linecolor "#cccccc" notitle, \
        for [i = 1:count] for [wave in "P S"] csv using \
        (is_shown(i, xi, wave) ? radius(column("reflected")) * cos(column("degrees")) : NaN): \
        (radius(column("reflected")) * turned(wave, sin(column("degrees")))) with lines linewidth 2 dashtype i \
        linecolor rgb colours[i] title (wave eq "P" ? names[i] : "")
}
unset multiplot
