#!/usr/bin/env bash
# Forecasts in NetCDF and GRIB, as other programs write them, on the command line.
# Use: cli_forecast_checks.sh CLI SOURCE_DIR WORK_DIR NCGEN GRIB_FILTER CODES_INFO
. "$2/tests/app/cli/cli_support.sh"
ncgen=$4
grib_filter=$5
samples=$("$6" -s)

cat >wind.cdl <<'CDL'
netcdf wind {
dimensions: time = UNLIMITED ; lat = 3 ; lon = 3 ;
variables:
  double time(time) ; time:units = "hours since 2026-05-01 00:00:00" ;
  float lat(lat) ; lat:units = "degrees_north" ;
  float lon(lon) ; lon:units = "degrees_east" ;
  short u(time, lat, lon) ; u:standard_name = "eastward_wind" ; u:units = "m s-1" ; u:scale_factor = 0.5 ;
  short v(time, lat, lon) ; v:standard_name = "northward_wind" ; v:units = "m s-1" ; v:scale_factor = 0.5 ;
  float visibility(time, lat, lon) ; visibility:units = "m" ;
  float deptho(lat, lon) ; deptho:units = "m" ;
  double forecast_reference_time ; forecast_reference_time:units = "hours since 2026-05-01" ;
  :title = "Wind model" ;
data:
  time = 0, 1, 12 ; lat = 65, 64.5, 64 ; lon = -61, -60, -59 ;
  u = 20, 20, 20, 20, 20, 20, 20, 20, 20, 0, 0, 0, 0, 20, 0, 0, 0, 0, 20, 20, 20, 20, 20, 20, 20, 20, 20 ;
  v = 0, 0, 0, 0, 0, 0, 0, 0, 0, 20, 20, 20, 20, 20, 20, 20, 20, 20, 0, 0, 0, 0, 0, 0, 0, 0, 0 ;
  visibility = 9e3, 9e3, 9e3, 9e3, 4e3, 9e3, 9e3, 9e3, 9e3, 9e3, 9e3, 9e3, 9e3, 4e3, 9e3, 9e3, 9e3, 9e3,
    9e3, 9e3, 9e3, 9e3, 4e3, 9e3, 9e3, 9e3, 9e3 ;
  deptho = 100, 100, 100, 100, 250, 100, 100, 100, 100 ;
  forecast_reference_time = -30 ;
}
CDL
"$ncgen" -k nc4 -o wind.nc wind.cdl
cat >sea.rules <<'RULES'
set Ni = 3; set Nj = 2;
set latitudeOfFirstGridPointInDegrees = 65; set latitudeOfLastGridPointInDegrees = 64;
set longitudeOfFirstGridPointInDegrees = 299; set longitudeOfLastGridPointInDegrees = 301;
set iDirectionIncrementInDegrees = 1; set jDirectionIncrementInDegrees = 1;
set dataDate = 20260501; set dataTime = 0; set forecastTime = 0;
set shortName = "10u"; set values = {10,10,10,10,10,10}; write;
set shortName = "10v"; set values = {0,0,0,0,0,0}; write;
RULES
"$grib_filter" -o air.grib sea.rules "$samples/regular_ll_sfc_grib2.tmpl"

