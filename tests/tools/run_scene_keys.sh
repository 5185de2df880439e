#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Every mistake of a scene or an override.
# Usage: run_scene_keys.sh NMBCRUN SOURCE_FOLDER (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/bar.bash"

lacks() { ! LC_ALL=C grep -q "$1" "$2"; }
setting() { refuses "$1" "$2" "$scene" --set "$3"; }
setting 2 "model.horizn is not a key of a scene; the nearest one is model.horizon" model.horizn=2
setting 2 "must be a whole number from 1 to 100, not 0" model.horizon=0
setting 2 "must be a whole number from 1 to 100, not 1.5" model.horizon=1.5
setting 2 "must be a whole number from 1 to 100, written without a point and an exponent" model.horizon=1e2
setting 2 "must be a whole number from 1 to 100, not 'abc'" model.horizon=abc
setting 2 "no table for family nopd1d, horizon 7" model.horizon=7
setting 2 "must be a table" model=3
setting 2 'there is no family "nopd9"' model.family=nopd9
for bad in -1 nan inf true; do
    setting 2 "model.G must be a number not below 0" "model.G=$bad"
done
for bad in 1e400 '"-1"' '"1/0"' '"x"' '""'; do
    setting 2 "model.G must be an exact number not below 0" "model.G=$bad"
done
for bad in -1 nan 1e-30 '"1/0"' '"x"'; do
    setting 2 "model.damping must be an exact number not below 0" "model.damping=$bad"
done
setting 2 "model.damping must be a number, or one as a string" model.damping=true
for tau in 7/3 '"14/6"'; do
    setting 2 "order 1, stride 1, damping tau = 7/3. " "model.damping=$tau"
done
setting 2 "damping tau = 3/10. " model.damping=0.3
setting 2 "damping tau = 2. " model.damping=2
setting 2 "must be \"midpoint\" or \"explicit\", not \"implicit\"" boundary.ghosts=implicit
setting 2 'boundary.left.kind must be "nmbc", "fixed", "free"' boundary.left.kind=open
setting 2 "boundary.allow_unstable must be true or false, not 1" boundary.allow_unstable=1
setting 2 "--set boundary.rigth.kind: boundary.rigth is not a key of a scene" boundary.rigth.kind=free
setting 2 "--set bogus.key: bogus is not a key of a scene" bogus.key=1
setting 2 "no table for family nopd1d, horizon 2, order 9" boundary.right.order=9
setting 4 "these ends are certified in steps of 0.29495 (cfl = 0.61), and none above cfl = 1 is stable" time.step=0.6
setting 2 "drive.centre and drive.half_width select no node: the nodes are at X = 1 to 500" drive.centre=-99
refuses 2 "a run of 250000 steps is too long for an \"exact\" end, which is made for 200000 at most" \
    "$scene" --set boundary.kind=exact --set time.end=5000
refuses 4 "NMBC2 is not stable at n = 2, G = 1, cfl = 0.0668: a mode at that end grows as exp(" \
    "$scene" --set boundary.left.kind=exact --set boundary.right.order=2 --set model.G=1
refuses 4 "NMBC1 is certified against a pml end at no time step at n = 2, G = 1; the step has cfl = 0.0668" \
    "$scene" --set boundary.left.kind=pml --set boundary.left.layer=10 --set model.G=1
setting 2 "must not be 0" drive.amplitude=0
setting 2 "drive.amplitude must be of size 1e-100 at least, not -1e-165: energies are of its square" drive.amplitude=-1e-165
setting 2 "whole number from 1 to 100000000, not 0" domain.nodes=0
setting 2 "from 1 to 100000000, written without a point and an exponent: 100000000" domain.nodes=1e8
setting 2 "domain.nodes must be a whole number from 1 to 100000000, not 1000000000" domain.nodes=1e9
setting 2 "domain.spacing must be a positive number of size 1e+100 at most, not 1e+308" domain.spacing=1e308
sed '/^density /d' "$scene" >"$scratch/of_no_density.toml"
refuses 2 "material.density is missing: both are given, or neither, which makes them 1" "$scratch/of_no_density.toml"
for extreme in material.density=1e-320 material.youngs_modulus=1e-310; do
    setting 2 "makes the wave speed sqrt(youngs_modulus / density)" "$extreme"
