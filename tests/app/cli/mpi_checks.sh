#!/usr/bin/env bash
# A sweep flown by two MPI processes against the same sweep in one.
# Use: mpi_checks.sh MPIRUN CLI WORK_DIR
set -u
export LC_ALL=C.UTF-8
mpirun=$1
cli=$2
work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
# As root in a container, with no more cores than there are, without looking for networks.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl=self,vader OMPI_MCA_pml=ob1 OMPI_MCA_plm=isolated OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMPI_MCA_hwloc_base_binding_policy=none
failures=0

# check NAME CONDITION...: names a failed check.
check() {
    local name=$1
    shift
    if ! "$@"; then
        failures=$((failures + 1))
        echo "FAILED: $name"
        sed 's/^/  /' stderr.txt | head -20
    fi
}

# exits CODE COMMAND...: true when it ends with that code.
exits() {
    local wanted=$1
    shift
    "$@" >stdout.txt 2>stderr.txt
    [ $? -eq "$wanted" ]
}

# ranks N OPTION...: the command in N processes.
ranks() {
    local count=$1
    shift
    "$mpirun" --map-by :OVERSUBSCRIBE -n "$count" "$cli" "$@"
}

once() { [ "$(grep -cF -- "$1" stderr.txt)" -eq 1 ]; }

sweep=(sweep --random 7 --tau 0:2:1 --policies visitation,latency)
check "one process" exits 0 "$cli" "${sweep[@]}" --study one.bergstudy --output one.csv
cp stdout.txt one.txt
for count in 2 3; do
    rm -f ranks.bergstudy ranks.csv
    check "$count ranks" exits 0 ranks $count "${sweep[@]}" --study ranks.bergstudy --output ranks.csv
    check "$count ranks: the same table" cmp -s one.txt stdout.txt
    check "$count ranks: the same study" cmp -s one.bergstudy ranks.bergstudy
    check "$count ranks: the same CSV" cmp -s one.csv ranks.csv
done

# Shards of ranks, and a file that is carried on.
check "a shard on two ranks" exits 0 ranks 2 "${sweep[@]}" --shard 2/2 --study part.bergstudy
check "the rest on two ranks" exits 0 ranks 2 "${sweep[@]}" --study part.bergstudy
check "the rest on two ranks: the same" cmp -s one.bergstudy part.bergstudy
check "nothing left on two ranks" exits 0 ranks 2 "${sweep[@]}" --study part.bergstudy

# What is wrong is said once, by all of them ending.
check "wrong usage" exits 2 ranks 2 sweep --random 2
check "wrong usage: once" once "--tau is required"
check "wrong values" exits 2 ranks 2 sweep --random 2 --tau 300
check "wrong values: once" once "--tau: 300 is not"
check "no scenario" exits 3 ranks 2 sweep missing.berg --tau 1
check "no scenario: once" once "missing.berg"
check "a scenario that cannot be flown" exits 3 ranks 2 sweep --random 1000000 --tau 0,1
check "a scenario that cannot be flown: once" once "at most 1000000"
# By the rank: mpirun 5.0.7 crashes where it is given two programs.
cat >different.sh <<'S'
#!/bin/sh
[ "$OMPI_COMM_WORLD_RANK" = 0 ] && exec "$@"
exec "$1" sweep --random 3 --tau 1
S
chmod +x different.sh
check "different options" exits 2 "$mpirun" --map-by :OVERSUBSCRIBE -n 2 ./different.sh "$cli" "${sweep[@]}"
check "different options: once" once "different options"
check "a file that cannot be written" exits 1 ranks 2 "${sweep[@]}" --output one.csv/x.csv

# Ended from outside, as a queue does: what is done is kept.
interrupted() {
    "$mpirun" --map-by :OVERSUBSCRIBE -n 2 "$cli" sweep --random 2000 --tau 0:3:0.1 --study long.bergstudy >stdout.txt 2>stderr.txt &
    local job=$!
    for _ in $(seq 100); do
        [ -e long.bergstudy ] && break
        sleep 0.1
    done
    sleep 1
    kill -TERM $job
    wait $job
    [ $? -ne 0 ]
}
check "ended from outside" interrupted
check "ended from outside: a study is left" exits 0 "$cli" study long.bergstudy
check "ended from outside: a part of it" grep -q "incomplete: [1-9]" stderr.txt

[ "$failures" -eq 0 ] && echo "all passed"
[ "$failures" -eq 0 ]
