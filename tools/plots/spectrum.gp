# SPDX-License-Identifier: MIT
# The spectra of the fields at the end of runs (output.field), displacement above velocity:
#     gnuplot -c share/nmbc/plots/spectrum.gp OUT NAME_field.csv TITLE [CSV TITLE ..]
# writes OUT.svg and OUT.png: the amplitude of the wave of each wave number that fills the chain, as
# spectrum.awk has it.
if (ARGC < 3 || ARGC % 2 == 0) {
    printerr "usage: gnuplot -c spectrum.gp OUT CSV TITLE [CSV TITLE ..] (writes OUT.svg and OUT.png)"
    exit status 2
}
folder = system(sprintf("dirname '%s'", ARG0))
files = (ARGC - 1) / 2
array spectrum[files]
do for [i = 1:files] {
    file = ARGV[2 * i]
    if (strstrt(file, "'") > 0) {
        printerr sprintf("spectrum.gp: no name with an apostrophe: %s", file)
        exit status 2
    }
    spectrum[i] = system("mktemp")
    system(sprintf("awk -f '%s/spectrum.awk' '%s' >'%s'", folder, file, spectrum[i]))
    if (GPVAL_SYSTEM_ERRNO != 0) {
        system(sprintf("rm -f '%s'", spectrum[i]))
        exit status 2
    }
}

set datafile separator comma
set datafile columnheaders
set logscale y
set format y "10^{%T}"
set xrange [0:pi]
set xtics ("0" 0, "π/4" pi / 4, "π/2" pi / 2, "3π/4" 3 * pi / 4, "π" pi)
set border 3
set tics nomirror
set grid xtics ytics linetype 1 linecolor "#cccccc" linewidth 0.5
set key top right noenhanced
# Told apart without colour vision too: Okabe and Ito's palette.
set linetype 1 linecolor "#0072b2" linewidth 1.5
set linetype 2 linecolor "#d55e00" linewidth 1.5
set linetype 3 linecolor "#009e73" linewidth 1.5
set linetype 4 linecolor "#cc79a7" linewidth 1.5

do for [kind in "svg png"] {
    if (kind eq "svg") {
        set terminal svg size 800,700 font "sans,16" background "white"
    } else {
        set terminal pngcairo size 1600,1400 fontscale 2 linewidth 2 font "sans,12"
    }
    set output sprintf("%s.%s", ARG1, kind)
    set multiplot layout 2, 1
    do for [field in "u v"] {
        set xlabel (field eq "v" ? "wave number ξ [1/dX]" : "")
        set ylabel (field eq "u" ? "amplitude of u [length unit]" : "amplitude of v [length / time unit]")
        plot for [i = 1:files] spectrum[i] using "xi":(column(field) > 0 ? column(field) : NaN) \
             with lines linetype i title (field eq "u" ? ARGV[2 * i + 1] : "")
    }
    unset multiplot
    set output
}
do for [i = 1:files] {
    system(sprintf("rm -f '%s'", spectrum[i]))
}
