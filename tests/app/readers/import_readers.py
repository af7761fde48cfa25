"""Compares what bergwatch-cli imports of each fixture with what ogrinfo (GDAL) and gpsbabel read.

Use: import_readers.py CLI SOURCE_DIR WORK_DIR OGRINFO GPSBABEL

The number of places is compared (sightings and rejected rows against places of theirs), and each
iceberg that is where it was sighted must be at a place that they have as well. Where the programs
differ the difference is listed below with its reason; a difference that is not listed fails, and so
does one that is no longer there.
"""

import json
import math
import os
import re
import subprocess
import sys
import zipfile

cli, source, work, ogrinfo, gpsbabel = sys.argv[1:6]
fixtures = os.path.join(source, "tests", "data", "import")
os.makedirs(work, exist_ok=True)
TOLERANCE_DEG = 3e-4  # an iceberg with several fixes is where the filter through them has it

# Places that they have more than we do (or fewer, negative), and why. Of two numbers the second is
# that of gpsbabel 1.10, which reads more of the outlines of KML than 1.8.
OWN = "UAVs, area, asset, paths and visits of an export of our own are no sightings"
PREFIX = "it does not know the elements by their prefix"
KNOWN = {
    ("ogrinfo", "geometries.geojson"): (-2, "no place for the null geometry and the nested collection"),
    ("ogrinfo", "lines.geojsonl"): (-1, "the line that is cut off is a rejected row"),
    ("ogrinfo", "links.kmz"): (-1, "the link out of the archive is a rejected row"),
    ("gpsbabel", "links.kmz"): (-1, "the link out of the archive is a rejected row"),
    ("ogrinfo", "metno.geojson"): (-2, "a short position and a null geometry are rejected rows"),
    ("gpsbabel", "metno.geojson"): (3, "five corners of a polygon, nothing for the null geometry, "
                                       "and a latitude for the one that lacks it"),
    ("ogrinfo", "places.kml"): (-2, "an empty polygon and a place without numbers are rejected rows"),
    ("ogrinfo", "places.kmz"): (-2, "an empty polygon and a place without numbers are rejected rows"),
    ("gpsbabel", "points.geojson"): (1, "the line without times is one rejected row"),
    ("ogrinfo", "prefix.gpx"): (-3, PREFIX),
    ("gpsbabel", "prefix.gpx"): (-3, PREFIX),
    ("gpsbabel", "prefix.kml"): (-2, PREFIX),
    ("ogrinfo", "route.geojson"): (-4, "a corner without numbers costs the line"),
    ("ogrinfo", "scene.geojson"): (15, OWN),
    ("gpsbabel", "scene.geojson"): (29, OWN),
    ("ogrinfo", "scene.gpx"): (8, OWN),
    ("gpsbabel", "scene.gpx"): (8, OWN),
    ("ogrinfo", "scene.kml"): (15, OWN),
    ("gpsbabel", "scene.kml"): ((15, 31), OWN),
    ("ogrinfo", "shapes.kml"): (-1, "no model and no link, but both corners of a line"),
    ("gpsbabel", "shapes.kml"): ((4, 6), "no model, no points of collections, but corners of outlines"),
    ("ogrinfo", "tracks.kml"): (-1, "the track without places is a rejected row"),
}
# Files that they do not read, and why.
NOT_READ = {
    ("gpsbabel", "geometries.geojson"): "it stops at a point in metres",
    ("gpsbabel", "polar.geojson"): "it stops at a point in metres",
    ("gpsbabel", "lines.geojsonl"): "it knows no text sequences",
    ("gpsbabel", "records.geojsons"): "it knows no text sequences",
    ("gpsbabel", "places.kml"): "it stops at a track with more places than times",
    ("gpsbabel", "places.kmz"): "it stops at a track with more places than times",
    ("gpsbabel", "tracks.kml"): "it stops at a track with more places than times",
}
problems = []
compared = 0


