#!/usr/bin/env bash
# What the command line takes of processor and memory, for what is long and what is hostile.
# Not under sanitizers, which take many times as much.
# Use: resource_checks.sh CLI SOURCE_DIR WORK_DIR
set -u
cli=$1
source_dir=$2
work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
. "$source_dir/tests/app/cli_support.sh"

# within SECONDS MB COMMAND...: takes no more of either, whatever it ends with.
within() {
    python3 - "$@" <<'P'
import resource, subprocess, sys
seconds, megabytes, command = float(sys.argv[1]), float(sys.argv[2]), sys.argv[3:]
limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
code = subprocess.run(command, stdout=open("stdout.txt", "wb"), stderr=open("stderr.txt", "wb"),
                      preexec_fn=limit).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
took_s, took_mb = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
if code < 0 or took_s > seconds or took_mb > megabytes:
    sys.exit(f"  exit {code}, {took_s:.1f} s and {took_mb:.0f} MB, not {seconds} s and {megabytes} MB")
P
}

# --- a long flight -----------------------------------------------------------------------------
# 240 MB of tables are written while it is flown.
python3 - <<'P'
import json, random
random.seed(1)
place = lambda: [random.uniform(-2e4, 2e4), random.uniform(-2e4, 2e4)]
bergs = [{"id": f"b{i}", "position_m": place(), "velocity_mps": [0.1, 0.05]} for i in range(300)]
json.dump({"format": "bergwatch-scenario", "version": 1, "duration_s": 12000, "icebergs": bergs,
           "uavs": [{"id": "u", "position_m": [0, 0]}], "planner": {"policy": "nearest"}}, open("long.berg", "w"))
P
check "a long flight" within 60 120 "$cli" simulate long.berg --output long
check "a long flight: all of it" test "$(wc -l <long/sigma.csv)" -eq 3600301
mv long before
cp -r before long
check "a long flight over another" within 60 120 "$cli" simulate long.berg --output long --force
check "a long flight over another: the same" diff -rq long before
check "a long flight replayed" within 60 120 "$cli" simulate before/run.bergrun --output again
check "a long flight replayed: the same" diff -rq again before
rm -rf long before again

all_checked