done
setting 2 "is too long for time steps of" time.step=1e-320
setting 2 "whole number from 1 to 100000000, not 100000001" domain.nodes=100000001
refuses 2 "boundary.layer must be a whole number from 1 to 10000000, not 100000000" \
    "$scene" --set boundary.kind=sponge --set boundary.layer=100000000
# What a scene has in it does not command the terminal.
setting 2 'must be "midpoint" or "explicit", not "\x1b[2J\u009b31m"' 'boundary.ghosts="\u001b[2J\u009b31m"'
setting 2 'boundary.\x1b]0;title is not a key of a scene' $'boundary.\e]0;title=1'
expect "no control character" lacks $'[\x01-\x09\x0b-\x1f\x7f]' "$scratch/stderr"
refuses 5 "cannot read /dev/zero: it is not a regular file" "$scene" --set force.history=csv \
    --set force.centre=250 --set force.file=/dev/zero
setting 2 "steps; at most 1e15" time.step=1e-300
for bad in a/b .. ../a a..b .a '"a\nb"' '"\u001b[2J"' '""' "\"it's\"" 'a<b'; do
    setting 2 "output.name must be a file name" "output.name=$bad"
done
setting 2 "output.field must be true or false, not 1" output.field=1
for bad in 0 -1 1.5 true '"2"' nan; do
    setting 2 "output.snapshots must be a whole number from 1 to 100000000" "output.snapshots=$bad"
done
for bad in 0 -1 nan inf true '"2"' '[1]'; do
    setting 2 "output.checkpoint must be a positive number" "output.checkpoint=$bad"
done
setting 2 "output.probes must be a list of numbers, [1, 2.5], not 3" output.probes=3
setting 2 "output.probes must be a list of numbers, each a number; one of them is" 'output.probes=[1, "a"]'
setting 2 "each a number of size 1e+100 at most; one of them is 1e+301" 'output.probes=[1e301]'
for bad in nan inf '[1]' true; do
    setting 2 "output.probes must be a list of numbers, each a number; one of them is" "output.probes=[$bad]"
done
for bad in 0.4 500.6 -3 1e+100; do
    setting 2 "output.probes has $bad, but the nodes are at 1 to 500" "output.probes=[$bad]"
done
setting 2 "output.probes has node 7 twice" 'output.probes=[7, 250, 7.3]'
# Of two that do not fit, the one that an override has set is named.
sed 's/^\[output\]/&\nprobes = [250]/' "$scene" >"$scratch/probed.toml"
refuses 2 "--set domain.nodes: output.probes has 250, but the nodes are at 1 to 3" "$scratch/probed.toml" --set domain.nodes=3
refuses 2 "--set domain.nodes: initial.centre puts it outside of the bar, whose nodes are at 1 to 3" \
    "$2/tools/scenes/broadband.toml" --set domain.nodes=3
setting 2 "bar1d.toml:10: material, with --set material.density, makes the wave speed" material.density=1e-320
# A table that an override gives as a whole.
refuses 2 "--set initial: initial.amplitude is missing" "$sourceless" --set 'initial={shape="gaussian"}'
refuses 2 "--set initial: initial.width must be a positive number, not 'a'" "$sourceless" \
    --set 'initial={shape="gaussian", amplitude=1, width="a"}'
setting 2 "--set needs KEY=VALUE, not 'time.step'" time.step
setting 2 "left is not a key of a scene; the nearest one is boundary.left" left.kind=fixed
setting 2 "--set needs KEY=VALUE" =3
# What there is instead of a table that there is not.
setting 2 "in which there are the horizons 1, 2, 3, 4, 5 of this family" model.horizon=7
expect "no other families" lacks nopd2d "$scratch/stderr"
setting 2 "of this family and horizon there are nopd1d_n2_order1, nopd1d_n2_order2," boundary.order=9
expect "tables of another horizon are not listed" test "$(grep -c nopd1d_n1 "$scratch/stderr")" -eq 0
# The chain of atoms has one horizon and no G.
atoms=$2/tools/scenes/fig6_md.toml
refuses 2 "the lattice of family chain1d has no stabilisation: model.G must be absent or 0, not 0.5" \
    "$atoms" --set model.G='"1/2"'
