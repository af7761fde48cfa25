#include "core/io/import/import_tracks.h"

#include "core/base/error.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_selection.h"
#include "core/io/text/atomic_file.h"
#include "core/tracking/sighting_track.h"

#include <algorithm>

namespace berg {

namespace {

PlacedTrack trackOf(const SightedIceberg& iceberg)
{
    std::vector<const PlacedSighting*> timed;
    for (const PlacedSighting& sighting : iceberg.sightings)
        if (sighting.timeKnown)
            timed.push_back(&sighting);
    if (timed.empty())
        return {};
    const LocalFrame frame(timed.front()->sighting->place);
    std::vector<Fix> fixes;
    for (const PlacedSighting* const sighting : timed)
        fixes.push_back({.time_s = sighting->fix.time_s,
                         .position_m = frame.toPlane(sighting->sighting->place)});
    PlacedTrack track;
    for (const std::size_t i : consistentFixes(fixes, TrackRules{}).indices)
        track.push_back({.time_s = fixes[i].time_s, .place = timed[i]->sighting->place});
    return track;
}

} // namespace

std::vector<PlacedTrack> tracksOf(const SightingTable& table)
{
    std::vector<const Sighting*> sightings;
    for (const Sighting& sighting : table.sightings)
        sightings.push_back(&sighting);
    std::vector<PlacedTrack> tracks;
    for (const SightedIceberg& iceberg : grouped(sightings, table, UtcTime(), {}))
        if (PlacedTrack track = trackOf(iceberg); !track.empty())
            tracks.push_back(std::move(track));
    return tracks;
}

std::vector<PlacedTrack> loadTracks(const std::string& path)
{
    const std::string text = readFile(path);
    SightingTable table = readSightings(text, path);
    if (table.isIdentityUnclear)
        table = readSightings(text, path, {.rows = RowIdentity::OneIceberg});
    std::vector<PlacedTrack> tracks = tracksOf(table);
    if (tracks.empty())
        throw Error(ErrorCode::InvalidInput, path, {{Severity::Error, "time", {IssueId::Missing}}});
    return tracks;
}

} // namespace berg
