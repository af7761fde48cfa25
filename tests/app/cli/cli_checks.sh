#!/usr/bin/env bash
# Command-line checks: run bergwatch-cli as a stranger would and look at what comes out.
# Use: cli_checks.sh CLI SOURCE_DIR WORK_DIR CBC(ON|OFF) CHECKER
# Needs bash and python3 only, so that it also runs where there is no Qt.
. "$2/tests/app/cli/cli_support.sh"
with_cbc=$4
checker=${5:-true} # of certificates
default="$source_dir/resources/scenarios/grand-banks-12.berg"

# --- usage -----------------------------------------------------------------------------------
check "help" exits 0 "$cli" --help
check "version" exits 0 "$cli" --version
check "no command is wrong usage" exits 2 "$cli"
check "unknown command" exits 2 "$cli" fly
check "unknown flag" exits 2 "$cli" simulate "$default" --fast
check "unknown policy" exits 2 "$cli" simulate "$default" --policy drunken
check "tau out of range" exits 2 "$cli" plan "$default" --tau -1
check "tau not a number" exits 2 "$cli" sweep "$default" --tau 0:x:1
check "sweep without scenarios" exits 2 "$cli" sweep --tau 1
check "unknown export format" exits 2 "$cli" export "$default" --format docx --output x.docx
check "no file left by a wrong format" test ! -e x.docx

# --- solve -----------------------------------------------------------------------------------
cat >problem.json <<'P'
{"format":"bergwatch-problem","version":1,"sigma":[0,3.0,7.5],
 "distance_m":[[0,900,1500],[900,0,700],[1500,700,0]],"tau":0.5,"route":"open"}
P
check "solve" exits 0 "$cli" solve problem.json --json
# By hand: F1max = 3*1 + 7.5*2 = 18, D_est = 6200/6*2, mu = 0.5*18/D_est; order 1,2: -3*1 + mu 1600.
check "solve: members" json 'list(d) == ["status","objective","bound","gap","order","distance_m","mu","seconds","backend"]'
check "solve: mu" json 'abs(d["mu"] - 0.5*18/(6200/6*2)) < 1e-12'
check "solve: order and objective" json 'd["order"] == [2,1] and abs(d["objective"] - (-7.5 + d["mu"]*2200)) < 1e-9 or d["order"] == [1,2] and abs(d["objective"] - (-3 + d["mu"]*1600)) < 1e-9'
check "solve: best of both" json 'abs(d["objective"] - min(-7.5 + d["mu"]*2200, -3 + d["mu"]*1600)) < 1e-9'
check "solve: proven" json 'd["status"] == "optimal" and d["gap"] == 0 and d["bound"] == d["objective"]'
check "solve --mu beside --tau is refused" exits 2 "$cli" solve problem.json --tau 5 --mu 0
check "solve --mu beside --tau is refused: names both" says "--tau excludes --mu"
sed 's/"tau":0.5/"tau":0.5,"mu":1/' problem.json >both.json
check "a problem with mu beside tau is refused" exits 3 "$cli" solve both.json
check "a problem with mu beside tau is refused: says so" says "tau: must not be given beside mu"
check "solve --mu" exits 0 "$cli" solve problem.json --mu 0 --json
check "solve --mu 0: most uncertain first" json 'd["order"] == [2,1] and d["mu"] == 0'
cat >huge.json <<'P'
{"format":"bergwatch-problem","version":1,"sigma":[0,1,2,3],"mu":1,
 "position_m":[[0,0],[1e10,0],[0,1e10],[3e10,5]]}
P
check "solve --certificate" exits 0 "$cli" solve problem.json --certificate proof.json --json
check "solve --certificate: what it proves" python3 -c 'import json; p = json.load(open("proof.json"))["proofs"]; assert len(p) == 1 and p[0]["claim"] == "the orders are optimal"'
check "solve --certificate overwrites nothing" exits 2 "$cli" solve problem.json --certificate proof.json
check "curve --certificate" exits 0 "$cli" curve "$default" --certificate curve-proof.json --json
check "curve --certificate: what it proves" python3 -c 'import json; assert all(p["claim"] == "the orders are optimal" for p in json.load(open("curve-proof.json"))["proofs"])'
check "plan --certificate" exits 0 "$cli" plan "$default" --certificate plan-proof.json --json
check "plan --certificate of several UAVs" exits 0 "$cli" plan "$source_dir/resources/scenarios/svalbard-two-uavs.berg" --certificate fleet-proof.json --json
check "certificates are confirmed" "$checker" proof.json plan-proof.json curve-proof.json fleet-proof.json
# Latency and TSPLIB. By hand: orders 1,2 and 2,1 come to 3*900 + 7.5*1600 and 7.5*1500 + 3*2200.
check "solve --criterion latency" exits 0 "$cli" solve problem.json --criterion latency --json
check "solve --criterion latency: by hand" json 'd["order"] == [1,2] and d["objective"] == 14700 and d["mu"] == 1 and d["status"] == "optimal"'
check "solve --return" exits 0 "$cli" solve problem.json --criterion latency --return --json
check "solve --return: by hand" json 'd["order"] == [1,2] and d["objective"] == 14700 + 3100 and d["distance_m"] == 3100'
check "solve --return: mu" exits 0 "$cli" solve problem.json --criterion latency --return --mu 0.5 --json
check "solve --return: half of it" json 'd["objective"] == 8900'
check "solve --return without latency" exits 2 "$cli" solve problem.json --return
check "solve --return without latency: says so" says "--return excludes --criterion visitation"
check "solve latency beside a route" exits 2 "$cli" solve problem.json --criterion latency --route closed
check "solve latency beside tau" exits 2 "$cli" solve problem.json --criterion latency --tau 1
check "solve latency by cbc" exits 2 "$cli" solve problem.json --criterion latency --backend cbc
sed 's/7.5/0/' problem.json >zero.json
check "solve --return of a place without sigma" exits 3 "$cli" solve zero.json --criterion latency --return
check "solve --return of a place without sigma: names it" says "zero.json: sigma[2]: must be above 0"
optima() { # FILE: round tour, latency, latency with the return, by trying all orders
    python3 - "$1" <<'P'
import itertools, math, re, sys
text = open(sys.argv[1]).read()
numbers = [float(x) for x in re.search(r"SECTION\n(.*)", text, re.S).group(1).replace("EOF", "").split()]
n = int(re.search(r"DIMENSION: (\d+)", text).group(1))
at = [numbers[3 * i + 1:3 * i + 3] for i in range(n)]
d = lambda i, j: math.floor(math.dist(at[i], at[j]) + 0.5) if "EUC_2D" in text else numbers[n * i + j]
def costs(order):
    arrivals = list(itertools.accumulate(d(i, j) for i, j in zip((0,) + order, order)))
    back = arrivals[-1] + d(order[-1], 0)
    return back, sum(arrivals), sum(arrivals) + back
print(*(int(min(c)) for c in zip(*map(costs, itertools.permutations(range(1, n))))))
P
}
for instance in small.tsp small.atsp; do
    file=$source_dir/tests/data/scenarios/$instance
    read -r tour latency with_return <<<"$(optima "$file")"
    check "$instance: tour" exits 0 "$cli" solve "$file" --json
    check "$instance: tour: optimum" json "d['objective'] == d['distance_m'] == $tour and sorted(d['order']) == list(range(2, len(d['order']) + 2))"
    check "$instance: latency" exits 0 "$cli" solve "$file" --criterion latency --json
    check "$instance: latency: optimum" json "d['objective'] == $latency and d['distance_m'] < $latency"
    check "$instance: latency with the return" exits 0 "$cli" solve - --criterion latency --return --json <"$file"
    check "$instance: latency with the return: optimum" json "d['objective'] == $with_return and d['status'] == 'optimal' and 1 not in d['order']"
    check "$instance: certificate" exits 0 "$cli" solve "$file" --criterion latency --return --certificate "$instance.json"
    check "$instance: certificate is confirmed" "$checker" "$instance.json"
    check "$instance: validate" exits 0 "$cli" validate "$file"
