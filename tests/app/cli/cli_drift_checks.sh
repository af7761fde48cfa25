#!/usr/bin/env bash
# The commands forecast and drift, run as a stranger would.
# Use: cli_drift_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
cp "$source_dir"/tests/data/forecast/*.json .
weather=locationforecast.json
sea=oceanforecast.json

# --- drift in a constant wind and current ----------------------------------------------------
# By hand (tst_wind_drift): 1.693 % of 10 m/s to the east and 98.307 % of 0.3 m/s to the north.
constant=(--wind-speed 10 --wind-from 270 --current-speed 0.3 --current-to 0)
check "drift of a length" exits 0 "$cli" drift --length 100 "${constant[@]}" --json
check "drift of a length: by hand" json 'abs(d["speed_mps"] - 0.34007) < 1e-4 and abs(d["direction_deg"] - 29.862) < 0.01 and abs(d["wind_share"] - 0.016932) < 1e-6'
check "drift of a length: members" json 'list(d) == ["length_m","draft_m","sail_m2","current_share","wind_share","turn_deg","speed_mps","direction_deg"]'
check "drift in words" exits 0 "$cli" drift --length 100 "${constant[@]}"
check "drift in words: velocity" grep -qx 'drift      0.340 m/s (0.66 kn) towards 30 deg' stdout.txt
check "drift in words: law" grep -qx 'law        98.31 % of the current and 1.69 % of the wind' stdout.txt
check "drift of a class" exits 0 "$cli" drift --size medium --wind-speed 10 --wind-from 0 --json
check "drift of a class: 90 m, to the south" json 'd["length_m"] == 90 and d["direction_deg"] == 180'
check "drift by the coefficients of OpenBerg" exits 0 "$cli" drift --length 100 "${constant[@]}" --coefficients openberg --json
check "drift by the coefficients of OpenBerg: more wind" json '0.02 < d["wind_share"] < 0.03'
# 2 % of 10 m/s towards 90 + 20 degrees in the north, 90 - 20 in the south.
small=(drift --size growler --wind-speed 10 --wind-from 270 --json)
check "drift of a growler" exits 0 "$cli" "${small[@]}" --latitude 64
check "drift of a growler: to the right in the north" json 'abs(d["speed_mps"] - 0.2) < 1e-9 and abs(d["direction_deg"] - 110) < 1e-9'
check "drift of a growler in the south" exits 0 "$cli" "${small[@]}" --latitude -64
check "drift of a growler: to the left in the south" json 'abs(d["direction_deg"] - 70) < 1e-9'
check "drift of a growler without a latitude" exits 2 "$cli" "${small[@]}"
check "drift of a growler without a latitude: says why" says "--latitude is required: growlers"
check "drift of a growler in the current alone" exits 0 "$cli" drift --size growler --current-speed 1 --current-to 10
refused() { # words, then options
    local words=$1
    shift
    check "drift $*: refused" exits 2 "$cli" drift "$@"
    check "drift $*: says $words" says "$words"
}
refused "--length, --size is required" "${constant[@]}"
refused "--length excludes --size" --length 9 --size small "${constant[@]}"
refused "huge is none of growler, bergy-bit, small, medium, large, very-large" --size huge "${constant[@]}"
refused "--wind-speed needs --wind-from" --length 90 --wind-speed 10
refused "--current-to needs --current-speed" --length 90 --current-to 10
refused "--wind-speed, --current-speed, --forecast is required" --length 90
refused "--hours needs --forecast" --length 90 "${constant[@]}" --hours 6
refused "--output needs --forecast, --track" --length 90 "${constant[@]}" --output none.csv
refused "must be from 0 to 360, not 361" --length 90 --wind-speed 10 --wind-from 361

# --- drift against a recorded track ----------------------------------------------------------
# Seven days at 0.2 m/s to the south, one fix an hour: 4.32 km in 6 h, 34.56 km in 48 h.
python3 - <<'P'
import datetime
start = datetime.datetime(2026, 5, 1)
with open("track.csv", "w") as file:
    file.write("time,latitude,longitude\n")
    for hour in range(169):
        time = start + datetime.timedelta(hours=hour)
        file.write(f"{time.isoformat()}Z,{64.5 - hour * 720 / 111495:.6f},-59.8\n")
P
check "drift beside a track" exits 0 "$cli" drift --size medium --current-speed 0.2 --current-to 180 --track track.csv --json
check "drift beside a track: leads" json '[e["lead_h"] for e in d["errors"]] == [6, 12, 24, 48]'
check "drift beside a track: starts" json '[e["starts"] for e in d["errors"]] == [160, 154, 142, 118]'
check "drift beside a track: moved" json 'all(abs(e["moved_km"] - 0.72 * e["lead_h"]) < 0.02 for e in d["errors"])'
check "drift beside a track: its wind share is missing" json 'all(abs(e["drift_km"] - (1 - d["current_share"]) * e["moved_km"]) < 0.03 for e in d["errors"])'
check "drift beside a track: last velocity" json 'all(e["last_velocity_km"] < 0.05 for e in d["errors"])'
check "drift beside a track in words" exits 0 "$cli" drift --size medium --current-speed 0.2 --current-to 180 --track track.csv --output errors.csv
check "drift beside a track in words: a row" grep -qE '^ +48 +118 +34\.6 +0\.6 +0\.0$' stdout.txt
check "drift beside a track: CSV" grep -qx 'lead_h,starts,moved_km,drift_km,last_velocity_km' <(head -1 errors.csv)
cp <(head -9 track.csv) short.csv
check "drift beside a short track: no start" exits 0 "$cli" drift --size medium --current-speed 0 --current-to 0 --track short.csv
check "drift beside a short track: no error" grep -qE '^ +6 +0 +- +- +-$' stdout.txt
printf 'lat,lon\n64,-59\n64.1,-59\n' >timeless.csv
check "drift beside a track without times" exits 3 "$cli" drift --size medium "${constant[@]}" --track timeless.csv
check "drift beside a track without times: says so" says "timeless.csv: time: is missing"

# --- forecasts -------------------------------------------------------------------------------
check "forecast" exits 0 "$cli" forecast $weather $sea --json
check "forecast: members" json 'list(d) == ["source","issued","latitude_deg","longitude_deg","series","gaps","missing"]'
check "forecast: both files" json 'd["source"] == "MET Norway locationforecast, MET Norway oceanforecast" and d["issued"] == "2026-04-30T06:00:00Z" and d["missing"] == []'
check "forecast: wind from, current to" json '(lambda e: (e["wind_speed_mps"], e["wind_from_deg"], e["gust_mps"], e["air_temperature_degC"], e["fog_percent"], e["current_speed_mps"], e["current_to_deg"]) == (8, 350, 12.5, -1.5, 10, 0.2, 180))(d["series"][0])'
check "forecast: gaps" json '[(g["quantity"], g["from"]) for g in d["gaps"]] == [("wind", "2026-05-02T00:00:00Z"), ("air temperature", "2026-05-02T00:00:00Z")]'
check "forecast: weather between its times" json 'abs(d["series"][2]["air_temperature_degC"] + 0.98) < 1e-9 and d["series"][2]["fog_percent"] is None'
check "forecast: names gaps" says "warning: wind: no values between 2026-05-02T00:00:00Z and 2026-05-02T12:00:00Z"
check "forecast: names an old one" says "oceanforecast.json: warning: issued 30 h before 2026-05-01T12:00:00Z; get a newer forecast"
check "forecast: names no new one" test -z "$(grep locationforecast.json stderr.txt)"
check "forecast: a window in a gap" exits 0 "$cli" forecast $weather --since 2026-05-02T01:00:00Z --until 2026-05-02T02:00:00Z --json
check "forecast: a window in a gap: names it" json '[g["quantity"] for g in d["gaps"]] == ["wind", "air temperature"] and d["series"][0]["wind_speed_mps"] is None'
check "forecast -q" exits 0 "$cli" forecast $weather $sea -q
check "forecast -q: nothing on stderr" test ! -s stderr.txt
check "forecast in words: columns" grep -qE '^ +time  wind m/s  from  gust m/s  air C  fog %  current m/s   to$' stdout.txt
check "forecast of the wind alone" exits 0 "$cli" forecast $weather --output wind.csv
check "forecast of the wind alone: without" grep -qx 'without    current' stdout.txt
check "forecast of the wind alone: CSV" grep -qx '2026-05-01T12:00:00Z,8,350,12.5,-1.5,10,,' wind.csv
check "forecast: a window" exits 0 "$cli" forecast $weather --since 2026-05-01T12:30:00Z --until 2026-05-01T15:30:00Z --json
check "forecast: a window: its ends" json '[e["time"][11:16] for e in d["series"]] == ["12:30", "13:00", "15:30"]'
check "forecast: a window: by way of north" json 'd["series"][0]["wind_from_deg"] == 0 and d["series"][0]["wind_speed_mps"] == 7.88'
check "forecast: another window" exits 2 "$cli" forecast $weather --since 2027-01-01T00:00:00Z
check "forecast: another window: says which" says "the forecast is from 2026-05-01T12:00:00Z to 2026-05-02T12:00:00Z"
check "forecast: an old one" exits 0 "$cli" forecast $weather --since 2026-05-02T12:00:00Z
check "forecast: an old one: says so" says "issued 25 h before 2026-05-02T12:00:00Z"
check "forecast from a pipe" exits 0 bash -c 'cat "$1" | "$0" forecast -' "$cli" $weather
check "forecast of a scenario" exits 3 "$cli" forecast "$source_dir/resources/scenarios/disko-bay-4.berg"
check "forecast of a scenario: says what it needs" says "A forecast is the JSON reply of MET Norway's locationforecast"
check "forecast of a table" exits 3 "$cli" forecast track.csv
check "forecast of a table: says what it needs" says "A forecast is the JSON reply of MET Norway's locationforecast"
sed 's/350.0/361/' $weather >off.json
check "forecast with a wrong direction" exits 3 "$cli" forecast off.json
check "forecast with a wrong direction: names it" says "off.json: properties.timeseries[0].data.instant.details.wind_from_direction: must be from 0 to 360, not 361"
check "forecast with a wrong direction, in Norwegian" exits 3 env LC_ALL=nb_NO.UTF-8 "$cli" forecast off.json
check "forecast with a wrong direction, in Norwegian: words" says "må være fra 0 til 360, ikke 361"

# --- drift over a forecast -------------------------------------------------------------------
# The winds of 12:00 and 13:00 are known until 00:00, the current as long.
check "drift over a forecast" exits 0 "$cli" drift --size medium --forecast $weather --forecast $sea --output path.csv --json
check "drift over a forecast: a point each hour" json '[p["time"][11:13] for p in d["path"]] == [f"{h % 24:02}" for h in range(12, 25)]'
check "drift over a forecast: starts at its place" json '(d["path"][0]["latitude_deg"], d["path"][0]["longitude_deg"]) == (64.5, -59.8)'
# At the start 0.01668 of 8 m/s towards 170 and 0.98332 of 0.2 m/s towards 180.
check "drift over a forecast: by hand" json 'abs(d["path"][0]["speed_mps"] - 0.3289) < 2e-4 and abs(d["path"][0]["direction_deg"] - 176.0) < 0.1'
check "drift over a forecast: how far it goes" says "wind and current are known for 12 h only"
check "drift over a forecast: its age" says "oceanforecast.json: warning: issued 30 h before"
check "drift over a forecast: imports read the path" exits 0 "$cli" import path.csv --one-iceberg --output path.berg --json
check "drift over a forecast: all of it" json 'd["sightings"] == 13 and d["added"] == 1 and d["rejected"] == 0'
check "drift over a forecast in words" exits 0 "$cli" drift --size medium --forecast $weather --forecast $sea --at 2026-05-01T14:00:00Z --hours 3 --place 64.6N,59.8W
check "drift over a forecast in words: rows" grep -qE '^2026-05-01T14:00:00Z +64\.6000 +-59\.8000 ' stdout.txt
check "drift over a forecast in words: four" test "$(grep -c '^2026' stdout.txt)" = 4
check "drift over a forecast, far away" exits 0 "$cli" drift --size medium --forecast $weather --forecast $sea --place 65.5N,59.8W --hours 1
check "drift over a forecast, far away: says so" says "locationforecast.json: warning: is for a place 111 km away"
check "drift of wind and a constant current" exits 0 "$cli" drift --size medium --forecast $weather --current-speed 0.1 --current-to 90 --hours 2 --json
check "drift of wind and a constant current: three points" json 'len(d["path"]) == 3'
check "drift over a forecast of the wind alone" exits 2 "$cli" drift --size medium --forecast $weather
check "drift over a forecast of the wind alone: says so" says "the forecasts hold no current: add one that does, or give --current-speed, --current-to"
check "drift with two currents" exits 2 "$cli" drift --size medium --forecast $weather --forecast $sea --current-speed 0.1 --current-to 90
check "drift with two currents: says so" says "--current-speed, --current-to excludes --forecast"
check "drift from too late" exits 2 "$cli" drift --size medium --forecast $weather --forecast $sea --at 2026-06-01T00:00:00Z
check "drift from too late: says so" says "wind and current are not both known then"
check "drift from nowhere" exits 2 "$cli" drift --size medium --forecast $weather --forecast $sea --place nowhere
check "drift from nowhere: says so" says "--place: nowhere is not a position"
check "drift of a track over a forecast" exits 0 "$cli" drift --size medium --forecast $weather --forecast $sea --track track.csv --json
check "drift of a track over a forecast: while it lasts" json '[e["starts"] for e in d["errors"]] == [7, 1, 0, 0] and d["errors"][2]["drift_km"] is None'
check "drift of a track at a time" exits 2 "$cli" drift --size medium --forecast $weather --forecast $sea --track track.csv --at 2026-05-01T14:00:00Z

all_checked
