# SPDX-License-Identifier: MIT
# Space-time pictures of runs, a panel for each: displacement u or velocity v as colour, over position
# and time, from the snapshots of nmbcrun (output.snapshots). h5dump (package hdf5-tools) reads them.
#     gnuplot -c share/nmbc/plots/spacetime.gp u|v OUT RUN.h5 TITLE [RUN.h5 TITLE ..] (writes OUT.png)
# Up to three runs; all have the same colours.
if (ARGC < 4 || ARGC % 2 == 1 || (ARG1 ne "u" && ARG1 ne "v")) {
    printerr "usage: gnuplot -c spacetime.gp u|v OUT RUN.h5 TITLE [RUN.h5 TITLE ..] (writes OUT.png)"
    exit status 2
}
if (system("command -v h5dump || true") eq "") {
    printerr "spacetime.gp: needs h5dump (package hdf5-tools)"
    exit status 2
}
panels = (ARGC - 2) / 2

# What h5dump has of a dataset of one dimension, a line each.
values(file, name) = sprintf("h5dump -d %s -y -w 1 '%s' 2>/dev/null | ", name, file) . \
                     "sed -n '/DATA {/,/}/s/^ *\\([-+.0-9e]\\{1,\\}\\),*$/\\1/p'"
count(file, name) = int(system(values(file, name) . " | grep -c . || true"))
lowest(file, name) = real(system(values(file, name) . " | sed -n 1p"))
highest(file, name) = real(system(values(file, name) . " | sed -n '$p'"))

array nodes[panels]
array snapshots[panels]
array raw[panels]
largest = 0
do for [p = 1:panels] {
    file = ARGV[2 * p + 1]
    if (strstrt(file, "'") > 0) {
        printerr sprintf("spacetime.gp: no name with an apostrophe: %s", file)
        exit status 2
    }
    nodes[p] = count(file, "x")
    snapshots[p] = count(file, "time")
    if (nodes[p] < 2 || snapshots[p] < 2) {
        printerr sprintf("spacetime.gp: no two snapshots of nmbcrun in %s", file)
        exit status 2
    }
}
do for [p = 1:panels] {
    raw[p] = system("mktemp")
    system(sprintf("h5dump -d %s -b LE -o '%s' '%s' >/dev/null", ARG1, raw[p], ARGV[2 * p + 1]))
    stats raw[p] binary format="%float64" using 1 nooutput
    largest = STATS_max > largest ? STATS_max : largest
    largest = -STATS_min > largest ? -STATS_min : largest
}

width = 310 + 400 * panels
set terminal pngcairo size width, 560 linewidth 1.3 font "sans,13"
set output ARG2 . ".png"
set multiplot layout 1, panels margins 125.0 / width, 1 - 185.0 / width, 0.14, 0.92 \
    spacing 40.0 / width, 0
# White between blue and red, as ColorBrewer's RdBu: told apart without colour vision.
set palette defined (-1 "#053061", -0.6 "#4393c3", -0.2 "#d1e5f0", 0 "#ffffff", \
                     0.2 "#fddbc7", 0.6 "#d6604d", 1 "#67001f") maxcolors 65
set cbrange [-largest:largest]
set tics out nomirror
set format "%g"
# Five or so along a bar.
round_up(part, power) = power * (part <= power ? 1 : part <= 2 * power ? 2 : part <= 5 * power ? 5 : 10)
set xlabel "position X (length unit)"
set colorbox user origin 1 - 165.0 / width, 0.14 size 18.0 / width, 0.78
set cblabel (ARG1 eq "u" ? "displacement u (length unit)" : "velocity v (length / time unit)") offset 1
unset key
do for [p = 1:panels] {
    file = ARGV[2 * p + 1]
    x0 = lowest(file, "x")
    x1 = highest(file, "x")
    t0 = lowest(file, "time")
    t1 = highest(file, "time")
    part = (x1 - x0) / 5.5
    set xtics round_up(part, 10 ** floor(log10(part)))
    set xrange [x0:x1]
    set yrange [t0:t1]
    set title ARGV[2 * p + 2] offset 0, -0.5 noenhanced
    if (p == 1) {
        set ylabel "time t (time unit)"
    } else {
        unset ylabel
        set format y ""
    }
    plot raw[p] binary array=(nodes[p], snapshots[p]) format="%float64" \
         dx=(x1 - x0) / (nodes[p] - 1) dy=(t1 - t0) / (snapshots[p] - 1) origin=(x0, t0) \
         using 1 with image
    unset colorbox
}
unset multiplot
set output
do for [p = 1:panels] {
    system(sprintf("rm -f '%s'", raw[p]))
}
