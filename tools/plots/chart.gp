# SPDX-License-Identifier: MIT
# What boundaries cost and how good they are, of nmbcrun chart's CSV:
#     gnuplot -c share/nmbc/plots/chart.gp results/bar1d_chart.csv results/bar1d_chart
# writes OUT.svg and OUT.png. Left: in steps of one cfl, what both ends add to a step against the error
# they make. Numbers are orders of Higdon's conditions and widths of layers, which thin lines join.
# Right: whole runs at every cfl, against a run without ends in fine steps; its labels have the cfl. A
# dotted line joins what nothing steady beats in both respects.
if (ARGC != 2) {
    printerr "usage: gnuplot -c chart.gp CHART.csv OUT (writes OUT.svg and OUT.png)"
    exit status 2
}
call system(sprintf("dirname '%s'", ARG0)) . "/csv.gp" "chart.gp" ARG1 "boundary kind cfl step_cost total_cost" "nmbcrun chart"
set datafile separator comma
set datafile columnheaders

# The conditions there are, in the order of the file, and the cfl of the left panel.
nmbc = ""
kinds = ""
steps = 0
with(list, name) = strstrt(list, "," . name . ",") ? list : (list eq "" ? "," : list) . name . ","
stats ARG1 using (nmbc = strcol("kind") eq "nmbc" ? with(nmbc, strcol("boundary")) : nmbc, \
                  kinds = with(kinds, strcol("kind")), \
                  steps = column("cfl") > steps && column("cfl") < 0.401 ? column("cfl") : steps, 1) nooutput
conditions = nmbc eq "" ? 0 : strlen(nmbc) - strlen(system("echo '" . nmbc . "' | tr -d ,")) - 1
name_of(i) = system(sprintf("echo '%s' | cut -d, -f%d", nmbc, i + 1))
array series[conditions + 1] # the last one is for loops over none, which look at it
series[conditions + 1] = "NMBC1 s1"
do for [i = 1:conditions] { series[i] = name_of(i) }
all_others = "truncated higdon sponge pml extended exact free fixed passive mirror node_mirror snm sbp kernel cut"

# Okabe and Ito's palette; blues for the orders of NMBC.
blue(name) = word("#56b4e9 #0072b2 #00497a #332288", int(name[5:5]))
shape(name) = name[8:8] eq "1" ? 7 : 15
all_colours = "#cc79a7 #e69f00 #009e73 #d55e00 #666666 #000000 #bbbbbb #bbbbbb #117733 " . \
              "#0072b2 #56b4e9 #e69f00 #009e73 #d55e00 #666666"
all_shapes = "6 13 9 5 10 11 8 12 14 7 15 13 9 5 11"
colour_of(kind) = (n = 0, sum [i = 1:words(all_others)] (word(all_others, i) eq kind ? (n = i) : 0), word(all_colours, n))
others = ""
colours = ""
shapes = ""
do for [i = 1:words(all_others)] {
    if (strstrt(kinds, "," . word(all_others, i) . ",")) {
        others = others . " " . word(all_others, i)
        colours = colours . " " . word(all_colours, i)
        shapes = shapes . " " . word(all_shapes, i)
    }
}
highest = 10.0
lowest = 1e-10
clip(error) = error > highest || error != error ? highest : error < lowest ? lowest : error
failed(outcome, error) = outcome ne "steady" || !(error <= highest)
least_cost = 1.0   # per cent
overhead(cost) = 100 * (cost - 1) > least_cost ? 100 * (cost - 1) : least_cost
is_shown(cfl) = abs(cfl - steps) < 1e-9
number(kind, name) = kind eq "sponge" || kind eq "pml" || kind eq "higdon" || \
                     (kind eq "extended" && words(name) == 2) ? word(name, 2) : ""

set logscale xy
set grid xtics ytics linetype 1 linecolor "#dddddd" linewidth 0.5
set border 3
set tics nomirror
set key noenhanced samplen 1 Left reverse

