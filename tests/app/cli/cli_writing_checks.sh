#!/usr/bin/env bash
# What the command line writes, where, and what it refuses before any work: run as a stranger would.
# Use: cli_writing_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
scenario="$source_dir/resources/scenarios/disko-bay-4.berg"
sightings="$source_dir/tests/data/import/iip.csv"

cp "$scenario" four.berg
cp "$sightings" iip.csv
sweep=(sweep four.berg --tau 0,1)
check "a study to read" exits 0 "$cli" "${sweep[@]}" --study four.bergstudy
check "a run to read" exits 0 "$cli" simulate four.berg --duration 60 --output run

# A field so large that its sweep, curve and benchmark take minutes: what is refused is refused first.
endless=(sweep --random 5000 --tau 0:5:0.1)

# refused NAME CODE WORDS COMMAND...: ends with the code within two seconds and says the words.
refused() {
    local name=$1 code=$2 words=$3
    shift 3
    check "$name" exits "$code" timeout 2 "$@"
    check "$name: says '$words'" says "$words"
    check "$name: prints nothing else" test ! -s stdout.txt
}

# --- an output that is an input --------------------------------------------------------------
ln four.berg hard.berg
ln -s four.berg soft.berg
for file in four.berg ./four.berg hard.berg soft.berg; do
    refused "curve over its input, $file" 2 "--output: $file is an input" "$cli" curve four.berg --output $file --force
    refused "sweep over its input, $file" 2 "--output: $file is an input" "$cli" "${endless[@]}" four.berg --output $file --force
    refused "sweep's report over its input, $file" 2 "--report: $file is an input" "$cli" "${endless[@]}" four.berg --report $file --force
    refused "sweep's study over its input, $file" 2 "--study: $file is an input" "$cli" "${endless[@]}" four.berg --study $file --replace-study
    refused "export over its input, $file" 2 "--output: $file is an input" "$cli" export four.berg --format csv --output $file --force
done
refused "study over its input" 2 "--output: four.bergstudy is an input" "$cli" study four.bergstudy --output four.bergstudy --force
refused "study's report over its input" 2 "--report: four.bergstudy is an input" "$cli" study four.bergstudy --report four.bergstudy --force
refused "import over its input" 2 "--output: iip.csv is an input" "$cli" import iip.csv --output iip.csv --force
refused "a run replayed into its folder" 2 "--output: run/run.bergrun is an input" "$cli" simulate run/run.bergrun --output run --force

# --- outputs of one name ---------------------------------------------------------------------
refused "table and report of one name" 2 "--report: x.out is already the file of --output" "$cli" "${endless[@]}" --output x.out --report x.out
refused "the same by another name" 2 "--report: ../${work##*/}/x.out is already the file of --output" "$cli" "${endless[@]}" --output x.out --report "../${work##*/}/x.out"
refused "three of one name" 2 "--output: x.out is already the file of --study" "$cli" "${endless[@]}" --study x.out --output x.out --report x.out
cp four.bergstudy table.csv
ln table.csv page.html
refused "two names of one file" 2 "--report: page.html is already the file of --output" "$cli" "${endless[@]}" --output table.csv --report page.html --force
rm table.csv page.html

# --- what exists, what cannot be -------------------------------------------------------------
echo mine >there.csv
mkdir folder
for command in "curve four.berg" "${endless[*]}" "study four.bergstudy" "import iip.csv" "benchmark"; do
    name=${command%% *}
    refused "$name exists" 2 "--output: there.csv exists; use --force to overwrite it" "$cli" $command --output there.csv
    refused "$name: no folder" 1 "--output: none/x.csv: there is no folder none" "$cli" $command --output none/x.csv
    refused "$name: a file for a folder" 1 "--output: there.csv/x.csv: there.csv is no folder" "$cli" $command --output there.csv/x.csv
    refused "$name: a folder for a file" 1 "--output: folder: cannot be written: Is a directory" "$cli" $command --output folder
    refused "$name: a folder that takes no files" 1 "--output: /proc/x.csv: cannot be written" "$cli" $command --output /proc/x.csv
