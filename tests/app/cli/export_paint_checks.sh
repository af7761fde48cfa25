#!/usr/bin/env bash
# Exports that are painted: bergwatch-cli leaves them to the program bergwatch, where there is one.
# Use: export_paint_checks.sh CLI SOURCE_DIR WORK_DIR BERGWATCH|none
. "$2/tests/app/cli/cli_support.sh"
bergwatch=$4
default="$source_dir/resources/scenarios/grand-banks-12.berg"

painted="brief map-pdf map-svg map-png log charts-pdf charts-svg charts-png"
check "a plan to be in the way" exits 0 "$cli" export "$default" --format plan --output plan.plan
# --- whether there is a bergwatch ------------------------------------------------------------
# A copy in a folder of its own, where each bergwatch is one that this script has put there.
mkdir -p alone/bin alone/path alone/bergwatch
cp "$cli" alone/bin/bergwatch-cli
alone() { env PATH="$work/alone/path" "$work/alone/bin/bergwatch-cli" "$@"; }
# stand_in FILE: a bergwatch that tells where it is and what it was given.
stand_in() {
    printf '#!/bin/sh\nprintf "%%s|" %s "$@"\nexit 7\n' "$1" >"$1"
    chmod +x "$1"
}
for format in $painted; do
    check "no $format without bergwatch" exits 1 alone export "$default" --format $format --output none.$format
    check "no $format without bergwatch: says so" says "--format $format: the program bergwatch paints this format, but it is neither"
    check "no $format without bergwatch: no file" test ! -e none.$format
done
check "without bergwatch a file is in the way all the same" exits 2 alone export "$default" --format brief --output plan.plan
check "without bergwatch the rest is exported" exits 0 alone export "$default" --format kml --output alone.kml
for place in alone/path alone/ alone/bin; do
    [ $place = alone/ ] && rmdir alone/bergwatch # a folder is passed over
    stand_in $place/bergwatch
    check "bergwatch in $place" exits 7 alone export "a b.berg" --what order --format brief --output "c d.pdf" --loiter 2
    check "bergwatch in $place: what it is given" test "$(cat stdout.txt)" = "$place/bergwatch|export|a b.berg|--what|order|--format|brief|--output|c d.pdf|--loiter|2|"
done
check "bergwatch is not asked for what the core writes" exits 0 alone export "$default" --format gpx --output alone.gpx
check "bergwatch is not asked to write over a file" exits 2 alone export "$default" --format brief --output plan.plan
check "bergwatch is not asked for a format that is none" exits 2 alone export "$default" --format briefs --output none.pdf

# --- what it paints --------------------------------------------------------------------------
if [ "$bergwatch" != none ]; then
    check "a run" exits 0 "$cli" simulate "$default" --output out
    for format in $painted; do
        check "export $format" exits 0 "$cli" export out/run.bergrun --format $format --output page.$format
        check "export $format: not empty" test -s page.$format
        check "export $format: says nothing but notes" test -z "$(grep -v '^note: ' stdout.txt stderr.txt)"
    done
    check "export brief again" exits 0 "$bergwatch" export out/run.bergrun --format brief --output again.pdf
    check "export brief again: the same bytes" cmp -s page.brief again.pdf
    for format in charts-pdf charts-svg charts-png; do
        check "no $format of a plan" exits 2 "$cli" export "$default" --format $format --output none.$format
    done
    cp page.brief before.pdf
    check "a brief does not write over a file" exits 2 "$bergwatch" export "$default" --format brief --output page.brief
    check "a brief does not write over a file: says so" says "page.brief exists; use --force to overwrite it"
    check "a brief does not write over a file: as before" cmp -s page.brief before.pdf
    check "a brief with --force" exits 0 "$cli" export "$default" --format brief --output page.brief --force
    check "a brief with --force: another one" test -s page.brief -a -z "$(cmp -s page.brief before.pdf && echo same)"
    check "a brief of an unknown UAV" exits 2 "$cli" export "$default" --format brief --uav nobody --output none.pdf
    check "a brief of an unknown UAV: says so" says "nobody"
    check "a map of a track of a plan" exits 2 "$cli" export "$default" --format map-svg --what track --output none.svg
    check "a brief into a folder that is none" exits 1 "$cli" export "$default" --format brief --output plan.plan/none.pdf
    check "a brief of a missing file" exits 3 "$cli" export missing.berg --format brief --output none.pdf
    check "a brief of a missing file: names it" says "missing.berg"
    python3 - "$default" two.berg <<'EDIT'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["uavs"] = [dict(scenario["uavs"][0], id=name) for name in ("uav-1", "uav-2")]
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
    check "a brief of two UAVs" exits 0 "$cli" export two.berg --format brief --output two.pdf
    check "a brief of two UAVs: one file" test -s two.pdf -a ! -e two-uav-1.pdf
    check "refused pages leave nothing" test -z "$(ls none.* plan.plan/none.* 2>/dev/null)"

    # The window's program says and writes the same as the command line's.
    check "bergwatch export --help" exits 0 "$bergwatch" export --help
    check "bergwatch export --help: formats" grep -q "charts-png" stdout.txt
    for format in plan kmz zeta-csv; do
        check "bergwatch-cli exports $format" exits 0 "$cli" export out/run.bergrun --format $format --output run.$format
        check "bergwatch exports $format" exits 0 "$bergwatch" export out/run.bergrun --format $format --output own.$format
        check "bergwatch exports $format: the same bytes" cmp -s own.$format run.$format
    done
    # alike NAME ARGUMENTS...: the same exit code and words of both.
    alike() {
        local name=$1 code
        shift
        "$cli" export "$@" >/dev/null 2>ours.txt
        code=$?
        check "$name: exit code" exits $code "$bergwatch" export "$@"
        check "$name: words" cmp -s <(sed 's/bergwatch-cli/bergwatch/g' ours.txt) stderr.txt
    }
    alike "no arguments in both"
    alike "an unknown format in both" "$default" --format docx --output none.docx
    alike "a number out of range in both" "$default" --format plan --altitude -3 --output none.plan
    alike "a missing file in both" missing.berg --format plan --output none.plan
    alike "an unknown option in both" "$default" --format brief --output none.pdf -platform xcb
    check "a page without a display" exits 0 env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$bergwatch" export "$default" --format map-png --output display.png
    check "a page where the display is none" exits 0 env DISPLAY=:none QT_QPA_PLATFORM=xcb "$bergwatch" export "$default" --format map-png --output display.png --force
fi

# --- Ctrl-C ----------------------------------------------------------------------------------
python3 - "$default" endless.berg <<'EDIT'
import json, random, sys
random.seed(8)
scenario = json.load(open(sys.argv[1]))
scenario["planner"] = {"backend": "exact"}
scenario["icebergs"] = [{"id": f"berg-{i}", "position_m": [random.uniform(0, 9000), random.uniform(0, 9000)],
                         "sigma0_m2": random.uniform(1, 10)} for i in range(100)]
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
for format in plan $([ "$bergwatch" = none ] || echo brief); do
    check "Ctrl-C of an export, $format" exits 130 interrupt "$cli" export endless.berg --format $format --output endless.out
    check "Ctrl-C of an export, $format: no file" test -z "$(ls endless.out* 2>/dev/null)"
done

all_checked
