# SPDX-License-Identifier: MIT
# Whether a CSV has these columns and a row below them, for the scripts beside it; those marked by
# =number have one in each row, or "nan" or "inf":
#     awk -v script=energy.gp -v columns="time=number total" -v of="nmbcrun run" -f columns.awk FILE
# prints "yes", or says on stderr what is wrong. Lines that are empty or begin with # do not count.
function is_number(text) {
    return tolower(text) ~ /^ *[-+]?(([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?|nan|inf) *$/
}
BEGIN {
    file = ARGV[1]
    count = split(columns, wanted, " ")
    for (i = 1; i <= count; i++) is_numeric[i] = sub(/=number$/, "", wanted[i])
    while (problem == "" && (got = (getline line < file)) > 0) {
        place++
        sub(/\r$/, "", line)
        if (line ~ /^(#.*)?$/) continue
        fields = split(line, entry, ",")
        if (rows++ == 0) {
            for (i = 1; i <= fields; i++) column[entry[i]] = i
            continue
        }
        for (i = 1; i <= count && problem == ""; i++) {
            if (!is_numeric[i] || !(wanted[i] in column)) continue  # indexing it would make it
            value = entry[column[wanted[i]]]
            if (!is_number(value)) {
                gsub(/[^ -~]/, "?", value)
                problem = sprintf("%s:%d: %s is \"%.40s\", which is no number", file, place, wanted[i], value)
            }
        }
    }
    for (i = 1; i <= count; i++) {
        if (!(wanted[i] in column)) lacks = lacks " " wanted[i]
    }
    if (got < 0) problem = "cannot read " file
    else if (lacks != "") problem = file " is no CSV of " of ": it has no column" lacks
    else if (problem == "" && rows < 2) problem = file " has no rows"
    if (problem == "") print "yes"
    else print script ": " problem >"/dev/stderr"
}