done
refused "report: exists" 2 "--report: there.csv exists" "$cli" "${endless[@]}" --report there.csv
refused "report: no folder" 1 "--report: none/x.html: there is no folder none" "$cli" "${endless[@]}" --report none/x.html
refused "study: no folder" 1 "--study: none/x.bergstudy: there is no folder none" "$cli" "${endless[@]}" --study none/x.bergstudy
refused "simulate: the files of a flight exist" 2 "--output: run/trajectory.csv exists" "$cli" simulate four.berg --duration 60 --output run
refused "simulate: a file for a folder" 1 "--output: there.csv: is no folder" "$cli" simulate four.berg --output there.csv
refused "simulate: no folder can be made there" 1 "there.csv is no folder" "$cli" simulate four.berg --output there.csv/new/out
check "what is there is as before" test "$(cat there.csv)" = mine
check "nothing was written, nothing was left" test "$(ls -A | sort | tr '\n' ' ')" = "folder four.berg four.bergstudy hard.berg iip.csv run soft.berg stderr.txt stdout.txt there.csv "
check "no input was touched" cmp -s four.berg "$scenario"
python3 - "$scenario" two.berg <<'P'
import json, sys
d = json.load(open(sys.argv[1]))
d["uavs"] = [dict(d["uavs"][0], id=name) for name in ("a", "b")]
json.dump(d, open(sys.argv[2], "w"))
P
touch two-b.plan
refused "one of the files of an export exists" 2 "--output: two-b.plan exists" "$cli" export two.berg --format plan --output two.plan
check "one of the files of an export exists: none is written" test ! -e two-a.plan -a ! -s two-b.plan

# --- with --force ----------------------------------------------------------------------------
check "curve --force" exits 0 "$cli" curve four.berg --output there.csv --force
check "curve --force: written" grep -q '^tau_from' there.csv
check "sweep --force" exits 0 "$cli" "${sweep[@]}" --output there.csv --report page.html --force
check "sweep --force: written" grep -q '^policy,tau' there.csv
check "simulate --force" exits 0 "$cli" simulate four.berg --duration 90 --output run --force
check "simulate --force: written" grep -q '^90,' run/zeta.csv
check "a scenario to add to" exits 0 "$cli" import iip.csv --output more.berg
check "import into the scenario itself" exits 2 "$cli" import iip.csv --into more.berg --output more.berg
check "import into the scenario itself, --force" exits 0 "$cli" import iip.csv --into more.berg --output more.berg --force
check "--force is not --replace-study" exits 3 "$cli" sweep --random 2 --tau 1 --study four.bergstudy --force
check "--force is not --replace-study: says so" says "--replace-study replaces it"
check "benchmark --force" exits 0 "$cli" benchmark --sizes 2 --repeat 1 --backends exact --output there.csv --force

# --- pipes and devices -----------------------------------------------------------------------
check "a table on standard output" exits 0 "$cli" curve "$scenario" --output -
check "a table on standard output: alone" python3 -c 'import csv; rows = list(csv.DictReader(open("stdout.txt"))); raise SystemExit(not (rows and rows[0]["tau_from"] == "0"))'
check "a table on standard output: words for people elsewhere" says "order: icebergs by their place"
cp stdout.txt table.csv
check "the same by its name" exits 0 "$cli" curve "$scenario" --output /dev/stdout
check "the same by its name: the same" cmp -s stdout.txt table.csv
"$cli" curve "$scenario" --output - 2>/dev/null | cat >piped.csv
check "a table into a pipe" cmp -s piped.csv table.csv
check "a table into a substitute" exits 0 bash -c '"$1" curve "$2" --output >(cat >late.csv); for i in $(seq 50); do [ -s late.csv ] && break; sleep 0.1; done; sleep 0.1' - "$cli" "$scenario"
check "a table into a substitute: the same" cmp -s late.csv table.csv
check "a table for nobody" exits 0 "$cli" curve "$scenario" --output /dev/null
check "a device twice" exits 0 "$cli" "${sweep[@]}" --output /dev/null --report /dev/null
check "two things on standard output" exits 2 "$cli" curve "$scenario" --output - --json
check "two things on standard output: told" says "--output: /dev/stdout and --json both need standard output"
check "two things on standard output: in JSON" json 'd["error"]["kind"] == "wrong-usage"'
refused "standard output twice" 2 "--report: /dev/stdout is already the file of --output" "$cli" "${sweep[@]}" --output - --report -
check "a scenario on standard output" exits 0 "$cli" import iip.csv --output -
cp stdout.txt piped.berg
check "a scenario on standard output: is one" exits 0 "$cli" validate piped.berg
refused "a study on standard output" 2 "--study: '-' is not possible here" "$cli" "${sweep[@]}" --study -
refused "a flight on standard output" 2 "--output: '-' is not possible here" "$cli" simulate four.berg --output -
refused "--replace-study without a study" 2 "--replace-study needs --study FILE" "$cli" study four.bergstudy --replace-study
check "an export on standard output" exits 0 "$cli" export "$scenario" --format wpl --output -
check "an export on standard output: is one" test "$(head -1 stdout.txt)" = "QGC WPL 110"