refuses 2 "there is no such model: the chain of atoms has bonds to next neighbours only: horizon 1" \
    "$atoms" --set model.horizon=2
setting 2 'there is no family "nopd7d": model.family is "nopd1d", "bond1d", "chain1d", a wave of a plane' model.family=nopd7d
refuses 2 "the lattice of family bond1d has no stabilisation: model.G must be absent or 0, not 0.5" "$scene" \
    --set model.family=bond1d --set model.G=0.5
for same in model.G=0 model.horizon=1; do
    try run "$atoms" "${short[@]}" --set "$same" --out "$scratch/atoms"
    expect_exit 0
done

# G: no default, exact, and refused where an exact one is a pole, however it is written.
sed '/^G /d' "$scene" >"$scratch/unstabilised.toml"
refuses 2 'model.G is missing: 0 is standard NOPD, whose zero-energy modes no end absorbs; "32/15" makes' \
    "$scratch/unstabilised.toml"
refuses 2 'model.G is missing; is model.g meant for it?' "$scratch/unstabilised.toml" --set model.g=1
for G in '"128/85"' 1.5058823529411764; do
    refuses 3 "has a pole of a coefficient at G = 1.5058823529411764" "$scene" --set boundary.order=2 \
        --set model.G="$G" --set boundary.allow_unstable=true
    expect "what is certified in a line of its own" \
        grep -q '^Certified at this G: order 1, stride 1 up to cfl = 0.75; order 1, stride 2 up to' "$scratch/stderr"
done

# Sources: none, unfinished ones, keys that say nothing.
refuses 2 "sourceless.toml: nothing starts or drives the scene: it needs at least one of the tables drive, initial," "$sourceless"
# source_of CODE TEXT KEY=VALUE..: the scene with these alone.
source_of() {
    local code=$1 text=$2 settings=()
    shift 2
    for setting; do settings+=(--set "$setting"); done
    refuses "$code" "$text" "$sourceless" "${settings[@]}"
}
source_of 2 "sourceless.toml: initial.shape is missing" initial.width=3
source_of 2 'initial.shape must be "gaussian", "ricker", "packet" or "csv", not "box"' initial.shape=box
source_of 2 "initial.amplitude is missing" initial.shape=gaussian
source_of 2 "initial.amplitude must not be 0" initial.shape=gaussian initial.amplitude=0
pulse=(initial.shape=gaussian initial.amplitude=1 initial.width=3 initial.centre=9)
source_of 2 "initial.width must be a positive number, not 0" "${pulse[@]}" initial.width=0
source_of 2 "initial.wave_number has no meaning for this shape" "${pulse[@]}" initial.wave_number=1
source_of 2 "initial.wave_number must be a number from 0 to pi, not 4" "${pulse[@]}" initial.shape=packet initial.wave_number=4
source_of 2 "initial.wave_number is missing" "${pulse[@]}" initial.shape=packet
source_of 2 'initial.direction must be "both", "right" or "left", not "up"' "${pulse[@]}" initial.direction=up
source_of 2 'initial.direction must be "both" of a velocity' "${pulse[@]}" initial.of=velocity initial.direction=left
source_of 2 "initial.file has no meaning for this shape" "${pulse[@]}" initial.file=a.csv
source_of 2 "initial.widht is not a key of a scene; the nearest one is initial.width" "${pulse[@]}" initial.widht=2
source_of 2 "must be from a tenth to 1e6 of domain.spacing, not 0.01 of it" "${pulse[@]}" initial.direction=right initial.width=0.01
source_of 2 "initial.width is missing; is initial.widht meant for it?" "${pulse[@]:0:2}" initial.widht=2
setting 2 "boundary.lefft is not a key of a scene; the nearest one is boundary.left" boundary.lefft.kind=fixed
source_of 2 "initial must be a table" initial=3
source_of 2 "initial.file is missing" initial.shape=csv
source_of 2 "initial.centre has no meaning for a csv" initial.shape=csv initial.file=a.csv initial.centre=3
source_of 5 "$scratch/nowhere.csv: No such file" initial.shape=csv initial.file=nowhere.csv
source_of 5 "Is a directory" initial.shape=csv initial.file=.
# A byte order mark is skipped; entries that no column is of are not.
printf '\xef\xbb\xbftime,force\r\n0,0\r\n1,2\r\n' >"$scratch/marked.csv"
csv=(force.history=csv force.centre=250)
try run "$sourceless" "${short[@]}" --set force.history=csv --set force.file=marked.csv \
    --set force.centre=250 --set force.half_width=99
