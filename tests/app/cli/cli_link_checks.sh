#!/usr/bin/env bash
# The commands vehicle and listen over UDP on this computer, and vehicle with a ground station by the
# npm package node-mavlink, which shares no code with it (see CONTRIBUTING.md).
# Use: cli_link_checks.sh CLI SOURCE_DIR WORK_DIR
. "$2/tests/app/cli/cli_support.sh"
scenario=$source_dir/resources/scenarios/grand-banks-12.berg
port=24550

# --- a vehicle is heard ------------------------------------------------------------------------
"$cli" vehicle "$scenario" --link udpout:127.0.0.1:$port --autopilot px4 --fly --speed 20 --duration 60 \
    >vehicle.txt 2>vehicle_errors.txt &
vehicle=$!
check "listen" exits 0 "$cli" listen --link udp:$port --duration 8 --tlog heard.tlog
check "listen: a line of the vehicle" grep -Eq '^1/1  px4  mode 67371008  4[67]\.[0-9]+ -4[0-9]\.[0-9]+  ' stdout.txt
check "listen: wind and battery" grep -Eq 'battery 100 %|item [0-9]' stdout.txt
# From python: a shell lets its background jobs ignore the signal.
check "vehicle: is ended" kill -TERM $vehicle
wait $vehicle
check "vehicle: ends cleanly" test $? -eq 0
check "vehicle: says who it is" grep -q 'system 1, px4$' vehicle.txt
check "vehicle: mission on board" grep -q 'mission items on board$' vehicle.txt
check "vehicle: no complaint" test ! -s vehicle_errors.txt
check "interrupt of listen: exit 0" interrupt "$cli" listen --link udp:$((port + 1))

# --- GPS receivers and ships -------------------------------------------------------------------
# A ship at 47.1 N, 48.2 W and 10 knots to the north, and a text that would change a terminal.
python3 - $((port + 3)) <<'P' &
import functools, operator, socket, sys, time
def sentence(content):
    return f"${content}*{functools.reduce(operator.xor, content.encode()):02X}\r\n".encode()
sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for _ in range(20):
    sender.sendto(sentence("GPRMC,120000,A,4706.000,N,04812.000,W,10.0,0.0,010526,,,A") + b"\x1b[2J$AIVDM\r\n",
                  ("127.0.0.1", int(sys.argv[1])))
    time.sleep(0.2)
P
check "ship" exits 0 "$cli" listen --link udp:$((port + 3)) --duration 4
check "ship: place and speed" grep -Eq '^127\.0\.0\.1:[0-9]+  nmea GPRMC  47\.100000 -48\.200000  5\.1 m/s  0 deg$' stdout.txt
check "ship: no control character" test -z "$(tr -d '[:print:]\n' <stdout.txt)"
wait

# --- the log is a recorded flight --------------------------------------------------------------
check "replay" exits 0 "$cli" listen --replay heard.tlog --output track.csv
check "replay: all of it" grep -Eq '^frames +[0-9]+, 0 bytes skipped$' stdout.txt
check "replay: positions" grep -Eq '^1/1 +[0-9]+ positions in [0-9.]+ s$' stdout.txt
check "replay: table" grep -qx 'time,system,component,latitude,longitude,altitude_m' track.csv
check "replay: a UAV that flies" python3 - <<'P'
import csv, sys
rows = list(csv.DictReader(open("track.csv")))
places = {(r["latitude"], r["longitude"]) for r in rows}
sys.exit(not (len(rows) > 10 and len(places) > 10 and all(r["system"] == "1" for r in rows)))
P
: >empty.tlog
check "replay of an empty log" exits 0 "$cli" listen --replay empty.tlog
{ cat heard.tlog && head -c 70000000 /dev/zero; } >large.tlog
check "replay of a log above 64 MiB" exits 0 "$cli" listen --replay large.tlog
check "replay of a log above 64 MiB: its positions" grep -Eq '^1/1 +[0-9]+ positions' stdout.txt
rm large.tlog
# --- a log of NMEA sentences -------------------------------------------------------------------
check "replay of NMEA" exits 0 "$cli" listen --replay "$source_dir/tests/data/import/radar.nmea" --output targets.csv
check "replay of NMEA: targets" grep -Eq '^radar +3 reports$' stdout.txt
check "replay of NMEA: broken lines" grep -Eq '^broken +4 lines$' stdout.txt
check "replay of NMEA: each with its reason" grep -q 'line 12: another part of the AIS message' stderr.txt
check "replay of NMEA: table" grep -qx '2026-05-02T12:00:02Z,radar,1,,47.0833500,-48.1666667,,' targets.csv
check "replay of another file" exits 3 "$cli" listen --replay "$scenario"
check "replay of another file: says why" says "is no telemetry log"

# --- mistakes ----------------------------------------------------------------------------------
refused() { # words, then the command
    local words=$1
    shift
    check "$*: refused" exits 2 "$cli" "$@"
    check "$*: says $words" says "$words"
}
refused "--link is required" vehicle "$scenario"
refused "--link, --replay is required" listen
refused "--link excludes --replay" listen --link udp --replay heard.tlog
refused "--tlog excludes --replay" listen --replay heard.tlog --tlog never.tlog
refused "--duration excludes --replay" listen --replay heard.tlog --duration 5
refused "--link: 14550 is no link: write udp:HOST:PORT" listen --link 14550
refused "--link: udp:127.0.0.1:70000 has no port from 1 to 65535" listen --link udp:127.0.0.1:70000
refused "--link: serial:/dev/ttyUSB0:1 has no baud rate" listen --link serial:/dev/ttyUSB0:1
refused "heard.tlog" listen --link udp --tlog heard.tlog
refused "there is no UAV uav-99" vehicle "$scenario" --link udp --uav uav-99
refused "must be from 0 to 100, not 101" vehicle "$scenario" --link udp --loss 101
check "vehicle of no scenario" exits 3 "$cli" vehicle track.csv --link udp --duration 1
check "broken link: is not the end" exits 0 "$cli" listen --link serial:/dev/null --duration 1.5
check "broken link: says so" says "the link is broken: "

# --- an independent ground station -------------------------------------------------------------
export BERGWATCH_NODE_MODULES=${BERGWATCH_NODE_MODULES:-$source_dir/build/node/node_modules}
if node -e 'require(process.env.BERGWATCH_NODE_MODULES + "/node-mavlink")' 2>/dev/null; then
    for autopilot in ardupilot px4; do
        port=$((port + 2))
        "$cli" vehicle "$scenario" --link udp:$port --autopilot $autopilot --duration 120 >/dev/null 2>&1 &
        vehicle=$!
        check "ground station of node-mavlink: $autopilot" exits 0 \
            node "$source_dir/tests/app/link/station.cjs" $port $autopilot
        kill $vehicle
        wait $vehicle
        port=$((port + 2))
        "$cli" vehicle "$scenario" --link udp:$port --autopilot $autopilot --duration 120 >/dev/null 2>&1 &
        vehicle=$!
        check "ground station with MAVProxy's habits: $autopilot" exits 0 \
            node "$source_dir/tests/app/link/mavproxy.cjs" $port $autopilot
        kill $vehicle
        wait $vehicle
    done
else
    echo "SKIPPED: node or its package node-mavlink is missing: no independent ground station was tested"
fi
all_checked
