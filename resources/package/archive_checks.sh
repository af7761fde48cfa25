#!/bin/sh
# The unpacked archive at work where nothing but an X server is installed: flies, replays, plans by the helper
# program, reads forecasts (wind.grib and wind.nc beside this script), exports, paints, shows its window, goes
# into the menus and out of them.
# Use: archive_checks.sh FOLDER
set -eu
folder=$1
scenario=$folder/share/bergwatch/scenarios/grand-banks-12.berg
work=$(mktemp -d)
cd "$work"
export HOME="$work/home" XDG_RUNTIME_DIR="$work/run"
mkdir -m 700 "$HOME" "$XDG_RUNTIME_DIR"
! touch "$folder/written" 2>/dev/null || {
    echo "$folder can be written to" >&2
    exit 1
}
cli() { "$folder/bergwatch-cli" "$@"; }

cli --version
cli simulate "$scenario" --output flown --quiet
cli simulate flown/run.bergrun --quiet | grep 'equal to the recorded run'
cli plan "$scenario" --backend cbc --formulation reduced --quiet | grep '^order '
cli validate "$folder"/share/bergwatch/scenarios/*.berg >valid.txt
for file in survey.plan survey.kmz brief.pdf map.svg; do
    cli export "$scenario" --output "$file"
    test -s "$file"
done
cli forecast "${0%/*}/wind.grib" | grep '^2026-05-01T06:00:00Z  *7.07  *315'
cli forecast "${0%/*}/wind.nc" | grep '^2026-05-01T06:00:00Z  *7.07  *315'
QT_QPA_PLATFORM=offscreen "$folder/bergwatch" --pictures painted flown/run.bergrun
test "$(wc -c <painted/map.png)" -gt 20000

# The window is there when it has changed a third of what the server shows.
mkdir screen
Xvfb :97 -noreset -screen 0 1280x800x24 -fbdir screen >xvfb.txt 2>&1 &
server=$!
window=
trap 'kill $window $server 2>/dev/null || true' EXIT
for i in $(seq 100); do
    test ! -S /tmp/.X11-unix/X97 || break
    sleep 0.1
done
cp screen/Xvfb_screen0 blank
DISPLAY=:97 "$folder/bergwatch" "$scenario" >window.txt 2>&1 &
window=$!
for i in $(seq 300); do
    kill -0 "$window"
    changed=$(cmp -l blank screen/Xvfb_screen0 | wc -l)
    test "$changed" -lt 1400000 || break
    sleep 0.1
done
test "$changed" -ge 1400000
sleep 2 # so that a picture of the screen has its plan
cp screen/Xvfb_screen0 /tmp/window.xwd
cat window.txt
test ! -s window.txt

prefix="$work/a prefix"
"$folder/install.sh" "$prefix"
grep -F "Exec=\"$folder/bergwatch\" %f" "$prefix/share/applications/org.bergwatch.bergwatch.desktop"
test -f "$prefix/share/mime/packages/bergwatch.xml"
test -f "$prefix/share/icons/hicolor/256x256/apps/bergwatch.png"
"$prefix/bin/bergwatch-cli" --version
"$folder/install.sh" --remove "$prefix"
test -z "$(find "$prefix" -type f -o -type l)"
echo "All passed."
