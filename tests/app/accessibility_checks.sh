#!/usr/bin/env bash
# The window as a screen reader knows it, under an X server, a message bus and a registry of its own.
# Use: accessibility_checks.sh BERGWATCH SOURCE_DIR WORK_DIR PYTHON
set -euo pipefail
program=$1
project=$2
output=$3
python=$4
walk=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/accessibility_walk.py
rm -rf "$output"
mkdir -p "$output"/{home,config,data,cache}
# Sockets have short names only, and a bus leaves nothing behind in a folder that goes.
runtime=$(mktemp -d)
chmod 700 "$runtime"
server=
cleanUp() {
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    rm -rf "$runtime"
}
trap cleanUp EXIT
# Nothing of the user's desktop: neither its bus, nor its settings, nor its language.
export HOME=$output/home XDG_RUNTIME_DIR=$runtime XDG_CONFIG_HOME=$output/config
export XDG_DATA_HOME=$output/data XDG_CACHE_HOME=$output/cache
unset LC_ALL LC_MESSAGES LANGUAGE DBUS_SESSION_BUS_ADDRESS AT_SPI_BUS_ADDRESS WAYLAND_DISPLAY
unset NO_AT_BRIDGE QT_ACCESSIBILITY QT_SCALE_FACTOR
export LANG=C.UTF-8 QT_QPA_PLATFORM=xcb QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1
# The server finds a free display; the end of its line says that it is up.
mkfifo "$runtime/display"
Xvfb -displayfd 3 -screen 0 1920x1080x24 -nolisten tcp 3>"$runtime/display" >"$output/server" 2>&1 &
server=$!
read -r display <"$runtime/display"
export DISPLAY=:$display
dbus-run-session -- "$python" "$walk" "$program" \
    "$project/resources/scenarios/grand-banks-12.berg" "$output" 2>"$output/messages" || {
    tail -n 40 "$output/messages" >&2
    exit 1
}