done
check "solve --mu beyond all measure" exits 2 "$cli" solve huge.json --mu 1e300
check "solve --mu as large as in a file" exits 0 "$cli" solve huge.json --mu 1e15 --json
check "solve --route closed" exits 0 "$cli" solve problem.json --route closed --json
check "solve --route closed: distance" json 'd["distance_m"] == 3100'
for backend in auto exact heuristic; do
    check "solve --backend $backend" exits 0 "$cli" solve problem.json --backend $backend --json
    check "solve --backend $backend: result" json 'd["order"] in ([1,2],[2,1])'
done
if [ "$with_cbc" = ON ]; then
    check "solve --verify" exits 0 "$cli" solve problem.json --verify --json
    check "solve --verify: members" json 'list(d["verify"]) == ["agrees","backend","formulation","status","objective","bound","seconds"]'
    check "solve --verify agrees" json 'd["verify"]["agrees"] is True and d["verify"]["backend"] == "cbc" and d["verify"]["formulation"] == "position"'
    check "solve --verify in words" exits 0 "$cli" solve problem.json --verify
    check "solve --verify in words: agrees" grep -q "^verify  *agrees: cbc (position), objective .* ms)" stdout.txt
    check "cbc is verified by the exact solver" exits 0 "$cli" solve problem.json --backend cbc --verify --json
    check "cbc is verified by the exact solver: agrees" json 'd["verify"]["agrees"] is True and d["verify"]["backend"] == "exact" and d["verify"]["formulation"] is None'
    for formulation in position printed reduced; do
        check "solve cbc $formulation" exits 0 "$cli" solve problem.json --backend cbc --formulation $formulation --json
        check "solve cbc $formulation: proven" json 'd["status"] == "optimal" and d["backend"] == "cbc"'
    done
    python3 - <<'P'
import json, random
random.seed(3)
n = 13
json.dump({"format": "bergwatch-problem", "version": 1, "sigma": [0] + [random.randint(1, 10) for _ in range(n - 1)],
           "position_m": [[random.uniform(0, 5000), random.uniform(0, 5000)] for _ in range(n)], "tau": 0.5},
          open("hard.json", "w"))
P
    check "limit without a plan" exits 4 "$cli" solve hard.json --backend cbc --time-limit 0 --json
    check "limit without a plan: says none" json 'd["status"] == "none" and d["order"] == []'
    check "verify on 12 icebergs" exits 0 "$cli" solve hard.json --verify --json
    check "verify on 12 icebergs agrees" json 'd["verify"]["agrees"]'
    check "reduced on 12 icebergs" exits 0 "$cli" solve hard.json --backend cbc --formulation reduced --verify --json
    check "reduced on 12 icebergs: proven and verified" json 'd["status"] == "optimal" and d["verify"]["agrees"]'
    python3 - <<'P'
import json, random
random.seed(5)
for n in (31, 81):
    json.dump({"format": "bergwatch-problem", "version": 1, "sigma": [0] + [random.randint(1, 10) for _ in range(n - 1)],
               "position_m": [[random.uniform(0, 5000), random.uniform(0, 5000)] for _ in range(n)], "tau": 0.5},
              open(f"large{n - 1}.json", "w"))
P
    check "verify on 30 icebergs" exits 0 "$cli" solve large30.json --verify --json
    check "verify on 30 icebergs agrees" json 'd["verify"]["agrees"] is True and d["verify"]["formulation"] == "reduced"'
    check "verify with the formulation asked for" exits 0 "$cli" solve problem.json --formulation printed --verify --json
    check "verify with the formulation asked for: printed" json 'd["verify"]["formulation"] == "printed" and d["verify"]["agrees"]'
    check "no verdict is no failure" exits 0 "$cli" solve large30.json --formulation position --verify --time-limit 0.05
    check "no verdict: words" grep -q "not verified: cbc (position) came to the time limit" stdout.txt
    check "too large to verify" exits 0 "$cli" solve large80.json --tau 0 --verify --json
    check "too large to verify: null" json 'd["verify"]["agrees"] is None and d["verify"]["status"] == "none"'
else
    check "cbc is missing, said clearly" exits 3 "$cli" solve problem.json --backend cbc
    check "cbc is missing: words" says "without COIN-OR CBC"
    check "nothing to verify with" exits 3 "$cli" solve problem.json --verify
    check "nothing to verify with: words" says "without COIN-OR CBC"
    check "benchmark of the solvers there are" exits 0 "$cli" benchmark --sizes 4 --repeat 2 --json
    check "benchmark of the solvers there are: rows" json '[r["backend"] for r in d["rows"]] == ["exact","heuristic"]'
fi