expect_exit 0
expect_no_stderr
rm -r results
printf 'time,force\n0,0\n1,2,3\n' >"$scratch/longer.csv"
source_of 2 "longer.csv:3: the row has 3 entries, the header 2" "${csv[@]}" force.file=longer.csv
source_of 2 "force.history is missing" force.centre=9
source_of 2 "force.centre is missing" force.history=sine
force=(force.centre=9 force.amplitude=1)
source_of 2 "force.duration is missing" "${force[@]}" force.history=gaussian
source_of 2 "force.frequency is missing" "${force[@]}" force.history=sine
source_of 2 "force.duration has no meaning for a sine, which has a frequency and cycles" "${force[@]}" force.history=sine force.duration=1
# A key of another history is not taken for a misspelt one, and what is meant by it is said.
source_of 2 "sourceless.toml: force.file is missing" "${force[@]}" force.history=csv force.time=3
expect "no hint" lacks "meant for it" "$scratch/stderr"
source_of 2 "force.frequency has no meaning for a ricker: force.duration = 3.183, 1/(pi frequency), makes its spectrum largest there" \
    "${force[@]}" force.history=ricker force.frequency=0.1
source_of 2 "force.frequency has no meaning for a gaussian, exp(-((t - time)/duration)^2): give force.duration" \
    "${force[@]}" force.history=gaussian force.frequency=0.1
source_of 2 "force.duration is missing; is force.duratoin meant for it?" "${force[@]}" force.history=ricker force.duratoin=3
source_of 2 "force.cycles has no meaning for this history" "${force[@]}" force.history=ricker force.cycles=1 force.duration=1 force.time=2
source_of 2 "force.centre and force.half_width select no node: the nodes are at X = 1 to 500" force.centre=-9 force.amplitude=1 force.history=sine force.frequency=1
source_of 2 "the nearest is at X = 7, and force.half_width = 0.32 would select it" force.centre=7.3125 force.amplitude=1 force.history=sine force.frequency=1
# .. which it does.
try run "$sourceless" "${short[@]}" --set force.centre=7.3125 --set force.half_width=0.32 --set force.amplitude=1 --set force.history=sine \
    --set force.frequency=0.02
expect_exit 0
rm -r results
source_of 5 "nowhere.csv: No such file" "${force[@]}" force.history=csv force.file=nowhere.csv
wave=(incoming.shape=gaussian incoming.amplitude=1 incoming.width=9 incoming.arrival=5 incoming.end=left)
source_of 2 'incoming.end must be "left" or "right", not "both"' "${wave[@]}" incoming.end=both
source_of 2 "incoming.arrival must be a number not below 0" "${wave[@]}" incoming.arrival=-1
source_of 2 'is where the body ends, by kind "sbp": waves come in through artificial ends' "${wave[@]}" boundary.left.kind=sbp
source_of 2 "at most 100000 are taken" "${wave[@]}" incoming.arrival=1e9 time.end=1e10
source_of 2 "a damped lattice has no wave that comes from afar" "${wave[@]}" model.damping=1/20 \
    boundary.order=2 boundary.stride=4
source_of 2 "preload.strain must be a number, not nan" preload.strain=nan
source_of 2 "domain.nodes is 1, but NMBC2, stride 1, midpoint ghosts needs at least 2" "${pulse[@]}" \
    boundary.order=2 model.G=1/2 model.horizon=1 domain.nodes=1
source_of 2 "the chain needs at least 4 interior nodes for these ends" "${pulse[@]}" \
    boundary.kind=free domain.nodes=3

# .. and those that act on no node, or at no time of the run.
source_of 2 "initial.centre puts it outside of the bar, whose nodes are at 1 to 500" "${pulse[@]}" initial.centre=-99
source_of 2 "initial.centre puts it outside of the bar" "${pulse[@]}" initial.centre=600
# .. or on a tail alone, of 5e-12 of the amplitude.
source_of 2 "initial.centre puts it outside of the bar" "${pulse[@]}" initial.width=10 initial.centre=-50
for late in "gaussian force.duration=1" "ricker force.duration=2" "sine force.frequency=1"; do
    read -ra late <<<"$late"
    source_of 2 "force.time lets it begin at t =" "${force[@]}" force.history="${late[0]}" "${late[1]}" force.time=99
