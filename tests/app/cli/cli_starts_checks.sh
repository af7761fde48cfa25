#!/usr/bin/env bash
# The command starts, the drift of a scenario's icebergs and the verdict on the weather, run as a
# stranger would.
# Use: cli_starts_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
scenarios=$source_dir/resources/scenarios

# Two UAVs, one with limits; three icebergs, one with a recorded track.
python3 - <<'P'
import json
scenario = {
    "format": "bergwatch-scenario", "version": 1, "start_utc": "2026-05-01T12:00:00Z",
    "origin": {"latitude_deg": 64, "longitude_deg": -58},
    "wind_mps": [9, 0], "current_mps": [0, 0.3], "duration_s": 120, "noise": False,
    "weather": {"gust_mps": 13},
    "planner": {"policy": "nearest"},
    "uavs": [{"id": "uav-1", "position_m": [0, 0], "max_wind_mps": 10, "max_gust_mps": 15},
             {"id": "uav-2", "position_m": [900, 0], "max_wind_mps": 8}],
    "icebergs": [{"id": "a", "position_m": [2000, 0], "sigma0_m2": 25},
                 {"id": "b", "position_m": [3000, 2000], "velocity_mps": [0.1, 0]},
                 {"id": "c", "position_m": [0, 4000],
                  "track": {"time_s": [hour * 3600 for hour in range(31)],
                            "position_m": [[0, 4000 + 720 * hour] for hour in range(31)]}}]}
json.dump(scenario, open("limits.berg", "w"))
scenario["uavs"] = [{"id": "uav-1", "position_m": [0, 0]}]
json.dump(scenario, open("free.berg", "w"))
scenario["uavs"] = [{"id": "uav-1", "position_m": [0, 0], "max_wind_mps": 20}]
json.dump(scenario, open("calm.berg", "w"))
scenario.pop("start_utc")
json.dump(scenario, open("startless.berg", "w"))
# Wind of 5 m/s at 12:00, 12 m/s at 13:00 and 9 m/s from 14:00 on, for a limit of 10 m/s.
scenario["start_utc"] = "2026-05-01T12:00:00Z"
scenario["uavs"] = [{"id": "uav-1", "position_m": [0, 0], "max_wind_mps": 10}]
scenario["forecast"] = {
    "source": "by hand", "issued": "2026-05-01T06:00:00Z",
    "places": [{"latitude_deg": 64, "longitude_deg": -58,
                "series": [{"time": f"2026-05-01T{12 + i}:00:00Z", "wind_mps": [wind, 0]}
                           for i, wind in enumerate([5, 12, 9, 9])]}]}
json.dump(scenario, open("front.berg", "w"))
P

# --- verdict of plan and simulate ------------------------------------------------------------
check "plan in the wind" exits 0 "$cli" plan limits.berg --json
check "plan in the wind: no-go" json 'd["weather"]["state"] == "no-go"'
check "plan in the wind: each UAV" json '[(u["id"], u["state"], u["limit"], u["value"], u["limit_value"], u["time_s"]) for u in d["weather"]["uavs"]] == [("uav-1", "marginal", "wind", 9, 10, 0), ("uav-2", "no-go", "wind", 9, 8, 0)]'
check "plan in the wind, in words" exits 0 "$cli" plan limits.berg
check "plan in the wind, in words: verdict" grep -qx 'weather    no-go  uav-2: wind 9 m/s at 2026-05-01 12:00 UTC, limit 8 m/s' stdout.txt
check "plan in the wind: warns" says "uavs[1].max_wind_mps"
check "simulate in the wind" exits 0 "$cli" simulate limits.berg --json
check "simulate in the wind: no-go" json '[u["state"] for u in d["weather"]["uavs"]] == ["marginal", "no-go"]'
check "simulate in the wind, in words" exits 0 "$cli" simulate limits.berg --output run
check "simulate in the wind, in words: verdict" grep -q '^weather   no-go  uav-2: wind 9 m/s' stdout.txt
check "a replay has the same verdict" exits 0 "$cli" simulate run/run.bergrun
check "a replay has the same verdict: line" grep -q '^weather   no-go  uav-2: wind 9 m/s' stdout.txt
check "simulate without limits" exits 0 "$cli" simulate free.berg --json
check "simulate without limits: no verdict" json '"weather" not in d'
check "plan within the limits" exits 0 "$cli" plan calm.berg
check "plan within the limits: go" grep -qx 'weather    go' stdout.txt

