#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/scenario/scenario.h"
#include "core/tracking/sighting_track.h"

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace berg {

/** Box of latitudes and longitudes; it crosses the antimeridian if west is greater than east. */
struct GeoBox
{
    double south_deg = -90;
    double west_deg = -180;
    double north_deg = 90;
    double east_deg = 180;
    bool operator==(const GeoBox&) const = default;

    /**
     * Returns true if the place is in the box, including its edges; longitudes of the box may be
     * from -180 to 360.
     */
    [[nodiscard]] bool contains(const LatLon& place) const;
};

/** Options for turning sightings into icebergs. */
struct ImportOptions
{
    /**
     * Instant that becomes t = 0; nullopt for the start of the scenario, or the last sighting used
     * if that is later.
     */
    std::optional<UtcTime> at;
    std::optional<UtcTime> since; ///< earlier sightings are left out
    std::optional<UtcTime> until; ///< later sightings are left out
    std::optional<GeoBox> area;   ///< sightings outside are left out
    /**
     * Whether the origin moves to the middle of the icebergs' last sightings, or of their densest
     * group if they are too far apart (to 0.0001 degrees). nullopt moves it unless the scenario is
     * already located by icebergs, an asset, an area or an origin from which they are within reach.
     */
    std::optional<bool> moveOrigin;
    /**
     * Rules of the velocity estimate: how far back sightings are used, how velocities change, and
     * more.
     */
    TrackRules track{.drift = kFittedDrift};
    /** Error of sightings without their own; without a value, that of the format. */
    std::optional<double> positionSd_m;
    /**
     * Standard deviation, along an axis, of a speed and direction that the file states: such drifts
     * are rounded to 0.1 kn and 10 degrees, and are means over an unknown time.
     */
    double statedDriftSd_mps = 0.1;
    double q_m2ps = 0.025;   ///< for icebergs whose sightings do not give it
    bool withTracks = false; ///< sightings after `at` become the true motion
    double tolerance_m = 20; ///< largest error of a track thinned by leaving out positions
    bool operator==(const ImportOptions&) const = default;
};

/** Result for one iceberg of an import. */
enum class ImportOutcome
{
    Added,
    Updated,   ///< the scenario has an iceberg with this id
    Unchanged, ///< the scenario has an iceberg with this id, and the sightings add nothing new
    LeftOut    ///< not imported; see the notes
};

/** Remarks about one imported iceberg. */
enum class ImportNote
{
    TimeUnknown,     ///< the file or scenario has times but the sighting has none; t = 0 is assumed
    VelocityUnknown, ///< there is one sighting, or the previous one is too old: drifts with the
                     ///< current, or as before
    VelocityGiven,   ///< by the file only
    VelocityClamped,
    GrowthEstimated,
    GrowthClamped,
    Stationary, ///< all sightings at one place, or reported aground: velocity and q are 0
    Repeated,   ///< some sightings had the same time as another
    Jumped,     ///< some sightings were at places it cannot have reached
    TrackAttached,
    NoTrack,      ///< no sighting after `at`
    Older,        ///< left out: the scenario has a later observation
    SeenLater,    ///< left out: sighted after `at` only
    DriftedAway,  ///< left out: more than 1000 km from the origin by `at`
    TooMany,      ///< left out: the scenario is full of icebergs sighted later
    IdTaken,      ///< left out: an aircraft has this id
    Contradicted, ///< the drift of the file is not used, because the fixes exclude it
    TooFast,      ///< faster than icebergs drift (`kDoubtfulSpeed_mps`); see `needsConsent`
    OnLand        ///< last seen on land, or carried there by its drift; see `needsConsent`
};

/** No iceberg is known to have drifted faster for long; most stay below 1 m/s. */
inline constexpr double kDoubtfulSpeed_mps = 1.5;

/** Evidence for the velocity of an iceberg at the start. */
enum class VelocitySource
{
    Nothing, ///< unknown, or as in the scenario before
    Fixes,
    File, ///< a drift stated by a sighting, or that it is aground
    Both
};

/** Returns the English sentence of a note. */
[[nodiscard]] std::string importNoteText(ImportNote note);

/** Names on the command line and in JSON. */
inline constexpr std::array<Named<VelocitySource>, 4> kVelocitySourceNames{{
    {VelocitySource::Nothing, "none"},
    {VelocitySource::Fixes, "fixes"},
    {VelocitySource::File, "file"},
    {VelocitySource::Both, "both"},
}};

/** Result of one iceberg of the file. */
struct ImportedIceberg
{
    std::string id;
    ImportOutcome outcome = ImportOutcome::Added;
    std::size_t sightings = 0; ///< number of its sightings that were used
    std::size_t used = 0;      ///< number of these used for the velocity
    double age_s = 0;          ///< age of the last one at t = 0
    VelocitySource velocityFrom = VelocitySource::Nothing;
    double velocityAge_s = 0; ///< age at t = 0 of the last fix or stated drift used for it
    std::vector<ImportNote> notes;
};

/** Result of an import of sightings. */
struct ImportResult
{
    Scenario scenario;         ///< valid (`validate`) if the scenario before the import was
    std::optional<UtcTime> at; ///< nullopt if neither the sightings nor the options have a time
    std::vector<ImportedIceberg> icebergs; ///< in the order of the file
    std::size_t added = 0;
    std::size_t updated = 0;
    std::size_t unchanged = 0;
    std::size_t leftOut = 0;
    std::size_t tooFar = 0;          ///< number of rejected sightings outside the plane
    std::size_t outsideArea = 0;     ///< number of sightings outside the area
    std::size_t outsideTime = 0;     ///< sightings, also after `at` without tracks
    Rejections rejected;             ///< rows of the table, and sightings too far from the origin
    Rejections noted;                ///< rows of the table that are used in part, or changed
    Rejections outside;              ///< sightings outside the area or the time
    std::vector<SceneFinding> scene; ///< results for the rest of the file
    bool observerSet = false;        ///< velocities are not exact, so it measures
};

/** Returns true if the iceberg is added or updated although it is too fast, or on land. */
[[nodiscard]] bool isDoubtful(const ImportedIceberg& iceberg);
/** Returns true if the user must agree before the result is used: an iceberg is doubtful. */
[[nodiscard]] bool needsConsent(const ImportResult& result);

/** Returns a scenario with one UAV for sightings that belong to no scenario yet. */
[[nodiscard]] Scenario newScenarioForImport(std::string name);

/**
 * Returns `base` with the icebergs of the table, matched by id; nothing is written.
 *
 * The last sighting at or before t = 0 places an iceberg, its velocity (`estimateTrack` in the
 * scenario's plane, or the file's) moves it on to t = 0, and `observed_s` is the age of that
 * sighting, since which the variance has grown. The drift that a file states and the velocity of
 * the fixes are combined by their variances (`fitDrift`). A velocity that the file does not give
 * exactly has the uncertainty of its sightings, or their spread, and fades to the current
 * (`TrackRules::drift`); the observer is then one that measures. The current of the scenario is
 * subtracted from the velocity, because the simulation adds it. An existing iceberg keeps its name
 * and all values that the sightings do not give. In a scenario without icebergs, area and asset the
 * scene of the table is applied too: its UAVs, area and asset; otherwise the scenario keeps its
 * own. Without ids each place is an iceberg named by it, or all rows are one iceberg
 * (`SightingTable::oneIceberg`) named by its first time.
 *
 * When the start of the scenario moves, its objects are carried along: positions by their
 * velocities, and ages, appearance and tracks by the time difference.
 *
 * Throws `Error{InvalidInput}` for options out of range, if the origin cannot move because of
 * objects in the scenario, if moving the start would carry some of them off the plane, and if the
 * result would have errors that `base` has not; `Error{FileTooLarge}` for more than 50,000 icebergs
 * (`readLimit`); `Stopped` if a stop is requested. Cost: linear in the sightings; a million take a
 * few seconds.
 */
[[nodiscard]] ImportResult importSightings(const Scenario& base, const SightingTable& table,
                                           const ImportOptions& options = {},
                                           const std::stop_token& stop = {});

/**
 * Returns the JSON document that the command line prints for an import: format, counts, start,
 * origin, results for UAVs, area and asset, an entry for each iceberg of the file, and the first
 * thousand each of the rows that are rejected, noted and outside the area or the time. The member
 * `photographs` has the JSON text given, unless that is empty.
 */
[[nodiscard]] std::string importJson(const SightingTable& table, const ImportResult& result,
                                     const std::string& photographs = {});

/** Returns the stored rows of a list as a JSON array of lines (or features) and reasons. */
[[nodiscard]] std::string rowsJson(const Rejections& rows);

} // namespace berg