done
source_of 2 "force.time lets it end before the run begins" "${force[@]}" force.history=gaussian \
    force.duration=1 force.time=-7
source_of 2 "incoming.arrival lets it begin at t = 93" "${wave[@]}" incoming.arrival=99

setting 3 "pole of a coefficient at G = 0" boundary.order=4
refuses 3 "C(1) = 0" "$scene" --set model.horizon=1 --set model.G=1 --set boundary.order=3
refuses 5 "No such file" nowhere.toml
refuses 5 "Is a directory" /
refuses 2 "SCENE is required"
refuses 2 "SCENE: must not be empty" ""
refuses 2 "--out: must not be empty" "$scene" --out ""
try frob
expect_exit 2
expect_stderr "'frob' is not expected: nmbcrun takes the subcommands run, verify, chart, advise"
try
expect_exit 2
expect_stderr "nmbcrun needs one of the subcommands run, verify, chart, advise"
refuses 2 "'--foo' is not expected: run takes --help, SCENE, --set, --quiet, --out," "$scene" --foo 0.5 --bar
refuses 2 "--quiet takes no value: give it alone, or leave it out" "$scene" --quiet=yes
for command in run verify chart advise; do
    try $command --help
    expect "$command --help: exit codes" grep -q '130 stopped by Ctrl-C' "$scratch/stdout"
done

# Keys that do not count for the kind beside them.
layer=(--set boundary.layer=20)
idle() { refuses 2 "$1" "$scene" "${@:2}"; }
idle 'boundary.layer does not count for kind "fixed", which has no keys of its own' \
    --set boundary.kind=fixed "${layer[@]}"
# .. or, where none is given, for the default one.
for key in boundary.layer boundary.left.layer; do
    idle "$key does not count for kind \"nmbc\", whose keys are order, stride" --set $key=5
done
sed 's/^\[boundary\].*/&\nlayer = 50/' "$scene" >"$scratch/default.toml"
refuses 2 'default.toml:25: boundary.layer does not count for kind "nmbc"' "$scratch/default.toml"
try run "$scratch/default.toml" "${short[@]}" --set boundary.left.kind=sponge --set boundary.right.kind=free
expect_exit 0
rm -r results
idle 'boundary.right.stride does not count for kind "higdon", whose keys are order' \
    --set boundary.right.kind=higdon --set boundary.right.stride=2
idle 'boundary.target does not count for kind "nmbc", whose keys are order, stride' \
    --set boundary.kind=nmbc --set boundary.target=0.1
sed 's/^order.*/kind = "fixed"\n&/' "$scene" >"$scratch/idle.toml"
refuses 2 'idle.toml:29: boundary.order does not count for kind "fixed"' "$scratch/idle.toml"
stable --set boundary.order=1 --set boundary.right.kind=free
rm -r results
for value in 0 1 -1 nan \"x\"; do
    idle "boundary.target must be a number between 0 and 1, neither of them" \
        "${layer[@]}" --set boundary.kind=pml --set "boundary.target=$value"
done
idle "boundary.profile must be a number from 0 to 10, not 11" \
    "${layer[@]}" --set boundary.kind=pml --set boundary.profile=11
for kind in sponge pml; do
    idle "is of a kind that needs boundary.layer" --set boundary.right.kind=$kind
done
idle "the order of a higdon end is 1 to 10, not 11" --set boundary.kind=higdon \
    --set boundary.order=11 --set boundary.allow_unstable=true

# Mistakes in the file itself are named with their line, and a misspelt table before what is missing
# without it.
sed 's/^\[domain\]/[Domain]/' "$scene" >"$scratch/capital.toml"
refuses 2 "capital.toml:14: Domain is not a key of a scene; the nearest one is domain" "$scratch/capital.toml"
sed 's/^\[drive\]/[drvie]/' "$scene" >"$scratch/drive.toml"
refuses 2 "drvie is not a key of a scene; the nearest one is drive" "$scratch/drive.toml"
# What is no UTF-8 is not for a terminal.
# The command that makes a missing table comes before the tables there are.
refuses 2 'order 7, stride 1. To make it beside the scene: nmbcgen --family nopd1d --order 7 --horizon 2' \
    "$scene" --set boundary.order=7