# --- what was computed is printed, whatever becomes of the files -----------------------------
for command in "curve $scenario" "${sweep[*]}" "study four.bergstudy" "benchmark --sizes 2 --repeat 1 --backends exact"; do
    name=${command%% *}
    check "$name on a full device" exits 1 "$cli" $command --output /dev/full
    check "$name on a full device: says so" says "/dev/full: cannot be written: No space left on device"
    check "$name on a full device: the result is printed" test "$(wc -l <stdout.txt)" -ge 2
done

# limited KIB COMMAND...: no file of it may grow larger, as on a disk that is full.
limited() { (ulimit -f "$1"; shift; exec "$@"); }
check "simulate on a full disk" exits 1 limited 8 "$cli" simulate "$scenario" --duration 60 --output small
check "simulate on a full disk: says so" says "cannot be written: File too large"
check "simulate on a full disk: the result is printed" grep -q '^zeta ' stdout.txt
check "simulate on a full disk: all files or none" test -z "$(ls -A small)"
check "a flight to be overwritten" exits 0 "$cli" simulate "$scenario" --duration 30 --output kept
cp -r kept kept.before
check "simulate over another on a full disk" exits 1 limited 8 "$cli" simulate "$scenario" --duration 60 --output kept --force
check "simulate over another on a full disk: that is whole" diff -r kept kept.before
check "sweep on a full disk" exits 1 limited 8 "$cli" "${sweep[@]}" --output full.csv --report full.html
check "sweep on a full disk: none is written" test ! -e full.csv -a ! -e full.html
check "sweep on a full disk: the result is printed" grep -q '^visitation' stdout.txt
check "help on a full device" exits 1 bash -c '"$1" --help >/dev/full' - "$cli"
check "version on a full device" exits 1 bash -c '"$1" --version >/dev/full' - "$cli"

# --- Ctrl-C and termination ------------------------------------------------------------------
# stops SIGNAL COMMAND...: CPU time after the signal is below 100 ms, exit code 130.
stops() {
    python3 - "$@" <<'P'
import os, resource, signal, subprocess, sys, time
asked, command = getattr(signal, sys.argv[1]), sys.argv[2:]
def children_s(): # a script that became this python may have had some
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
earlier = children_s()
job = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=open("stderr.txt", "w"),
                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
tick = os.sysconf("SC_CLK_TCK")
def cpu_s():
    fields = open(f"/proc/{job.pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / tick
while job.poll() is None and cpu_s() < 0.3:
    time.sleep(0.01)
if job.poll() is not None:
    sys.exit("  ended by itself")
before = cpu_s()
job.send_signal(asked)
code = job.wait(60)
after = children_s() - earlier - before
if code != 130 or after > 0.1 + 2 / tick: # user and system time are rounded down to ticks
    sys.exit(f"  exit {code}, {after:.3f} s of work after the signal")
P
}
python3 - <<'P'
import random
random.seed(1)
with open("long.csv", "w") as f:
    f.write("id,latitude,longitude,time\n")
    for i in range(600_000):
        f.write(f"berg-{i},{random.uniform(45, 55):.4f},{random.uniform(-55, -45):.4f},2021-04-{1 + i % 28:02}T00:00:00Z\n")
with open("long.berg", "w") as f:
    f.write('{"format": "bergwatch-scenario", "version": 1, "icebergs": [' + ",".join('{"position_m": [0, %d]}' % i for i in range(1_000_000)) + "]}")
P
for signal in SIGINT SIGTERM; do
    check "$signal stops an import" stops $signal "$cli" import long.csv --output long.out
    check "$signal stops an import: says so" says "interrupted, nothing written"
    check "$signal stops the reading of a scenario" stops $signal "$cli" validate long.berg
done
check "what was stopped wrote nothing" test ! -e long.out
check "Ctrl-C of a bound keeps the flight" exits 130 interrupt "$cli" simulate "$source_dir/resources/scenarios/scoresby-sund-40.berg" --duration 300 --bound --output bounded
check "Ctrl-C of a bound keeps the flight: all files" test "$(ls bounded | wc -l)" -eq 5

# killed COMMAND...: at 20 instants; the set is whole and no temporary file stays. The renamings are
# made by a process of their own, which may need a moment after the program is dead.
killed() {
    python3 - "$@" <<'P'
import os, random, shutil, signal, subprocess, sys, time
random.seed(7)
for i in range(20):
    shutil.rmtree("killed", ignore_errors=True)
    job = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(random.uniform(0, 0.4))
    job.send_signal(signal.SIGKILL)
    job.wait()
    for wait in range(1000):
        names = os.listdir("killed") if os.path.isdir("killed") else []
        if len(names) in (0, 5) and not any(name.startswith(".") for name in names):
            break
        time.sleep(0.01)
    else:
        sys.exit(f"  left: {names}")
P
}
check "killed at any instant: five files or none" killed "$cli" simulate "$scenario" --duration 600 --output killed

all_checked
