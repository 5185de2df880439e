# SPDX-License-Identifier: MIT
# The displacement |u| of a plane as colour, from the snapshots of nmbcrun (output.snapshots):
#     gnuplot -c share/nmbc/plots/fields.gp OUT RUN.pvd TITLE
# writes OUT.png, up to six of the snapshots, evenly spaced, and OUT.gif, up to a hundred of them.
# Colours are logarithmic over three decades below the largest displacement of those of OUT.png.
if (ARGC != 3) {
    printerr "usage: gnuplot -c fields.gp OUT RUN.pvd TITLE (writes OUT.png and OUT.gif)"
    exit status 2
}
if (strstrt(ARG2, "'") > 0) {
    printerr sprintf("fields.gp: no name with an apostrophe: %s", ARG2)
    exit status 2
}
folder = system(sprintf("dirname '%s'", ARG2))
list = sprintf("sed -n 's/^<DataSet timestep=\"\\([^\"]*\\)\" file=\"\\([^\"]*\\)\".*/%%s/p' '%s' 2>/dev/null", ARG2)
count = int(system(sprintf(list, "\\2") . " | grep -c . || true"))
if (count < 1) {
    printerr sprintf("fields.gp: no snapshots of nmbcrun in %s", ARG2)
    exit status 2
}
file_of(i) = folder . "/" . system(sprintf(list, "\\2") . sprintf(" | sed -n %dp", i))
# With a point: gnuplot takes 8e-05 for no number.
time_of(i) = real(system(sprintf(list, "\\1") . sprintf(" | awk 'NR == %d { printf \"%%.12e\", $1 }'", i)))

# The header is text; what follows it are the bytes' count, 8 bytes, and displacements of three doubles.
marker = "<AppendedData encoding=\"raw\">"
head(file, name) = system(sprintf("sed '/<AppendedData/q' '%s' | grep -ao '%s=\"[^\"]*\"' | cut -d '\"' -f 2", file, name))
skip(file) = int(system(sprintf("grep -abo -m 1 '%s' '%s' | cut -d : -f 1", marker, file))) + strlen(marker) + 2 + 8
first = file_of(1)
extent = head(first, "WholeExtent")
nx = int(word(extent, 2)) + 1
ny = int(word(extent, 4)) + 1
spacing = real(system(sprintf("echo '%s' | awk '{ printf \"%%.12e\", $1 }'", head(first, "Spacing"))))
image(file) = sprintf("'%s' binary skip=%d array=(%d,%d) format='%%3float64' dx=%.9g dy=%.9g " . \
                      "origin=(%.9g,%.9g) using (shown(sqrt($1**2 + $2**2))) with image", \
                      file, skip(file), nx, ny, spacing, spacing, spacing, spacing)

panels = count < 6 ? count : 6
chosen(p) = panels == 1 ? 1 : 1 + int((p - 1) * (count - 1.0) / (panels - 1) + 0.5)
largest = 0
do for [p = 1:panels] {
    file = file_of(chosen(p))
    stats file binary skip=skip(file) record=(nx * ny) format="%3float64" \
        using (sqrt($1**2 + $2**2)) nooutput
    largest = STATS_max > largest ? STATS_max : largest
}
largest = largest > 0 ? largest : 1
shown(u) = u > largest / 1000 ? u : largest / 1000  # 0 has no logarithm

# Dark is still: told apart without colour vision, and printed in grey.
set palette defined (0 "#000004", 0.25 "#51127c", 0.5 "#b73779", 0.75 "#fc8961", 1 "#fcfdbf")
set logscale cb
set cbrange [largest / 1000:largest]
set xrange [spacing / 2:(nx + 0.5) * spacing]
set yrange [spacing / 2:(ny + 0.5) * spacing]
set size ratio -1
set tics out nomirror
set format "%g"
set format cb "10^{%T}"
set xtics (spacing, nx * spacing)
set ytics (spacing, ny * spacing)
set cblabel "|u| (length unit)" offset 1
unset key

columns = panels < 3 ? panels : 3
columns = nx > ny ? (panels < 2 ? 1 : 2) : columns
rows = ceil(panels / (1.0 * columns))
side = 420
panel_x = nx > ny ? side : side * nx / (1.0 * ny)
panel_x = panel_x < 150 ? 150 : panel_x
panel_y = nx > ny ? side * ny / (1.0 * nx) : side
panel_y = panel_y < 60 ? 60 : panel_y
width = int(70 + columns * (panel_x + 50) + 130)
height = int(50 + rows * (panel_y + 70) + 20)
set terminal pngcairo size width, height font "sans,12"
set output ARG1 . ".png"
set multiplot layout rows, columns margins 60.0 / width, 1 - 130.0 / width, 40.0 / height, \
    1 - 70.0 / height spacing 50.0 / width, 70.0 / height title ARG3 noenhanced
set colorbox user origin 1 - 115.0 / width, 40.0 / height size 16.0 / width, 1 - 110.0 / height
do for [p = 1:panels] {
    set title sprintf("t = %.4g", time_of(chosen(p)))
    eval "plot " . image(file_of(chosen(p)))
    unset colorbox
}
unset multiplot
set output

frames = count < 100 ? count : 100
set colorbox user origin 1 - 115.0 / (panel_x + 200), 0.1 size 16.0 / (panel_x + 200), 0.75
set terminal gif animate delay 10 size int(panel_x + 200), int(panel_y + 90) font "sans,11"
set lmargin at screen 60.0 / (panel_x + 200)
set rmargin at screen 1 - 140.0 / (panel_x + 200)
set output ARG1 . ".gif"
do for [f = 1:frames] {
    i = frames == 1 ? 1 : 1 + int((f - 1) * (count - 1.0) / (frames - 1) + 0.5)
    set title sprintf("%s, t = %.4g", ARG3, time_of(i)) noenhanced
    eval "plot " . image(file_of(i))
}
set output
