#!/usr/bin/env python3
"""Turns a land layer of the npm package world-atlas (TopoJSON) into the compact file the map reads.

    convert_land.py land-50m.json land-50m.bin

The same input gives the same bytes. Format, all numbers little-endian:

    8 bytes    "BERGLAND"
    u16        version, 1
    u16        units of the coordinates for one degree
    u16        side of a cell, degrees
    u32        number of cells, of those that hold land
    per cell, by row and then column:
      u8       row from the South Pole, u8 column from 180 W
      varint   number of rings
      per ring:
        varint   number of points, at least 3; the last one joins the first
        pairs of zigzag varints, east and north, units: the first point from the south-western
        corner of the cell, every other one from the point before it

Land is what has a winding number other than zero round all the rings of a cell; outer rings go
counter-clockwise and holes clockwise. The rings of neighbouring cells share every point of their
common border, so that they join without a seam in any projection. Edges along the border of a cell
are cuts, all others are coast.
"""

import json
import struct
import sys
from collections import defaultdict

MAGIC = b"BERGLAND"
VERSION = 1
UNITS = 1000  # 110 m; the coordinates of world-atlas are no finer than that
CELL_DEG = 5
CELL = CELL_DEG * UNITS
BORDER_STEP = UNITS  # points of a border at least every degree, so that it stays near its parallel
TURN = 360 * UNITS
POLE = 90 * UNITS