refuses 2 '--set model.\xff is not a key of a scene' "$scene" --set $'model.\xff=1'
sed 's/^density/densty/' "$scene" >"$scratch/misspelt.toml"
refuses 2 "misspelt.toml: material.density is missing; is material.densty meant for it?" "$scratch/misspelt.toml"
sed '/^horizon/d' "$scene" >"$scratch/missing.toml"
refuses 2 "model.horizon is missing" "$scratch/missing.toml"
{
    cat "$scene"
    echo '[extra]'
} >"$scratch/extra.toml"
refuses 2 "extra is not a key of a scene" "$scratch/extra.toml"
sed '1i "model.G" = 3' "$scene" >"$scratch/quoted.toml"
refuses 2 "is one quoted name" "$scratch/quoted.toml"
sed 's/^step.*/&\ncfl = 0.5/' "$scene" >"$scratch/both.toml"
refuses 2 "has both step and cfl" "$scratch/both.toml"
# Strings without quotes, but nothing else that is no TOML.
for string in nmbc fixed true-ish ./x.csv "a b"; do
    printf '[boundary]\nkind = %s # ends\n' "$string" >"$scratch/bare.toml"
    refuses 2 "; a string needs quotes: \"$string\"" "$scratch/bare.toml"
done
printf '[model]\nowner = { "a" = spline, b = 1 }\n' >"$scratch/bare.toml"
refuses 2 '; a string needs quotes: "spline"' "$scratch/bare.toml"
printf '[model]\nowner = { a = "b", c = two }\n' >"$scratch/bare.toml"
refuses 2 '; a string needs quotes: "two"' "$scratch/bare.toml"
for garbled in 'a = = 1' 'a = "b' 'a = 1,5' 'a =' '[a' 'a b = 3' 'a = "b" c' 'a = True' 'a = .5e1' '= nmbc'; do
    echo "$garbled" >"$scratch/garbled.toml"
    refuses 2 "garbled.toml:1:" "$scratch/garbled.toml"
    expect "no word of quotes" lacks "needs quotes" "$scratch/stderr"
done
: >"$scratch/empty.toml"
refuses 2 "empty.toml: has no keys; docs/reference/scene.md lists those of a scene" "$scratch/empty.toml"

# Tables in tables are on the stack, so there is an end to them; the deepest that is read.
deep=$(printf 'a.%.0s' {1..20000})
printf '%sa=1' "${deep:0:32764}" >"$scratch/deep.toml"
refuses 2 "deep.toml:1: a is not a key of a scene" "$scratch/deep.toml"
printf '%sa=1' "${deep:0:32766}" >"$scratch/deep.toml"
refuses 2 "deep.toml: a scene has at most 32768 bytes" "$scratch/deep.toml"
refuses 2 "/dev/zero: a scene has at most 32768 bytes" /dev/zero
refuses 2 "is not a key of a scene" "$scene" --set "${deep:0:4094}a=1"
refuses 2 "a key and its value have at most 4096 bytes" "$scene" --set "${deep:0:4096}=1"
refuses 2 "a key and its value have at most 4096 bytes" "$scene" --set "title={${deep:0:4090}a=1}"
refuses 2 "title must be a string in quotes, not {a = {a = " "$scene" --set "title={${deep:0:4080}a=1}"
expect "it is quoted in part" test "$(wc -c <"$scratch/stderr")" -lt 200

# A pulse that is nowhere different.
refuses 2 "initial.width is 1e+09, so wide that the displacement is the same all over the bar to 1e-09" \
    "$2/tools/scenes/broadband.toml" --set initial.width=1e9

# A whole number that no double is.
try run "$scene" --set material.youngs_modulus=9223372036854775807
expect_exit 2
expect_stderr 'material.youngs_modulus must be a positive number, not 9223372036854775807'
# An infinity deep in a value that is none.
try run "$scene" --set 'model.horizon=[[1], {d = inf}]'
expect_exit 2
expect_stderr 'model.horizon must be a whole number from 1 to 100, not [[1], {d = inf}]'

finish
