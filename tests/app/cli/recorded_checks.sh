#!/usr/bin/env bash
# What was flown on one system is flown on another to the bit: tests/data/recorded holds five runs, zeta of all
# examples, a table of 200 random scenarios and half a study.
# Use: recorded_checks.sh CLI SOURCE_DIR WORK_DIR [record]
# With "record" the files are written anew, where results have changed on purpose.
. "$2/tests/app/cli/cli_support.sh"
recorded=$source_dir/tests/data/recorded
examples=$source_dir/resources/scenarios
sweep=(sweep --random 24 --tau 0,1,2 --policies visitation,latency)

# runs FUNCTION: of name, example and options each: a run with a fence and endurance, wind, losses, two UAVs, beacons' tracks.
runs() {
    "$1" endurance fram-strait-endurance --duration 900 --policy coverage
    "$1" wind barents-wind --duration 900
    "$1" lost bonavista-lost --duration 1200
    "$1" fleet svalbard-two-uavs --duration 900 --policy latency
    "$1" drift upernavik-real-drift --duration 900 --policy coverage
}
zetaOfExamples() {
    local example
    for example in "$examples"/*.berg; do
        printf '%s ' "$(basename "$example")"
        "$cli" simulate "$example" --json --quiet | python3 -c 'import json, sys; print(repr(json.load(sys.stdin)["zeta_m2s"]))'
    done
}
table() {
    "$cli" sweep --random 200 --tau 0,1,3 --policies visitation,latency,path,tour,nearest --output "$1" --quiet >/dev/null &&
        "$cli" sweep --random 10 --tau 1 --policies coverage --output coverage.csv --quiet >/dev/null &&
        cat coverage.csv >>"$1"
}

if [ "${4:-}" = record ]; then
    rm -rf "$recorded"
    mkdir -p "$recorded"
    record() { "$cli" simulate "$examples/$2.berg" "${@:3}" --output flown --force --quiet >/dev/null && cp flown/run.bergrun "$recorded/$1.bergrun"; }
    runs record
    zetaOfExamples >"$recorded/zeta.txt"
    table "$recorded/table.csv"
    "$cli" "${sweep[@]}" --shard 1/2 --study "$recorded/half.bergstudy" --quiet >/dev/null
    exit
fi

replay() {
    check "$1: replays" exits 0 "$cli" simulate "$recorded/$1.bergrun"
    check "$1: equal" grep -q 'equal to the recorded run' stdout.txt
}
runs replay
zetaOfExamples >zeta.txt
check "examples: sixteen" test "$(grep -c . zeta.txt)" -ge 16
check "examples: zeta" diff "$recorded/zeta.txt" zeta.txt
check "200 scenarios" table table.csv
check "200 scenarios: the table" diff "$recorded/table.csv" table.csv
check "study: the other half" exits 0 "$cli" "${sweep[@]}" --shard 2/2 --study half.bergstudy
check "study: both in one" exits 0 "$cli" study "$recorded/half.bergstudy" half.bergstudy --study both.bergstudy
check "study: all of it here" exits 0 "$cli" "${sweep[@]}" --study whole.bergstudy
check "study: the same bytes" cmp whole.bergstudy both.bergstudy
all_checked
