#!/usr/bin/env python3
"""Checks the order of elements in GPX 1.1 and KML 2.2 files, which their schemas fix and most readers
do not look at. Use: xml_order.py FILE"""

import sys
import xml.etree.ElementTree as tree

POINT = ["ele", "time", "magvar", "geoidheight", "name", "cmt", "desc", "src", "link", "sym", "type",
         "extensions"]
FEATURE = ["name", "visibility", "open", "description", "TimeStamp", "TimeSpan", "styleUrl", "Style",
           "ExtendedData"]
GEOMETRY = ["Point", "LineString", "Polygon", "MultiGeometry", "Track", "MultiTrack"]
ORDER = {
    "gpx": ["metadata", "wpt", "rte", "trk", "extensions"],
    "metadata": ["name", "desc", "author", "copyright", "link", "time"],
    "wpt": POINT, "rtept": POINT, "trkpt": POINT,
    "rte": ["name", "cmt", "desc", "src", "link", "number", "type", "extensions", "rtept"],
    "trk": ["name", "cmt", "desc", "src", "link", "number", "type", "extensions", "trkseg"],
    "Document": FEATURE + ["Folder", "Placemark"],
    "Folder": FEATURE + ["Placemark"],
    "Placemark": FEATURE + GEOMETRY,
    "Track": ["altitudeMode", "when", "coord"],
    "Polygon": ["extrude", "tessellate", "altitudeMode", "outerBoundaryIs"],
    "LineString": ["extrude", "tessellate", "altitudeMode", "coordinates"],
    "Point": ["extrude", "altitudeMode", "coordinates"],
}
MIXED = {"Folder", "Placemark"}  # features in any order among themselves


def local(element):
    return element.tag.rsplit("}", 1)[1]


def check(element):
    order = ORDER.get(local(element))
    last = 0
    for child in element:
        if order is not None:
            rank = order.index(local(child))  # an unknown child fails here
            if local(element) == "Document" and local(child) in MIXED:
                rank = len(order)
            assert rank >= last, f"{local(child)} too late in {local(element)}"
            last = rank
        check(child)
    if local(element) == "Track":
        names = [local(child) for child in element]
        assert names.count("when") == names.count("coord"), "a time for each place"


check(tree.parse(sys.argv[1]).getroot())
