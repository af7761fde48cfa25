#!/usr/bin/env bash
# Takes the pictures of the window in resources/pictures anew, by the program itself and without a display:
#   cmake/window_pictures.sh build/release/app/bergwatch
# Those of the study, of the export dialog and of looking back are taken by hand.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../resources"
export QT_QPA_PLATFORM=offscreen
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

picture() { # name scenario time_s [size [theme]]
    "$program" --config "$folder/settings" --screenshot "$folder/$1.png" --size "${4:-1280x800}" \
        --theme "${5:-light}" --at "$3" --wait 60 "scenarios/$2.berg"
    convert "$folder/$1.png" +dither -colors 256 "png8:pictures/$1.png"
}

picture window grand-banks-12 600
picture window-dark grand-banks-12 600 1920x1080 dark
picture world-wind barents-wind 300
picture world-lost bonavista-lost 520
picture world-leaving flemish-pass-appearing 930
picture world-clusters twillingate-clusters 200
picture world-asset hibernia-asset 900
picture world-endurance fram-strait-endurance 500
picture world-late jones-sound-late-plans 420
picture world-fleet melville-bay-three-uavs 300 1600x900
"$program" export scenarios/grand-banks-12.berg --format brief --output "$folder/brief.pdf"
pdftoppm -r 96 -png -singlefile "$folder/brief.pdf" "$folder/brief"
convert "$folder/brief.png" +dither -colors 256 png8:pictures/flight-brief.png
