#!/usr/bin/env bash
# The real programs where memory runs out in the middle of their work: they say so and end with 1, or
# do their work; they never die of it. Not under sanitizers, which reserve terabytes.
# The program of the window is in tst_main_window_memory: Qt waits for ever for threads to paint that it
# does not get.
# Use: memory_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
scenarios=$source_dir/resources/scenarios
python3 - <<'P'
import random
random.seed(1)
with open("long.csv", "w") as f:
    f.write("id,latitude,longitude,time\n")
    for i in range(100_000):
        f.write(f"berg-{i % 900},{random.uniform(45, 55):.4f},{random.uniform(-55, -45):.4f},2021-04-{1 + i % 28:02}T00:00:00Z\n")
P

# starved COMMAND...: with less and less memory than it needs, down to what the program needs to say
# that it is one. Each end is in order, and some end for lack of memory.
starved() {
    python3 - "$@" <<'P'
import os, resource, subprocess, sys
command = sys.argv[1:]
def run(words, limit_mb):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (limit_mb << 20, limit_mb << 20))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    done = subprocess.run(words, preexec_fn=limit, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, timeout=300)
    return done.returncode, done.stderr.decode(errors="replace")
def least(words, low, high):
    """Of the limits with which it does its work, to a megabyte."""
    while high - low > 1:
        middle = (low + high) // 2
        if run(words, middle)[0] == 0:
            high = middle
        else:
            low = middle
    return high
start_mb = least([command[0], "--version"], 1, 2048)
enough_mb = start_mb
while run(command, enough_mb)[0] != 0:
    enough_mb = enough_mb * 5 // 4 + 1
    if enough_mb > 8192:
        sys.exit("  does not work with 8 GB either")
tries = 16
failed = 0
for i in range(tries):
    limit_mb = start_mb + (enough_mb - start_mb) * i // tries
    code, said = run(command, limit_mb)
    if code == 0:
        continue
    no_plan = code == 4 # the promise of `plan` where a limit comes first, said on standard output
    if not no_plan and (code != 1 or "memory" not in said):
        sys.exit(f"  with {limit_mb} MB: exit {code}: {said[-300:]}")
    failed += 1
if failed == 0:
    sys.exit(f"  nothing failed from {start_mb} to {enough_mb} MB")
P
}

check "import" starved "$cli" import long.csv --output imported.berg --force --accept-doubtful
check "simulate" starved "$cli" simulate "$scenarios/scoresby-sund-40.berg" --duration 300 --output flown --force
check "plan" starved "$cli" plan "$scenarios/scoresby-sund-40.berg"
check "curve" starved "$cli" curve "$scenarios/labrador-20.berg" --output curve.csv --force
check "study on all cores" starved "$cli" sweep --random 8 --tau 0:2:1 --study some.bergstudy --force
check "study on all cores: whole or not there" exits 0 "$cli" sweep --random 8 --tau 0:2:1 --study whole.bergstudy
check "export" starved "$cli" export "$scenarios/scoresby-sund-40.berg" --format kml --output plan.kml --force

all_checked
