#!/usr/bin/env bash
# Pages and pictures read back by programs that are not ours: pdfinfo, pdftotext and pdftoppm
# (poppler), xmllint and gdalinfo. What the flight brief says is compared with the table of the same.
# Use: export_page_readers.sh CLI SOURCE_DIR WORK_DIR PDFINFO PDFTOTEXT PDFTOPPM XMLLINT GDALINFO
set -u
cli=$1
scenarios=$2/resources/scenarios
work=$3
pdfinfo=$4
pdftotext=$5
pdftoppm=$6
xmllint=$7
gdalinfo=$8
here=$2/tests/app/readers
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
export LC_ALL=C.UTF-8
. "$here/reader_checks.sh"

# pages FILE, page_size FILE: of a PDF; the size in points.
pages() { "$pdfinfo" "$1" 2>>stderr.txt | sed -n 's/^Pages: *//p'; }
page_size() { "$pdfinfo" "$1" 2>>stderr.txt | sed -n 's/^Page size: *\([0-9.]*\) x \([0-9.]*\) pts.*/\1 \2/p'; }

# image_size FILE: in pixels, as GDAL reads it.
image_size() { "$gdalinfo" "$1" | sed -n 's/^Size is \([0-9]*\), \([0-9]*\)/\1 \2/p'; }

# painted FILE: how many bands of an image are those of a page with something on it: light most
# of it, with something dark.
painted() {
    "$gdalinfo" -stats --config GDAL_PAM_ENABLED NO "$1" |
        sed -n 's/.*Minimum=\([0-9.]*\), Maximum=\([0-9.]*\), Mean=\([0-9.]*\), StdDev=\([0-9.]*\).*/\1 \2 \3 \4/p' |
        awk '$1 < 128 && $2 > 240 && $3 > 128 && $4 > 5 { bands++ } END { print bands + 0 }'
}

# check_pdf NAME: one page that poppler reads without complaint and that is not blank.
check_pdf() {
    : >stderr.txt
    same "$1: pages" 1 "$(pages "$1.pdf")"
    run "$pdftoppm" -r 60 -png -singlefile "$1.pdf" "$1-rendered"
    same "$1: poppler's complaints" "" "$(cat stderr.txt)"
    same "$1: something is on the page" 3 "$(painted "$1-rendered.png")"
}

# check_picture NAME: NAME.pdf, NAME.svg and NAME.png are one picture of the same size.
check_picture() {
    check_pdf "$1"
    run "$xmllint" --noout --nonet "$1.svg"
    local box width height
    box=$("$xmllint" --xpath 'string(/*/@viewBox)' "$1.svg")
    read -r width height <<<"$(cut -d' ' -f3,4 <<<"$box")"
    same "$1: the SVG begins at its corner" "0 0" "$(cut -d' ' -f1,2 <<<"$box")"
    same "$1: size of the PNG" "$((2 * width)) $((2 * height))" "$(image_size "$1.png")"
    near "$1: width of the PDF" "$(awk "BEGIN { print $width * 0.75 }")" "$(page_size "$1.pdf" | cut -d' ' -f1)" 1
    near "$1: height of the PDF" "$(awk "BEGIN { print $height * 0.75 }")" "$(page_size "$1.pdf" | cut -d' ' -f2)" 1
    same "$1: something is in the PNG" 3 "$(painted "$1.png")"
    same "$1: something is in the SVG" yes \
        "$([ "$("$xmllint" --xpath 'count(//*[local-name()="path" or local-name()="polyline" or local-name()="text"])' "$1.svg")" -gt 20 ] && echo yes)"
}

# check_map NAME FILE OPTION...: the map in all three forms.
check_map() {
    local name=$1 file=$2 form
    shift 2
    for form in pdf svg png; do
        run "$cli" export "$file" --format map-$form --output "$name-map.$form" "$@"
    done
    check_picture "$name-map"
}

# check_brief NAME FILE READ OPTION...: READ is said to the reader of the table.
check_brief() {
    local name=$1 file=$2 read=$3
    shift 3
    run "$cli" export "$file" --format brief --output "$name-brief.pdf" "$@"
    run "$cli" export "$file" --format csv --output "$name.csv" "$@"
    check_pdf "$name-brief"
    near "$name: width of A4" 595.28 "$(page_size "$name-brief.pdf" | cut -d' ' -f1)" 1
    near "$name: height of A4" 841.89 "$(page_size "$name-brief.pdf" | cut -d' ' -f2)" 1
    run "$pdftotext" -layout "$name-brief.pdf" "$name.txt"
    run "$pdftotext" -bbox "$name-brief.pdf" "$name.words"
    same "$name: the table of the brief" ok \
        "$(python3 "$here/brief_reader.py" "$name.words" "$name.csv" "$file" "$read")"
}

# says NAME TEXT: how often the brief has it, yes or no.
says() { grep -qF -- "$2" "$1.txt" && echo yes || echo no; }

# check_scenario NAME FILE: both, of a scenario whose names are plain.
check_scenario() {
    check_brief "$1" "$2" names
    check_map "$1" "$2"
    local uav
    while IFS= read -r uav; do
        same "$1: the brief names $uav" yes "$(says "$1" "$uav")"
    done < <(number "$2" '"\n".join(u.get("name") or u["id"] for u in d["uavs"])')
    same "$1: the brief tells the wind" yes "$(says "$1" Wind)"
    same "$1: the brief names the scenario" yes "$(says "$1" "$(number "$2" 'd["name"]')")"
}

