# Checks that the scripts for the command line share; sourced. Each runs a program as a stranger would
# and looks at what comes out. Needs bash and python3 only, so that it also runs where there is no Qt.
# The scripts are called as SCRIPT CLI SOURCE_DIR WORK_DIR ... and work in that folder, empty at first.
set -u
export LC_ALL=C.UTF-8
cli=$1
source_dir=$2
work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
checks=0
failures=0
# Where python3 is a script that looks for python, that takes longer than most checks.
python=$(python3 -c 'import sys; print(sys.executable)')
python3() { "$python" "$@"; }

# check NAME CONDITION...: counts and names a failed check.
check() {
    local name=$1
    shift
    checks=$((checks + 1))
    if ! "$@"; then
        failures=$((failures + 1))
        echo "FAILED: $name"
    fi
}

# exits CODE COMMAND...: runs quietly, true when it ends with that code.
exits() {
    local wanted=$1
    shift
    "$@" >stdout.txt 2>stderr.txt
    local got=$?
    [ "$got" -eq "$wanted" ] && return 0
    echo "  exit $got in place of $wanted: $*"
    sed 's/^/  /' stderr.txt | head -5
    return 1
}

# json EXPRESSION: evaluates a python expression on `d`, the document in stdout.txt.
json() {
    python3 -c 'import json,sys; d=json.load(open("stdout.txt")); sys.exit(0 if eval(sys.argv[1]) else 1)' "$1"
}

says() { grep -qF -- "$1" stderr.txt; }

# interrupt COMMAND...: exit code of one that gets Ctrl-C after a second, five under sanitizers.
# From python: a shell lets its background jobs ignore the signal.
interrupt() {
    python3 - "$@" <<'P'
import os, signal, subprocess, sys, time
job = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
time.sleep(5 if "ASAN_OPTIONS" in os.environ else 1)
job.send_signal(signal.SIGINT)
sys.exit(job.wait(60))
P
}

# all_checked: the last line of a script; fails when a check did.
all_checked() {
    echo "$((checks - failures)) passed, $failures failed"
    [ "$failures" -eq 0 ]
}
