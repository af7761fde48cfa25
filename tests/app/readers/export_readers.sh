#!/usr/bin/env bash
# Exports read back by programs that are not ours: ogrinfo (GDAL) and gpsbabel. What they report is
# compared with the scenario file and with the other export formats.
# Use: export_readers.sh CLI SOURCE_DIR WORK_DIR OGRINFO GPSBABEL
set -u
cli=$1
scenarios=$2/resources/scenarios
work=$3
ogrinfo=$4
gpsbabel=$5
rm -rf "$work"
mkdir -p "$work"
cd "$work" || exit 1
export LC_ALL=C.UTF-8
. "$2/tests/app/readers/reader_checks.sh"

# kinds FILE: how many features of each kind and geometry.
kinds() {
    ask "$1" "SELECT kind || ' ' || GeometryType(geometry) || ' ' || count(*) AS a
              FROM $(basename "$1" .geojson) GROUP BY kind, GeometryType(geometry) ORDER BY kind" |
        tr '\n' ';'
}

# check_plan NAME SCENARIO AREA LINE: exports and reads the plan; AREA and LINE are the kinds
# expected of those two.
check_plan() {
    local name=$1 scenario=$2 area=$3 line=$4
    local format
    for format in geojson csv wpl plan; do
        run "$cli" export "$scenario" --format "$format" --output "$name.$format"
    done
    local visits icebergs
    visits=$(rows "$name.csv")
    icebergs=$(number "$scenario" 'len(d["icebergs"])')
    same "$name: features" \
        "${area}iceberg POINT $icebergs;plan $line 1;uav POINT 1;visit POINT $visits;" \
        "$(kinds "$name.geojson")"
    same "$name: every geometry is valid" 0 \
        "$(ask "$name.geojson" "SELECT count(*) AS a FROM $name WHERE NOT ST_IsValid(geometry)")"
    same "$name: WGS 84" 1 "$("$ogrinfo" -al -so "$name.geojson" | grep -c 'ID\["EPSG",4326\]')"
    same "$name: ids in order" "$(tail -n +2 "$name.csv" | cut -d, -f2)" \
        "$(ask "$name.geojson" "SELECT iceberg FROM $name WHERE kind = 'visit' ORDER BY sequence")"
    near "$name: latitude of the UAV is home's of the waypoint file" \
        "$(sed -n 2p "$name.wpl" | cut -f9)" \
        "$(ask "$name.geojson" "SELECT ST_Y(geometry) AS a FROM $name WHERE kind = 'uav'")" 1e-8
    local row
    for row in 1 "$visits"; do
        local at="FROM $name WHERE kind = 'visit' AND sequence = $row"
        near "$name: latitude of visit $row" "$(field "$name.csv" "$row" 6)" \
            "$(ask "$name.geojson" "SELECT ST_Y(geometry) AS a $at")" 1e-8
        near "$name: longitude of visit $row" "$(field "$name.csv" "$row" 7)" \
            "$(ask "$name.geojson" "SELECT ST_X(geometry) AS a $at")" 1e-8
        near "$name: time of visit $row" "$(field "$name.csv" "$row" 5)" \
            "$(ask "$name.geojson" "SELECT time_s $at")" 0.001
        near "$name: latitude in the waypoint file" "$(field "$name.csv" "$row" 6)" \
            "$(sed -n "$((row + 4))p" "$name.wpl" | cut -f9)" 1e-8
        near "$name: longitude in the .plan" "$(field "$name.csv" "$row" 7)" \
            "$(number "$name.plan" "d['mission']['items'][$((row + 1))]['params'][5]")" 1e-8
    done
    same "$name: rows of the waypoint file" $((visits + 5)) "$(wc -l <"$name.wpl")"
    same "$name: items of the .plan" $((visits + 3)) "$(number "$name.plan" 'len(d["mission"]["items"])')"
    "$ogrinfo" -al -so -oo AUTODETECT_TYPE=YES -oo X_POSSIBLE_NAMES=longitude_deg \
        -oo Y_POSSIBLE_NAMES=latitude_deg "$name.csv" >table.txt
    same "$name: table read as points" "Geometry: Point,Feature Count: $visits" \
        "$(grep -E '^(Geometry|Feature Count)' table.txt | paste -sd,)"
    same "$name: numbers of the table are numbers" 0 \
        "$(grep -E '_(m|s|deg|m2): ' table.txt | grep -cvE 'Real|Integer')"
}

