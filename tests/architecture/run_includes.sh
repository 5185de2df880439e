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
allow generator/table 'generator/table/|nmbc/table.hpp|boost/'
allow generator/exact 'generator/(table|exact)/|nmbc/table.hpp|boost/'
allow generator/lattice 'generator/(table|exact|lattice)/|boost/'
allow generator/families "generator/(table|exact|lattice|names|families)/|$text"
allow generator/names "generator/(table|exact|names)/|$text"
allow generator/bonds "generator/(table|exact|families|bonds)/|$text"
allow generator/closures 'generator/(table|dense|closures)/|nmbc/(correspondence_model|plane_closure).hpp'
allow generator/dense 'generator/dense/|(unsupported/)?Eigen/'
allow generator/stability 'generator/(table|exact|dense|lattice|stability)/|generator/support/on_all_cores.hpp|boost/|Eigen/Core'
allow generator/enclosures 'generator/(table|exact|lattice|stability|enclosures)/|nmbc/table.hpp|boost/'
allow generator/plane 'generator/(table|exact|dense|lattice|plane)/|Eigen/Core'
allow generator/coupling "generator/(table|exact|dense|plane|coupling)/|nmbc/(boundary|coefficients).hpp|Eigen/(Core|SparseCore|SparseLU)|$text"
allow generator/passive 'generator/(table|exact|dense|families|plane|passive)/|nmbc/(passive|plane_sides).hpp|Eigen/Core'
allow generator/matching "generator/(table|exact|lattice|matching)/|ginac/|$text"
allow generator/emit "generator/(table|exact|lattice|names|emit)/|nlohmann/|$text"
allow generator/support "generator/(table|emit|names|support)/|nlohmann/|CLI/|fcntl.h|unistd.h|sys/(file|stat).h|$text"
allow generator/commands "generator/(table|exact|dense|lattice|bonds|closures|coupling|families|names|stability|enclosures|plane|passive|matching|emit|support|commands)/|generator/pipeline.hpp|Eigen/Core|nlohmann/|$text"
allow generator/cli "generator/(table|exact|bonds|closures|coupling|families|names|emit|commands|support|cli)/|generator/matching/real.hpp|CLI/|$text"
allow generator "generator/|unistd.h|$text"
allow generated/nmbc/tables 'nmbc/table.hpp|nmbc/tables/'
allow runtime/nmbc 'nmbc/[a-z_]+\.hpp|omp.h'

# nmbcrun, from the ground up: each room may also include those it names.
run() { # ROOM OTHER_ROOMS FURTHER
    allow "tools/nmbcrun/$1" "tools/nmbcrun/($1${2:+|$2})/|tools/nmbcrun/errors.hpp|nmbc/|$text${3:+|$3}"
}
run terminal '' 'unistd.h|sys/ioctl.h'
run scene '' 'generator/(table|exact|lattice|names|families)/|nlohmann/|toml\+\+/|hdf5.h'
run stepping '' ''
run ends 'terminal|scene|stepping' 'generator/(families|passive)/|(unsupported/)?Eigen/'
run sources 'scene|ends'
run tables scene 'generator/(table|exact|families|names)/'
run certification 'terminal|scene|ends|sources|tables' 'generator/(table|exact|stability|enclosures)/'
run simulation 'scene|ends|sources|tables|certification' 'unistd.h'
run output 'terminal|scene|simulation' 'generator/(names/(checksum|printable)|support/posix_file).hpp|spawn.h|unistd.h|sys/wait.h'
below='terminal|scene|ends|sources|tables|certification|simulation'
run compare 'terminal|scene|sources|simulation' 'generator/(exact|closures)/|boost/math/'
run prediction "$below|compare" 'generator/stability/|Eigen/Sparse(Core|LU)|unsupported/Eigen/FFT'
run chart "$below|compare|prediction|output" 'generator/(support/|names/printable.hpp)|boost/math/'
run advise "$below|compare|prediction|chart|output" 'generator/(table|exact|stability)/|generator/support/progress_line.hpp|unsupported/Eigen/FFT|boost/math/'
run plane 'terminal|scene|stepping|sources|simulation|output' 'generator/(table|exact|closures|families|names|plane|passive)/|generator/support/(files|posix_file|progress_line).hpp|boost/math/'
run plane_compare 'terminal|scene|stepping|output|chart|plane' 'generator/(support/|names/printable.hpp)'
allow tools/nmbcrun "tools/nmbcrun/|generator/names/(checksum|printable).hpp|generator/support/(command_line_problem|exit_code|number_between|posix_file).hpp|nmbc/|CLI/|unistd.h|$text"
allow tools/bench "generator/|tools/nmbcrun/|CLI/|nmbc/|benchmark/|boost/math/|$text"
allow tools/stability_atlas "tools/|nmbc/|generator/|CLI/|unistd.h|$text"

# The algebra system: in matching alone, and in the pipeline that calls it.
if grep -rlE '(ginac|cln)/|GiNaC::|cln::' generator runtime tools generated --include='*.?pp' |
    grep -vE '^generator/(matching/|pipeline.cpp)'; then
    echo "GiNaC or CLN outside generator/matching"
    failed=1
fi
# What others need is linked, not compiled again.
if grep -rnE '\.\./[^ ]*\.cpp' generator runtime tools --include=CMakeLists.txt; then
    echo "a source of another room is compiled there"
    failed=1
fi
exit "$failed"
