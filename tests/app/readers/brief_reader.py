"""Reads the table of a flight brief off its words and compares it with the CSV export of the same.

Use: brief_reader.py WORDS CSV SCENARIO [names] [first]; WORDS is what `pdftotext -bbox` made of the
brief. With `names` the names of the icebergs are compared as well; with `first` the brief may end
after some of the visits. Prints ok, or what differs.
"""
import csv
import datetime
import html
import json
import re
import sys

WORD = re.compile(r'<word xMin="(.*?)" yMin="(.*?)" xMax="(.*?)" yMax="(.*?)">(.*?)</word>')
ANGLE = r"(\d+)° ?(\d+[.,]\d+)′(?: ?([{}]))?"
ROW = re.compile(r"(\d+) (.*?) " + ANGLE.format("NS") + " " + ANGLE.format("EW") + " (.*)")
TOLERANCE_DEG = 1e-4  # hundredths of minutes are printed
SOME = 40  # visits that a brief has room for in any case


def degrees(whole, minutes, hemisphere):
    value = int(whole) + float(minutes.replace(",", ".")) / 60
    return -value if hemisphere in ("S", "W") else value


def lines_of(words):
    """The lines of the table in the order of reading: it may go on in further columns of the page."""
    heads = [word for word in words if word[4] == "Latitude"]
    words = [word for word in words if word[1] > min(head[1] for head in heads)]
    left, right = min(word[0] for word in words), max(word[2] for word in words)
    width = (right - left) / len(heads)
    lines = {}
    for x, top, _, bottom, text in sorted(words):
        column = int((x - left) / width)
        middle = (top + bottom) / 2
        key = next((k for k in lines if k[0] == column and abs(k[1] - middle) < 2), (column, middle))
        lines.setdefault(key, []).append(text)
    return [" ".join(lines[key]) for key in sorted(lines)]


def rows_of(bbox):
    """(number, name, latitude, longitude, rest of the line) of each iceberg."""
    words = [(*map(float, word[:4]), html.unescape(word[4])) for word in WORD.findall(bbox)]
    for line in lines_of(words):
        if match := ROW.fullmatch(re.sub("[\u00a0\u2009\u202f]", " ", line)):
            number, name, *angles, rest = match.groups()
            yield int(number), name, degrees(*angles[:3]), degrees(*angles[3:]), rest


def visits_of(table):
    """(number, names, latitude, longitude, arrival) of each visit; a cluster is one."""
    visits = []
    for row in table:
        name = row["name"] or row["iceberg"]
        number = int(row["sequence"])
        if visits and visits[-1][0] == number and float(row["leg_m"]) == 0:
            visits[-1][1].append(name)
        else:
            visits.append((number, [name], float(row["latitude_deg"]), float(row["longitude_deg"]),
                           float(row["arrival_s"])))
    return visits


def clock(start_utc, arrival_s):
    if start_utc is None:
        minutes, seconds = divmod(round(arrival_s), 60)
        hours, minutes = divmod(minutes, 60)
        return f"{hours}:{minutes:02}:{seconds:02}" if hours else f"{minutes:02}:{seconds:02}"
    start = datetime.datetime.fromisoformat(start_utc.replace("Z", "+00:00"))
    instant = start + datetime.timedelta(seconds=arrival_s + 0.5)
    return instant.strftime("%H:%M:%S")


def faults(rows, visits, start_utc, with_names):
    if len(rows) != len(visits):
        yield f"{len(rows)} rows of {len(visits)} visits"
        return
    for row, visit in zip(rows, visits):
        if row[0] != visit[0]:
            yield f"row {row[0]} in place of {visit[0]}"
        if with_names and not all(name in row[1] for name in visit[1]):
            yield f"row {row[0]}: {row[1]} in place of {visit[1]}"
        if abs(row[2] - visit[2]) > TOLERANCE_DEG:
            yield f"row {row[0]}: latitude {row[2]} in place of {visit[2]}"
        if abs((row[3] - visit[3] + 180) % 360 - 180) > TOLERANCE_DEG:
            yield f"row {row[0]}: longitude {row[3]} in place of {visit[3]}"
        if clock(start_utc, visit[4]) not in row[4]:
            yield f"row {row[0]}: {row[4]} in place of {clock(start_utc, visit[4])}"


def main(words_file, csv_file, scenario_file, *options):
    with open(csv_file, newline="") as table:
        visits = visits_of(list(csv.DictReader(table)))
    with open(scenario_file) as scenario:
        start_utc = json.load(scenario).get("start_utc")
    with open(words_file) as words:
        rows = list(rows_of(words.read()))
    if "first" in options and len(rows) >= SOME:
        visits = visits[:len(rows)]
    found = list(faults(rows, visits, start_utc, "names" in options))
    print("; ".join(found) or "ok")


main(*sys.argv[1:])
