#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# The same table in every format: python and csv hold the numbers of the JSON, C computes them, and
# LaTeX compiles where pdflatex is there.
# Usage: run_nmbcgen_formats.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

# prints COMMAND..: it succeeds; what it prints is kept.
prints() {
    tried="$*"
    code=0
    "$@" >"$scratch/stdout" 2>"$scratch/stderr" || code=$?
    expect "success" test "$code" -eq 0
}

requests=(
    "--order 2 --horizon 1 --time-step 1/2"
    "--order 3 --horizon 3 --stride 3"
    "--order 2 --horizon 2 --stride 4 --damping 1/20"
    "--order 3 --horizon 2 --stride 2 --G 3/2"
    "--order 2 --horizon 1 --damping 1/50 --G 0.1 --uncertified"
    "--order 2 --horizon 2 --weights cubic --stride 2"
    "--match 0:3,pi/3:1 --horizon 1 --G 1/2"
    "--match 0:3,3/10:2 --horizon 2 --stride 2 --G 1"
)
declare -A endings=([header]=hpp [json]=json [python]=py [c]=h [csv]=csv [latex]=tex)
for request in "${requests[@]}"; do
    rm -rf out
    for format in "${!endings[@]}"; do
        # shellcheck disable=SC2086  # words are meant
        try $request --format "$format" --out out
        expect_exit 0
        name=$(basename "$(tail -n 1 "$scratch/stdout")" ".${endings[$format]}")
        expect_file "out/$name.${endings[$format]}"
    done
    expect "one file a format, and the header of the lattice" test "$(files_in out)" -eq 7
    for ending in py h tex; do
        expect "the command in the banner" grep -qF "Regenerate: nmbcgen --family nopd1d" \
            "out/$name.$ending"
    done

    # Python and CSV against JSON, exactly; the values at three G for the C program.
    cat >check.py <<'EOF'
import csv, importlib, json, sys
from fractions import Fraction

name = sys.argv[1]
sys.path.insert(0, "out")
module = importlib.import_module(name)
table = json.load(open(f"out/{name}.json"))
lists = ["symbol", "damping", "taylor", "c", "b"]
lattice = table["lattice"]
fixed = table["G"]
assert (module.FIXED_G is None) == (fixed is None)
assert module.TAU == Fraction(lattice["tau"]) and module.TIME_STEP == Fraction(table["time_step"])
assert module.LEAST_NODES == (table["least_nodes"] or 0)  # null: not sought
rows = list(csv.DictReader(open(f"out/{name}.csv")))
assert len(rows) == sum(len((lattice if name in lattice else table)[name]) for name in lists)
for list_name in lists:
    first = 1 if list_name == "taylor" else 0
    own = getattr(module, list_name.upper())
    entries = table[list_name] if list_name in table else lattice[list_name]
    assert len(own) == len(entries)
    for i, entry in enumerate(entries):
        if fixed and list_name in lattice:  # open in JSON, at the fixed G elsewhere
            at_G = sum(int(a) * Fraction(fixed)**k for k, a in enumerate(entry["num"]))
            entry = str(at_G / int(entry["den"][0]))
        row = next(r for r in rows if r["list"] == list_name and r["index"] == str(i + first))
        if fixed:
            assert module.evaluate(own[i]) == Fraction(entry) == Fraction(row["exact"])
            assert float(Fraction(entry)) == float(row["value"])
        else:
            num, den = (tuple(map(int, entry[key])) for key in ("num", "den"))
            assert own[i] == (num, den), (own[i], num, den)
            assert row["numerator"] == " ".join(entry["num"])
            assert row["denominator"] == " ".join(entry["den"])
assert module.MAX_CFL == [
    (s["low"], s["high"] if s["high"] is not None else float("inf"), s["cfl"], s["from"])
    for s in table["max_cfl"] or []]
for wrong in [-1, None if fixed is None else 99]:
    try:
        module.coefficients(wrong)
        raise AssertionError("accepted")
    except ValueError as error:
        assert "FIXED_G" in str(error)
for G in [fixed] if fixed else ["3/10", "17/16", "5/2"]:
    c, b = module.coefficients(G)
    assert c[0] == 1
    values = " ".join(repr(float(value)) for value in c + b)
    cfl = module.largest_cfl(G)
    assert cfl == module.largest_cfl(Fraction(G)) == module.largest_cfl(float(Fraction(G)))
    assert cfl > 0 or not fixed or not (table["windows"] and table["windows"]["modal"])
    print(float(Fraction(G)), cfl, values)
EOF
    prints python3 check.py "$name"
    cp "$scratch/stdout" expected

    # C99 without a warning, by a Horner's rule whose terms are not much larger than the sum.
    open="${name}_c(G, c); ${name}_b(G, b);"
    [[ $request != *--G* ]] || open="memcpy(c, ${name}_c, sizeof c); memcpy(b, ${name}_b, sizeof b);"
    cat >check.c <<EOF
#include "out/$name.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
int main(void) {
    double G, cfl, c[${name}_order + 1], b[${name}_order + 1];
    while (scanf("%lf %lf", &G, &cfl) == 2) {
        $open
        if (${name}_largest_cfl(G) != cfl) return printf("cfl %g %g\n", cfl, ${name}_largest_cfl(G));
        for (int j = 0; j < 2 * (${name}_order + 1); ++j) {
            double expected, found = j <= ${name}_order ? c[j] : b[j - ${name}_order - 1];
            if (scanf("%lf", &expected) != 1) return 2;
            if (fabs(found - expected) > 1e-13 * fabs(expected))
                return printf("G = %g, %d: %.17g, not %.17g\n", G, j, found, expected);
        }
    }
    return 0;
}
EOF
    prints "${CC:-cc}" -std=c99 -pedantic -Wall -Wextra -Werror -Wno-unused-function \
        -Wno-unused-const-variable check.c -o check -lm
    tried="the values by C of $name"
    ./check <expected >"$scratch/stdout" || fail "those of Python"

    if command -v pdflatex >/dev/null; then
        printf '%s\n' '\documentclass{article}\usepackage{amsmath}\begin{document}' \
            "\\input{out/$name.tex}" '\end{document}' >page.tex
        prints pdflatex -interaction=nonstopmode -halt-on-error page.tex
    fi
    for word in begin end; do
        expect "as many lists as there are" test "$(grep -c "^.$word{align\*}" "out/$name.tex")" \
            -eq "$([[ $request == *--damping* ]] && echo 5 || echo 4)"
    done
done
expect "a pole is named by Python" python3 -c "
import sys; sys.path.insert(0, 'out')
from fractions import Fraction
import $name as m
assert m.evaluate(((1,), (2,))) == Fraction(1, 2)
try: m.evaluate(((1,), (-1, 1)), 1)
except ZeroDivisionError: pass
else: raise SystemExit(1)"
rm -rf out

finish
