# SPDX-License-Identifier: MIT
# Called by the scripts beside it: ends gnuplot where a CSV is none of the program that writes it.
#     call folder . "/csv.gp" SCRIPT FILE COLUMNS PROGRAM
if (strstrt(ARG2, "'") > 0) {
    printerr sprintf("%s: no name with an apostrophe: %s", ARG1, ARG2)
    exit status 2
}
if (system(sprintf("awk -v script='%s' -v columns='%s' -v of='%s' -f '%s/columns.awk' '%s' || true", \
                   ARG1, ARG3, ARG4, system(sprintf("dirname '%s'", ARG0)), ARG2)) ne "yes") {
    exit status 2
}
