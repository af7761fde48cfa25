#!/usr/bin/env bash
# What the command line takes of processor and memory, for what is long and what is hostile.
# Not under sanitizers, which take many times as much.
# Use: resource_checks.sh CLI SOURCE_DIR WORK_DIR FUZZ_READERS
. "$2/tests/app/cli/cli_support.sh"
readers=$4

# within SECONDS MB COMMAND...: takes no more of either, whatever it ends with.
within() {
    python3 - "$@" <<'P'
import resource, subprocess, sys
seconds, megabytes, command = float(sys.argv[1]), float(sys.argv[2]), sys.argv[3:]
limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
code = subprocess.run(command, stdout=open("stdout.txt", "wb"), stderr=open("stderr.txt", "wb"),
                      preexec_fn=limit).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
took_s, took_mb = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
if code < 0 or took_s > seconds or took_mb > megabytes:
    sys.exit(f"  exit {code}, {took_s:.1f} s and {took_mb:.0f} MB, not {seconds} s and {megabytes} MB")
P
}

# --- a long flight -----------------------------------------------------------------------------
# 240 MB of tables are written while it is flown.
python3 - <<'P'
import json, random
random.seed(1)
place = lambda: [random.uniform(-2e4, 2e4), random.uniform(-2e4, 2e4)]
bergs = [{"id": f"b{i}", "position_m": place(), "velocity_mps": [0.1, 0.05]} for i in range(300)]
json.dump({"format": "bergwatch-scenario", "version": 1, "duration_s": 12000, "icebergs": bergs,
           "uavs": [{"id": "u", "position_m": [0, 0]}], "planner": {"policy": "nearest"}}, open("long.berg", "w"))
P
check "a long flight" within 60 120 "$cli" simulate long.berg --output long
check "a long flight: all of it" test "$(wc -l <long/sigma.csv)" -eq 3600301
mv long before
cp -r before long
check "a long flight over another" within 60 120 "$cli" simulate long.berg --output long --force
check "a long flight over another: the same" diff -rq long before
check "a long flight replayed" within 60 120 "$cli" simulate before/run.bergrun --output again
check "a long flight replayed: the same" diff -rq again before
rm -rf long before again
# A week, the longest there is: what is exported is written while the run is flown again.
sed 's/"duration_s": 12000/"duration_s": 604800, "dt_s": 1/' long.berg |
    python3 -c 'import json, sys; d = json.load(sys.stdin); d["icebergs"] = d["icebergs"][:3]; print(json.dumps(d))' >week.berg
check "a week" within 60 100 "$cli" simulate week.berg --output week
for table in sigma zeta; do
    check "a week's $table exported" within 60 100 "$cli" export week/run.bergrun --format $table-csv --output $table.csv
    check "a week's $table exported: the same" cmp -s $table.csv week/$table.csv
done
for format in plan wpl csv geojson gpx kml kmz czml; do
    check "a week exported as $format" within 60 100 "$cli" export week/run.bergrun --format $format --output week.$format
done
check "a week exported as csv: the same" cmp -s week.csv week/trajectory.csv
rm -rf week week.* sigma.csv zeta.csv

# --- files that are large, deep, wide, long, or a product -------------------------------------------
# Reading takes ten times the file and 50 MB at most, beside the 10 MB of the program and
# the 20 MB of the libraries that read forecasts and photographs, in linear time
# (core/io/text/read_budget.h).
python3 - <<'P'
def put(name, text):
    with open(name, "w") as file:
        file.write(text)
