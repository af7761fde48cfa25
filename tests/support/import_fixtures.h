#pragma once

#include "core/io/import/import_formats.h"
#include "core/io/import/import_scenario.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <array>
#include <string>

namespace berg::test {

/** A file of tests/data/import and what is in it. */
struct ImportFixture
{
    const char* file;
    const char* format;
    std::size_t sightings;
    std::size_t rejected;
};

inline constexpr std::array<ImportFixture, 17> kImportFixtures = {{
    {"iip.csv", "iip", 7, 7},
    {"cis-beacon.csv", "cis-beacon", 9, 3},
    {"usnic.csv", "usnic", 3, 3},
    {"metno.geojson", "metno", 3, 4},
    {"points.geojson", "geojson", 5, 3},
    {"route.geojson", "geojson", 3, 1},
    {"scene.geojson", "geojson", 4, 2},
    {"places.kml", "kml", 5, 4},
    {"scene.kml", "kml", 4, 2},
    {"places.kmz", "kmz", 5, 4},
    {"packets.czml", "czml", 4, 5},
    {"route.gpx", "gpx", 3, 1},
    {"scene.gpx", "gpx", 4, 1},
    {"qgc.plan", "plan", 3, 3},
    {"fence.plan", "plan", 1, 1},
    {"ardupilot.waypoints", "wpl", 3, 3},
    {"table.csv", "csv", 3, 6},
}};

inline std::string importFixture(const std::string& file)
{
    return readFile(BERG_TEST_DATA "/import/" + file);
}

inline SightingTable readFixture(const std::string& file)
{
    return readSightings(importFixture(file), file);
}

/** The sighting of a line; the fixtures have one for each line asked for. */
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

inline SightingTable readText(const std::string& text, const ReadOptions& options = {})
{
    return readSightings(text, "file", options);
}

/** A scenario that sightings can be imported into: one aircraft, no icebergs. */
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

/** A beacon at 60 N, 50 W that drifts north by 0.001 degrees (111.4 m) every ten minutes. */
inline SightingTable northward(int count)
{
    std::string rows;
    for (int i = 0; i < count; ++i)
        rows += "b," + utcText(utc("2024-05-01T00:00:00Z"), i * 600.0) + ',' +
                std::to_string(60 + 0.001 * i) + ",-50\n";
    return csv(rows);
}
inline constexpr double kNorthward_mps = 0.1857; // of the above, to 0.1 %

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

/** What a file is by itself. */
inline ImportResult importedAsNew(const std::string& text)
{
    return importSightings(newScenarioForImport("new"), readSightings(text, "export"));
}

} // namespace berg::test
