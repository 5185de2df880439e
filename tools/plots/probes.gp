# SPDX-License-Identifier: MIT
# For the scripts that draw planes: where the probes of a run are. RUN: its FOLDER/NAME.

has_probes(run) = system(sprintf("test -s '%s_probes.csv' && echo yes || true", run)) eq "yes"
circles(run, spacing, width, colour) = sprintf( \
    ", '< sed 1q ''%s_probes.csv'' | grep -o ''ux_[0-9]*_[0-9]*'' | tr _ '' ''' using ($2 * %.12e):($3 * %.12e) " . \
    "with points pointtype 6 pointsize 1.3 linewidth %g linecolor rgb '%s' notitle", run, spacing, spacing, width, colour)
# To go on with behind a plot: white circles with a black rim, nothing where there are none.
probes(run, spacing) = has_probes(run) ? circles(run, spacing, 4, "#000000") . circles(run, spacing, 1.5, "#ffffff") : ""
