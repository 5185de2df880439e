#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Scenes with tables of the user's own: made, run, verified, and every mistake with their files.
# Usage: run_tables.sh NMBCRUN NMBCGEN (absolute)
source "$(dirname "${BASH_SOURCE[0]}")/../program/assert.sh"
nmbcgen=$2
lacks() { ! grep -q "$1" "$2"; }
differ() { ! cmp -s "$1" "$2"; }
make_table() { "$nmbcgen" "$@" --format json >"$scratch/made"; }

mkdir scenes
make_table --order 1 --horizon 2 --weights conical --G 1 --out scenes
make_table --match 0:3,1/2:1 --horizon 1 --G 1/2 --out scenes
make_table --order 2 --horizon 1 --G 1/3 --out scenes
make_table --family bond1d --order 1 --horizon 2 --out scenes
make_table --order 1 --horizon 3 --weights 1,3/4,1/2 --G 1 --uncertified --out scenes
scene=scenes/own.toml
cat >"$scene" <<'TOML'
[model]
horizon = 2
G = 1
influence = "conical"
tables = ["nopd1d_n2_w_1o1_1o2_order1_G1o1.json"]
[domain]
nodes = 300
[initial]
shape = "gaussian"
amplitude = 0.01
centre = 150
width = 20
[time]
end = 300
TOML

try run "$scene"
expect_exit 0
expect_no_stderr
expect_stdout_line "lattice   nopd1d horizon 2, G = 1, influence 1, 1/2"
expect "the step of its certificate" grep -qF 'cfl = 0.88): the largest certified for NMBC1' "$scratch/stdout"
# Its waves of xi dX = 0.08, in the middle of the pulse's spectrum, come back with 4.0e-4 of their
# amplitude (verify's own prediction), and the whole pulse with 2.98e-4.
try verify "$scene" --tolerance 3e-4
expect_exit 0
try verify "$scene" --tolerance 2.9e-4
expect_exit 1
# Two ways to the same lattice without ends differ by roundings of 132 steps.
try verify "$scene" --tolerance 1e-13 --set boundary.kind=exact
expect_exit 0
for same in '[2,1]' '["1","1/2"]' '[1,0.5]' inverse; do # 1/m at n = 2
    try run "$scene" --quiet --set "model.influence=$same" --set output.name=same \
        --set title=own
    expect_exit 0
    expect_same results/own.csv results/same.csv
done
# What walks the tables finds this one, and none of the committed set, whose influence is constant.
try advise "$scene" --tolerance 1e-3
expect_exit 0
expect "its NMBC1" grep -q 'NMBC1, stride 1' "$scratch/stdout"
expect "no NMBC2" lacks NMBC2 "$scratch/stdout"

