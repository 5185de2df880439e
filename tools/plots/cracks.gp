# SPDX-License-Identifier: MIT
# How cracks of nmbcrun's plane scenes have grown: the damage at the end and how far they reach.
#     gnuplot -c share/nmbc/plots/cracks.gp OUT.png TITLE RUN [RUN ..]
# RUN: FOLDER/NAME of a run, whose NAME_field.vti and NAME_cracks.csv are drawn, up to four beside
# each other; their titles are their NAMEs.
if (ARGC < 3 || ARGC > 6) {
    printerr "usage: gnuplot -c cracks.gp OUT.png TITLE RUN [RUN ..] (up to four runs)"
    exit status 2
}
array runs[4] = [ARG3, ARG4, ARG5, ARG6]
count = ARGC - 2
load system(sprintf("dirname '%s'", ARG0)) . "/probes.gp"
do for [i = 1:count] {
    if (strstrt(runs[i], "'") > 0) {
        printerr sprintf("cracks.gp: no name with an apostrophe: %s", runs[i])
        exit status 2
    }
    if (system(sprintf("test -s '%s_field.vti' && test -s '%s_cracks.csv' && echo yes || true", \
                       runs[i], runs[i])) ne "yes") {
        printerr sprintf("cracks.gp: %s_field.vti and %s_cracks.csv are needed", runs[i], runs[i])
        exit status 2
    }
}
field(i) = runs[i] . "_field.vti"
growth(i) = runs[i] . "_cracks.csv"
name(i) = system(sprintf("basename '%s'", runs[i]))

# The header is text; damage follows at its offset, after a count of 8 bytes.
marker = "<AppendedData encoding=\"raw\">"
head(file, name) = system(sprintf("sed '/<AppendedData/q' '%s' | grep -ao '%s=\"[^\"]*\"' | head -n 1 | cut -d '\"' -f 2", file, name))
offset(file) = int(system(sprintf("sed '/<AppendedData/q' '%s' | grep -a 'Name=\"damage\"' | grep -ao 'offset=\"[^\"]*\"' | cut -d '\"' -f 2", file)))
skip(file) = int(system(sprintf("grep -abo -m 1 '%s' '%s' | cut -d : -f 1", marker, file))) + strlen(marker) + 2 + offset(file) + 8
extent = head(field(1), "WholeExtent")
nx = int(word(extent, 2)) + 1
ny = int(word(extent, 4)) + 1
spacing = real(system(sprintf("echo '%s' | awk '{ printf \"%%.12e\", $1 }'", head(field(1), "Spacing"))))
ends = (int(system(sprintf("head -n 1 '%s' | tr -cd , | wc -c", growth(1)))) - 1) / 4

wide = 2.5 * ny < nx * 1.5  # panels below each other
columns = wide ? 1 : count
rows = wide ? count : 1
panel_x = wide ? 780.0 : 0.79 * 0.86 * 1150 / count
panel_y = panel_x * ny / nx + 70
set terminal pngcairo size (wide ? 1000 : 1150), rows * panel_y + (ends > 0 ? 330 : 0) + 40 noenhanced font "sans,11"
set output ARG1
total = rows * panel_y + (ends > 0 ? 330 : 0) + 40
probed = 0
do for [i = 1:count] { probed = probed || has_probes(runs[i]) }
set multiplot title ARG2 . (probed ? " (circles: probes)" : "") noenhanced
set palette defined (0 "#ffffff", 0.35 "#c8c8c8", 1 "#000000")
set cbrange [0:0.7]
set cbtics 0.1 format "%.1f"
set cblabel "damage: share of bonds broken"
set colorbox user origin 0.9, (total - 40.0 - panel_y + 30) / total size 0.012, (panel_y - 55.0) / total
set tics out nomirror
set format "%g"
set size ratio -1
set xrange [spacing / 2:(nx + 0.5) * spacing]
set yrange [spacing / 2:(ny + 0.5) * spacing]
# About three steps along the shorter side, of 1, 2 or 5 times a power of ten.
decade = 10 ** floor(log10((nx < ny ? nx : ny) * spacing / 3))
steps = (nx < ny ? nx : ny) * spacing / 3 / decade
set xtics decade * (steps < 2 ? 1 : steps < 5 ? 2 : 5) * (nx > 4 * ny ? 5 : 1)
set ytics decade * (steps < 2 ? 1 : steps < 5 ? 2 : 5) * (ny > 4 * nx ? 5 : 1)
set xlabel "X (length unit)" offset 0, 0.4
do for [i = 1:count] {
    panel = wide ? 0 : i - 1
    row = wide ? i - 1 : 0
    set lmargin at screen (wide ? 0.1 : 0.02 + 0.86 * (panel + 0.2) / columns)
    set rmargin at screen (wide ? 0.88 : 0.02 + 0.86 * (panel + 0.99) / columns)
    set tmargin at screen 1 - (40.0 + row * panel_y + 25) / total
    set bmargin at screen 1 - (40.0 + (row + 1) * panel_y - 30) / total
    set title name(i) noenhanced offset 0, -0.6
    set ylabel (panel == 0 ? "Y (length unit)" : "") offset 1
    eval "plot field(i) binary skip=skip(field(i)) array=(nx,ny) format='%float64' dx=spacing dy=spacing " . \
        "origin=(spacing,spacing) using 1 with image notitle" . probes(runs[i], spacing)
    unset colorbox
}
if (ends > 0) {
    unset title
    set size noratio
    set autoscale
    set xtics autofreq
    set ytics autofreq
    set lmargin at screen 0.1
    set rmargin at screen 0.97
    set tmargin at screen 290.0 / total
    set bmargin at screen 55.0 / total
    set datafile separator comma
    set xlabel "time (time unit)" offset 0, 0.5
    set ylabel "reach from the end (length unit)" offset 0
    set key top left noenhanced
    set grid linecolor "#dddddd"
    array colours[4] = ["000000", "d55e00", "0072b2", "009e73"]
    # The first end is broad and pale, so that others on it are seen.
    dash(end) = end < 3 ? 1 : end
    plot for [i = 1:count] for [end = 1:ends] growth(i) using 1:(column(4 * end - 1)) skip 1 with lines \
        linewidth (ends > 1 && end == 1 ? 6 : 2) dashtype dash(end) \
        linecolor rgb ((ends > 1 && end == 1 ? "#a0" : "#") . colours[i]) title name(i) . (ends > 1 ? sprintf(", end %d", end) : "")
}
unset multiplot
