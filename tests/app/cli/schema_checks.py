#!/usr/bin/env python3
"""The JSON Schemas that are shipped, against every file of the tree and what the program writes.

Use: schema_checks.py CLI SOURCE_DIR WORK_DIR BUILT_SCHEMA_DIR
"""
import csv, json, pathlib, subprocess, sys

import jsonschema

cli, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
schemas = {path.name: json.loads(path.read_text())
           for folder in (source / "resources/schema", pathlib.Path(sys.argv[4]))
           for path in sorted(folder.glob("*.schema.json"))}
failures = 0


def check(what, holds, why=""):
    global failures
    if not holds:
        failures += 1
        print(f"FAILED: {what}" + (f": {why}" if why else ""))


def validator(kind):
    """With the scenario's definitions put in: how files find each other is up to who uses them."""
    own = json.dumps(schemas[f"bergwatch-{kind}.schema.json"])
    inner = json.dumps(schemas["bergwatch-scenario.schema.json"]["$defs"])
    schema = json.loads(own.replace('"bergwatch-scenario.schema.json#/$defs/', '"#/$defs/of_scenarios/'))
    if kind != "scenario":
        schema["$defs"] = schema.get("$defs", {}) | {
            "of_scenarios": json.loads(inner.replace('"#/$defs/', '"#/$defs/of_scenarios/'))}
    return jsonschema.Draft202012Validator(schema)


validators = {suffix: validator(kind)
              for suffix, kind in [(".berg", "scenario"), (".bergrun", "run"), (".bergstudy", "study")]}


def refused(constant):
    raise ValueError(constant) # Python takes NaN and Infinity, JSON has none


def faults(path):
    """What is wrong with the file by its schema; None: it is no JSON at all."""
    try:
        value = json.loads(path.read_text(), parse_constant=refused)
    except (ValueError, RecursionError):
        return None
    return [f"{error.json_path}: {error.message[:80]}" for error in validators[path.suffix].iter_errors(value)]


for name, schema in schemas.items():
    jsonschema.Draft202012Validator.check_schema(schema)
check("three schemas", len(schemas) == 3)

# What the program takes, the schema takes: examples, test files, and what it writes.
work.mkdir(parents=True, exist_ok=True)
run = lambda *words: subprocess.run([cli, *map(str, words)], check=True, capture_output=True)
examples = sorted((source / "resources/scenarios").glob("*.berg"))
for example in examples:
    run("simulate", example, "--duration", 300, "--output", work / example.stem, "--force", "--quiet")
study = work / "some.bergstudy"
run("sweep", source / "tests/data/scenarios/plain.berg", "--random", 2, "--tau", "0.5,1", "--policies",
    "visitation,tour", "--study", study, "--replace-study", "--quiet")
good = examples + sorted(work.glob("*/run.bergrun")) + [study]
good += [path for folder in ("scenarios", "odd") for path in sorted((source / "tests/data" / folder).iterdir())
         if path.suffix in validators]
for path in good:
    found = faults(path)
    check(path.name, found == [], str(found[:3] if found else found))

# What the program refuses, the schema refuses, but for what is about several fields together.
together = set("""
    area-crossing.berg area-on-a-line.berg autopilot-slow-endurance.berg dt-longer-than-run.berg
    duplicate-ids-uav-iceberg.berg duplicate-ids.berg duplicate-member-nested.berg
    duplicate-member.berg duplicate-nameless-member.berg duplicate-unknown-member.berg
    geofence-without-area.berg home-outside-geofence.berg iceberg-uav-unknown.berg
    lone-surrogate.berg observer-interval-short.berg run-end-late.bergrun
    run-intervention-backwards.bergrun run-intervention-iceberg-id.bergrun
    run-intervention-late.bergrun run-keyframe-no-icebergs.bergrun
    run-keyframe-step-backwards.bergrun run-keyframe-step-late.bergrun
    run-keyframe-each-step.bergrun run-keyframe-target-none.bergrun
    run-keyframe-tracks-missing.bergrun run-plan-backwards.bergrun run-plan-leg-iceberg.bergrun
    run-plan-order.bergrun run-plan-target.bergrun start-30-february.berg track-lists-unequal.berg
    track-times-falling.berg uav-outside-geofence.berg wind-as-fast-as-uav.berg
""".split())
with open(source / "tests/data/broken/EXPECTED.tsv") as table:
    rows = [row for row in csv.reader(table, delimiter="\t", quoting=csv.QUOTE_NONE) if not row[0].startswith("#")]
broken = [source / "tests/data/broken" / row[0] for row in rows if pathlib.Path(row[0]).suffix in validators]
check("broken files", len(broken) > 150)
for path in broken:
    passes = faults(path) == []
    check(path.name, passes == (path.name in together), "valid by its schema" if passes else "known to it now")

scenario = schemas["bergwatch-scenario.schema.json"]


def resolved(node):
    while "$ref" in node and node["$ref"].startswith("#"):
        target = scenario
        for part in node["$ref"][2:].split("/"):
            target = target[part]
        node = target
    return node


def unnamed(value, node, path):
    """Members that the schema has no name for."""
    node = resolved(node)
    if isinstance(value, list):
        return [name for entry in value for name in unnamed(entry, node["items"], path + "[]")]
    if not isinstance(value, dict):
        return []
    named = node["properties"]
    return [name for member, inner in value.items()
            for name in (unnamed(inner, named[member], f"{path}.{member}") if member in named else [f"{path}.{member}"])]


every = json.loads((source / "tests/data/scenarios/every-field.berg").read_text())
foreign = """.origin.datum .no_fly[].class .airspace[].frequency .ice_chart.areas[].stage .ice_chart.agency .operation.insurer .uavs[].colour .icebergs[].track.beacon .icebergs[].source .asset.flag
    .weather.visibility_m .ground_station.operator .planner.depth .camera""".split()
check("members without a name are those of others", unnamed(every, scenario, "") == foreign)

print(f"{len(good)} good and {len(broken)} broken files, {failures} failures")
sys.exit(failures > 0)