# One that takes the place of another says so; one that has its coefficients needs not.
make_table --match 0:3,1/2:1 --horizon 2 --stride 2 --G 1 --out scenes
make_table --order 2 --horizon 2 --stride 2 --G 1 --out scenes
for hides in nopd1d_n2_order2_s2_at1o2x1_G1o1:yes nopd1d_n2_order2_s2_G1o1:no; do  # by their files
    try run "$scene" --set model.influence=constant --set boundary.order=2 --set boundary.stride=2 \
        --set "model.tables=[\"${hides%:*}.json\"]" --quiet --set boundary.allow_unstable=true
    expect_exit 0
    if [ ${hides#*:} = yes ]; then
        expect_stderr "matched at 0:3,1/2:1 of model.tables takes the place of the committed nopd1d_n2_order2_s2,"
    else
        expect "no word" lacks 'takes the place' "$scratch/stderr"
    fi
done

# Near a pole of its coefficients a mode of this condition grows in steps below cfl 0.047.
make_table --order 2 --horizon 1 --damping 1/50 --G 9/200 --out scenes
stiff=(--set model.influence=constant --set model.horizon=1 --set model.G=0.045
    --set model.damping=1/50 --set boundary.order=2
    --set 'model.tables=["nopd1d_n1_order2_tau1o50_G9o200.json"]')
for cfl in 0.02 0.0469; do
    try run "$scene" "${stiff[@]}" --set time.cfl=$cfl
    expect_exit 4
    expect_stderr "NMBC2 is certified from cfl = 0.047 to 0.15 at n = 1, G = 0.045, tau = 1/50"
done
for cfl in 0.048 0.15; do
    try run "$scene" "${stiff[@]}" --set time.cfl=$cfl
    expect_exit 0
done

# The condition matched at xi = 1/2 stands for the committed one of this order and stride.
other=(--set model.influence=constant --set model.horizon=1)
matched=("${other[@]}" --set model.G=0.5 --set boundary.order=2
    --set 'model.tables=["nopd1d_n1_order2_at1o2x1_G1o2.json"]')
try verify "$scene" "${matched[@]}" --set time.cfl=0.3 --tolerance 1
cp "$scratch/stdout" "$scratch/matched"
expect_exit 0
try verify "$scene" "${matched[@]}" --set time.cfl=0.3 --tolerance 1 --set 'model.tables=[]'
expect_exit 0
expect "another condition" differ "$scratch/stdout" "$scratch/matched"
# At xi dX = 0.23, next to the matched wave, less comes back.
reflected() { awk '/^ *0\.229/ { print $4 }' "$1"; }
expect "and one that reflects less there" \
    awk "BEGIN { exit !($(reflected "$scratch/matched") < 0.9 * $(reflected "$scratch/stdout")) }"
# A G that no double is: beside a committed table, whose symbol is rounded, of one lattice.
third=("${other[@]}" --set 'model.G="1/3"' --set boundary.left.order=2
    --set 'model.tables=["nopd1d_n1_order2_G1o3.json"]')
try run "$scene" "${third[@]}" --quiet
expect_exit 0
# A family of which there is no committed table; a chain so short that its own length is looked at.
bonds=(--set model.influence=constant --set model.family=bond1d --set model.G=0
    --set 'model.tables=["bond1d_n2_order1.json"]')
try run "$scene" "${bonds[@]}"
expect_exit 0
expect_stdout_line "lattice   bond1d horizon 2, G = 0"
try run "$scene" "${bonds[@]}" --quiet --set domain.nodes=8 --set initial.centre=4 --set initial.width=2 --set time.cfl=0.3
expect_exit 0

# refuses CODE TEXT ARGUMENT..: that exit code, that text; of 4 what to do in lines of its own, of others no more.
refuses() {
    local expected=$1 text=$2
    shift 2
    try run "$scene" --quiet "$@"
    expect_exit "$expected"
    expect_stderr "$text"
    expect_stderr_lines $((expected == 4 ? 3 : 1))
    expect_no_stdout
}
third=(--set model.horizon=3 --set 'model.influence=[1,0.75,0.5]')
refuses 2 "nmbcrun has no table for family nopd1d, horizon 3, influence 1, 3/4, 1/2, order 1, stride 1. To make it beside the \
scene: nmbcgen --family nopd1d --order 1 --horizon 3 --weights 1,3/4,1/2 --G 1 --format json --out FOLDER, and \
model.tables = [\"nopd1d_n3_w_1o1_3o4_1o2_order1_G1o1.json\"]. It knows the committed set and those of model.tables, in which there is nothing of this \
influence" "${third[@]}"
# It has the G that the scene states, which no double is, and that of another setting.
for given in '"1/3":1/3:1o3' '0.25:1/4:1o4'; do
    IFS=: read -r G exact name <<<"$given"
    refuses 2 "nmbcgen --family nopd1d --order 5 --horizon 2 --G $exact --format json --out FOLDER, and model.tables = $(:
        )[\"nopd1d_n2_order5_G$name.json\"]" --set model.influence=constant --set model.G="$G" --set boundary.order=5
done
# Without a certificate of its own: no step is chosen, and one that is given is certified here.
third+=(--set 'model.tables=["nopd1d_n3_w_1o1_3o4_1o2_order1_G1o1.json"]')
refuses 4 "its table, in scenes/nopd1d_n3_w_1o1_3o4_1o2_order1_G1o1.json, was written with --uncertified; NMBC1 with \
stride 1 is not certified at its G, 1" "${third[@]}"
refuses 4 "NMBC1 is certified against a pml end at no time step" "${third[@]}" --set time.cfl=0.3 \
    --set boundary.right.kind=pml --set boundary.right.layer=10
try run "$scene" --quiet "${third[@]}" --set time.cfl=0.3
expect_exit 0
expect_no_stderr

# A table of the family says nothing of damping, which bonds have nothing for.
refuses 2 "nmbcrun has no table for family bond1d, horizon 2, order 1, stride 1, damping tau = 1/10: there is no such model: damping \
1/10: this model has no stabilisation to be damped by. It knows the committed set and those of model.tables, in which of this family \
and horizon there are bond1d_n2_order1" "${bonds[@]}" --set model.damping=1/10
# Of a family that only the table knows there is nothing to say.
sed 's/"bond1d/"mine/' scenes/bond1d_n2_order1.json >scenes/mine.json
refuses 2 "nmbcrun has no table for family mine, horizon 2, order 1, stride 1, damping tau = 1/10. It knows" "${bonds[@]}" \
    --set model.family=mine --set 'model.tables=["mine.json"]' --set model.damping=1/10

refuses 2 'model.influence must be "constant", "conical", "inverse", "cubic", or a list of 2 exact numbers, not "cone"' \
    --set model.influence=cone
refuses 2 "model.influence must be a list, not 3" --set model.influence=3
refuses 2 "model.influence has 3 weights, where horizon 2 needs 2" --set 'model.influence=[1,1,1]'
refuses 2 "model.influence has a 0: every bond needs a weight other than 0" --set 'model.influence=[1,0]'
refuses 2 "model.influence has a weight below 0, which nopd1d does not take" --set 'model.influence=[1,-1]'
refuses 2 "one of them is true" --set 'model.influence=[1,true]'
refuses 2 'model.tables must be a list of strings in quotes, ["a", "b"], not 3' --set model.tables=3
refuses 2 'model.tables must be a list of strings in quotes, ["a", "b"], not [1]' --set 'model.tables=[1]'

file() { refuses "$1" "$2" --set "model.tables=[\"$3\"]"; }
file 5 "cannot read scenes/none.json: No such file or directory" none.json
file 5 "cannot read scenes/..: Is a directory" ..
file 5 "cannot read /dev/zero: it is not a regular file" /dev/zero
mkfifo scenes/pipe
file 5 "cannot read scenes/pipe: it is not a regular file" pipe
file 2 "scenes/own.toml is no JSON: parse error at line 1" own.toml
table=scenes/nopd1d_n2_w_1o1_1o2_order1_G1o1.json
head -c 500 "$table" >scenes/cut.json
file 2 "scenes/cut.json is no JSON: parse error at line" cut.json
sed 's/"schema": 4/"schema": 3/' "$table" >scenes/schema.json
file 2 "scenes/schema.json: schema must be 4, not 3" schema.json
sed 's/"horizon": 2/"horizon": "2"/' "$table" >scenes/type.json
file 2 'scenes/type.json: lattice.horizon must be a whole number from 1 to 100, not "2"' type.json
: >scenes/empty.json
file 2 "scenes/empty.json is no JSON" empty.json
head -c 15000000 /dev/zero | tr '\0' '[' >scenes/brackets.json
file 2 "scenes/brackets.json is no table of nmbcgen: it is nested too deeply" brackets.json
truncate -s 100000000 scenes/long.json
file 2 "scenes/long.json has 100000000 bytes; at most 16000000 are allowed" long.json

# A run does not go on with another table, or the same table written in another way.
long=(--quiet --set time.end=1e9 --set output.checkpoint=1e-9 --set output.every=1000)
"$program" run "$scene" "${long[@]}" --out stopped >/dev/null 2>&1 &
run=$!
until test -e stopped/own.checkpoint || ! kill -0 "$run" 2>/dev/null; do sleep 0.05; done
kill -TERM "$run"
wait "$run" || true
cp "$table" "$scratch/kept"
echo >>"$table"
refuses 2 "stopped/own.checkpoint is of another scene: there the checksum of $table is " "${long[@]}" --out stopped --resume
cp "$scratch/kept" "$table"
touch mark
"$program" run "$scene" "${long[@]}" --out stopped --resume >/dev/null 2>"$scratch/stderr" &
run=$!
until test stopped/own.checkpoint -nt mark || ! kill -0 "$run" 2>/dev/null; do sleep 0.05; done
rm mark
kill -TERM "$run" 2>/dev/null || true
code=0
wait "$run" || code=$?
expect_exit 130 # it went on, till it was stopped again
finish