# --- tables ----------------------------------------------------------------------------------
check "NetCDF" exits 0 "$cli" forecast wind.nc --json
check "NetCDF: the middle" json '(d["latitude_deg"], d["longitude_deg"], d["depth_m"], d["source"], d["issued"]) == (64.5, -60, 250, "Wind model", "2026-04-29T18:00:00Z")'
# 10 m/s to the east comes from 270 degrees; an hour later 10 to the east and 10 to the north.
check "NetCDF: by hand" json '[(e["wind_speed_mps"], e["wind_from_deg"], e["visibility_m"]) for e in d["series"][:2]] == [(10, 270, 4000), (14.14, 225, 4000)]'
check "NetCDF: its grid" json '[(g["file"], g["format"], g["rows"], g["columns"], g["thinning"]) for g in d["grids"]] == [("wind.nc", "NetCDF", 3, 3, 1)]'
check "NetCDF: its gap" json '[(g["quantity"], g["from"], g["to"]) for g in d["gaps"]] == [("wind", "2026-05-01T01:00:00Z", "2026-05-01T12:00:00Z"), ("visibility", "2026-05-01T01:00:00Z", "2026-05-01T12:00:00Z")]'
check "NetCDF: an old one" says "wind.nc: warning: issued 30 h before 2026-05-01T00:00:00Z; get a newer forecast"
check "NetCDF in words" exits 0 "$cli" forecast wind.nc --output wind.csv
check "NetCDF in words: depth" grep -qx 'depth      250 m' stdout.txt
check "NetCDF in words: grid" grep -q '^grid       NetCDF, 3 x 3 places from 64.00' stdout.txt
check "NetCDF in words: a column of its own" grep -qx '2026-05-01T00:00:00Z,10,270,,,,,,4000' wind.csv
check "NetCDF at a place" exits 0 "$cli" forecast wind.nc --place 64.75N,60.5W --json
check "NetCDF at a place: between four" json '(d["latitude_deg"], d["longitude_deg"]) == (64.75, -60.5) and abs(d["series"][0]["visibility_m"] - 7750) < 1'
check "NetCDF of an area" exits 0 "$cli" forecast wind.nc --area 64.4,-60.2,64.5,-60 --json
check "NetCDF of an area: the nodes around" json '(d["grids"][0]["rows"], d["grids"][0]["columns"]) == (2, 2)'
check "NetCDF elsewhere" exits 3 "$cli" forecast wind.nc --place 10N,10E
check "NetCDF elsewhere: says so" says "wind.nc: latitude: the forecast has no values in the area"
check "NetCDF at another time" exits 3 "$cli" forecast wind.nc --since 2027-01-01T00:00:00Z
check "NetCDF at another time: says which" says "the forecast is for another time, from 2026-05-01T00:00:00Z to 2026-05-01T12:00:00Z"
check "NetCDF from a pipe" exits 0 bash -c 'cat wind.nc | "$0" forecast -' "$cli"
head -c 9000 wind.nc >cut.nc
check "NetCDF that is cut off" exits 3 "$cli" forecast cut.nc
check "NetCDF that is cut off: names it" says "cut.nc: "
check "GRIB" exits 0 "$cli" forecast air.grib --json
check "GRIB: by hand" json 'd["issued"] == "2026-05-01T00:00:00Z" and abs(d["series"][0]["wind_speed_mps"] - 10) < 0.01 and abs(d["series"][0]["wind_from_deg"] - 270) < 0.1'
check "NetCDF and a reply of MET Norway" exits 0 "$cli" forecast wind.nc "$source_dir/tests/data/forecast/oceanforecast.json" --json
check "NetCDF and a reply of MET Norway: both" json 'd["missing"] == ["gust", "air temperature", "fog"]'

# --- into a scenario -------------------------------------------------------------------------
python3 - "$source_dir" <<'P'
import json, sys
with open(sys.argv[1] + "/resources/scenarios/disko-bay-4.berg") as file:
    scenario = json.load(file)
scenario["origin"] = {"latitude_deg": 64.5, "longitude_deg": -60}
scenario["start_utc"] = "2026-05-01T00:00:00Z"
with open("ice.berg", "w") as file:
    json.dump(scenario, file)
P
into=(--format forecast --into ice.berg)
check "into a scenario" exits 0 "$cli" import wind.nc "${into[@]}" --output with.berg
check "into a scenario: what" grep -qx 'gives      wind, visibility' stdout.txt
check "into a scenario: its age" says "wind.nc: warning: issued 30 h before"
check "into a scenario, as JSON" exits 0 "$cli" import wind.nc "${into[@]}" --output with.berg --force --json
check "into a scenario, as JSON: members" json 'list(d) == ["format","source","issued","places","columns","thinning","from","to","times","quantities"]'
check "into no scenario" exits 2 "$cli" import wind.nc --format forecast --output none.berg
check "into no scenario: says so" says "--format forecast needs --into, the scenario to add it to"
check "with an option for sightings" exits 2 "$cli" import wind.nc "${into[@]}" --output none.berg --area 1,2,3,4
check "with an option for sightings: says so" says "--format forecast accepts only"
check "without its format" exits 2 "$cli" import wind.nc --output none.berg
check "without its format: says which" says "wind.nc is a forecast; use --format forecast with --into SCENARIO"
check "at another time" exits 3 "$cli" import wind.nc "${into[@]}" --at 2027-01-01T00:00:00Z --output none.berg
check "--replace for sightings" exits 2 "$cli" import "$source_dir/tests/data/forecast/oceanforecast.json" --replace --output none.berg
check "no scenario is left" test ! -e none.berg

all_checked
