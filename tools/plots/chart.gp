# SPDX-License-Identifier: MIT
# What boundaries cost and how good they are, of nmbcrun chart's CSV:
#     gnuplot -c tools/plots/chart.gp results/bar1d_chart.csv results/bar1d_chart
# writes OUT.svg and OUT.png. Left: at cfl 0.4, what both ends add to a step against the error they
# make; numbers are orders, with the stride of an nmbc, and widths of layers; open squares are what a
# pml would cost if its nodes were no dearer than others. Right: whole runs at every cfl, against a
# run without ends in fine steps. A line joins those that no other one beats in both respects;
# crosses fail in a long run. What is off the scale is at its edge.
if (ARGC != 2) {
    printerr "usage: gnuplot -c chart.gp CHART.csv OUT (writes OUT.svg and OUT.png)"
    exit status 2
}
set datafile separator comma
set datafile columnheaders
set datafile missing "none"

kinds = "nmbc mbc higdon sponge pml exact extended fixed free"
colours = "#0072b2 #56b4e9 #e69f00 #009e73 #d55e00 #000000 #888888 #bbbbbb #bbbbbb"
shapes = "7 6 13 9 5 11 10 12 8"
highest = 10.0
lowest = 1e-10
clip(error) = error > highest || error != error ? highest : error < lowest ? lowest : error
failed(fate, error) = fate ne "steady" || !(error <= highest)
least_cost = 0.1   # per cent: below it, a step with ends takes no longer than one without
overhead(cost) = 100 * (cost - 1) > least_cost ? 100 * (cost - 1) : least_cost
# "NMBC2 s1" is 2, "NMBC2 s4" 2 s4, "pml 20" 20; those of which there is one need no number.
# "higdon 1" is NMBC1.
label(kind, name) = kind eq "nmbc" ? (name[7:] eq "s1" ? name[5:5] : name[5:]) : \
                    kind eq "sponge" || kind eq "pml" || (kind eq "higdon" && name ne "higdon 1") ? \
                    word(name, 2) : ""

set logscale xy
set format "10^{%T}"
set grid xtics ytics linetype 1 linecolor "#dddddd" linewidth 0.5
set border 3
set tics nomirror
set key outside right top noenhanced samplen 1

do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size 1200,560 font "sans,15" background "white"
        small = ",11"
        set pointsize 0.6
    } else {
        set terminal pngcairo size 2400,1120 fontscale 2 linewidth 2 font "sans,10"
        small = ",7"
        set pointsize 0.9
    }
    set output sprintf("%s.%s", ARG2, kind)
    set multiplot layout 1, 2
    do for [panel = 1:2] {
        if (panel == 1) {
            set title "cost and error of the ends, cfl 0.4"
            set xlabel "added to a step by both ends [%]"
            set ylabel "error of the ends / max |u|"
            set key off
            set yrange [lowest / 3:highest * 3]
            set format x "%g"
            x(steps, total, cfl) = abs(cfl - 0.4) < 1e-9 ? overhead(total / steps) : NaN
            error_column = "boundary_error"
            front_column = "on_step_front"
        } else {
            set title "whole runs: ends and time steps"
            set xlabel "cost of the run [steps of the bare interior]"
            set ylabel "error / max |u|"
            set key on
            set yrange [*:highest * 3]
            set format x "10^{%T}"
            x(steps, total, cfl) = total
            error_column = "total_error"
            front_column = "on_front"
        }
        set xrange [*:*]
        # By itself, as a line would end at each point that is not of it.
        set print $front
        print "cost,error"
        set print
        set table $front append separator comma
        plot ARG1 using (x(column("steps"), column("total_cost"), column("cfl"))): \
                        (clip(column(error_column))) with table \
                  if (column(front_column) == 1 && (panel == 2 || abs(column("cfl") - 0.4) < 1e-9))
        unset table
        plot for [i = 1:words(kinds)] ARG1 \
                 using (strcol("kind") eq word(kinds, i) && \
                        !failed(strcol("fate"), column(error_column)) ? \
                        x(column("steps"), column("total_cost"), column("cfl")) : NaN): \
                       (clip(column(error_column))) \
                 with points pointtype int(word(shapes, i)) linecolor rgb word(colours, i) \
                 title word(kinds, i), \
             for [i = 1:words(kinds)] ARG1 \
                 using (strcol("kind") eq word(kinds, i) && \
                        failed(strcol("fate"), column(error_column)) ? \
                        x(column("steps"), column("total_cost"), column("cfl")) : NaN): \
                       (clip(column(error_column))) \
                 with points pointtype 2 pointsize 0.9 linewidth 1.5 linecolor rgb word(colours, i) notitle, \
             ARG1 using (panel == 1 && abs(column("cfl") - 0.4) < 1e-9 && strcol("kind") eq "pml" ? \
                         100 * column("layer_share") : NaN):(clip(column(error_column))) \
                 with points pointtype 4 pointsize 0.5 linecolor rgb word(colours, 5) notitle, \
             ARG1 using (panel == 1 && column(error_column) < highest ? \
                         x(column("steps"), column("total_cost"), column("cfl")) : NaN): \
                       (clip(column(error_column))):(label(strcol("kind"), strcol("boundary"))) \
                 with labels left offset character 0.7, 0.35 font small noenhanced notitle, \
             $front using 1:2 \
                 smooth unique with lines linecolor "#444444" dashtype 3 \
                 title (panel == 2 ? "none better" : "")
    }
    unset multiplot
    set output
}