# --- plan ------------------------------------------------------------------------------------
check "plan" exits 0 "$cli" plan "$default" --json
check "plan: every iceberg once" json 'sorted(d["order"]) == list(range(1,13)) and len(d["icebergs"]) == 12'
check "plan: proven" json 'd["status"] == "optimal"'
check "plan 40" exits 0 "$cli" plan "$source_dir/resources/scenarios/scoresby-sund-40.berg" --json
check "plan 40: an honest gap" json 'd["bound"] is not None and 0 <= d["gap"] < 0.1 and d["bound"] <= d["objective"]'
check "plan with --mu is refused" exits 2 "$cli" plan "$default" --mu 1
check "plan with --mu is refused: says so" says "--mu"
check "plan --help offers no --mu" test -z "$("$cli" plan --help | grep -e --mu)"
check "solve --help offers --mu" grep -q -e "--mu FLOAT" <("$cli" solve --help)
check "plan --help: defaults of the scenario" test "$("$cli" plan --help | tr -s ' \n' ' ' | grep -o "(the scenario's)" | wc -l)" -eq 3
python3 - "$default" <<'PY'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["planner"]["clusters"] = True
json.dump(scenario, open("clusters.berg", "w"))
PY
check "plan with clusters" exits 0 "$cli" plan clusters.berg --json
check "plan with clusters: every iceberg once, theirs in a row" json 'sorted(d["order"]) == list(range(1,13)) and d["clusters"] and all(any(d["icebergs"][k:k+len(c)] == c for k in range(12)) for c in d["clusters"])'
cp stdout.txt clusters.json
check "plan with clusters in words" exits 0 "$cli" plan clusters.berg
check "plan with clusters in words: who together" grep -q "^together " stdout.txt
check "curve with clusters" exits 0 "$cli" curve clusters.berg --json
check "curve with clusters: the plan is on it" json '[i["order"] for i in d["intervals"] if i["tau_from"] <= 1 < i["tau_to"]] == [json.load(open("clusters.json"))["order"]]'

# --- curve -----------------------------------------------------------------------------------
endurance=$source_dir/resources/scenarios/fram-strait-endurance.berg
check "plan with endurance" exits 0 "$cli" plan "$endurance" --json
check "plan with endurance: what one sortie can visit" json '1 <= d["uavs"][0]["this_sortie"] <= len(d["order"])'
check "plan with endurance in words" exits 0 "$cli" plan "$endurance"
check "plan with endurance in words: then home" grep -q "^sortie .*then home" stdout.txt
ends_at_home='rows = [line.split("\t") for line in open("sortie.waypoints")][1:]; raise SystemExit(rows[-1][3] != "20")'
check "export with endurance" exits 0 "$cli" export "$endurance" --format wpl --output sortie.waypoints
check "export with endurance: ends at home" python3 -c "$ends_at_home"
check "export --no-return-home" exits 0 "$cli" export "$endurance" --format wpl --output sortie.waypoints --force --no-return-home
check "export --no-return-home: ends over an iceberg" exits 1 python3 -c "$ends_at_home"

check "plan at tau 0.6" exits 0 "$cli" plan "$default" --tau 0.6 --json
cp stdout.txt plan06.json
check "curve" exits 0 "$cli" curve "$default" --json --output curve.csv
check "curve: members" json 'list(d) == ["intervals","complete","seconds"] and list(d["intervals"][0]) == ["tau_from","tau_to","distance_m","reward_m2","proven","order","icebergs","uavs"]'
check "curve: no gap from 0 to 5" json '[d["intervals"][0]["tau_from"]] + [i["tau_to"] for i in d["intervals"]] == [i["tau_from"] for i in d["intervals"]] + [5]'
check "curve: proven" json 'd["complete"] and all(i["proven"] for i in d["intervals"])'
check "curve: the plan is on it" json '[i["order"] for i in d["intervals"] if i["tau_from"] <= 0.6 < i["tau_to"]] == [json.load(open("plan06.json"))["order"]]'
check "curve --output" python3 -c '
import csv, json
table = list(csv.DictReader(open("curve.csv", newline="")))
d = json.load(open("stdout.txt"))["intervals"]
same = [[float(r["tau_to"]), [int(k) for k in r["order"].split()], r["icebergs"].split(";"), r["proven"]] for r in table] \
    == [[i["tau_to"], i["order"], i["icebergs"], "1"] for i in d]
raise SystemExit(0 if same else 1)'
check "curve table" exits 0 "$cli" curve "$default" --tau-max 1
check "curve table: its end" grep -q ' 1\.00000 .* yes ' stdout.txt
check "curve: tau-max out of range" exits 2 "$cli" curve "$default" --tau-max 0
check "curve of a missing file" exits 3 "$cli" curve missing.berg

# --- simulate --------------------------------------------------------------------------------
check "simulate" exits 0 "$cli" simulate "$default" --json
check "simulate: members" json 'list(d) == ["zeta_m2s","visits","replans","flown_m","lower_bound_m2s","seconds","uavs","closest_m"]'
check "simulate: length" json 'abs(d["flown_m"] - 22000) < 1e-6'
grep -v '"seconds"' stdout.txt >first.json
check "simulate again" exits 0 "$cli" simulate "$default" --json --output out
grep -v '"seconds"' stdout.txt >second.json
check "simulate twice: the same bytes" cmp -s first.json second.json
check "no bound unless asked for" json 'd["lower_bound_m2s"] is None'
four="$source_dir/resources/scenarios/disko-bay-4.berg" # the bound of twelve takes seconds
check "simulate --bound" exits 0 "$cli" simulate "$four" --duration 200 --bound --json
check "simulate --bound: below zeta" json '0 < d["lower_bound_m2s"] < d["zeta_m2s"]'
check "simulate --bound in words" exits 0 "$cli" simulate "$four" --duration 200 --bound
check "simulate --bound: the words" grep -q 'lower bound on zeta [0-9 ]* m2 s, from visit sequences$' stdout.txt
check "simulate: what befell icebergs" exits 0 "$cli" simulate "$source_dir/resources/scenarios/bonavista-lost.berg" --json
check "simulate: lost and found" json 'd["events"]["lost"] > 0 and d["events"]["found"] > 0 and list(d)[-1] == "events"'
check "simulate: lost and found in words" exits 0 "$cli" simulate "$source_dir/resources/scenarios/bonavista-lost.berg"
check "simulate: the words for lost" grep -q '^events .* lost, [0-9]* found' stdout.txt
for file in trajectory.csv sigma.csv events.csv zeta.csv run.bergrun; do
    check "simulate --output: $file" test -s out/$file
done
check "trajectory header" grep -qx 'time_s,uav,east_m,north_m,latitude_deg,longitude_deg,heading_deg,turn_rate_radps,cross_track_m' <(head -1 out/trajectory.csv)
check "zeta.csv ends at zeta" python3 -c '
import csv, json
last = list(csv.DictReader(open("out/zeta.csv")))[-1]
zeta = json.loads("{" + ",".join(open("first.json").read().strip(" {}\n\t").rstrip(",").split(",")) + "}")["zeta_m2s"]
raise SystemExit(0 if float(last["zeta_m2s"]) == zeta and float(last["time_s"]) == 1000 else 1)'
check "replay" exits 0 "$cli" simulate out/run.bergrun --json
grep -v '"seconds"' stdout.txt >replayed.json
check "replay: the same bytes" cmp -s first.json replayed.json
sed 's/"tau": *1\(\.0\)\?/"tau": 0.9/' out/run.bergrun >tampered.bergrun
check "tampered run differs" test "$(cmp -s out/run.bergrun tampered.bergrun; echo $?)" = 1
check "tampered run is refused" exits 1 "$cli" simulate tampered.bergrun
check "what options make wrong is wrong usage" exits 2 "$cli" simulate "$four" --dt 1 --duration 0.5
check "what options make wrong: named" says "--dt, --duration: "
cat >removed.bergrun <<'EOF'
{"format": "bergwatch-run", "version": 1,
 "scenario": {"format": "bergwatch-scenario", "version": 1, "duration_s": 60, "dt_s": 0.1, "uavs": [{"id": "u",
   "position_m": [0, 0], "heading_deg": 45}], "icebergs": [{"id": "a", "position_m": [3000, 3000], "sigma0_m2": 5},
   {"id": "b", "position_m": [-9000, 1000], "sigma0_m2": 1000}], "planner": {"policy": "visitation", "tau": 1}},
 "options": {}, "flown_until_s": 60, "interventions": [{"time_s": 0, "removed": "b"}],
 "plans": [{"time_s": 0, "target": 1, "order": [1, 0]}, {"time_s": 0, "target": 0, "order": [0]}],
 "metrics": {"zeta_m2s": 345.0750000000071, "visits": 0, "replans": 2, "flown_m": 1320.0000000000148},
 "keyframes": []}
EOF
sed 's/"removed": "b"}/"removed": "b"}, {"time_s": 1, "seen": "b"}/' removed.bergrun >removed-seen.bergrun
check "an intervention that cannot be" exits 3 "$cli" simulate removed-seen.bergrun
check "an intervention that cannot be: named" grep -q 'removed-seen.bergrun: interventions\[1\].seen: ' stderr.txt
check "no bound where an iceberg was removed" exits 2 "$cli" simulate removed.bergrun --bound
check "replay takes no changes" exits 2 "$cli" simulate out/run.bergrun --tau 2
check "other seed, other zeta" exits 0 "$cli" simulate "$default" --seed 99 --json
check "other seed differs" test "$(grep -v '"seconds"' stdout.txt | cmp -s - first.json; echo $?)" = 1
check "no noise" exits 0 "$cli" simulate "$default" --no-noise --dt 0.05 --duration 300 --policy tour
check "latency flies" exits 0 "$cli" simulate "$default" --policy latency --json
check "latency is planned" exits 0 "$cli" plan "$default" --policy latency
check "latency is planned: proven" grep -q "proven optimal" stdout.txt
check "latency with a back end that cannot" exits 2 "$cli" plan "$default" --policy latency --backend cbc
check "latency is swept" exits 0 "$cli" sweep "$default" --tau 1 --policies visitation,latency
check "coverage" exits 0 "$cli" simulate "$default" --policy coverage --duration 300 --output aimed
check "coverage: replay" exits 0 "$cli" simulate aimed/run.bergrun
check "coverage: the run holds its aim points" grep -q '"legs"' aimed/run.bergrun
check "output folder that cannot be" exits 1 "$cli" simulate "$default" --output problem.json/out
for scenario in "$source_dir"/resources/scenarios/*.berg; do
    check "simulate $(basename "$scenario")" exits 0 "$cli" simulate "$scenario" --json
done

# --- several UAVs ----------------------------------------------------------------------------
fleet="$source_dir/resources/scenarios/svalbard-two-uavs.berg"
check "fleet: plan" exits 0 "$cli" plan "$fleet" --json
check "fleet: plan: members" json 'list(d) == ["status","objective","bound","gap","order","distance_m","mu","seconds","backend","icebergs","uavs"] and list(d["uavs"][0]) == ["id","order","icebergs","distance_m"]'
check "fleet: plan: each iceberg once" json 'sorted(d["order"]) == list(range(1, 17)) and [u["id"] for u in d["uavs"]] == ["uav-1","uav-2"]'
check "fleet: plan: one order after the other" json 'd["order"] == d["uavs"][0]["order"] + d["uavs"][1]["order"] and d["icebergs"] == ["berg-%d" % k for k in d["order"]]'
check "fleet: plan: distances" python3 -c '
import json, math
d = json.load(open("stdout.txt")); s = json.load(open("'"$fleet"'"))
place = [b["position_m"] for b in s["icebergs"]]
def way(k):
    stops = [s["uavs"][k]["position_m"]] + [place[i - 1] for i in d["uavs"][k]["order"]]
    return sum(math.dist(a, b) for a, b in zip(stops, stops[1:]))
ok = all(abs(way(k) - d["uavs"][k]["distance_m"]) < 1e-6 for k in (0, 1)) and abs(way(0) + way(1) - d["distance_m"]) < 1e-6
sigma = [b["sigma0_m2"] for b in s["icebergs"]]
reward = sum(sigma[i - 1] * (17 - t) for u in d["uavs"] for t, i in enumerate(u["order"], 2))
raise SystemExit(0 if ok and abs(-reward + d["mu"] * d["distance_m"] - d["objective"]) < 1e-6 else 1)'
check "fleet: plan: gap" json '0 <= d["gap"] < 0.01 and d["bound"] <= d["objective"]'
check "fleet: standard output takes one file" exits 2 "$cli" export "$fleet" --format plan --output -
check "fleet: one UAV on standard output" exits 0 "$cli" export "$fleet" --format plan --output - --uav uav-1
check "fleet: plan in words" exits 0 "$cli" plan "$fleet"
check "fleet: plan in words: a line each" grep -q "^uav-2  *berg-[0-9 berg-]*(.* m)" stdout.txt
check "fleet: plan by coverage" exits 0 "$cli" plan "$fleet" --policy coverage --json
check "fleet: coverage has no objective" json 'd["objective"] is None and d["mu"] is None and len(d["uavs"]) == 2'
if [ "$with_cbc" = ON ]; then
    check "fleet: --verify" exits 0 "$cli" plan "$fleet" --verify --json
    check "fleet: --verify: by cbc" json 'd["verify"]["backend"] == "cbc" and d["verify"]["formulation"] is None and d["verify"]["agrees"] is not False'
fi
check "fleet: coverage is nothing to verify" exits 2 "$cli" plan "$fleet" --policy coverage --verify
check "fleet: coverage is nothing to verify: options" grep -q -- "--policy, --verify: this plan solves" stderr.txt
check "fleet: curve" exits 0 "$cli" curve "$fleet" --json --output fleet-curve.csv --certificate fleet-curve-proof.json
check "fleet: curve: proven" json 'd["complete"] and all(i["proven"] for i in d["intervals"])'
check "fleet: curve: orders by UAV" json 'all([u["id"] for u in i["uavs"]] == ["uav-1", "uav-2"] and sum((u["order"] for u in i["uavs"]), []) == i["order"] for i in d["intervals"])'
check "fleet: curve: both in the table" grep -q "^0,.*,[0-9 ]*|[0-9 ]*," fleet-curve.csv
check "fleet: curve: its proofs are confirmed" "$checker" fleet-curve-proof.json
check "fleet: curve in words" exits 0 "$cli" curve "$fleet" --tau-max 1
check "fleet: curve in words: whose" grep -q "those of uav-1 | uav-2" stdout.txt
check "fleet: --bound" exits 0 "$cli" simulate "$fleet" --duration 120 --bound --json
check "fleet: --bound: below zeta" json '0 < d["lower_bound_m2s"] < d["zeta_m2s"]'
check "fleet: simulate" exits 0 "$cli" simulate "$fleet" --json --output fleet
check "fleet: simulate: members" json 'list(d) == ["zeta_m2s","visits","replans","flown_m","lower_bound_m2s","seconds","uavs","closest_m"] and d["lower_bound_m2s"] is None'
check "fleet: simulate: sums" json 'sum(u["visits"] for u in d["uavs"]) == d["visits"] and abs(sum(u["flown_m"] for u in d["uavs"]) - d["flown_m"]) < 1e-6 and all(u["visits"] > 0 for u in d["uavs"])'
check "fleet: simulate: separation" json 'd["closest_m"] > 0'
grep -v '"seconds"' stdout.txt >fleet.json
check "fleet: simulate without tables" exits 0 "$cli" simulate "$fleet" --json
check "fleet: simulate without tables: the same" cmp -s fleet.json <(grep -v '"seconds"' stdout.txt)
check "fleet: replay" exits 0 "$cli" simulate fleet/run.bergrun --json
check "fleet: replay: the same" cmp -s fleet.json <(grep -v '"seconds"' stdout.txt)
check "fleet: tables" python3 -c '
import csv
rows = list(csv.DictReader(open("fleet/trajectory.csv")))
two = [r["uav"] for r in rows[:4]] == ["uav-1", "uav-2"] * 2 and len(rows) == 2 * 1501
reached = [e["uav"] for e in csv.DictReader(open("fleet/events.csv")) if e["event"] == "reached"]
raise SystemExit(0 if two and set(reached) == {"uav-1", "uav-2"} else 1)'
check "one UAV: simulate without tables" exits 0 "$cli" simulate "$source_dir/resources/scenarios/disko-bay-4.berg"
check "one UAV: its visits are told" grep -q "^uav-1  *$(sed -n 's/^visits  *\([0-9]*\) .*/\1/p' stdout.txt) visits, " stdout.txt
check "fleet: simulate in words" exits 0 "$cli" simulate "$fleet"
check "fleet: simulate in words: a line each" grep -q "^uav-2  *[0-9]* visits, " stdout.txt
check "fleet: sweep" exits 0 "$cli" sweep "$fleet" --tau 0,1 --policies visitation,tour --runs 2 --threads 1 --output fleet1.csv
check "fleet: sweep on three threads" exits 0 "$cli" sweep "$fleet" --tau 0,1 --policies visitation,tour --runs 2 --threads 3 --output fleet3.csv
check "fleet: sweep: threads do not matter" cmp -s fleet1.csv fleet3.csv
check "one UAV has no list of them" exits 0 "$cli" simulate "$default" --duration 60 --json
check "one UAV is a fleet of one" json '[u["visits"] for u in d["uavs"]] == [d["visits"]] and d["closest_m"] is None'

# --- sweep -----------------------------------------------------------------------------------
check "sweep" exits 0 "$cli" sweep --random 6 --tau 0:1:0.5 --policies visitation,tour --threads 1 --json --output sweep.csv
check "sweep: rows" json '[(r["policy"], r["tau"]) for r in d["rows"]] == [("visitation",0),("visitation",0.5),("visitation",1),("tour",None)]'
check "sweep: sizes" json 'all(r["n"] == 6 and r["mean_m2s"] > 0 for r in d["rows"])'
check "sweep: the reference" json 'd["reference"] == {"policy": "visitation", "tau": 1} and d["rows"][2]["difference"] == {"mean_percent": 0, "low_percent": 0, "high_percent": 0}'
check "sweep: differences" json 'all(r["difference"]["low_percent"] <= r["difference"]["mean_percent"] <= min(r["worst_percent"], r["difference"]["high_percent"]) and 0 <= r["lower_share"] <= 1 for r in d["rows"])'
check "sweep: best tau" json '0 <= d["best_tau"]["decile1"] <= d["best_tau"]["median"] <= d["best_tau"]["decile9"] <= 1 and d["best_tau"]["mean_m2s"] <= min(r["mean_m2s"] for r in d["rows"][:3])'
check "sweep: csv" grep -qx 'policy,tau,n,mean_m2s,standard_error_m2s,median_m2s,quartile1_m2s,quartile3_m2s,decile1_m2s,decile9_m2s,stuck_share,mean_visits,difference_percent,difference_low_percent,difference_high_percent,lower_share,worst_percent' <(head -1 sweep.csv)
cp sweep.csv one.csv
check "sweep with real drift" exits 0 "$cli" sweep --random 2 --regime fitted-drift --tau 1 --policies visitation,coverage
check "a first seed is of random scenarios" exits 2 "$cli" sweep "$default" --first-seed 5 --tau 1
check "a first seed is of random scenarios: says so" says "--first-seed needs --random N"
check "sweep of wide numbers" exits 0 "$cli" sweep "$source_dir"/resources/scenarios/{baffin-bay-day,recorded-drift}.berg --tau 0,1 -q
check "sweep of wide numbers: columns apart" python3 -c '
import re
rows = [re.split("  +", line.strip()) for line in open("stdout.txt")][:3]
raise SystemExit(not all(len(row) == 13 for row in rows))'
check "a regime is of random scenarios" exits 2 "$cli" sweep "$default" --regime measured --tau 1
check "sweep on four threads" exits 0 "$cli" sweep --random 6 --tau 0:1:0.5 --policies visitation,tour --threads 4 --output sweep.csv --force
check "sweep: threads do not matter" cmp -s one.csv sweep.csv
check "sweep: several noise seeds" exits 0 "$cli" sweep "$default" --tau 1 --runs 3 --json
check "sweep: several noise seeds, n" json 'd["rows"][0]["n"] == 3'
check "sweep: another reference" exits 0 "$cli" sweep --random 3 --tau 0:1:0.1 --policies visitation,tour --reference tour --json
check "sweep: another reference is used" json 'd["reference"] == {"policy": "tour", "tau": None} and d["rows"][-1]["worst_percent"] == 0'
check "sweep: 3 * 0.1 is 0.3" exits 0 "$cli" sweep --random 1 --tau 0:1:0.1 --reference visitation:0.3 --json
check "sweep: 3 * 0.1 is 0.3, in the rows" json 'd["rows"][3]["tau"] == 0.3 and d["reference"]["tau"] == 0.3'
check "sweep: reference not flown" exits 2 "$cli" sweep --random 1 --tau 0,1 --reference visitation:0.5
check "sweep: reference without tau" exits 2 "$cli" sweep --random 1 --tau 0,1 --reference visitation
check "sweep: the first seed" exits 0 "$cli" sweep --random 2 --first-seed 5 --tau 1 --json
cp stdout.txt later.json
check "sweep: the first seed, from the start" exits 0 "$cli" sweep --random 6 --tau 1 --json
check "sweep: the first seed matters" json 'd["rows"][0]["mean_m2s"] != json.load(open("later.json"))["rows"][0]["mean_m2s"]'
check "sweep: too many missions" exits 3 "$cli" sweep --random 1000000 --tau 0,1
check "sweep: too many missions: says so" says "at most 1000000"

# --- study files -----------------------------------------------------------------------------
small=(--random 5 --tau 0:2:1 --policies visitation,tour)
check "sweep --study" exits 0 "$cli" sweep "${small[@]}" --study whole.bergstudy --output whole.csv
cp stdout.txt whole.txt
cp whole.bergstudy first.bergstudy
check "sweep --study again" exits 0 "$cli" sweep "${small[@]}" --study whole.bergstudy
check "sweep --study again: the same" cmp -s first.bergstudy whole.bergstudy
check "a study is a valid file" exits 0 "$cli" validate whole.bergstudy
for part in 1 2 3; do
    check "shard $part" exits 0 "$cli" sweep "${small[@]}" --study part$part.bergstudy --shard $part/3 --threads $part
    check "shard $part: says that it is a part" says "incomplete"
done
check "study" exits 0 "$cli" study part3.bergstudy part1.bergstudy part2.bergstudy --study merged.bergstudy --output merged.csv
check "study: prints what one sweep prints" cmp -s whole.txt stdout.txt
check "study: is the file of one sweep" cmp -s whole.bergstudy merged.bergstudy
check "study: writes the table of one sweep" cmp -s whole.csv merged.csv
check "study of a part" exits 0 "$cli" study part2.bergstudy --json
check "study of a part: its cases" json 'd["cases"] == 2 and d["flown"] == 8 and d["missions"] == 20 and d["rows"][0]["n"] == 2'
check "study of a part: says so" says "incomplete: 8 of 20 missions"
check "a part is carried on by another shard" exits 0 "$cli" sweep "${small[@]}" --study part2.bergstudy --shard 1/3
check "a part is carried on by the whole" exits 0 "$cli" sweep "${small[@]}" --study part2.bergstudy
check "a part is carried on: the same" cmp -s whole.bergstudy part2.bergstudy
check "another study is refused" exits 3 "$cli" sweep --random 5 --tau 0:3:1 --policies visitation,tour --study part1.bergstudy
check "another study: says what differs" says "part1.bergstudy: taus: differs"
check "another study is not merged" exits 0 "$cli" sweep --random 5 --tau 1 --study other.bergstudy
check "another study is not merged: refused" exits 3 "$cli" study whole.bergstudy other.bergstudy
check "another study is not merged: names the file" says "other.bergstudy: taus: differs"
check "merged over another study" exits 3 "$cli" study whole.bergstudy --study other.bergstudy
check "--replace-study" exits 0 "$cli" sweep "${small[@]}" --study other.bergstudy --replace-study
check "--replace-study: the new study" cmp -s whole.bergstudy other.bergstudy
cp "$default" precious.berg
check "--replace-study spares what is no study" exits 3 "$cli" sweep "${small[@]}" --study precious.berg --replace-study
check "--replace-study spares what is no study: untouched" cmp -s "$default" precious.berg
python3 - <<'P'
import json
d = json.load(open("whole.bergstudy"))
d["outcomes"][1][2][0] += 1
json.dump(d, open("wrong.bergstudy", "w"))
P
check "contradicting outcomes" exits 3 "$cli" study whole.bergstudy wrong.bergstudy
check "contradicting outcomes: says where" says "setting 3 of case 2 has two different outcomes"
head -c 700 whole.bergstudy >cut.bergstudy
check "a study cut off" exits 3 "$cli" study cut.bergstudy
check "a study cut off: says where" says "cut.bergstudy: line"
check "a study is no scenario" exits 3 "$cli" simulate whole.bergstudy
check "a scenario is no study" exits 3 "$cli" study "$default"
check "shard without a file" exits 2 "$cli" sweep "${small[@]}" --shard 1/3
check "shard with a table" exits 2 "$cli" sweep "${small[@]}" --shard 1/3 --study x.bergstudy --output x.csv
for shard in 0/3 4/3 1 1/3x a/b " +1/ 3" "1/ 3"; do
    check "shard $shard" exits 2 "$cli" sweep "${small[@]}" --shard "$shard" --study x.bergstudy
done
check "wrong shards leave no file" test ! -e x.bergstudy
check "faulty studies leave no file" exits 3 "$cli" sweep "$default" --tau 1 --policies latency --study x.bergstudy --random 1000000 --runs 2
check "faulty studies leave no file: none" test ! -e x.bergstudy
check "study file that cannot be" exits 1 "$cli" sweep "${small[@]}" --study problem.json/x.bergstudy

# --- reports ---------------------------------------------------------------------------------
# report_is FILE EXPRESSION: `page` is the report as XML, `text` its text.
report_is() {
    python3 -c 'import sys, xml.etree.ElementTree as tree; page = tree.parse(sys.argv[1]).getroot()
text = " ".join(page.itertext()); sys.exit(0 if eval(sys.argv[2]) else 1)' "$1" "$2"
}
check "report" exits 0 "$cli" sweep --random 6 --tau 0:1:0.5 --policies visitation,tour --report report.html
check "report: charts" report_is report.html 'len(list(page.iter("{http://www.w3.org/2000/svg}svg"))) == 3'
check "report: what was flown" report_is report.html '"Random fields: 6, seeds 1 to 6." in text and "24 of 24" in text'
check "report: version" report_is report.html "\"Bergwatch $("$cli" --version)\" in text"
check "report: names neither machine nor user" report_is report.html 'not any(len(n) > 3 and n in text for n in (__import__("socket").gethostname(), __import__("os").environ.get("USER", "")))'
check "report is read again" exits 0 "$cli" study report.html --output again.csv --report again.html
check "report: the same numbers" cmp -s one.csv again.csv
made() { grep -v -e 'T[0-9:]*Z' -e 'Last run took' -e '<dd>[0-9.]* s</dd>' "$1" >"$1.numbers"; }
made report.html && made again.html
check "report: the same page" cmp -s report.html.numbers again.html.numbers
check "report is not flown into" exits 3 "$cli" sweep --random 6 --tau 0:1:0.5 --policies visitation,tour --study again.html
check "report is as before" cmp -s report.html.numbers again.html.numbers
check "report of one scenario" exits 0 "$cli" sweep "$default" --tau 0:1:0.5 --report one.html
check "report of one scenario: a curve" report_is one.html 'len(list(page.iter("{http://www.w3.org/2000/svg}svg"))) == 1 and "Grand Banks" in text'
check "no report of a shard" exits 2 "$cli" sweep --random 6 --tau 1 --shard 1/2 --study part.study --report part.html
check "no report of nothing" exits 3 "$cli" study one.csv --report no.html
check "no report of nothing is left" test ! -e no.html

# --- export ----------------------------------------------------------------------------------
for format in plan wpl geojson csv gpx kml kmz czml; do
    check "export $format" exits 0 "$cli" export "$default" --format $format --output plan.$format
    check "export $format of a run" exits 0 "$cli" export out/run.bergrun --format $format --output run.$format
    check "export $format: not empty" test -s plan.$format -a -s run.$format
done
check "plan is JSON" python3 -c 'import json; assert json.load(open("plan.plan"))["fileType"] == "Plan"'
check "wpl head" grep -qx 'QGC WPL 110' <(head -1 plan.wpl)
for format in sigma-csv decisions-csv zeta-csv; do
    check "export $format of a run" exits 0 "$cli" export out/run.bergrun --format $format --output run.$format
    check "no $format of a plan" exits 2 "$cli" export "$default" --format $format --output none.$format
    check "no $format of a plan: no file" test ! -e none.$format
done
check "no sightings of a plan" exits 2 "$cli" export "$default" --format sightings --output none.sightings
check "export zeta-csv: the run's table" cmp -s run.zeta-csv out/zeta.csv
cp plan.plan before.plan
check "export does not write over a file" exits 2 "$cli" export "$default" --format plan --altitude 90 --output plan.plan
check "export does not write over a file: says so" says "plan.plan exists"
check "export does not write over a file: as before" cmp -s plan.plan before.plan
check "export --force" exits 0 "$cli" export "$default" --format plan --altitude 90 --output plan.plan --force
plan_is() { python3 -c 'import json, sys; m=json.load(open(sys.argv[1]))["mission"]["items"]; sys.exit(0 if eval(sys.argv[2]) else 1)' "$@"; }
check "export --altitude" plan_is plan.plan 'all(i["params"][6] == 90 for i in m[2:-1])'
check "export first leg" exits 0 "$cli" export "$default" --format plan --what first-leg --speed 18.5 --acceptance 40 --output leg.plan
check "export first leg: one waypoint" plan_is leg.plan '[i["command"] for i in m] == [22, 178, 16, 17]'
check "export --speed, --acceptance" plan_is leg.plan 'm[1]["params"][1] == 18.5 and m[2]["params"][1] == 40'
check "export notes" says "note: Mission Planner reads the cruise speed as a whole number"
check "export --loiter --return-home" exits 0 "$cli" export "$default" --format plan --loiter 2 --return-home --output home.plan
check "export --loiter: turns" plan_is home.plan '{i["command"] for i in m[2:-1]} == {18} and m[2]["params"][0] == 2'
check "export --return-home" plan_is home.plan 'm[-1]["command"] == 20'
python3 - "$default" px4.berg <<'EDIT'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["uavs"][0].update(firmware="px4", mission_end="landing", camera="time", trigger_s=3)
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
check "export for PX4" exits 0 "$cli" export px4.berg --format plan --loiter 1 --output px4.plan
check "export for PX4: its commands" plan_is px4.plan '{i["command"] for i in m} == {22, 178, 16, 19, 2000, 2001, 189, 31, 21}'
check "export for PX4: lands at home" plan_is px4.plan 'm[-1]["command"] == 21 and m[-1]["params"][6] == 0 and m[-2]["params"][6] == 40'
check "export for PX4: notes" says "PX4 has no loiter by turns"
check "export path" exits 0 "$cli" export "$default" --format csv --what path --output path.csv
check "export path: a row a second" test "$(wc -l <path.csv)" -gt 500
check "export of an unknown UAV" exits 2 "$cli" export "$default" --format plan --uav nobody --output nobody.plan
check "export of a track of a plan" exits 2 "$cli" export "$default" --format gpx --what track --output none.gpx
check "export with a bad number" exits 2 "$cli" export "$default" --format plan --altitude -3 --output none.plan
check "refused exports leave nothing" test ! -e nobody.plan -a ! -e none.gpx -a ! -e none.plan
python3 - "$default" two.berg <<'EDIT'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["uavs"] = [dict(scenario["uavs"][0], id=name) for name in ("uav-1", "uav-2")]
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
python3 - "$default" years.berg <<'EDIT'
import json, sys
scenario = json.load(open(sys.argv[1]))
scenario["uavs"][0].update(airspeed_mps=1, position_m=[-900000, 0])
scenario["icebergs"] = [{"id": "away", "position_m": [900000, 0], "velocity_mps": [0.99, 0]}]
json.dump(scenario, open(sys.argv[2], "w"))
EDIT
for format in kml geojson csv gpx plan; do
    check "export $format of what takes years" exits 3 "$cli" export years.berg --format $format --output years.out
    check "export $format of what takes years: says why" says "cannot be exported: at "
    check "export $format below any airspeed" exits 2 "$cli" export "$default" --format $format --speed 0.001 --output years.out
done
check "what takes years: no file" test ! -e years.out
check "export of two UAVs" exits 0 "$cli" export two.berg --format plan --output two.plan
check "export of two UAVs: a file each" test -s two-uav-1.plan -a -s two-uav-2.plan -a ! -e two.plan
check "export of one of them" exits 0 "$cli" export two.berg --format plan --uav uav-2 --output two.plan
check "export of both in one file" exits 0 "$cli" export two.berg --format kml --output two.kml

# --- import ----------------------------------------------------------------------------------
data="$source_dir/tests/data/import"
for file in iip.csv cis-beacon.csv usnic.csv metno.geojson points.geojson places.kml waypoints.gpx \
            qgc.plan fence.plan ardupilot.waypoints route.gpx route.geojson scene.geojson scene.kml \
            scene.gpx table.csv geometries.geojson lines.geojsonl polar.geojson tracks.kml \
            commas.kml shapes.kml links.kmz radar.nmea; do
    check "import $file" exits 0 "$cli" import "$data/$file" --output imported.berg --force
    check "import $file: names each rejected row" grep -q "$file: \(line\|feature\) " stderr.txt
    check "import $file: valid" exits 0 "$cli" validate imported.berg
    check "import $file: flies" exits 0 "$cli" simulate imported.berg --duration 20
done
# Photographs, where this build reads them.
if "$cli" import "$data/photo-gps.jpg" --output photo.berg 2>stderr.txt >stdout.txt; then
    check "import of photographs" exits 0 "$cli" import "$data"/photo-*.jpg --output photo.berg --force --json
    check "import of photographs: counts" json '(d["photographs"]["photographs"], d["photographs"]["with_position"], d["photographs"]["new"], d["added"], d["rejected"]) == (3, 1, 1, 1, 2)'
    mkdir -p folder && cp "$data"/photo-gps.jpg folder/A.JPEG && cp "$data/photo-plain.jpg" folder/b.jpg && echo no >folder/c.txt
    check "import of a folder" exits 0 "$cli" import folder --output photo.berg --force
    check "import of a folder: counts" grep -Eq '^read +2 photographs$' stdout.txt
    check "import of a folder: names the photograph" grep -q 'photograph 2: the photograph has no position' stderr.txt
    check "import of photographs without any position" exits 3 "$cli" import "$data/photo-plain.jpg" --output none.berg
    check "import of a photograph as a table" exits 2 "$cli" import "$data/photo-gps.jpg" --format csv --output none.berg
else
    check "import of photographs: this build says that it reads none" says "libexiv2"
    echo "NOTE: no libexiv2, photographs were not tested"
fi
check "--run without photographs" exits 2 "$cli" import "$data/iip.csv" --run run.bergrun --output none.berg
printf '{x "coordinates"' >broken.geojson
check "import of broken JSON" exits 3 "$cli" import broken.geojson --output none.berg
check "import of broken JSON: does not hint at itself" test -z "$(grep "'import'" stderr.txt)"
check "import --json" exits 0 "$cli" import "$data/iip.csv" --format iip --output imported.berg --force --json
check "import --json: members" json 'list(d) == ["format","sightings","rejected","noted","outside_area","outside_time","added","updated","unchanged","left_out","needs_consent","start_utc","origin","unused_columns","scene","icebergs","rejected_rows","noted_rows","outside_rows"]'
check "import --json: counts" json '(d["sightings"], d["rejected"], d["added"]) == (10, 4, 7) and d["rejected_rows"][0]["line"] == 7 and [r["line"] for r in d["noted_rows"]] == [8, 9, 10]'
check "import of a fence" exits 0 "$cli" import "$data/fence.plan" --output fence.berg
check "import of a fence: what is taken over" grep -q 'scene      area taken over as geofence' stdout.txt
check "import of a fence: its circles" grep -q 'scene      2 no-fly areas taken over' stdout.txt
check "import of a fence: it is there" python3 -c 'import json; s = json.load(open("fence.berg")); raise SystemExit(not (s["geofence"] and len(s["area_m"]) == 5 and s["uavs"][0]["altitude_m"] == 60))'
check "import of a fence into a scenario" exits 0 "$cli" import "$data/fence.plan" --into fence.berg --output again.berg --json
check "import of a fence into a scenario: kept" json 'd["scene"] == [{"note": "UAVs, area and asset of the file not taken over: the scenario is in use", "count": 1}]'
check "import again" exits 0 "$cli" import "$data/iip.csv" --into imported.berg --output again.berg --force --json
check "import again: nothing new" json 'd["unchanged"] == 7 and d["added"] + d["updated"] == 0'
check "import again: the same file" cmp -s imported.berg again.berg
check "import of an area and time" exits 0 "$cli" import "$data/iip.csv" --output area.berg --area 47,-50,53,-49 --since 2021-01-01T00:00:00Z --at 2021-04-02T00:00:00Z --json
check "import of an area and time: one" json '[i["id"] for i in d["icebergs"]] == ["2021-302"] and d["start_utc"] == "2021-04-02T00:00:00Z" and d["icebergs"][0]["age_s"] == 7.25 * 3600'
check "import with a track" exits 0 "$cli" import "$data/cis-beacon.csv" --output track.berg --at 2012-07-03T07:00:00Z --with-tracks --json
check "import with a track: it is there" python3 -c 'import json; t = json.load(open("track.berg"))["icebergs"][0]["track"]; raise SystemExit(not (t["time_s"][0] == 0 and t["time_s"][-1] == 39600 and len(t["time_s"]) == len(t["position_m"])))'
check "a track is flown and replayed" exits 0 "$cli" simulate track.berg --duration 60 --output trackout
check "a track is flown and replayed: equal" exits 0 "$cli" simulate trackout/run.bergrun
check "import of a continent" exits 0 "$cli" import "$data/antarctica.csv" --output far.berg
check "import of a continent: names what is left out" grep -q 'antarctica.csv: line 8: is more than 1000 km' stderr.txt
check "import of a continent: names what to do" grep -q 'choose others with --area' stderr.txt
check "import of an area: names what is outside" exits 0 "$cli" import "$data/antarctica.csv" --output far.berg --force --area -75,-110,-70,-100
check "import of an area: lists what is outside" grep -q 'line 2: lies outside the chosen area: "-64.5 -44.2"' stderr.txt
printf 'A,B\n47.1,-48.2\n' >columns.csv
check "import with a mapping" exits 0 "$cli" import columns.csv --map latitude=A --map longitude=B --output mapped.berg --json
check "import with a mapping: taken" json 'd["format"] == "csv" and d["added"] == 1 and d["start_utc"] is None'
check "import: one column mapped twice" exits 2 "$cli" import columns.csv --map latitude=A --map longitude=A --output never.berg
check "import: one field mapped twice" exits 2 "$cli" import columns.csv --map latitude=A --map latitude=B --output never.berg
check "import without the mapping" exits 3 "$cli" import columns.csv --output never.berg
check "import: a field that is none" exits 2 "$cli" import columns.csv --map height=A --output never.berg
check "import: a time that is none" exits 2 "$cli" import "$data/iip.csv" --at yesterday --output never.berg
check "import: an area that is none" exits 2 "$cli" import "$data/iip.csv" --area 1,2,3 --output never.berg
check "import: tracks from when" exits 2 "$cli" import "$data/cis-beacon.csv" --with-tracks --output never.berg
check "import: unknown format" exits 2 "$cli" import "$data/iip.csv" --format shp --output never.berg
check "import of a missing file" exits 3 "$cli" import missing.csv --output never.berg
check "import of a scenario" exits 3 "$cli" import "$default" --output never.berg
check "import of the program" exits 3 "$cli" import "$cli" --output never.berg
check "import of an empty area" exits 3 "$cli" import "$data/iip.csv" --area 0,0,1,1 --output never.berg
check "import of an empty area: words" says "none of its 10 sightings"
check "import: a place that cannot be written" exits 1 "$cli" import "$data/iip.csv" --output columns.csv/x.berg
printf 'call,time,lat,lon\nX,2026-05-01T10:00:00Z,47,-48\nY,2026-05-01T10:30:00Z,47.5,-48\nX,2026-05-01T11:00:00Z,47.01,-48\nY,2026-05-01T11:30:00Z,47.51,-48\n' >calls.csv
check "import: nothing tells the icebergs" exits 3 "$cli" import calls.csv --output never.berg
check "import: nothing tells the icebergs: a column" says "--map id=call: icebergs: 2, greatest speed between two sightings: 0.31 m/s"
check "import: nothing tells the icebergs: all rows" says "--one-iceberg: icebergs: 1"
check "import: nothing tells the icebergs: each row" says "--each-row: icebergs: 4"
check "import: a column tells the icebergs" exits 0 "$cli" import calls.csv --map id=call --output calls.berg --json
check "import: a column tells the icebergs: two" json '[(i["id"], i["velocity_from"], i["velocity_age_s"]) for i in d["icebergs"]] == [("X", "fixes", 1800), ("Y", "fixes", 0)]'
check "import: each row" exits 0 "$cli" import calls.csv --each-row --output calls.berg --force --json
check "import: each row: four" json 'd["added"] == 4'
printf 'time,lat,lon\n2026-05-01T10:00:00Z,47,-48\n2026-05-01T11:00:00Z,47.07,-48\n' >fast.csv
check "import: one iceberg is too fast" exits 3 "$cli" import fast.csv --one-iceberg --output never.berg
check "import: one iceberg is too fast: says so" says "is faster than 1.5 m/s"
check "import: one iceberg and each row" exits 2 "$cli" import calls.csv --one-iceberg --each-row --output never.berg
printf 'id,lat,lon\na,48.7,-56\n' >land.csv
check "import: on land" exits 3 "$cli" import land.csv --output never.berg
check "import: on land: names the option" says "accept it with --accept-doubtful"
check "import: on land all the same" exits 0 "$cli" import land.csv --accept-doubtful --output land.berg --json
check "import: on land all the same: says so" json 'd["needs_consent"] and "on land" in d["icebergs"][0]["notes"]'
check "import: nothing is written in vain" test ! -e never.berg

# --- benchmark -------------------------------------------------------------------------------
check "benchmark" exits 0 "$cli" benchmark --sizes 10,6,2,6 --repeat 3 --backends auto,heuristic --seconds 20 --json
check "benchmark: rows" json 'len(d["rows"]) == 6 and all(r["instances"] == 3 for r in d["rows"])'
check "benchmark: small sizes first" json '[r["icebergs"] for r in d["rows"]] == [2,2,6,6,10,10]'
check "benchmark: the paper beside it" json 'd["rows"][0]["paper_average_s"] == 0.02 and d["rows"][4]["paper_worst_s"] == 1.5'
facts() { python3 -c 'import json; print([[r[k] for k in ("icebergs","backend","formulation","instances","proven","worst_gap","mean_objective","work")] for r in json.load(open("stdout.txt"))["rows"]])'; }
facts >facts.txt
check "benchmark again" exits 0 "$cli" benchmark --sizes 2,6,10 --repeat 3 --backends auto,heuristic --seconds 20 --json
check "benchmark: all but the seconds repeats" cmp -s facts.txt <(facts)
check "benchmark table" exits 0 "$cli" benchmark --sizes 6 --repeat 2 --backends auto --seconds 5 --output bench.csv
check "benchmark table: the paper beside it" grep -q "^ *6  auto .* 0.18 .* 0.42 .* x" stdout.txt
check "benchmark csv" grep -qx 'icebergs,backend,formulation,instances,proven,cut,average_s,median_s,worst_s,worst_gap,mean_objective,work,paper_average_s,paper_worst_s,note' <(head -1 bench.csv)
check "benchmark of an unknown solver" exits 2 "$cli" benchmark --backends cplex
check "benchmark without time" exits 0 "$cli" benchmark --sizes 4,400 --repeat 2 --backends exact --seconds 0.001 --json
check "benchmark without time: a word for what is not tried" json '"note" in d["rows"][1] and d["rows"][1]["instances"] == 0'
if [ "$with_cbc" = ON ]; then
    check "benchmark of every solver" exits 0 "$cli" benchmark --sizes 2,4 --repeat 2 --seconds 60 --json
    check "benchmark of every solver: rows" json '[(r["backend"], r["formulation"]) for r in d["rows"]] == 2 * [("exact", None), ("heuristic", None), ("cbc", "reduced"), ("cbc", "position"), ("cbc", "printed")]'
    check "benchmark of every solver: they agree" json 'all(abs(r["mean_objective"] - d["rows"][5 * (i // 5)]["mean_objective"]) < 1e-6 and r["proven"] == 2 for i, r in enumerate(d["rows"]))'
    check "benchmark: cbc is its default formulation" exits 0 "$cli" benchmark --sizes 41 --repeat 2 --backends cbc --seconds 1 --json
    check "benchmark: beyond its ability" json 'd["rows"][0]["formulation"] == "position" and "at most 40" in d["rows"][0]["note"]'
fi

# --- validate and broken files ---------------------------------------------------------------
check "validate good files" exits 0 "$cli" validate "$source_dir"/resources/scenarios/*.berg problem.json out/run.bergrun
broken=0
while IFS= read -r -d '' file; do
    broken=$((broken + 1))
    check "validate $(basename "$file")" exits 3 "$cli" validate "$file"
    check "validate $(basename "$file"): names the file" says "$(basename "$file")"
    check "simulate $(basename "$file")" exits 3 "$cli" simulate "$file" --output never
done < <(find "$source_dir/tests/data/broken" -type f ! -name 'EXPECTED.tsv' -print0)
check "at least 40 broken files" test "$broken" -ge 40
check "broken input writes nothing" test ! -e never
check "validate: scenarioWarnings" exits 0 "$cli" validate "$source_dir/resources/scenarios/flemish-pass-appearing.berg"
check "validate: scenarioWarnings names the field" says "hint: icebergs[2].velocity_mps: drifts out of the area"
check "validate --json" exits 3 "$cli" validate --json problem.json missing.berg
check "validate --json: list" json '[(f["file"], f["severity"]) for f in d] == [("problem.json", "valid"), ("missing.berg", "error")]'

sed 's/"seed": *[0-9]*/"seed": 9007199254740993/' "$default" >seed.berg
check "validate: a seed beyond 2^53" exits 3 "$cli" validate seed.berg
check "validate: a seed beyond 2^53: names it" says "seed: "
python3 -c 'import json, sys; d = json.load(open(sys.argv[1])); d["icebergs"] = []; json.dump(d, open("none.berg", "w"))' "$default"
check "curve --certificate of no icebergs" exits 3 "$cli" curve none.berg --certificate none.json
check "plan --certificate of no icebergs" exits 3 "$cli" plan none.berg --certificate none.json

# --- numbers as they are meant ---------------------------------------------------------------
check "a number is decimal" exits 0 "$cli" simulate "$default" --duration 60 --seed 8 --json
grep -v '"seconds"' stdout.txt >eight.json
check "a number is decimal: 010 is ten" exits 0 "$cli" simulate "$default" --duration 60 --seed 010 --json
check "a number is decimal: 010 is not eight" test "$(grep -v '"seconds"' stdout.txt | cmp -s - eight.json; echo $?)" = 1
check "a number is decimal: 08 is eight" exits 0 "$cli" simulate "$default" --duration 60 --seed 08 --json
check "a number is decimal: 08 is eight, the same" cmp -s eight.json <(grep -v '"seconds"' stdout.txt)
check "a number is decimal: 0x10" exits 2 "$cli" simulate "$default" --seed 0x10
for word in nan inf -nan 1e999 0x1p3; do
    check "--gap $word" exits 2 "$cli" plan "$default" --gap=$word
    check "--time-limit $word" exits 2 "$cli" plan "$default" --time-limit=$word
    check "--tau $word" exits 2 "$cli" plan "$default" --tau=$word
    check "--tau-max $word" exits 2 "$cli" curve "$default" --tau-max=$word
    check "--duration $word" exits 2 "$cli" simulate "$default" --duration=$word
done
printf 'lat,lon,time\n47.1,-48.2,05/02/2021\n' >dates.csv
check "dates that can be read two ways" exits 0 "$cli" import dates.csv --output dates.berg
check "dates that can be read two ways: says so" says "line 2: dates such as 05/02/2021 are read month first"
check "dates: the day first" exits 0 "$cli" import dates.csv --output dates.berg --force --dates day-first
check "dates: the day first: taken" grep -q '"start_utc": "2021-02-05T00:00:00Z"' dates.berg
check "dates: the day first: nothing to say" test -z "$(grep dates stderr.txt)"

# --- texts of files on terminals -------------------------------------------------------------
odd="$source_dir/tests/data/odd/ids-escapes.berg"
# tame: neither stdout nor stderr holds a control character or a line that an id has broken.
tame() { ! LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|^newline' stdout.txt stderr.txt; }
for command in "plan $odd" "plan $odd --json" "simulate $odd --duration 60 --output odd" "validate $odd" \
               "export $odd --format plan --output odd.plan" "sweep $odd --tau 1"; do
    check "odd ids: $command" exits 0 "$cli" $command
    check "odd ids are tame: $command" tame
done
check "odd ids: an error" exits 2 "$cli" export "$odd" --format csv --uav "$(printf 'x\033[31m')" --output none.csv
check "odd ids: an error is tame" tame
check "odd ids: no formula in a table" exits 0 "$cli" export "$odd" --format csv --output odd.csv
check "odd ids: no formula in a table: an apostrophe" grep -q "'=cmd" odd.csv
for format in plan wpl geojson csv gpx kml czml; do
    check "odd ids: $format" exits 0 "$cli" export "$odd" --format $format --output "odd/odd.$format" --force
done
check "odd ids: no file holds a control that terminals obey" \
    test -z "$(LC_ALL=C grep -rlP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' odd)"
check "odd ids: no formula in a table of the flight" test -z "$(grep -rE '(^|,)"?[=@]' odd/*.csv)"

# --- Ctrl-C ----------------------------------------------------------------------------------
check "Ctrl-C gives 130" exits 130 interrupt "$cli" sweep --random 5000 --tau 0:5:0.1 --output interrupted.csv
check "Ctrl-C leaves no file" test ! -e interrupted.csv
check "Ctrl-C leaves no temporary file" test -z "$(find . -name '*interrupted*')"

long=(sweep --random 400 --tau 0:3:0.1)
check "Ctrl-C of a study gives 130" exits 130 interrupt "$cli" "${long[@]}" --study long.bergstudy --output long.csv
check "Ctrl-C of a study keeps what is done" exits 0 "$cli" study long.bergstudy --json
check "Ctrl-C of a study: a part" json '0 < d["flown"] < d["missions"] == 12400'
check "Ctrl-C of a study writes no table" test ! -e long.csv
check "Ctrl-C of a benchmark gives 130" exits 130 interrupt "$cli" benchmark --sizes 8,100 --repeat 200 --backends exact,heuristic --seconds 1000 --output part.csv
check "Ctrl-C of a benchmark keeps what is done" test "$(wc -l <part.csv)" -ge 2

all_checked
