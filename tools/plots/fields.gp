# SPDX-License-Identifier: MIT
# The displacement |u| of a plane, or its energy, as colour, from the snapshots of nmbcrun
# (output.snapshots):
#     gnuplot -c share/nmbc/plots/fields.gp OUT RUN.pvd TITLE
#     gnuplot -c share/nmbc/plots/fields.gp OUT RUN.pvd TITLE energy
# writes OUT.png, up to six of the snapshots, evenly spaced, and OUT.gif, up to a hundred of them; of
# the energy, and from the field at the end (output.field), OUT.png alone:
#     gnuplot -c share/nmbc/plots/fields.gp OUT RUN_field.vti TITLE
# Colours are logarithmic over three decades of displacement, or six of energy, below the largest of
# those of OUT.png.
if (ARGC != 3 && !(ARGC == 4 && ARG4 eq "energy")) {
    printerr "usage: gnuplot -c fields.gp OUT RUN.pvd|RUN_field.vti TITLE [energy] (writes OUT.png and OUT.gif)"
    exit status 2
}
is_energy = ARGC == 4
if (strstrt(ARG2, "'") > 0) {
    printerr sprintf("fields.gp: no name with an apostrophe: %s", ARG2)
    exit status 2
}
load system(sprintf("dirname '%s'", ARG0)) . "/probes.gp"
folder = system(sprintf("dirname '%s'", ARG2))
is_field = strstrt(ARG2 . "|", "_field.vti|") > 0
run = ARG2[1:strlen(ARG2) - strlen(is_field ? "_field.vti" : ".pvd")]
list = sprintf("sed -n 's/^<DataSet timestep=\"\\([^\"]*\\)\" file=\"\\([^\"]*\\)\".*/%%s/p' '%s' 2>/dev/null", ARG2)
count = is_field ? system(sprintf("test -s '%s' && echo 1 || echo 0", ARG2)) + 0 \
                 : int(system(sprintf(list, "\\2") . " | grep -c . || true"))
if (count < 1) {
    printerr sprintf("fields.gp: no %s of nmbcrun in %s", is_field ? "field" : "snapshots", ARG2)
    exit status 2
}
file_of(i) = is_field ? ARG2 : folder . "/" . system(sprintf(list, "\\2") . sprintf(" | sed -n %dp", i))
# With a point: gnuplot takes 8e-05 for no number.
times = is_field ? sprintf("sed '/<AppendedData/q' '%s' | sed -n 's/.*Name=\"TimeValue\"[^>]*>\\([^<]*\\)<.*/\\1/p'", ARG2) \
                 : sprintf(list, "\\1")
time_of(i) = real(system(times . sprintf(" | awk 'NR == %d { printf \"%%.12e\", $1 }'", i)))

# The header is text; what follows it are arrays, before each their bytes' count, 8 bytes.
marker = "<AppendedData encoding=\"raw\">"
head(file, name) = system(sprintf("sed '/<AppendedData/q' '%s' | grep -ao '%s=\"[^\"]*\"' | cut -d '\"' -f 2", file, name))
quantity = is_energy ? "energy" : "displacement"
offset(file) = int(system(sprintf("sed '/<AppendedData/q' '%s' | sed -n 's/.*Name=\"%s\".* offset=\"\\([0-9]*\\)\".*/\\1/p'", file, quantity)))
skip(file) = int(system(sprintf("grep -abo -m 1 '%s' '%s' | cut -d : -f 1", marker, file))) + strlen(marker) + 2 + 8 + offset(file)
numbers = is_energy ? "%float64" : "%3float64"
size_of = is_energy ? "(column(1))" : "(sqrt(column(1)**2 + column(2)**2))"
first = file_of(1)
extent = head(first, "WholeExtent")
nx = int(word(extent, 2)) + 1
ny = int(word(extent, 4)) + 1
spacing = real(system(sprintf("echo '%s' | awk '{ printf \"%%.12e\", $1 }'", head(first, "Spacing"))))
origin_x = real(system(sprintf("echo '%s' | awk '{ printf \"%%.12e\", $1 }'", head(first, "Origin"))))
origin_y = real(system(sprintf("echo '%s' | awk '{ printf \"%%.12e\", $2 }'", head(first, "Origin"))))
last_x = origin_x + (nx - 1) * spacing
last_y = origin_y + (ny - 1) * spacing
image(file) = sprintf("'%s' binary skip=%d array=(%d,%d) format='%s' dx=%.9g dy=%.9g " . \
                      "origin=(%.9g,%.9g) using (shown%s) with image%s", \
                      file, skip(file), nx, ny, numbers, spacing, spacing, origin_x, origin_y, size_of, probes(run, spacing))

