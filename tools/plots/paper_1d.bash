# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What the figures of tools/scripts/paper-1d are made of; it sets root, nmbcrun, out, data and pictures.

die() { # CODE MESSAGE
    echo "paper-1d: $2" >&2
    exit "$1"
}

# ---- runs ----

# simulate NAME SCENE [KEY=VALUE..]: leaves data/NAME.csv. Returns 0, or nmbcrun's 3 or 4 with its
# words in $errors; ends with any other code.
simulate() {
    local settings=() setting code=0
    for setting in "output.name=$1" "${@:3}"; do
        settings+=(--set "$setting")
    done
    errors=$("$nmbcrun" run "$root/tools/scenes/$2.toml" --quiet --out "$data" "${settings[@]}" \
        2>&1 >/dev/null) || code=$?
    case $code in
        0 | 3 | 4) return $code ;;
    esac
    die $code "$nmbcrun failed with exit code $code: ${errors:-no message}"
}

# must_simulate ..: as simulate, but ends with 3 and 4, too.
must_simulate() {
    local code=0
    simulate "$@" || code=$?
    if [ $code -ne 0 ]; then
        die $code "$nmbcrun failed with exit code $code: $errors"
    fi
}

# ratios NAME [REFERENCE]: rows time and energy over the peak of REFERENCE (without it, its own).
ratios() {
    awk -F, 'FNR == 1 { file++; for (i = 1; i <= NF; i++) if ($i == "total") total = i; next }
        file == 1 { if ($total > peak) peak = $total; next }
        { print $1, $total / peak; if ($total > 100 * peak) exit }' "$data/${2-$1}.csv" "$data/$1.csv"
}

# left NAME FORMAT [REFERENCE]: energy left over the peak, or that it has grown to more than ten peaks.
left() {
    ratios "$1" "${3-$1}" | awk -v format="$2" '
        $2 > 10 { grown = 1 }
        { last = $2 }
        END { print grown ? "> 10" : sprintf(format, last) }'
}

# ---- curves: a file for each panel, for tools/plots/panels.gp ----

panel() { # FILE TITLE
    echo "# $2" >"$data/$1.dat"
}
curve() { # FILE NAME: appends the rows of stdin
    printf '"%s"\n%s\n\n\n' "$2" "$(cat)" >>"$data/$1.dat"
}
# plot SCRIPT ARGUMENT..: in the folder of the results, so that its name does not matter to gnuplot.
plot() {
    if [ "$pictures" = yes ]; then
        (cd "$out" && gnuplot -c "$root/tools/plots/$1" "${@:2}") ||
            die 5 "gnuplot could not draw in $out"
    fi
}
draw() { # KIND FIGURE PANEL..: of data/PANEL.dat
    local files=("${@:3}")
    files=("${files[@]/#/data/}")
    plot panels.gp "$1" "$2" "${files[@]/%/.dat}"
}

# ---- spectra ----

# power NAME: rows xi and the power of u at xi and at -xi each, over the largest. The wave is far from
# the ends, so no window is needed.
power() {
    awk -v plain=1 -f "$root/tools/plots/spectrum.awk" "$data/$1_field.csv" |
        awk -F, 'NR > 1 { rows++; xi[rows] = $1; power[rows] = $2 ^ 2 / 4 }
            END {
                power[1] *= 4; power[rows] *= 4
                for (i = 1; i <= rows; i++) if (power[i] > largest) largest = power[i]
                for (i = 1; i <= rows; i++) print xi[i], power[i] / largest
            }'
}

# envelope: the rows of power, each with the largest within 0.05/dX: curves that can be told apart.
envelope() {
    awk '{ xi[NR] = $1; power[NR] = $2 }
        END {
            for (i = 1; i <= NR; i++) {
                largest = 0
                for (j = 1; j <= NR; j++)
                    if ((xi[j] - xi[i]) ^ 2 <= 0.0025 && power[j] > largest) largest = power[j]
                print xi[i], largest
            }
        }'
}

# peaks: of the rows of power, those at xi >= 0.5/dX that are the largest within 0.3/dX on both sides,
# 1e-6 or more.
peaks() {
    awk '{ xi[NR] = $1; power[NR] = $2 }
        END {
            for (i = 1; i <= NR; i++) {
                if (xi[i] < 0.5 || power[i] < 1e-6) continue
                highest = 1
                for (j = 1; j <= NR; j++)
                    if ((xi[j] - xi[i]) ^ 2 < 0.09 && power[j] > power[i]) highest = 0
                if (highest) printf "%.3f %.1e\n", xi[i], power[i]
            }
        }'
}

# zero_modes HORIZON: where (26) is 0 beyond xi = 0.
zero_modes() {
    awk -v n="$1" 'function s(xi, m, sum) {
            for (m = 1; m <= n; m++) sum += m * sin(m * xi)
            return sum
        }
        BEGIN {
            pi = atan2(0, -1)
            for (i = 1; i < 9999; i++)
                if (s(i * pi / 10000) * s((i + 1) * pi / 10000) <= 0)
                    printf "%.3f\n", (i + 0.5) * pi / 10000
            printf "%.3f\n", pi
        }'
}

listed() { paste -s -d ' ' | sed 's/ /, /g'; }

# ---- tables ----

# table: rows on stdin, the first of them the headings, as a table in Markdown.
table() {
    awk -F '|' '{
            columns = NF
            for (i = 1; i <= NF; i++) {
                cell[NR, i] = $i
                if (length($i) > width[i]) width[i] = length($i)
            }
        }
        END {
            for (row = 1; row <= NR; row++) {
                line = rule = "|"
                for (i = 1; i <= columns; i++) {
                    line = line sprintf(" %" (i == 1 ? "-" : "") width[i] "s |", cell[row, i])
                    dashes = sprintf("%" width[i] "s", "")
                    gsub(/ /, "-", dashes)
                    rule = rule (i == 1 ? ":" dashes "-|" : "-" dashes ":|")
                }
                print line
                if (row == 1) print rule
            }
        }'
}