# Plans: high latitude, wind, an area, icebergs that appear later, and across the antimeridian.
check_plan disko "$scenarios/disko-bay-4.berg" "" LINESTRING
check_plan barents "$scenarios/barents-wind.berg" "" LINESTRING
check_plan fram "$scenarios/fram-strait-endurance.berg" "area POLYGON 1;" LINESTRING
check_plan flemish "$scenarios/flemish-pass-appearing.berg" "area POLYGON 1;" LINESTRING
python3 - "$scenarios/disko-bay-4.berg" across.berg <<'EDIT'
import json, sys
scenario = json.load(open(sys.argv[1]))
xs = [iceberg["position_m"][0] for iceberg in scenario["icebergs"]]
middle_m = (min(xs) + scenario["uavs"][0]["position_m"][0]) / 2
# The antimeridian lies between the UAV and the icebergs: 38.2 km to a degree at 70 N.
scenario["origin"] = {"latitude_deg": 70, "longitude_deg": 180 - middle_m / 38188}
scenario["area_m"] = [[-5000, -5000], [9000, -5000], [9000, 9000], [-5000, 9000]]
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
check_plan across across.berg "area MULTIPOLYGON 1;" MULTILINESTRING
same "across: parts of the area" 2 \
    "$(ask across.geojson "SELECT ST_NumGeometries(geometry) AS a FROM across WHERE kind = 'area'")"

# The times of the line are those of ISO 8601 when the scenario has a start.
same "disko: first time of the plan" "$(number "$scenarios/disko-bay-4.berg" 'd["start_utc"]')" \
    "$(ask disko.geojson "SELECT coordinateProperties FROM disko WHERE kind = 'plan'" |
        grep -o '"[0-9]*-[^"]*Z"' | head -1 | tr -d '"')"

# gpsbabel takes points as waypoints and the line as a route.
"$gpsbabel" -i geojson -f disko.geojson -o unicsv -F points.csv 2>stderr.txt
same "disko: waypoints in gpsbabel" $(($(rows disko.csv) + 5)) "$(rows points.csv)"
"$gpsbabel" -r -i geojson -f disko.geojson -o unicsv -F route.csv 2>stderr.txt
same "disko: route points in gpsbabel" \
    "$(ask disko.geojson "SELECT ST_NumPoints(geometry) AS a FROM disko WHERE kind = 'plan'")" \
    "$(rows route.csv)"
near "disko: last latitude of the route" "$(field disko.csv "$(rows disko.csv)" 6)" \
    "$(tail -1 route.csv | cut -d, -f2)" 1e-6

# A run.
run "$cli" simulate "$scenarios/disko-bay-4.berg" --duration 200 --output flight
for format in geojson csv wpl plan; do
    run "$cli" export flight/run.bergrun --format "$format" --output "flown.$format"
done
same "flown: the table is the trajectory of the run" "" "$(cmp flown.csv flight/trajectory.csv 2>&1)"
reached=$(grep -c ',reached,' flight/events.csv)
same "flown: features" "iceberg POINT 4;track LINESTRING 1;uav POINT 1;visit POINT $reached;" \
    "$(kinds flown.geojson)"
same "flown: points of the track" "$(rows flown.csv)" \
    "$(ask flown.geojson "SELECT ST_NumPoints(geometry) AS a FROM flown WHERE kind = 'track'")"
near "flown: last latitude" "$(tail -1 flown.csv | cut -d, -f5)" \
    "$(ask flown.geojson "SELECT ST_Y(ST_EndPoint(geometry)) AS a FROM flown WHERE kind = 'track'")" 1e-8
near "flown: last longitude" "$(tail -1 flown.csv | cut -d, -f6)" \
    "$(ask flown.geojson "SELECT ST_X(ST_EndPoint(geometry)) AS a FROM flown WHERE kind = 'track'")" 1e-8
near "flown: zeta" "$(tail -1 flight/zeta.csv | cut -d, -f3)" \
    "$(ask flown.geojson "SELECT zeta_m2s FROM flown WHERE kind = 'track'")" 1e-6
same "flown: items of the .plan" $((reached + 3)) "$(number flown.plan 'len(d["mission"]["items"])')"
same "flown: rows of the waypoint file" $((reached + 5)) "$(wc -l <flown.wpl)"
# unicsv takes every column that begins with "time" for a date, so the columns are named to it.
tail -n +2 flown.csv |
    "$gpsbabel" -i unicsv,fields=ignore+name+ignore+ignore+lat+lon -f - -o unicsv -F track.csv 2>stderr.txt
same "flown: track points in gpsbabel" "$(rows flown.csv)" "$(rows track.csv)"
near "flown: last longitude in gpsbabel" "$(tail -1 flown.csv | cut -d, -f6)" \
    "$(tail -1 track.csv | cut -d, -f3)" 1e-6

all_checked
