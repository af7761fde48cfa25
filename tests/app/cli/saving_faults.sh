#!/usr/bin/env bash
# Saving while something goes wrong: after it, each file is the old one or the new one, whole, those that
# belong together are of one kind, and no temporary file stays. Prints a table.
# Use: saving_faults.sh CLI SOURCE_DIR WORK_DIR [KILLS]
. "$2/tests/app/cli/cli_support.sh"
kills=${4:-20}
cp "$source_dir/resources/scenarios/disko-bay-4.berg" four.berg

# The old files, and the new ones as they are to be.
check "old files" exits 0 "$cli" simulate four.berg --duration 60 --output old
check "new files" exits 0 "$cli" simulate four.berg --duration 900 --output new
# Where file systems can be made: one of 256 kB, and one that is read only.
mounted=no
mkdir -p small protected
if mount -t tmpfs -o size=256k bergwatch "$PWD/small" 2>/dev/null; then
    mounted=yes
    mount -t tmpfs bergwatch "$PWD/protected"
    trap 'umount "$PWD/small" "$PWD/protected"' EXIT
fi

printf '%-34s %5s %8s %8s %8s\n' fault tries old new neither
# row NAME TRIES: from `seen`, a line for each try; with neither there is a fault.
row() {
    local old new neither
    old=$(grep -cx old seen)
    new=$(grep -cx new seen)
    neither=$((${2} - old - new))
    printf '%-34s %5s %8s %8s %8s\n' "$1" "$2" "$old" "$new" "$neither"
    check "$1" test "$neither" -eq 0
    : >seen
}
# look FOLDER: what is in it now; who puts files in their places has a moment.
look() {
    local i
    for i in $(seq 50); do
        [ "$(ls -A "$1" | sort | tr '\n' ' ')" = "$(ls -A old | sort | tr '\n' ' ')" ] &&
            { same_as "$1" old && echo old && return; same_as "$1" new && echo new && return; }
        sleep 0.02
    done
    echo "neither: $(ls -A "$1" | tr '\n' ' ')" | tee -a neither.txt
}
same_as() { diff -rq "$1" "$2" >/dev/null; }
: >seen

simulate=("$cli" simulate four.berg --duration 900 --force --quiet --output)
if [ "$mounted" = yes ]; then
    cp old/* small/
    "${simulate[@]}" small 2>stderr.txt >/dev/null
    check "full disk: exit 1" test $? -eq 1
    check "full disk: says so" says "No space left on device"
    look small >>seen
    row "full disk" 1
    cp old/* protected/
    mount -o remount,ro "$PWD/protected"
    "${simulate[@]}" protected 2>stderr.txt >/dev/null
    check "read-only file system: exit 1" test $? -eq 1
    look protected >>seen
    row "read-only file system" 1
fi
for limit in 1 2 4 8 16 32 64 128 256 512; do
    rm -rf kept
    cp -r old kept
    (ulimit -f $limit; exec "${simulate[@]}" kept) >/dev/null 2>stderr.txt
    look kept >>seen
done
row "quota, from 1 to 512 kB" 10
rm -rf kept
cp -r old kept
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w kept/*
    "${simulate[@]}" kept 2>stderr.txt >/dev/null
    look kept >>seen
    chmod u+w kept/*
    row "files that are read-only" 1
fi
# EIO, and whatever else a system call may answer: in place of the library's own.
if command -v strace >/dev/null; then
    for fault in write:EIO fsync:EIO write:ENOSPC linkat:EACCES rename:EACCES; do
        for nth in 1 3 6 9; do
            rm -rf kept
            cp -r old kept
            strace -qq -o trace.txt -f -e "trace=${fault%:*}" \
                -e "inject=${fault%:*}:error=${fault#*:}:when=$nth+" "${simulate[@]}" kept >/dev/null 2>stderr.txt
            look kept >>seen
        done
        row "${fault#*:} from ${fault%:*}" 4
    done
fi

if [ "$mounted" = no ]; then
    echo "Not tried: full disk and read-only file system, which only root can make"
fi
if ! command -v strace >/dev/null; then
    echo "Not tried: faults of system calls, for which strace is missing"
fi

# kill -9 at random instants, the later half in the milliseconds of writing.
# A folder each: who puts the files in their places outlives the program.
python3 - "$kills" "${simulate[@]}" <<'P' >seen
import filecmp, os, random, shutil, signal, subprocess, sys, time
kills, command = int(sys.argv[1]), sys.argv[2:]
random.seed(os.getpid())
def start(kept):
    shutil.copytree("old", kept)
    return subprocess.Popen(command + [kept], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
def state(kept):
    names = sorted(os.listdir("old"))
    for kind in ("old", "new"):
        if sorted(os.listdir(kept)) == names and filecmp.cmpfiles(kept, kind, names, shallow=False)[0] == names:
            return kind
    return "neither: " + " ".join(sorted(os.listdir(kept)))
begin = time.monotonic()
start("whole").wait()
whole_s = time.monotonic() - begin
for i in range(kills):
    kept = f"kept-{i}"
    job = start(kept)
    time.sleep(whole_s * (random.random() if i % 2 else random.uniform(0.8, 1.05)))
    job.send_signal(signal.SIGKILL)
    job.wait()
    found = state(kept)
    until = time.monotonic() + 2
    while found.startswith("neither") and time.monotonic() < until:
        time.sleep(0.01)
        found = state(kept)
    print(found)
P
grep -h neither seen
row "kill -9" "$kills"

all_checked