def ours(path):
    """Counts and places of the icebergs that stand where they were sighted."""
    scenario = os.path.join(work, "imported.berg")
    run = subprocess.run([cli, "import", path, "--output", scenario, "--force", "--json"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        problems.append(f"{path}: {run.stderr}")
        return None
    report = json.loads(run.stdout)
    exported = os.path.join(work, "imported.geojson")
    subprocess.run([cli, "export", scenario, "--format", "geojson", "--output", exported, "--force"],
                   capture_output=True, check=True)
    with open(exported, encoding="utf-8") as file:
        features = json.load(file)["features"]
    still = {one["id"] for one in report["icebergs"] if one.get("age_s", 0) == 0}
    places = [one["geometry"]["coordinates"][:2] for one in features
              if one["properties"].get("kind") == "iceberg" and one["properties"]["id"] in still]
    too_far = sum("more than 1000 km" in row["reason"] for row in report["rejected_rows"])
    return report["sightings"] + report["rejected"] - too_far, places  # those are sightings, too


def numbers(text):
    return [[float(value) for value in part.split()[:2]] for part in text.split(",")]


def centroid(rings):
    """Of an area with holes; corners near one another."""
    sums = [0.0, 0.0, 0.0]
    for sign, ring in zip([1] + [-1] * len(rings), rings):
        first = ring[0]
        part = [0.0, 0.0, 0.0]
        for a, b in zip(ring[1:], ring[2:]):
            ax, ay, bx, by = a[0] - first[0], a[1] - first[1], b[0] - first[0], b[1] - first[1]
            area = (ax * by - ay * bx) / 2
            part = [part[0] + area, part[1] + area * (first[0] + (ax + bx) / 3),
                    part[2] + area * (first[1] + (ay + by) / 3)]
        turn = sign * math.copysign(1, part[0])
        sums = [total + turn * value for total, value in zip(sums, part)]
    return [sums[1] / sums[0], sums[2] / sums[0]]


def places_of_wkt(text):
    kind = text.split("(")[0].split()[0]
    if "EMPTY" in text:
        return []
    body = text[text.index("(") + 1:text.rindex(")")]
    if kind == "GEOMETRYCOLLECTION":
        points = [place for part in re.findall(r"POINT \([^)]*\)", body)
                  for place in places_of_wkt(part)]
        return points
    if kind.endswith("POLYGON"):
        polygons = re.findall(r"\(\([^()]*\)(?:,\([^()]*\))*\)", text)
        return [centroid([numbers(ring) for ring in re.findall(r"\(([^()]*)\)", polygon)])
                for polygon in polygons]
    return [place for part in re.findall(r"[-0-9. ,e]+", body) if part.strip(", ")
            for place in numbers(part.strip(", "))]


def in_degrees(path):
    """Of a file in metres, which ogrinfo shows as they are."""
    if path.endswith(".kmz"):
        return path
    with open(path, "rb") as file:
        if b'"crs"' not in file.read():
            return path
    degrees = os.path.join(work, "degrees.geojson")
    if os.path.exists(degrees):
        os.remove(degrees)
    subprocess.run([os.path.join(os.path.dirname(ogrinfo), "ogr2ogr"), "-f", "GeoJSON",
                    "-t_srs", "EPSG:4326", degrees, path], check=True)
    return degrees


def of_ogrinfo(path):
    path = in_degrees(path)
    run = subprocess.run([ogrinfo, "-ro", "-al", "-q", path], capture_output=True, text=True)
    places = []
    layer = ""
    for line in run.stdout.splitlines():
        feature = re.match(r"OGRFeature\((.*)\):", line)
        layer = feature.group(1) if feature else layer
        wkt = re.match(r"  ((?:MULTI)?(?:POINT|LINESTRING|POLYGON)|GEOMETRYCOLLECTION)(?: Z)? ", line)
        # Tracks and routes of GPX are there a second time as points.
        if wkt and not (path.endswith(".gpx") and layer in ("tracks", "routes")):
            places += places_of_wkt(line.strip())
    return places


def of_gpsbabel(path):
    kind = os.path.splitext(path)[1][1:]
    places = []
    for what in ("-w", "-r", "-t"):
        run = subprocess.run([gpsbabel, what, "-i", kind, "-f", path, "-o", "unicsv,prec=9", "-F", "-"],
                             capture_output=True, text=True)
        if run.returncode != 0:
            return None
        for row in run.stdout.splitlines()[1:]:
            values = row.split(",")
            places.append([float(values[2]), float(values[1])])
    return places


def read_by(read, path):
    """Neither program opens archives here, so their documents are given to it one by one."""
    if not path.endswith(".kmz"):
        return read(path)
    places = []
    with zipfile.ZipFile(path) as archive:
        for name in archive.namelist():
            if not name.lower().endswith(".kml") or os.path.basename(name).startswith("._"):
                continue
            document = os.path.join(work, "document.kml")
            with open(document, "wb") as file:
                file.write(archive.read(name))
            found = read(document)
            if found is None:
                return None
            places += found
    return places


def is_near(a, b):
    east = math.remainder(a[0] - b[0], 360)
    return abs(east) * math.cos(math.radians(a[1])) < TOLERANCE_DEG and abs(a[1] - b[1]) < TOLERANCE_DEG


def compare(program, name, mine, theirs):
    global compared
    compared += 1
    count, places = mine
    known, reason = KNOWN.get((program, name), (0, ""))
    if len(theirs) - count not in (known if isinstance(known, tuple) else (known,)):
        problems.append(f"{program}, {name}: {len(theirs)} places, ours {count}; "
                        f"known difference {known} {reason}")
    for place in places if reason in ("", OWN) else []:  # elsewhere they lack places
        if not any(is_near(place, other) for other in theirs):
            problems.append(f"{program}, {name}: they have no place {place}")


def main():
    names = sorted(name for name in os.listdir(fixtures)
                   if name.endswith((".geojson", ".geojsonl", ".geojsons", ".kml", ".kmz", ".gpx")))
    for name in names:
        path = os.path.join(fixtures, name)
        mine = ours(path)
        if mine is None:
            continue
        for program, read in (("ogrinfo", of_ogrinfo), ("gpsbabel", of_gpsbabel)):
            if (program, name) in NOT_READ:
                continue
            theirs = read_by(read, path)
            if theirs is None:
                problems.append(f"{program}, {name}: cannot be read, and is not listed")
            else:
                compare(program, name, mine, theirs)
    for program, name in list(KNOWN) + list(NOT_READ):
        if name not in names:
            problems.append(f"{program}, {name}: there is no such fixture")
    for problem in problems:
        print("FAILED:", problem)
    print(f"{compared} readings compared, {len(problems)} failures")
    return 1 if problems or compared < 20 else 0


sys.exit(main())
