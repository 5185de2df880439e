#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Who may include whom: a room that includes what it must not know about fails.
# Usage: run_includes.sh SOURCE_FOLDER
set -euo pipefail
cd "$1"
failed=0

# allow FOLDER PATTERN: every #include of the folder's own files must match the pattern. Standard
# headers (no slash, no dot) are always allowed.
allow() {
    local folder=$1 pattern=$2 wrong
    test -n "$(find "$folder" -maxdepth 1 -name '*.?pp')" || { echo "no files in $folder"; exit 1; }
    wrong=$(grep -nE '^ *# *include' "$folder"/*.?pp | grep -vE '<[a-z_]+>' |
        grep -vE "[<\"]($pattern)" || true)
    if [ -n "$wrong" ]; then
        printf '%s may not include:\n%s\n' "$folder" "$wrong"
        failed=1
    fi
}

text='fmt/'
allow generator/table 'generator/table/|boost/'
allow generator/exact 'generator/(table|exact)/|boost/'
allow generator/families "generator/(table|exact|families)/|$text"
allow generator/matching "generator/(table|exact|matching)/|ginac/|$text"
allow generator/stability 'generator/(table|exact|stability)/|Eigen/'
allow generator/emit "generator/(table|exact|emit)/|nlohmann/|$text"
allow generator "generator/|CLI/|fcntl.h|unistd.h|$text"
allow generated/nmbc/tables 'nmbc/table.hpp|nmbc/tables/'
allow runtime/nmbc 'nmbc/[a-z_]+\.hpp'
allow tools/nmbcrun "tools/nmbcrun/|tools/number_between.hpp|nmbc/|CLI/|$text"
allow tools/nmbcrun/scene "tools/nmbcrun/(scene/|errors.hpp)|nmbc/|generator/((table|exact)/|emit/emit.hpp|families/influence.hpp)|nlohmann/|toml\+\+/|$text"
allow tools/nmbcrun/simulation "tools/nmbcrun/(scene|simulation|ends)/|tools/nmbcrun/errors.hpp|nmbc/|generator/((table|exact|stability)/|emit/emit.hpp|families/family.hpp)|unistd.h|$text"
allow tools/nmbcrun/compare "tools/nmbcrun/(compare|scene|simulation)/|nmbc/|generator/(table|exact|stability)/|$text"
allow tools/nmbcrun/advise "tools/nmbcrun/(advise|chart|compare|scene|simulation)/|tools/nmbcrun/errors.hpp|nmbc/|generator/(table|exact|stability)/|unsupported/Eigen/FFT|$text"
allow tools/nmbcrun/chart "tools/nmbcrun/(chart|compare|output|scene|simulation)/|tools/nmbcrun/errors.hpp|nmbc/|$text"
allow tools/nmbcrun/ends "tools/nmbcrun/ends/|nmbc/|(unsupported/)?Eigen/|$text"
allow tools/nmbcrun/output "tools/nmbcrun/((output|simulation|scene)/|errors.hpp)|nmbc/|hdf5.h|fcntl.h|unistd.h|sys/(file|ioctl).h|$text"
allow tools/pulses "tools/pulses/|tools/number_between.hpp|nmbc/|CLI/|$text"
allow tools/bench "generator/|CLI/|nmbc/|benchmark/"
allow tools/stability_atlas "tools/|nmbc/|generator/|CLI/|$text"

# The algebra system: in matching alone, and in the pipeline that calls it.
if grep -rlE '(ginac|cln)/|GiNaC::|cln::' generator runtime tools generated --include='*.?pp' |
    grep -vE '^generator/(matching/|pipeline.cpp)'; then
    echo "GiNaC or CLN outside generator/matching"
    failed=1
fi
exit "$failed"
