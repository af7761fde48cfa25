#pragma once

#include "tests/support/files/known_shapes.h"
#include "tests/support/files/known_tables.h"

namespace berg::test {

/** Returns the file of this number, always the same; six of ten are tables. */
inline KnownFile knownFile(std::uint64_t number)
{
    KnownChooser choose(4900 + number);
    KnownFile file;
    const std::size_t kind = choose.below(20);
    addBergs(file, choose, anyIds(choose, 1 + choose.below(5)));
    ShapeWriter shapes(choose, file);
    const auto named = [&](const char* format) {
        file.name = formatted("%05llu.%s", static_cast<unsigned long long>(number), format);
    };
    if (kind < 12) {
        TableWriter(choose, file).write();
        named("csv");
    } else if (kind < 14) {
        shapes.geoJson();
        named("geojson");
    } else if (kind == 14) {
        shapes.geoJsonLines();
        named("geojson");
    } else if (kind == 15) {
        shapes.kmlPlacemarks();
        named("kml");
    } else if (kind == 16) {
        shapes.kmlTracks();
        named("kml");
    } else if (kind == 17) {
        shapes.gpx();
        named("gpx");
    } else if (kind == 18) {
        shapes.czml();
        named("czml");
    } else {
        shapes.mission();
        named(file.bytes.starts_with("QGC") ? "waypoints" : "plan");
    }
    return file;
}

} // namespace berg::test
