#pragma once

#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace berg::test {

/** A file of tests/data/import and its content. */
struct ImportFixture
{
    const char* file;
    const char* format;
    std::size_t sightings;
    std::size_t rejected;
};

inline constexpr std::array<ImportFixture, 31> kImportFixtures = {{
    {"iip.csv", "iip", 10, 4},
    {"cis-beacon.csv", "cis-beacon", 9, 3},
    {"usnic.csv", "usnic", 5, 1},
    {"metno.geojson", "metno", 4, 3},
    {"points.geojson", "geojson", 6, 2},
    {"route.geojson", "geojson", 3, 1},
    {"scene.geojson", "geojson", 4, 2},
    {"geometries.geojson", "geojson", 12, 2},
    {"lines.geojsonl", "geojson", 2, 1},
    {"records.geojsons", "geojson", 2, 0},
    {"polar.geojson", "geojson", 2, 1},
    {"ids.geojson", "geojson", 3, 0},
    {"places.kml", "kml", 5, 4},
    {"prefix.kml", "kml", 2, 0},
    {"tracks.kml", "kml", 5, 2},
    {"commas.kml", "kml", 1, 2},
    {"shapes.kml", "kml", 5, 2},
    {"links.kmz", "kmz", 3, 1},
    {"macos.kmz", "kmz", 1, 0},
    {"scene.kml", "kml", 4, 2},
    {"places.kmz", "kmz", 5, 4},
    {"packets.czml", "czml", 4, 5},
    {"route.gpx", "gpx", 3, 1},
    {"scene.gpx", "gpx", 4, 1},
    {"same-name.gpx", "gpx", 5, 0},
    {"prefix.gpx", "gpx", 3, 0},
    {"qgc.plan", "plan", 3, 3},
    {"fence.plan", "plan", 1, 1},
    {"ardupilot.waypoints", "wpl", 3, 3},
    {"radar.nmea", "nmea", 4, 4},
    {"table.csv", "csv", 5, 4},
}};

inline std::string importFixture(const std::string& file)
{
    return readFile(BERG_TEST_DATA "/import/" + file);
}

inline SightingTable readFixture(const std::string& file)
{
    return readSightings(importFixture(file), file);
}

/** Returns the sighting of a line; the fixtures have one for each line requested. */
inline Sighting at(const SightingTable& table, std::size_t line)
{
    for (const Sighting& sighting : table.sightings)
        if (sighting.line == line)
            return sighting;
    return {};
}

inline std::string timeOf(const Sighting& sighting)
{
    return sighting.time ? utcText(*sighting.time, 0) : "none";
}

inline std::string faultAt(const SightingTable& table, std::size_t line)
{
    for (const RejectedRow& row : table.rejected.first)
        if (row.line == line)
            return englishText(reasonOf(row));
    return "not rejected";
}

/** Returns the note about a change in the row of a line. */
inline std::string noteAt(const SightingTable& table, std::size_t line)
{
    for (const RejectedRow& row : table.noted.first)
        if (row.line == line)
            return englishText(reasonOf(row));
    return "not noted";
}

/** Returns all notes about a row or feature, each followed by a semicolon. */
inline std::string notesAt(const SightingTable& table, std::size_t line)
{
    std::string notes;
    for (const RejectedRow& row : table.noted.first)
        if (row.line == line)
            notes += (notes.empty() ? "" : "; ") + englishText(reasonOf(row));
    return notes;
}

/**
 * Returns "id latitude longitude", to a millionth of a degree, of each sighting in the order of the
 * file.
 */
inline std::vector<std::string> placesOf(const SightingTable& table)
{
    std::vector<std::string> places;
    for (const Sighting& sighting : table.sightings) {
        std::array<char, 120> text{};
        std::snprintf(text.data(), text.size(), "%s %.6f %.6f", sighting.id.c_str(),
                      sighting.place.latitude_deg, sighting.place.longitude_deg);
        places.emplace_back(text.data());
    }
    return places;
}

/** Joins lines, so that a mismatch shows both lists. */
inline std::string joinedLines(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines)
        text += line + '\n';
    return text;
}

inline SightingTable readText(const std::string& text, const ReadOptions& options = {})
{
    return readSightings(text, "file", options);
}

/** Returns a scenario for importing sightings: one UAV, no icebergs. */
inline Scenario openSea()
{
    Scenario scenario;
    scenario.name = "sea";
    Uav uav;
    uav.id = "uav-1";
    scenario.uavs.push_back(uav);
    return scenario;
}

inline UtcTime utc(const char* text)
{
    return *parseUtc(text);
}

inline SightingTable csv(const std::string& rows)
{
    return readSightings("id,time,lat,lon\n" + rows, "rows.csv");
}

/**
 * Returns a beacon at 60 N, 50 W that drifts north by 0.001 degrees (111.4 m) every ten minutes.
 */
inline SightingTable northward(int count)
{
    std::string rows;
    for (int i = 0; i < count; ++i)
        rows += "b," + utcText(utc("2024-05-01T00:00:00Z"), i * 600.0) + ',' +
                std::to_string(60 + 0.001 * i) + ",-50\n";
    return csv(rows);
}
inline constexpr double kNorthward_mps = 0.1857; // its speed, to 0.1 %

inline bool has(const ImportedIceberg& iceberg, ImportNote note)
{
    return std::find(iceberg.notes.begin(), iceberg.notes.end(), note) != iceberg.notes.end();
}

inline std::vector<SceneNote> notesOf(const ImportResult& result)
{
    std::vector<SceneNote> notes;
    for (const SceneFinding& finding : result.scene)
        notes.push_back(finding.note);
    return notes;
}

inline bool has(const ImportResult& result, SceneNote note)
{
    const std::vector<SceneNote> notes = notesOf(result);
    return std::find(notes.begin(), notes.end(), note) != notes.end();
}

/** Imports a text into a new scenario. */
inline ImportResult importedAsNew(const std::string& text)
{
    return importSightings(newScenarioForImport("new"), readSightings(text, "export"));
}

} // namespace berg::test
