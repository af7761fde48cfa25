#!/usr/bin/env bash
# GPX, KML, KMZ and CZML read back by programs that are not ours: xmllint, ogrinfo (GDAL), gpsbabel,
# unzip and the parsers of Python.
# Use: export_globe_readers.sh CLI SOURCE_DIR WORK_DIR OGRINFO GPSBABEL XMLLINT UNZIP
set -u
cli=$1
scenarios=$2/resources/scenarios
work=$3
ogrinfo=$4
gpsbabel=$5
xmllint=$6
unzip=$7
here=$2/tests/app/readers
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
export LC_ALL=C.UTF-8
. "$here/reader_checks.sh"

# features FILE LAYER: how many there are.
features() { "$ogrinfo" -so "$1" "$2" 2>/dev/null | sed -n 's/^Feature Count: //p'; }

# points FILE KIND: what gpsbabel reads; KIND is -w, -r or -t.
points() {
    "$gpsbabel" "$2" -i "${1##*.}" -f "$1" -o unicsv -F points.csv 2>stderr.txt
    [ -s points.csv ] && rows points.csv || echo 0
}

# check_maps NAME FILE WHAT: exports in every format and reads it.
check_maps() {
    local name=$1 file=$2 what=$3 format icebergs visits
    for format in gpx kml kmz czml csv; do
        run "$cli" export "$file" --format $format --what "$what" --output "$name.$format"
    done
    icebergs=$(number "$file" 'len(d["icebergs"])')
    local assets
    assets=$(number "$file" 'int("asset" in d)')
    for format in gpx kml; do
        run "$xmllint" --noout "$name.$format"
        run python3 "$here/xml_order.py" "$name.$format"
    done
    run python3 -c 'import json, sys; assert json.load(open(sys.argv[1]))[0]["version"] == "1.0"' "$name.czml"
    same "$name: waypoints of icebergs, home and asset" $((icebergs + 1 + assets)) \
        "$(features "$name.gpx" waypoints)"
    same "$name: waypoints in gpsbabel" $((icebergs + 1 + assets)) "$(points "$name.gpx" -w)"
    same "$name: one route" 1 "$(features "$name.gpx" routes)"
    same "$name: icebergs of the globe" "$icebergs" "$(features "$name.kml" Icebergs)"
    same "$name: the archive is whole" 0 "$("$unzip" -tq "$name.kmz" >/dev/null 2>&1; echo $?)"
    same "$name: the archive holds the same" "" \
        "$("$unzip" -p "$name.kmz" doc.kml | cmp - "$name.kml" 2>&1)"
    same "$name: GDAL opens the archive" "$icebergs" "$(features "$name.kmz" Icebergs)"
    if [ "$what" = path ]; then
        same "$name: points of the path" "$(rows "$name.csv")" "$(points "$name.gpx" -t)"
    else
        visits=$(rows "$name.csv")
        same "$name: start and visits of the route" $((visits + 1)) "$(points "$name.gpx" -r)"
    fi
}

check_maps disko "$scenarios/disko-bay-4.berg" order
check_maps disko-path "$scenarios/disko-bay-4.berg" path
check_maps barents "$scenarios/barents-wind.berg" path
check_maps fram "$scenarios/fram-strait-endurance.berg" path
check_maps flemish "$scenarios/flemish-pass-appearing.berg" order

# The North Pole, the antimeridian, no start time, and 500 icebergs.
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
def many(scenario):
    scenario["planner"] = {"policy": "nearest"}
    scenario["icebergs"] = [{"id": f"berg-{i}", "position_m": [700 * (i % 25), 700 * (i // 25)]}
                            for i in range(500)]
write("many.berg", many)
def hostile(scenario):
    names = ["<b>&amp; \"x\" 'y'", "two\nlines\tand, commas;", "\U0001F9CA \u05E7\u05E8\u05D7\u05D5\u05DF",
             "\u202Eback\u0001\u007F]]>"]
    scenario["name"] = names[0]
    scenario["uavs"][0]["name"] = names[3]
    for iceberg, name in zip(scenario["icebergs"], names):
        iceberg["name"] = name
write("hostile.berg", hostile)
EDIT
for name in pole across timeless; do
    check_maps $name $name.berg order
    check_maps $name-path $name.berg path
done
check_maps many many.berg order
check_maps hostile hostile.berg path
same "timeless: no dates" 0 \
    "$(cat timeless-path.gpx timeless-path.kml | grep -cE '<(time|when)>')"
same "disko-path: a date for each point" "$(($(rows disko-path.csv) + 8))" \
    "$(grep -o '<when>' disko-path.kml | wc -l)" # 4 icebergs and 4 visits have theirs

# Every name is read as it was, but for what no XML may hold and line ends.
same "hostile: names in GPX" "ok" "$(python3 - hostile.berg hostile.gpx hostile.kml <<'NAMES'
import json, sys, xml.etree.ElementTree as tree
def shown(name):
    out = ""
    for c in name:
        out += " " if c in "\n\t\r" else "\ufffd" if ord(c) < 32 or 127 <= ord(c) < 160 else c
    return out
icebergs = [shown(i["name"]) for i in json.load(open(sys.argv[1]))["icebergs"]]
gpx = [w.find("{*}name").text for w in tree.parse(sys.argv[2]).getroot().findall("{*}wpt")
       if w.find("{*}type").text == "iceberg"]
kml = [p.find("{*}name").text for p in tree.parse(sys.argv[3]).getroot().iter("{http://www.opengis.net/kml/2.2}Placemark")
       if p.find("{*}styleUrl").text == "#iceberg"]
print("ok" if icebergs == gpx == kml else (icebergs, gpx, kml))
NAMES
)"

# A fleet: a way for each UAV, in one file or a file each.
fleet=$scenarios/svalbard-two-uavs.berg
for format in gpx kml csv plan; do
    run "$cli" export "$fleet" --format $format --what path --output fleet.$format
done
same "fleet: routes" 2 "$(features fleet.gpx routes)"
same "fleet: tracks" 2 "$(features fleet.gpx tracks)"
same "fleet: points of both" "$(rows fleet.csv)" "$(points fleet.gpx -t)"
same "fleet: plans" "$(number "$fleet" '" ".join(sorted("fleet-" + u["id"] + ".plan" for u in d["uavs"]))')" \
    "$(ls fleet-*.plan | sort | paste -sd' ')"

# What was flown, with its times.
run "$cli" simulate "$scenarios/disko-bay-4.berg" --duration 200 --output flight
for format in gpx kml csv; do
    run "$cli" export flight/run.bergrun --format $format --output flown.$format
done
same "flown: points of the track" "$(rows flown.csv)" "$(points flown.gpx -t)"
same "flown: the track in GDAL" "$(rows flown.csv)" "$(features flown.gpx track_points)"
same "flown: first time" "$(number "$scenarios/disko-bay-4.berg" 'd["start_utc"]' | tr -d Z | tr T ' ')" \
    "$("$gpsbabel" -t -i gpx -f flown.gpx -o unicsv,utc=0 -F - 2>/dev/null | sed -n 2p |
        grep -oE '[0-9]{4}/[0-9]{2}/[0-9]{2},[0-9:]{8}' | tr '/,' '- ')"
same "flown: the globe's track" 1 "$("$ogrinfo" -al flown.kml | grep -c 'LINESTRING')"

all_checked