# Labels that would overlap one before them are left out. Distances in decades.
add(x, y, text) = (xs = xs . sprintf(" %.4f", log10(x)), ys = ys . sprintf(" %.4f", log10(y)), captions = captions . text . ";", 1)
do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size 1400,620 font "sans,15" background "white"
        small = ",11"
        set pointsize 0.6
    } else {
        set terminal pngcairo size 2800,1240 fontscale 2 linewidth 2 font "sans,10"
        small = ",7"
        set pointsize 1.6
    }
    set output sprintf("%s.%s", ARG2, kind)
    set multiplot
    do for [panel = 1:2] {
        unset label
        set xrange [*:*]
        set yrange [*:*]
        xs = ""
        ys = ""
        captions = ""
        if (panel == 1) {
            set title sprintf("cost and error of the ends, cfl %g", steps)
            set xlabel "added to a step by both ends [%]"
            error_name = "error of the ends / max |u|"
            set lmargin at screen 0.09
            set rmargin at screen 0.42
            set key off
            stats ARG1 using (is_shown(column("cfl")) ? column("total_cost") / column("steps") : NaN) nooutput
            from = least_cost / 1.5
            to = 2 * overhead(STATS_max)
            bottom = lowest / 3
            set format x "%g"
            set format y "10^{%T}"
            set xtics add (sprintf("≤%g", least_cost) least_cost)
            set ytics add ("≥10" highest, "≤10^{-10}" lowest)
            x(cost) = is_shown(column("cfl")) ? overhead(cost / column("steps")) : NaN
            error = "boundary_error"
            front = "on_step_front"
            is_of_panel(cfl) = is_shown(cfl)
            do for [labelled in "pml extended higdon sponge"] {
                stats ARG1 using (strcol("kind") eq labelled && is_shown(column("cfl")) && column(error) < highest && \
                    number(strcol("kind"), strcol("boundary")) ne "" ? \
                    add(x(column("total_cost")), clip(column(error)), number(strcol("kind"), strcol("boundary"))) : 1) nooutput
            }
            apart_x = 0.2
            apart_y = 0.45
        } else {
            set title "whole runs: ends and time steps"
            set xlabel "cost of the run [steps of the bare interior]"
            error_name = "error / max |u|"
            set lmargin at screen 0.515
            set rmargin at screen 0.815
            set key at screen 0.83, screen 0.93 left top
            set ytics autofreq
            set xtics autofreq
            set format x "10^{%T}"
            set ytics add ("≥10" highest)
            x(cost) = cost
            error = "total_error"
            front = "on_front"
            is_of_panel(cfl) = 1
            stats ARG1 using (column(front) == 1 && column(error) < 0.1 ? add(x(column("total_cost")), clip(column(error)), \
                sprintf("%s, %g", strcol("boundary"), column("cfl"))) : 1) nooutput
            stats ARG1 using (column("total_cost")):(column("total_error")) nooutput
            from = STATS_min_x / 12
            to = 2 * STATS_max_x
            bottom = clip(STATS_min_y) / 3
            apart_x = 9
            apart_y = 0.2
        }
        # The width that gnuplot takes of tic labels in SVG is too large, and its ylabel off the picture.
        set label error_name at graph -0.17, graph 0.5 center rotate
        placed_x = ""
        placed_y = ""
        do for [i = 1:words(xs)] {
            at_x = real(word(xs, i))
            at_y = real(word(ys, i))
            taken = 0
            do for [j = 1:words(placed_x)] {
                near_x = abs(at_x - real(word(placed_x, j))) < apart_x
                near_y = abs(at_y - real(word(placed_y, j))) < apart_y
                if (near_x && near_y) { taken = 1 }
            }
            if (!taken) {
                placed_x = placed_x . sprintf(" %.4f", at_x)
                placed_y = placed_y . sprintf(" %.4f", at_y)
                caption = system(sprintf("echo '%s' | cut -d';' -f%d", captions, i))
                if (panel == 1) {
                    set label caption at 10 ** at_x, 10 ** at_y left offset character 0.6, 0.4 font small noenhanced front
                } else {
                    set label caption at 10 ** at_x, 10 ** at_y right offset character -0.7, -0.3 font small noenhanced front
                }
            }
        }
        # By itself, as a line would end at each point that is not of it.
        set print $front
        print "cost,error"
        set print
        set table $front append separator comma
        plot ARG1 using (x(column("total_cost"))):(clip(column(error))) with table if (column(front) == 1 && is_of_panel(column("cfl")))
        unset table
        set xrange [from:to]
        set yrange [bottom:highest * 3]
        here(name) = strcol("boundary") eq name && !failed(strcol("long_run"), column(error))
        of_kind(name) = strcol("kind") eq name && !failed(strcol("long_run"), column(error))
        plot for [name in "sponge pml extended"] ARG1 \
                 using (panel == 1 && strcol("kind") eq name && words(strcol("boundary")) == 2 ? x(column("total_cost")) : NaN): \
                       (clip(column(error))) \
                 with lines linewidth 0.7 \
                 linecolor rgb colour_of(name) notitle, \
             for [i = 1:conditions] ARG1 using (here(series[i]) ? x(column("total_cost")) : NaN):(clip(column(error))) \
                 with points pointtype shape(series[i]) linecolor rgb blue(series[i]) title series[i], \
             for [i = 1:words(others)] ARG1 \
                 using (of_kind(word(others, i)) ? x(column("total_cost")) : NaN):(clip(column(error))) \
                 with points pointtype int(word(shapes, i)) linecolor rgb word(colours, i) \
                 title word(others, i), \
             ARG1 using (panel == 1 && is_shown(column("cfl")) && strcol("kind") eq "pml" ? \
                         100 * column("layer_share") : NaN):(clip(column(error))) \
                 with points pointtype 4 linecolor rgb colour_of("pml") \
                 title strstrt(kinds, ",pml,") ? "nodes of a pml alone" : "", \
             for [i = 1:conditions] ARG1 \
                 using (strcol("boundary") eq series[i] && !here(series[i]) ? x(column("total_cost")) : NaN): \
                       (clip(column(error))) \
                 with points pointtype 2 linewidth 1.5 linecolor rgb blue(series[i]) notitle, \
             for [i = 1:words(others)] ARG1 \
                 using (strcol("kind") eq word(others, i) && !of_kind(word(others, i)) ? x(column("total_cost")) : NaN): \
                       (clip(column(error))) \
                 with points pointtype 2 linewidth 1.5 linecolor rgb word(colours, i) notitle, \
             keyentry with points pointtype 2 linewidth 1.5 linecolor "#444444" title "grows in a long run", \
             $front using 1:2 smooth unique with lines linecolor "#444444" dashtype 3 title "none better"
    }
    unset multiplot
    set output
}
