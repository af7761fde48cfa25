#!/usr/bin/env bash
# Writes the manual as web pages and PDF, with pictures of the program as it is, in both languages:
#   cmake/manual.sh build/release/app/bergwatch build/release/app/cli/bergwatch-cli OUTPUT_FOLDER
# Needs no display. The same programs make the same files.
set -euo pipefail
program=$(realpath "$1")
cli=$(realpath "$2")
scenarios=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../resources/scenarios")
rm -rf "$3"
mkdir -p "$3"
output=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset LC_ALL LC_MESSAGES LC_NUMERIC LANGUAGE
export QT_QPA_PLATFORM=offscreen TZ=UTC

drawn() { # name scenario time_s map|zeta size: map or chart of a flight until then
    "$cli" simulate "$scenarios/$2.berg" --duration "$3" --output "$folder/$1-$language" --quiet >/dev/null
    "$program" --pictures "$folder/$1-$language/drawn" --size "$5" "$folder/$1-$language/run.bergrun" >/dev/null
    cp "$folder/$1-$language/drawn/$4.png" "$output/$language/$1.png"
}

for language in en nb; do
    case $language in
        en) export LANG=en_GB.UTF-8 ;;
        nb) export LANG=nb_NO.UTF-8 ;;
    esac
    mkdir "$output/$language"
    "$program" --config "$folder/settings" --screenshot "$output/$language/window.png" --at 600 --wait 60 \
        "$scenarios/grand-banks-12.berg"
    drawn lost bonavista-lost 520 map 1280x800
    drawn asset hibernia-asset 900 map 1280x800
    drawn fleet melville-bay-three-uavs 300 map 1280x800
    drawn zeta grand-banks-12 1000 zeta 1280x560
    "$program" --manual "$output/$language" >/dev/null
done