heading = ARG3 . (has_probes(run) ? " (circles: probes)" : "")
panels = count < 6 ? count : 6
chosen(p) = panels == 1 ? 1 : 1 + int((p - 1) * (count - 1.0) / (panels - 1) + 0.5)
largest = 0
do for [p = 1:panels] {
    file = file_of(chosen(p))
    stats file binary skip=skip(file) record=(nx * ny) format=numbers using @size_of nooutput
    largest = STATS_max > largest ? STATS_max : largest
}
largest = largest > 0 ? largest : 1
least = largest / (is_energy ? 1e6 : 1e3)
shown(u) = u > least ? u : least  # 0 has no logarithm

# Dark is still: told apart without colour vision, and printed in grey.
set palette defined (0 "#000004", 0.25 "#51127c", 0.5 "#b73779", 0.75 "#fc8961", 1 "#fcfdbf")
set logscale cb
set cbrange [least:largest]
set xrange [origin_x - spacing / 2:last_x + spacing / 2]
set yrange [origin_y - spacing / 2:last_y + spacing / 2]
set size ratio -1
set tics out nomirror
set format "%g"
set format cb "10^{%T}"
set xtics (origin_x, last_x)
set ytics (origin_y, last_y)
set cblabel (is_energy ? "energy (per volume)" : "|u| (length unit)") offset 1
unset key

# Room for the axes' names and the longest of their numbers, in pixels.
longer(a, b) = a > b ? a : b
tick = 9 * longer(longer(strlen(sprintf("%g", origin_x)), strlen(sprintf("%g", origin_y))), \
                  longer(strlen(sprintf("%g", last_x)), strlen(sprintf("%g", last_y))))
left = tick + 60
right = tick / 2 + 125  # of the colours, too
below = 65
above = 85
between = tick + 30

columns = panels < 3 ? panels : 3
columns = nx > ny ? (panels < 2 ? 1 : 2) : columns
rows = ceil(panels / (1.0 * columns))
side = 420
panel_x = nx > ny ? side : side * nx / (1.0 * ny)
panel_x = panel_x < 150 ? 150 : panel_x
panel_y = nx > ny ? side * ny / (1.0 * nx) : side
panel_y = panel_y < 60 ? 60 : panel_y
width = int(left + columns * (panel_x + between) - between + right)
height = int(above + rows * (panel_y + 70) - 70 + below)
set terminal pngcairo size width, height font "sans,12"
set output ARG1 . ".png"
set multiplot layout rows, columns margins 1.0 * left / width, 1 - 1.0 * right / width, \
    1.0 * below / height, 1 - 1.0 * above / height spacing 1.0 * between / width, 70.0 / height title heading noenhanced
set colorbox user origin 1 - 115.0 / width, 1.0 * below / height size 16.0 / width, \
    1 - 1.0 * (above + below) / height
do for [p = 1:panels] {
    set title sprintf("t = %.4g%s", time_of(chosen(p)), p == 1 ? " (time unit)" : "")
    set ylabel (columns == 1 || p % columns == 1 ? "Y (length unit)" : "")
    set xlabel (p + columns > panels ? "X (length unit)" : "")
    eval "plot " . image(file_of(chosen(p)))
    unset colorbox
}
unset multiplot
set output
if (is_field || is_energy) {
    exit
}

frames = count < 100 ? count : 100
width = int(left + panel_x + right)
height = int(50 + panel_y + below)
set terminal gif animate delay 10 size width, height font "sans,11"
set lmargin at screen 1.0 * left / width
set rmargin at screen 1 - 1.0 * right / width
set bmargin at screen 1.0 * below / height
set tmargin at screen 1 - 50.0 / height
set colorbox user origin 1 - 115.0 / width, 1.0 * below / height size 16.0 / width, 1 - (50.0 + below) / height
set xlabel "X (length unit)"
set ylabel "Y (length unit)"
set output ARG1 . ".gif"
do for [f = 1:frames] {
    i = frames == 1 ? 1 : 1 + int((f - 1) * (count - 1.0) / (frames - 1) + 0.5)
    set title sprintf("%s, t = %.4g (time unit)", heading, time_of(i)) noenhanced
    eval "plot " . image(file_of(i))
}
set output