# --- starts ----------------------------------------------------------------------------------
check "starts" exits 0 "$cli" starts calm.berg --hours 3 --output starts.csv --chart starts.svg --json
check "starts: each hour" json '[s["start_utc"] for s in d["starts"]] == [f"2026-05-01T{h}:00:00Z" for h in range(12, 16)]'
check "starts: all go" json 'all(s["weather"] == "go" and "reason" not in s for s in d["starts"])'
check "starts: older estimates are more uncertain" json 'all(a["zeta_m2s"] < b["zeta_m2s"] for a, b in zip(d["starts"], d["starts"][1:]))'
check "starts: the first is the best" json 'd["best"] == "2026-05-01T12:00:00Z"'
cp stdout.txt four.json
check "starts: one thread" exits 0 "$cli" starts calm.berg --hours 3 --threads 1 --json
check "starts: one thread: the same" cmp -s stdout.txt four.json
check "starts: as simulated" exits 0 "$cli" simulate calm.berg --json
check "starts: as simulated: zeta" json 'd["zeta_m2s"] == __import__("json").load(open("four.json"))["starts"][0]["zeta_m2s"]'
check "starts: CSV" grep -qx 'start_utc,delay_h,zeta_m2s,visits,weather,uav,limit,value,limit_value,time,best' <(head -1 starts.csv)
check "starts: CSV rows" test "$(wc -l <starts.csv)" = 5
check "starts: chart" python3 -c 'import xml.etree.ElementTree as t; t.parse("starts.svg")'
check "starts beyond a limit" exits 0 "$cli" starts limits.berg --hours 1
check "starts beyond a limit: reason" grep -qE '^2026-05-01T13:00:00Z .* no-go  uav-2: wind 9 m/s, limit 8 m/s, from 13:00 UTC$' stdout.txt
check "starts beyond a limit: none" grep -qx 'no start has weather that is go or marginal' stdout.txt
# From 12:00 the wind is 5 + 7 t / h until 13:00, then 12 - 3 t / h: 8.5 at 12:30, 10.5 at 13:30.
# Up to 0.8 of the limit is go.
check "starts as a front passes" exits 0 "$cli" starts front.berg --hours 2 --every 0.5 --json
check "starts as a front passes: go, marginal, no-go" json '[s["weather"] for s in d["starts"]] == ["go", "marginal", "no-go", "no-go", "marginal"]'
check "starts as a front passes: limits" json 'all(s["reason"]["limit"] == "wind" and s["reason"]["limit_value"] == 10 for s in d["starts"][1:])'
check "starts as a front passes: winds" json 'all(abs(s["reason"]["value"] - wind) < 1e-9 for s, wind in zip(d["starts"][1:], [8.5, 12, 10.5, 9]))'
check "starts as a front passes: the best" json 'd["best"] == "2026-05-01T12:00:00Z"'
check "plan before a front" exits 0 "$cli" plan front.berg
check "plan before a front: go" grep -qx 'weather    go' stdout.txt
check "starts without a start" exits 3 "$cli" starts startless.berg
check "starts without a start: says so" says "startless.berg: start_utc: is missing"
check "starts: too many" exits 2 "$cli" starts calm.berg --hours 240 --every 0.1
check "starts: too many: says so" says "more than 1000 starts"

# --- drift of the icebergs of a scenario -----------------------------------------------------
check "drift of a scenario" exits 0 "$cli" drift calm.berg --json
check "drift of a scenario: each 3 h" json '[p["hours"] for p in d["tracks"][0]["points"]] == list(range(0, 49, 3))'
check "drift of a scenario: to the north" json 'all(abs(p["direction_deg"]) < 0.1 and abs(p["speed_mps"] - 0.3) < 1e-9 for p in d["tracks"][0]["points"])'
# sqrt(25 + 0.025 t) after 3 h = 10800 s
check "drift of a scenario: spread" json 'abs(d["tracks"][0]["points"][1]["sd_m"] - 295 ** 0.5) < 0.06'
# The track goes at 0.2 m/s, the current at 0.3 m/s.
check "drift of a scenario: error of a track" json 'abs(d["tracks"][2]["points"][2]["error_m"] - 2160) < 1'
check "drift of a scenario: errors by lead" json '[e["lead_h"] for e in d["tracks"][2]["errors"]] == [6, 12, 24, 48] and abs(d["tracks"][2]["errors"][0]["drift_km"] - 2.16) < 0.01'
check "drift of a scenario in words" exits 0 "$cli" drift calm.berg --hours 6 --every 1.5 --output tracks.csv
check "drift of a scenario in words: a row" grep -qE '^ +a  2026-05-01 13:30 +1\.5 +64\.0145' stdout.txt
check "drift of a scenario: CSV rows" test "$(wc -l <tracks.csv)" = 16
check "drift of a scenario: GeoJSON" exits 0 "$cli" drift calm.berg --hours 6 --output tracks.geojson
check "drift of a scenario: lines and points" python3 -c 'import json; d = json.load(open("tracks.geojson")); assert [f["geometry"]["type"] for f in d["features"]] == 3 * (["LineString"] + 3 * ["Point"])'
check "drift without a start" exits 0 "$cli" drift startless.berg --hours 3
check "drift of a scenario with a length" exits 2 "$cli" drift calm.berg --length 100
check "drift of a scenario with a length: says so" says "--length excludes SCENARIO"
check "drift each hour without a scenario" exits 2 "$cli" drift --length 100 --wind-speed 1 --wind-from 0 --every 1
check "drift each hour without a scenario: says so" says "--every needs SCENARIO"
check "drift of real icebergs" exits 0 "$cli" drift "$scenarios/upernavik-real-drift.berg" --json
check "drift of real icebergs: grows" json 'all(a["sd_m"] < b["sd_m"] for t in d["tracks"] for a, b in zip(t["points"], t["points"][1:]))'

all_checked
