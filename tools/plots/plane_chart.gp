# SPDX-License-Identifier: MIT
# What the sides of a plane scene cost and how good they are, of nmbcrun chart's CSV:
#     gnuplot -c share/nmbc/plots/plane_chart.gp results/NAME_chart.csv results/NAME_chart TITLE
# writes OUT.svg and OUT.png: what the sides add to a run against their error. Numbers are widths of
# layers, which thin lines join. Crosses grow in a long run. A dotted line joins what nothing that does
# not grow beats in both respects.
if (ARGC != 3) {
    printerr "usage: gnuplot -c plane_chart.gp CHART.csv OUT TITLE (writes OUT.svg and OUT.png)"
    exit status 2
}
call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "plane_chart.gp" ARG1 "boundary kind error=number run_cost=number long_run" "nmbcrun chart of a plane"
set datafile separator comma
set datafile columnheaders
set datafile missing NaN
least_cost = 1.0
cost(run) = 100 * (run - 1) > least_cost ? 100 * (run - 1) : least_cost
highest = 10.0
lowest = 1e-6
clip(error) = error > highest || error != error ? highest : error < lowest ? lowest : error
kinds = "passive nmbc higdon sponge pml extended free fixed sbp kernel"
array titles[10] = ["passive", "NMBC", "Higdon", "sponge", "PML", "plain lattice", "free", "fixed", \
    "summation by parts", "convex kernels"]
colours = "#000000 #0072b2 #cc79a7 #009e73 #d55e00 #666666 #bbbbbb #bbbbbb #0072b2 #e69f00"
shapes = "7 5 13 9 11 15 8 12 7 5"
has_width(kind) = kind eq "sponge" || kind eq "pml" || kind eq "extended"
label_of(kind, name) = has_width(kind) ? word(name, 2) : kind eq "nmbc" || kind eq "higdon" ? name : ""

set logscale xy
set grid xtics ytics linetype 1 linecolor "#dddddd" linewidth 0.5
set border 3
set tics nomirror
set key outside right top noenhanced samplen 1 Left reverse
set title ARG3 noenhanced
set xlabel "added to a run by the sides [%]"
set ylabel "max |u - u_{ref}| / max |u_{ref}|"
set format y "10^{%T}"
set xtics add (sprintf("≤%g", least_cost) least_cost)
set ytics add ("≥10" highest, "≤10^{-6}" lowest)
set offsets graph 0.02, graph 0.06, graph 0.05, graph 0.05
do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size 900,560 font "sans,15" background "white"
        small = ",11"
    } else {
        set terminal pngcairo size 1800,1120 fontscale 1.9 linewidth 2 font "sans,10"
        small = ",7"
    }
    set output sprintf("%s.%s", ARG2, kind)
    plot ARG1 using (column("on_front") == 1 ? cost(column("run_cost")) : NaN):(clip(column("error"))) \
            smooth unique with lines dashtype 3 linecolor "#000000" title "none better", \
        for [i = 1:words(kinds)] ARG1 using (strcol("kind") eq word(kinds, i) && has_width(word(kinds, i)) ? \
            cost(column("run_cost")) : NaN):(clip(column("error"))) with lines linewidth 0.5 \
            linecolor rgb word(colours, i) notitle, \
        for [i = 1:words(kinds)] ARG1 using (strcol("kind") eq word(kinds, i) && strcol("long_run") ne "grows" ? \
            cost(column("run_cost")) : NaN):(clip(column("error"))) with points pointtype int(word(shapes, i)) \
            linecolor rgb word(colours, i) title titles[i], \
        ARG1 using (strcol("long_run") eq "grows" ? cost(column("run_cost")) : NaN):(clip(column("error"))) \
            with points pointtype 2 pointsize 1.3 linecolor "#aa0000" title "grows", \
        ARG1 using (cost(column("run_cost"))):(clip(column("error"))):(label_of(strcol("kind"), strcol("boundary"))) \
            with labels left offset character 0.7, 0.4 font small noenhanced notitle
}