many = 400_000
head = '{"format": "bergwatch-%s", "version": 1, "x": '
for kind, ending in (("scenario", "berg"), ("run", "bergrun"), ("study", "bergstudy"), ("problem", "json")):
    start = head % kind
    put(f"deep.{ending}", start + '[{"a":' * 5_000_000)
    put(f"objects.{ending}", start + "[" + ",".join(['{"a":' * 25 + "1" + "}" * 25] * (many // 8)) + "]}")
    put(f"lists.{ending}", start + "[" + ",".join(["[" * 30 + "]" * 30] * (many // 4)) + "]}")
    put(f"numbers.{ending}", start + "[" + "0," * (8 * many) + "0]}")
    put(f"members.{ending}", start + "{" + ",".join(f'"{i}":1' for i in range(2 * many)) + "}}")
    put(f"same.{ending}", start + "{" + ",".join(['"a":1'] * (2 * many)) + "}}")
    put(f"text.{ending}", start + '"' + "x" * 20_000_000 + '"}')
    put(f"texts.{ending}", start + "[" + ",".join(['""'] * (4 * many)) + "]}")
    put(f"escapes.{ending}", start + '"' + "\\u0041" * 2_000_000 + '"}')
    put(f"faults.{ending}", (head % kind)[:-5] + '"icebergs": [' + ",".join(['{"sigma0_m2": "x"}'] * many) + "]}")
    put(f"unknown.{ending}", start + "1" + "".join(f', "y{i}": 1' for i in range(many)) + "}")
# Lists of what takes far more memory than its text, and so many that each must be looked at quickly.
uav = '{"id": "u%d", "position_m": [0, %d]}'
scenario = '{"format": "bergwatch-scenario", "version": 1, "uavs": [%s], "icebergs": [{"id": "b", "position_m": [100, 100]%s}]}'
run = (head % "run")[:-5] + '"scenario": %s, "options": {}, "flown_until_s": 900, "metrics": {}, "%s": [%s]}'
one = scenario % (uav % (0, 0), "")
hundred = scenario % (",".join(uav % (i, 100 * i) for i in range(100)), "")
track = ', "track": {"time_s": [%s], "position_m": [%s]}' % (",".join(map(str, range(-10_000, 0))), ",".join(["[0,0]"] * 10_000))
put("changes.bergrun", run % (one, "interventions", ",".join(["{}"] * many)))
put("winds.bergrun", run % (hundred, "interventions", ",".join(['{"time_s":0,"wind_mps":[0,0]}' + " " * 200] * (many // 2))))
put("appears.bergrun", run % (scenario % (uav % (0, 0), track), "interventions", ",".join(['{"time_s":0,"appears":{"position_m":[0,0]}}'] * many)))
put("plans.bergrun", run % (one, "plans", ",".join(["{}"] * many)))
put("legs.bergrun", run % (one, "plans", '{"time_s":0,"legs":[' + ",".join(["[0,0,0,0,0,0,0]"] * many) + "]}"))
put("clusters.bergrun", run % (one, "plans", '{"time_s":0,"clusters":[' + ",".join(["[]"] * many) + "]}"))
put("keyframes.bergrun", run % (one, "keyframes", ",".join(["{}"] * many)))
put("uavs.bergrun", run % (hundred, "keyframes", ",".join(['{"other_uavs":[' + ",".join(["{}"] * 99) + "]}"] * (many // 50))))
put("tracks.bergrun", run % (one, "keyframes", '{"tracks":[' + ",".join(["[]"] * many) + "]}"))
study = (head % "study")[:-5] + '"policies": ["visitation"], '
put("scenarios.bergstudy", study + '"taus": [1], "scenarios": [' + ",".join(["{}"] * many) + "]}")
put("outcomes.bergstudy", study + '"taus": [1], "random": 1, "runs": 1000000, "outcomes": [' + ",".join(["null"] * 1_000_000) + "]}")
put("settings.bergstudy", study + '"random": 1, "runs": 1000, "taus": [' + ",".join(["1"] * 1000) + '], "outcomes": [' + ",".join(["null"] * 1000) + "]}")
put("matrix.json", (head % "problem")[:-5] + '"sigma": [0' + ",1" * 999 + '], "distance_m": [' + ",".join(["[]"] * 1000) + "]}")
put("fences.berg", (head % "scenario")[:-5] + '"uavs": [' + uav % (0, 0) + '], "icebergs": [], "no_fly": ['
    + ",".join(['{"area_m": [' + ",".join(f"[{9000 + i},{i * i // 5}]" for i in range(2000)) + "]}"] * 100) + "]}")
put("taus.bergstudy", '{"format": "bergwatch-study", "version": 1, "random": 1, "policies": ["visitation"], "taus": ['
    + ",".join(["1"] * many) + "]}")
point = '{"type":"Feature","properties":{%s},"geometry":{"type":"Point","coordinates":[-48,47]}}'
put("features.geojson", '{"type":"FeatureCollection","features":[' + ",".join([point % ""] * (many // 4)) + "]}")
put("properties.geojson", '{"type":"FeatureCollection","features":[' + point % ",".join(f'"p{i}":1' for i in range(many)) + "]}")
put("line.geojson", '{"type":"Feature","properties":{"times":[]},"geometry":{"type":"LineString","coordinates":['
    + ",".join(["[-48.00001,47.00001]"] * many) + "]}}")
put("packets.czml", '[{"id":"document"}' + ',{"id":"a","position":{"cartographicDegrees":[-48,47,0]}}' * (many // 4) + "]")
put("samples.czml", '[{"id":"document"},{"id":"a","position":{"epoch":"2021-01-01T00:00:00Z","cartographicDegrees":['
    + ",".join(f"{i},-48.001,47.001,0" for i in range(many // 2)) + "]}}]")
kml = '<kml xmlns="http://www.opengis.net/kml/2.2"><Document>%s</Document></kml>'
put("places.kml", kml % ("<Placemark><Point><coordinates>-48,47</coordinates></Point></Placemark>" * (many // 4)))
put("deep.kml", kml % ("<Folder>" * many))
put("data.kml", kml % ("<Placemark><ExtendedData>" + "".join(f'<Data name="d{i}"><value>1</value></Data>' for i in range(many // 2))
    + "</ExtendedData><Point><coordinates>-48,47</coordinates></Point></Placemark>"))
put("attributes.kml", kml % ("<Placemark " + " ".join(f'a{i}="1"' for i in range(many)) + "/>"))
put("text.kml", kml % ("<Placemark><name>" + "x" * 20_000_000 + "</name><Point><coordinates>-48,47</coordinates></Point></Placemark>"))
put("whens.kml", '<kml xmlns:gx="g"><Placemark><gx:Track>' + "<when>2021-01-01T00:00:00Z</when>" * (many // 4)
    + "<gx:coord>-48 47 0</gx:coord>" * (many // 4) + "</gx:Track></Placemark></kml>")
put("points.gpx", '<gpx><trk><trkseg>' + '<trkpt lat="47" lon="-48"><time>2021-01-01T00:00:00Z</time></trkpt>' * (many // 4) + "</trkseg></trk></gpx>")
put("rows.csv", "id,latitude,longitude\n" + "".join(f"b{i % 900},47.{i % 10000:04},-48.{i % 10000:04}\n" for i in range(many)))
put("columns.csv", "latitude,longitude" + ",x" * many + "\n47,-48\n")
put("many.csv", "id,latitude,longitude\n" + "".join(f"b{i},47,-48\n" for i in range(many // 4)))
put("quotes.csv", "latitude,longitude\n" + 'a","\n' * many)
put("cell.csv", "latitude,longitude,name\n47,-48,\"" + "x" * 20_000_000 + "\"\n")
put("rows_short.csv", "latitude,longitude\n" + "0,0\n" * (2 * many))
put("rows_ids.csv", "id,latitude,longitude\n" + "".join(f"{i},0,0\n" for i in range(2 * many)))
put("points_short.gpx", "<gpx>" + '<wpt lat="0" lon="0"/>' * many + "</gpx>")
put("points_short.geojson", '{"type":"FeatureCollection","features":['
    + ",".join(['{"geometry":{"type":"Point","coordinates":[0,0]},"type":"Feature"}'] * (many // 2)) + "]}")
put("samples_short.czml", '[{"id":"document"},{"id":"a","position":{"epoch":"2021-01-01T00:00:00Z","cartographicDegrees":['
    + ",".join(["0,0,0,0"] * (2 * many)) + "]}}]")
put("unknown_list.berg", (head % "scenario")[:-5] + '"icebergs": [{"x": {"y": [' + ",".join(["[0,0]"] * many) + "]}}]}")
put("wrong.csv", "latitude,longitude\n" + "x,y\n" * (4 * many))
put("items.waypoints", "QGC WPL 110\n" + "1\t0\t3\t16\t0\t0\t0\t0\t47.1\t-48.1\t100\t1\n" * (many // 4))
put("items.plan", '{"fileType": "Plan", "groundStation": "QGroundControl", "mission": {"items": ['
    + ",".join(['{"type":"SimpleItem","command":16,"params":[0,0,0,null,47,-48,50]}'] * (many // 4)) + "]}}")
area = "AC D\nAN zone\nAL GND\nAH FL100\n%s"
put("areas.openair", (area % "DP 47N 48W\nDP 47N 47.9W\nDP 47.1N 48W\n") * (many // 8))
put("circles.openair", area % "V X=47N 48W\n" + "DC 1\n" * many)
put("rings.openair", (area % "V X=47N 48W\nDC 1\n") * (many // 4))
put("lines.openair", area % ("AY x\n" * (4 * many)))
put("name.openair", "AC D\nAN " + "x" * 20_000_000 + "\nDP 47N 48W\n")
put("points.openair", area % ("DP 47N 48W\n" * (2 * many)))
put("bad.openair", (area % "DP x\n") * many)
comb = "".join("DP %.6fN %.6fW\n" % (47 + (i % 2) * 0.2, 48 + i * 1e-5) for i in range(20_000))
put("combs.openair", (area % comb) * 30)
triangle = "[[[-48,47],[-47.9,47],[-48,47.1],[-48,47]]]"
shape = '{"type":"Feature","properties":{%s},"geometry":{"type":"%s","coordinates":%s}}'
put("areas.airspace", '{"type":"FeatureCollection","features":[' + ",".join([shape % ("", "Polygon", triangle)] * (many // 8)) + "]}")
name = '"name":"' + "n" * 200 + '"'
put("parts.airspace", shape % (name, "MultiPolygon", "[" + ",".join([triangle] * (many // 4)) + "]"))
outline = "[[" + ",".join(f"[{-48 + i * 1e-6:.6f},{47 + i % 2 * 0.2}]" for i in range(many)) + "]]"
put("comb.geojson", shape % ('"kind":"area"', "Polygon", outline))
point = "<Point><coordinates>-48,47</coordinates></Point>"
put("urls.map", kml % ("<Placemark><styleUrl>#" + "u" * 2_000_000 + "</styleUrl><MultiGeometry>" + point * (many // 8) + "</MultiGeometry></Placemark>"))
put("pairs.map", kml % ('<StyleMap id="' + "i" * 2_000_000 + '">' + "<Pair><key>normal</key><styleUrl>#a</styleUrl></Pair>" * (many // 8)
    + "</StyleMap><Placemark>" + point + "</Placemark>"))
put("styles.map", kml % "".join(f'<Style id="s{i}"><PolyStyle><fill>0</fill></PolyStyle></Style>' for i in range(many // 4)))
put("names.map", kml % ("<Placemark><name>" + "n" * 300 + "</name><MultiGeometry>" + point * (many // 4) + "</MultiGeometry></Placemark>"))
put("nested.map", kml % ("<Placemark>" * 60 + point * (many // 4) + "</Placemark>" * 60))
put("tuples.map", kml % ("<Placemark><LineString><coordinates>" + "0,0 " * (8 * many) + "</coordinates></LineString></Placemark>"))
put("points.map", shape % (name, "MultiPoint", "[" + ",".join(["[0,0]"] * many) + "]"))
put("line.map", '{"type":"LineString","coordinates":[' + ",".join(["[0,0]"] * (4 * many)) + "]}")
put("rings.map", '{"type":"Polygon","coordinates":[' + ",".join(["[[0,0]]"] * (2 * many)) + "]}")
put("geometries.map", '{"type":"GeometryCollection","geometries":[' + ",".join(['{"type":"Point","coordinates":[0,0]}'] * many) + "]}")
import zipfile
with zipfile.ZipFile("bomb.kmz", "w", zipfile.ZIP_DEFLATED) as archive:
    archive.writestr("doc.kml", kml % (" " * 1_000_000_000))
with zipfile.ZipFile("many.kmz", "w") as archive:
    for i in range(60_000):
        archive.writestr(f"{i}.txt", "")
P
# frugal FILE COMMAND...: within the limits for the file; it ends with 0 or 3, in few lines.
frugal() {
    local size
    size=$(stat -c %s "$1")
    shift
    within "$(awk "BEGIN { print 2 + $size / 1e6 }")" "$(awk "BEGIN { print 80 + 10 * $size / 1e6 }")" "$@" &&
        [ "$(wc -l <stderr.txt)" -le 1100 ]
}
for file in *.berg *.bergrun *.bergstudy *.json; do
    check "validate $file" frugal "$file" "$cli" validate "$file"
done
for file in *.json; do
    check "solve $file" frugal "$file" "$cli" solve "$file"
done
for file in *.csv *.kml *.gpx *.geojson *.czml *.waypoints *.plan many.kmz; do
    check "import $file" frugal "$file" "$cli" import "$file" --output imported.berg --force
done
for file in *.openair *.airspace; do
    check "import $file" frugal "$file" "$cli" import "$file" --format airspace --into "$source_dir/resources/scenarios/grand-banks-12.berg" --output imported.berg --force
done
for file in *.map; do
    check "map $file" frugal "$file" "$readers" --map "$file"
done
check "import bomb.kmz" frugal bomb.kmz "$cli" import bomb.kmz --output imported.berg --force
check "import bomb.kmz: says why" says "would take more than 58 MB of memory, the limit for a file of its size"
check "import many.csv" exits 3 "$cli" import many.csv --output imported.berg --force
check "import many.csv: says why, and of which file" says "many.csv: there are more than 50000 icebergs to choose from"
check "import rows_short.csv" exits 3 "$cli" import rows_short.csv --output imported.berg --force
check "import rows_short.csv: says how to raise the limit" says "BERGWATCH_READ_LIMITS=2 in the environment"
check "import rows_short.csv: the limit raised" exits 0 env BERGWATCH_READ_LIMITS=6 "$cli" import rows_short.csv --output imported.berg --force

all_checked
