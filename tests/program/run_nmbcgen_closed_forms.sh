#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck disable=SC1091,SC2034,SC2154  # assert.sh defines and reads what is not used here
# nmbcgen closed-forms: what docs/reference/closed-forms.md quotes, in three formats, always the same.
# Usage: run_nmbcgen_closed_forms.sh NMBCGEN
source "$(dirname "${BASH_SOURCE[0]}")/assert.sh"

try closed-forms --order 2
expect_exit 0
expect_no_stderr
expect_stdout_line "  a_1 = 1"
expect_stdout_line "  a_3 = (3n^2 + 3n - 1)/30"
expect_stdout_line "        - G (n + 1)(2n + 1)(3n^2 + 3n - 1)/(120 n^3)"
expect_stdout_line "  a_5 = (3n^4 + 6n^3 - 3n + 1)/840"
expect_stdout_line \
    "        - G (n - 1)(n + 1)(n + 2)(2n - 1)(2n + 1)(2n + 3)/(25200 n^3)"
expect_stdout_line "        - G^2 (n + 1)^2(2n + 1)^2(3n^2 + 3n - 1)^2/(28800 n^6)"
expect "how many horizons prove it" grep -q "horizons n = 1 .. 11" "$scratch/stdout"
expect_stdout_line "  n = 1  G* = 1/4 = 0.25"
expect_stdout_line "         K  = 8"
expect_stdout_line "         (2G - 1) W + 1 = 0"
expect_stdout_line "  n = 2  G* = 1032/1445 = 0.7141868512"
expect_stdout_line "  n = 3  G* = (-282042 + 29079*sqrt(718))/393764 = 1.262545547"
expect_stdout_line "         K  = (392 + 28*sqrt(7))/2187 = 0.2131143286"
# begins TEXT: a line of the output begins so.
begins() { expect "a line '$1 ..'" grep -qF -- "$1" "$scratch/stdout"; }
begins "  n = 4  G* = 1.846147614, a root of 10415587125G^3 + "
begins "         K  = 0.0862430919, a root of 134217728K^3 - "
begins "  n = 5  G* = 2.448081272, a root of 4675993920446167G^4 + "
begins "         K  = 0.04306411653, a root of 19073486328125K^4 - "

for format in text latex json; do
    try closed-forms --order 4 --format "$format"
    expect_exit 0
    cp "$scratch/stdout" "$scratch/first"
    try closed-forms --order 4 --family nopd1d --format "$format"
    expect_same "$scratch/first" "$scratch/stdout"
done
# The JSON says the same in exact numbers: a_3 at n = 2, G = 16/5 is 17/30 - 16/5 * 255/960.
expect "JSON" python3 - "$scratch/stdout" <<'PYTHON'
import json, sys
from fractions import Fraction as F
forms = json.load(open(sys.argv[1]))
assert forms["schema"] == 1 and [a["k"] for a in forms["taylor"]] == [1, 3, 5, 7, 9]
def value(k, n, G):
    parts = forms["taylor"][k // 2]["coefficients"]
    return sum(F(sum(int(c) * n**i for i, c in enumerate(p["num"])), int(p["den"]))
               * (F(G) / n ** forms["pole"]) ** g for g, p in enumerate(parts))
assert value(3, 2, F(16, 5)) == F(17, 30) - F(16, 5) * F(255, 960)
assert value(5, 1, F(1, 2)) == F(1, 1920)  # the atom chain, 2 sin(xi/2)
assert forms["bands"][1]["threshold"]["exact"] == "1032/1445"
PYTHON

try closed-forms --order 1 --format latex
expect_stdout_line "  a_{3} &= \\frac{3n^{2} + 3n - 1}{30}"
expect_stdout_line "  G^*_{3} &= (-282042 + 29079\\sqrt{718})/393764 \\\\"

# refused TEXT ARGUMENT..
refused() {
    local text=$1
    shift
    try closed-forms "$@"
    expect_exit 2
    expect_no_stdout
    expect_stderr "$text"
    expect_stderr_lines 3
}
refused "--order is required"
for order in 0 13 -1 nan inf 1e308 "" 2,,3 01 1.5 9999999999; do
    refused "is not a whole number from 1 to 12" --order "$order"
done
refused "--order is given 2 times, where once is allowed" --order 1 --order 2
refused "is not a family of chains; allowed: nopd1d" --order 1 --family other
refused "is not a format; allowed: text, latex, json" --order 1 --format header
refused "not expected" --order 1 --horizon 2
refused "not expected" --order 1 stray
expect_nothing_written

tried="closed-forms to a full disk"
code=0
"$program" closed-forms --order 1 >/dev/full 2>"$scratch/stderr" || code=$?
expect_exit 5
finish
