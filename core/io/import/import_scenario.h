#pragma once

#include "core/io/import/import_table.h"
#include "core/scenario/scenario.h"
#include "core/tracking/sighting_track.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace berg {

/** Box of latitudes and longitudes; west above east: across the antimeridian. */
struct GeoBox
{
    double south_deg = -90;
    double west_deg = -180;
    double north_deg = 90;
    double east_deg = 180;
    bool operator==(const GeoBox&) const = default;

    /** The edges included. Longitudes may be given from -180 to 360. */
    [[nodiscard]] bool contains(const LatLon& place) const;
};

/** How sightings become icebergs. */
struct ImportOptions
{
    /**
     * Instant that becomes t = 0. None: the last sighting taken, or the scenario's own start where
     * that is later and it has icebergs already.
     */
    std::optional<UtcTime> at;
    std::optional<UtcTime> since; ///< sightings before are left out
    std::optional<UtcTime> until; ///< sightings after are left out
    std::optional<GeoBox> area;   ///< sightings outside are left out
    /**
     * Whether the origin moves to the middle of the icebergs' last sightings (to 0.0001 degrees);
     * none: when that moves nothing else, that is without icebergs, asset and area.
     */
    std::optional<bool> moveOrigin;
    /** How far back sightings are used for the velocity, how velocities change, and more. */
    TrackRules track{.drift = kFittedDrift};
    std::optional<double> positionSd_m; ///< of a sighting that does not tell; none: of such files
    double q_m2ps = 0.025;              ///< of an iceberg whose sightings do not tell
    bool withTracks = false;            ///< sightings after `at` become the true motion
    double tolerance_m = 20;            ///< of the positions left out of a track
    bool operator==(const ImportOptions&) const = default;
};

enum class ImportOutcome
{
    Added,
    Updated,   ///< the scenario has an iceberg of this id
    Unchanged, ///< likewise, and the sightings say nothing new
    LeftOut    ///< see the notes
};

/** What is worth knowing of one iceberg. */
enum class ImportNote
{
    TimeUnknown,     ///< of a file or scenario with times: counts as seen at t = 0
    VelocityUnknown, ///< one sighting, or the next too long ago: drifts with the current, or as
                     ///< before
    VelocityGiven,   ///< by the file
    VelocityClamped,
    GrowthEstimated,
    GrowthClamped,
    Stationary, ///< all sightings in one place, or reported aground: velocity and q are 0
    Repeated,   ///< some sightings had the time of another
    Jumped,     ///< some sightings were where it cannot have been
    TrackAttached,
    NoTrack,     ///< no sighting after `at`
    Older,       ///< left out: the scenario has a later observation
    SeenLater,   ///< left out: sighted only after `at`
    DriftedAway, ///< left out: more than 1000 km from the origin by `at`
    TooMany,     ///< left out: the scenario is full of icebergs sighted later
    IdTaken      ///< left out: an aircraft has this id
};

/** English words of a note. */
[[nodiscard]] std::string importNoteText(ImportNote note);

/** What became of one iceberg of the file. */
struct ImportedIceberg
{
    std::string id;
    ImportOutcome outcome = ImportOutcome::Added;
    std::size_t sightings = 0; ///< of it that were taken
    std::size_t used = 0;      ///< of these for the velocity
    double age_s = 0;          ///< of the last one at t = 0
    std::vector<ImportNote> notes;
};

struct ImportResult
{
    Scenario scenario;         ///< has no errors (`validate`) when the one it started from had none
    std::optional<UtcTime> at; ///< none: neither the sightings nor the options name a time
    std::vector<ImportedIceberg> icebergs; ///< in the order of the file
    std::size_t added = 0;
    std::size_t updated = 0;
    std::size_t unchanged = 0;
    std::size_t leftOut = 0;
    std::size_t outsideArea = 0;     ///< sightings
    std::size_t outsideTime = 0;     ///< sightings; those after `at` too, unless tracks are wanted
    Rejections rejected;             ///< rows of the table, and sightings too far from the origin
    std::vector<SceneFinding> scene; ///< what became of the rest of the file
    bool observerSet = false;        ///< to measurements: velocities are not known exactly
};

/** What sightings become a scenario with when they belong to none yet: one aircraft. */
[[nodiscard]] Scenario newScenarioForImport(std::string name);

/**
 * The scenario with the icebergs of the table, by id; nothing is written and `base` stays as it is.
 *
 * The last sighting at or before t = 0 places an iceberg, its velocity (`estimateTrack`, in the
 * scenario's plane; or what the file gives) carries it on to t = 0, and `observed_s` is the age of
 * that sighting, since which the variance has grown. A velocity that the file does not tell exactly
 * is known to what its sightings say, or to its spread, and fades to the current
 * (`TrackRules::drift`); the observer is then one that measures. The current of the scenario is
 * taken off the velocity, because the simulation adds it. An iceberg that is there already keeps
 * its name and whatever the sightings do not tell. In a scenario without icebergs, area and asset
 * the scene of the table is taken over too: its UAVs, area and asset; one in use keeps its own.
 * Without ids each place is an iceberg named by it, or all rows are one
 * (`SightingTable::oneIceberg`) named by its first time.
 *
 * When the start of the scenario moves, what was in it is carried along: positions by their
 * velocities, ages, appearance and tracks by the time between.
 *
 * Throws `Error{InvalidInput}` for options out of range, when the origin cannot move because of
 * what is in the scenario, and when moving the start would take some of that off the plane. Cost:
 * linear in the sightings; a million take a few seconds. `Stopped` when asked to stop.
 */
[[nodiscard]] ImportResult importSightings(const Scenario& base, const SightingTable& table,
                                           const ImportOptions& options = {},
                                           const std::stop_token& stop = {});

/**
 * What an import did, as the JSON document of the command line: format, counts, start, origin, what
 * became of UAVs, area and asset, an entry for each iceberg of the file, and the first thousand
 * rejected rows.
 */
[[nodiscard]] std::string importJson(const SightingTable& table, const ImportResult& result);

} // namespace berg
