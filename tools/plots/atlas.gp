# SPDX-License-Identifier: MIT
# The stability atlas of one horizon:
#     gnuplot -c tools/plots/atlas.gp HORIZON results/atlas docs/images/atlas_n1.svg
# reads points.csv and windows.csv of `stability_atlas atlas` in the folder and writes the SVG.
if (ARGC != 3) {
    printerr "usage: gnuplot -c atlas.gp HORIZON FOLDER OUT.svg"
    exit status 2
}
horizon = int(ARG1)
points = ARG2 . "/points.csv"
windows = ARG2 . "/windows.csv"

set datafile separator comma
set datafile columnheaders

# A strip for each condition, NMBC1 on top: predicted outcome as its colour, the measured growth
# as dots in it, and two bars above.
strides = horizon == 1 ? 1 : 2
rows = 4 * strides
row(order, stride) = rows - 1 - ((order - 1) * strides + (stride == 1 ? 0 : 1))
strip = 0.62
level(bar) = bar == 1 ? 0.81 : 0.68  # 1: scalar, 2: modal windows
thickness = 0.09

# Growth rates from 1e-7 to 1e2 c/dX over the height of a strip.
lowest = -7
highest = 2
height(rate) = strip * (log10(rate) - lowest) / (highest - lowest)

stats points using (column("G")) nooutput
top = STATS_max

# Okabe and Ito's palette, lighter; told apart without colour vision by lightness.
contractive = 0x6cc5a5
paired = 0xbfe3f5
slight = 0xf6eb8f
amplified = 0xf0b04c
growing = 0xd9743c
nothing = 0xffffff
colour(failure, grade, supremum) = \
    grade eq "contractive" ? contractive : grade eq "paired" ? paired : \
    failure eq "pole" || failure eq "Jordan block" ? nothing : \
    failure eq "growing boundary mode" || failure eq "resonance" ? growing : \
    supremum < 1.01 ? slight : amplified

set terminal svg size 1000, 115 + 92 * rows font "sans,15" background "white"
set output ARG3
set label sprintf("Horizon n = %d", horizon) font "sans,20" at screen 0.02, screen 1 offset 0, -1.6
set xrange [0:top]
set yrange [-0.05:rows]
set xlabel "stabilisation G [1]"
set xtics 0.5 out nomirror
set mxtics 5
set border 1
unset ytics
set lmargin 13
set rmargin 9
set tmargin 5.5
do for [order = 1:4] {
    do for [s = 1:strides] {
        stride = s == 1 ? 1 : horizon
        set label sprintf("NMBC%d%s", order, stride == 1 ? "" : sprintf("\nstride %d", stride)) \
            at graph -0.015, first row(order, stride) + strip / 2 + (stride == 1 ? 0 : 0.1) right
        do for [power in "-6 -3 0"] {
            set label sprintf("10^{%s}", power) font "sans,11" \
                at graph 1.01, first row(order, stride) + height(10.0 ** power)
        }
    }
}
set label "growth rate\n[c/dX]" font "sans,11" at graph 1.01, first rows + 0.15
set key at screen 0.99, screen 0.99 right top horizontal maxrows 3 maxcols 3 samplen 1.2 width -1 Left reverse

# A bar over a strip, from x to the end of the window or of the picture; NaN: none.
end(high) = valid(high) && column(high) < top ? column(high) : top
shown(kind) = column("horizon") == horizon && strcol("kind") eq kind && column("low") < top

plot \
    points using (column("G")):(column("horizon") == horizon ? \
        row(column("order"), column("stride")) + strip / 2 : NaN):(column("from")):(column("to")): \
        (row(column("order"), column("stride"))):(row(column("order"), column("stride")) + strip): \
        (colour(strcol("failure"), strcol("grade"), column("supremum"))) \
        with boxxyerror fillstyle solid noborder linecolor rgb variable notitle, \
    points using (column("horizon") == horizon && column("measured_growth") > 0 ? column("G") : NaN): \
        (row(column("order"), column("stride")) + height(column("measured_growth"))) \
        with points pointtype 7 pointsize 0.3 linecolor rgb "black" title "measured growth", \
    for [bar = 1:2] windows using (column("low")): \
        (shown(word("scalar modal", bar)) ? row(column("order"), column("stride")) + level(bar) : NaN): \
        (column("low")):(end(6)): \
        (row(column("order"), column("stride")) + level(bar)): \
        (row(column("order"), column("stride")) + level(bar) + thickness) \
        with boxxyerror fillstyle solid noborder linecolor rgb word("#888888 #006040", bar) \
        title bar == 1 ? "paper's scalar windows" : "modal windows", \
    NaN with boxes fillstyle solid noborder linecolor rgb contractive title "stable, contractive", \
    NaN with boxes fillstyle solid noborder linecolor rgb paired title "stable, paired", \
    NaN with boxes fillstyle solid noborder linecolor rgb slight title "amplified by up to 1 %", \
    NaN with boxes fillstyle solid noborder linecolor rgb amplified title "amplified", \
    NaN with boxes fillstyle solid noborder linecolor rgb growing title "growing mode, resonance"
