#!/usr/bin/env bash
# Writes the manual as web pages and PDF, with pictures of the program as it is, in both languages:
#   cmake/manual.sh build/release/app/bergwatch OUTPUT_FOLDER
# Needs no display and nothing but the program; the same program makes the same files.
set -euo pipefail
program=$(realpath "$1")
scenarios=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../resources/scenarios")
rm -rf "$2"
mkdir -p "$2"
output=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset LC_ALL LC_MESSAGES LC_NUMERIC LANGUAGE
export QT_QPA_PLATFORM=offscreen TZ=UTC

picture() { # name scenario time_s size
    "$program" --config "$folder/settings" --screenshot "$output/$language/$1.png" --size "$4" --at "$3" \
        "$scenarios/$2.berg"
}

for language in en nb; do
    case $language in
        en) export LANG=en_GB.UTF-8 ;;
        nb) export LANG=nb_NO.UTF-8 ;;
    esac
    mkdir "$output/$language"
    picture window grand-banks-12 600 1280x800
    picture lost bonavista-lost 520 1280x800
    picture asset hibernia-asset 900 1280x800
    picture fleet melville-bay-three-uavs 300 1280x800
    "$program" --pictures "$folder/$language" --size 1280x560 "$scenarios/grand-banks-12.berg" >/dev/null
    cp "$folder/$language/zeta.png" "$output/$language/"
    "$program" --manual "$output/$language" >/dev/null
done