def rings_of(topology):
    """Rings of the land, lists of (longitude, latitude) in degrees, each with `is it a hole`."""
    scale = topology["transform"]["scale"]
    translate = topology["transform"]["translate"]
    arcs = []
    for arc in topology["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x += dx
            y += dy
            points.append((x * scale[0] + translate[0], y * scale[1] + translate[1]))
        arcs.append(points)

    def joined(indices):
        points = []
        for index in indices:
            arc = arcs[index] if index >= 0 else arcs[~index][::-1]
            points += arc[1:] if points else arc
        return points[:-1]

    for geometry in topology["objects"]["land"]["geometries"]:
        for polygon in geometry["arcs"]:
            for k, indices in enumerate(polygon):
                points = joined(indices)
                if not is_artefact(points):
                    yield points, k > 0


def is_artefact(points):
    """The South Pole cut out as a hole, and "Null Island" at 0 N 0 E."""
    return all(lat < -89.9 or max(abs(lon), abs(lat)) < 0.01 for lon, lat in points)


def unwrapped(points):
    """In units, without jumps at the antimeridian; and the longitude gained going round once."""
    ring = []
    east = 0.0
    before = points[0][0]
    for lon, lat in points:
        step = lon - before
        east += step - 360 * round(step / 360)
        before = lon
        ring.append((round((points[0][0] + east) * UNITS), round(lat * UNITS)))
    step = points[0][0] - before
    gain = east + step - 360 * round(step / 360)
    return without_repeats(ring), round(gain / 360) * TURN


def without_repeats(ring):
    return [p for i, p in enumerate(ring) if p != ring[i - 1]]


def crossing(a, b, axis, line):
    """Where the edge from `a` to `b` crosses the line, the same both ways."""
    if a[axis] > b[axis]:
        a, b = b, a
    run = b[axis] - a[axis]
    other = 1 - axis
    at = a[other] + (2 * (b[other] - a[other]) * (line - a[axis]) + run) // (2 * run)
    return (line, at) if axis == 0 else (at, line)


def closed_over_pole(ring, gain):
    """A ring round the South Pole, opened at a border of cells and closed along the pole."""
    for i, a in enumerate(ring):
        b = ring[i + 1] if i + 1 < len(ring) else (ring[0][0] + gain, ring[0][1])
        line = max(a[0], b[0]) // CELL * CELL
        if min(a[0], b[0]) < line < max(a[0], b[0]):
            start = crossing(a, b, 0, line)
            rest = ring[i + 1:] + [(x + gain, y) for x, y in ring[:i + 1]]
            return [start] + rest + [(start[0] + gain, start[1]), (start[0] + gain, -POLE),
                                     (start[0], -POLE)]
    raise ValueError("a ring round the pole crosses no meridian")


def doubled_area(ring):
    return sum(ring[i - 1][0] * y - x * ring[i - 1][1] for i, (x, y) in enumerate(ring))


def halves(ring, axis, line):
    low, high = [], []
    for i, b in enumerate(ring):
        a = ring[i - 1]
        if (a[axis] - line) * (b[axis] - line) < 0:
            at = crossing(a, b, axis, line)
            low.append(at)
            high.append(at)
        if b[axis] <= line:
            low.append(b)
        if b[axis] >= line:
            high.append(b)
    return without_repeats(low), without_repeats(high)


def cut(ring, axis):
    """Parts of the ring between neighbouring lines of cells."""
    low = min(p[axis] for p in ring) if ring else 0
    high = max(p[axis] for p in ring) if ring else 0
    if len(ring) < 3 or low == high:
        return []
    first = low // CELL + 1
    last = -(-high // CELL) - 1
    if first > last:
        return [ring]
    parts = halves(ring, axis, (first + last) // 2 * CELL)
    return cut(parts[0], axis) + cut(parts[1], axis)


def cells_of(topology):
    """Rings by (row, column), in units from 180 W and the South Pole."""
    cells = defaultdict(list)
    for points, is_hole in rings_of(topology):
        ring, gain = unwrapped(points)
        if len(ring) < 3:
            continue
        if gain:
            ring = closed_over_pole(ring, gain)
        if (doubled_area(ring) < 0) != is_hole:
            ring.reverse()
        for strip in cut(ring, 0):
            column = min(x for x, _ in strip) // CELL
            shift = TURN // 2 - (column * CELL + TURN // 2) // TURN * TURN
            for part in cut([(x + shift, y + POLE) for x, y in strip], 1):
                row = min(y for _, y in part) // CELL
                cells[row, (column * CELL + shift) // CELL].append(part)
    return cells


def borders_of(cells):
    """Points on every line of cells: places along it by (axis, line)."""
    places = defaultdict(set)
    for rings in cells.values():
        for ring in rings:
            for p in ring:
                for axis in (0, 1):
                    if p[axis] % CELL == 0:
                        places[axis, p[axis] % TURN].add(p[1 - axis])
    return {key: sorted(values) for key, values in places.items()}


def with_border_points(ring, borders):
    """Every edge along a border gets all the points that there are on it."""
    full = []
    for i, b in enumerate(ring):
        a = ring[i - 1]
        for axis in (0, 1):
            if a[axis] == b[axis] and a[axis] % CELL == 0:
                low, high = sorted((a[1 - axis], b[1 - axis]))
                between = {v for v in borders[axis, a[axis] % TURN] if low < v < high}
                between.update(range((low // BORDER_STEP + 1) * BORDER_STEP, high, BORDER_STEP))
                order = sorted(between, reverse=a[1 - axis] > b[1 - axis])
                full += [(a[0], v) if axis == 0 else (v, a[1]) for v in order]
        full.append(b)
    return full


def varint(value):
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def zigzag(value):
    return varint(2 * value if value >= 0 else -2 * value - 1)


def encoded(cells):
    borders = borders_of(cells)
    out = bytearray(MAGIC + struct.pack("<HHHI", VERSION, UNITS, CELL_DEG, len(cells)))
    points = 0
    for (row, column), rings in sorted(cells.items()):
        out += bytes((row, column)) + varint(len(rings))
        for ring in rings:
            full = with_border_points(ring, borders)
            points += len(full)
            out += varint(len(full))
            x, y = column * CELL, row * CELL
            for to in full:
                out += zigzag(to[0] - x) + zigzag(to[1] - y)
                x, y = to
    return bytes(out), points


def main():
    source, target = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        cells = cells_of(json.load(file))
    data, points = encoded(cells)
    with open(target, "wb") as file:
        file.write(data)
    print(f"{target}: {len(cells)} cells, {points} points, {len(data)} bytes")


if __name__ == "__main__":
    main()