check_scenario disko "$scenarios/disko-bay-4.berg"
check_scenario fram "$scenarios/fram-strait-endurance.berg"
check_scenario melville "$scenarios/melville-bay-three-uavs.berg"
check_brief leg "$scenarios/disko-bay-4.berg" names --what first-leg
check_brief way "$scenarios/disko-bay-4.berg" names --return-home --loiter 2
same "way: home is in the brief" yes "$(says way Home)"

# The North Pole, the antimeridian, no start time, wind, and names that break files.
python3 - "$scenarios/disko-bay-4.berg" <<'EDIT'
import json, sys
def write(name, edit):
    scenario = json.load(open(sys.argv[1]))
    edit(scenario)
    json.dump(scenario, open(name, "w"))
def at(latitude_deg, longitude_deg):
    def edit(scenario):
        scenario["origin"] = {"latitude_deg": latitude_deg, "longitude_deg": longitude_deg}
        scenario["area_m"] = [[-5000, -5000], [9000, -5000], [9000, 9000], [-5000, 9000]]
    return edit
write("pole.berg", at(90, 0))
write("across.berg", at(70, 179.97))
write("timeless.berg", lambda scenario: scenario.pop("start_utc"))
write("windy.berg", lambda scenario: scenario.update(wind_mps=[6, -8]))
def hostile(scenario):
    names = ["<b>&amp; \"x\" 'y'", "two\nlines\tand, commas;", "\U0001F9CA \u05E7\u05E8\u05D7\u05D5\u05DF",
             "\u202Eback\u0001\u007F]]>"]
    scenario["name"] = names[0]
    scenario["uavs"][0]["name"] = names[3]
    for iceberg, name in zip(scenario["icebergs"], names):
        iceberg["name"] = name
write("hostile.berg", hostile)
def many(scenario):
    scenario["planner"] = {"policy": "nearest"}
    scenario["icebergs"] = [{"id": f"berg-{i}", "position_m": [700 * (i % 25), 700 * (i // 25)]}
                            for i in range(500)]
write("many.berg", many)
EDIT
for name in pole across timeless windy; do
    check_scenario $name $name.berg
done
same "windy: 10 m/s from 323 degrees" yes "$(grep -qE '10[.]0 m/s from 323' windy.txt && echo yes)"
check_brief hostile hostile.berg any
check_map hostile hostile.berg
same "hostile: the name of the scenario" yes "$(says hostile '<b>&amp; "x" '\''y'\''')"
same "hostile: a name of two lines on one" yes "$(says hostile 'two lines and, commas;')"

# 500 icebergs: still one page and one map.
check_brief many many.berg first
check_map many many.berg

# What was flown: map, charts and brief.
run "$cli" simulate "$scenarios/disko-bay-4.berg" --duration 200 --output flight
for form in pdf svg png; do
    run "$cli" export flight/run.bergrun --format charts-$form --output flown-charts.$form
done
check_picture flown-charts
check_map flown flight/run.bergrun
run "$cli" export flight/run.bergrun --format brief --output flown-brief.pdf
check_pdf flown-brief

# The log is one text on paper and in HTML.
for form in log log-html; do
    run "$cli" export flight/run.bergrun --format $form --output flown-$form
done
run "$pdftotext" -layout flown-log flown-log.txt
run "$xmllint" --noout --nonet flown-log-html
same "log: pages" 2 "$(pages flown-log)"
hash=$(grep -o '[0-9a-f]\{64\}' flown-log-html)
for part in "$hash" berg-1 berg-2 berg-3 berg-4 Sightings Deviations; do
    same "log: $part on paper" yes "$(says flown-log "$part")"
    same "log: $part in HTML" yes "$(grep -qF -- "$part" flown-log-html && echo yes)"
done

# Numbers as a German reads them; Qt needs no locale of the system for that.
run env -u LC_ALL LANG=de_DE.UTF-8 LC_CTYPE=C.UTF-8 "$cli" export windy.berg --format brief --output german-brief.pdf
run "$pdftotext" -layout german-brief.pdf german.txt
run "$pdftotext" -bbox german-brief.pdf german.words
same "german: the table of the brief" ok \
    "$(python3 "$here/brief_reader.py" german.words windy.csv windy.berg names)"
run env -u LC_ALL LANG=en_US.UTF-8 LC_CTYPE=C.UTF-8 "$cli" export windy.berg --format brief --output american.pdf
same "american: the paper is Letter" "612 792" "$(page_size american.pdf)"
same "german: commas" yes "$(says german '10,0 m/s')"
# The C library at work on German numbers, too: those of the command line keep their point.
mkdir -p locales
run localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8
run env LOCPATH="$PWD/locales" LC_ALL=de_DE.UTF-8 "$cli" export windy.berg --format brief --speed 21.5 --output point.pdf
run "$pdftotext" -layout point.pdf point.txt
same "german: an option with a point" yes "$(says point '21,5 m/s')"

all_checked
