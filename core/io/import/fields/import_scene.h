#pragma once

#include "core/earth/geodesy.h"
#include "core/scenario/utc_time.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

// Scene of a file of sightings: objects other than icebergs.

/** A UAV; members that the file does not give are empty. */
struct SceneUav
{
    std::string id;
    std::string name;
    std::optional<LatLon> start;
    std::optional<LatLon> home;        ///< landing place
    std::optional<double> heading_deg; ///< true, clockwise from north
    std::optional<double> airspeed_mps;
    std::optional<double> altitude_m;
};

/** An area of a file: the operating area, or a no-fly area. */
struct SceneArea
{
    /** Exterior rings, closed or not; several of one polygon that is cut at the antimeridian. */
    std::vector<std::vector<LatLon>> rings; ///< longitudes in [-180, 180]
    bool geofence = false;
    bool isNoFly = false; ///< whether it is a no-fly area, which uses the members below
    std::string name = {};
    std::optional<double> floor_m = {};
    std::optional<double> ceiling_m = {};
};

/** The protected asset of a file. */
struct SceneAsset
{
    std::string name;
    LatLon place;
    std::optional<UtcTime> time;       ///< time of the place; nullopt means the start
    std::optional<Point> velocity_mps; ///< true east and north
    std::optional<double> range_m;
    std::optional<double> standoff_m = {};
    std::optional<double> standoffCeiling_m = {};
};

/** Results of applying the scene of a file. */
enum class SceneNote
{
    UavsTaken,
    AreaTaken,
    FenceTaken, ///< the area is taken as a geofence
    AssetTaken,
    NoFlyTaken,
    InUse, ///< nothing is taken, because the scenario already holds icebergs, an asset or an area
    UavsTooMany,
    UavsTooFar, ///< more than 1000 km east, west, north or south of the origin
    AreaUnreadable,
    AreaCorners,  ///< fewer than three, or too many
    AreaTooFar,   ///< more than 1000 km east, west, north or south of the origin
    AreaCrossing, ///< the outline touches or crosses itself
    AreaInParts,
    AreasMore, ///< further areas are left out
    AreaHoles,
    FenceCorners, ///< too many, so the area is not a geofence
    FenceOutside, ///< a UAV starts or lands outside, so the area is not a geofence
    NoFlyUnfit,   ///< a UAV starts or lands inside, or its heights are wrong
    RallyPoints,  ///< there are several, so home is where the mission starts
    AssetsMore,
    AssetTooFar,
    NumberWrong
};

/** A result with its number of occurrences. */
struct SceneFinding
{
    SceneNote note = SceneNote::UavsTaken;
    std::size_t count = 1;
    std::string detail; ///< the first wrong number, with its name in the file
    bool operator==(const SceneFinding&) const = default;
};

/** Returns the English words of a note: "%n UAV(s) taken over", where %n is the count. */
[[nodiscard]] std::string sceneNotePattern(SceneNote note);
/** Returns the English words of a finding: "2 UAVs taken over". */
[[nodiscard]] std::string sceneFindingText(const SceneFinding& finding);

/** Adds a finding, or increases the count of an existing one, which keeps its detail. */
void addFinding(std::vector<SceneFinding>& findings, SceneNote note, std::string detail = {});

/** All objects of a file other than icebergs. */
struct FileScene
{
    std::vector<SceneUav> uavs;
    std::optional<SceneArea> area;
    std::vector<SceneArea> noFly;
    std::optional<SceneAsset> asset;
    std::vector<SceneFinding> findings; ///< about objects that are none of these

    [[nodiscard]] bool isEmpty() const
    {
        return uavs.empty() && !area && noFly.empty() && !asset && findings.empty();
    }
    /**
     * Adds a UAV and returns it; the pointer is valid until the next call. Returns null after
     * adding a finding if there are as many as a scenario holds.
     */
    SceneUav* addUav();
    /**
     * Adds an area or a no-fly area. A second area, a no-fly area beyond `kMostNoFlyAreas` and an
     * outline with too many corners become findings and are not added.
     */
    void addArea(SceneArea added);
    /** Adds the asset. Further ones become findings. */
    void addAsset(SceneAsset added);
};

/**
 * Returns the place with its longitude in [-180, 180], or nullopt if it is out of range (longitudes
 * up to 360 are allowed) or not finite.
 */
[[nodiscard]] std::optional<LatLon> scenePlace(double latitude_deg, double longitude_deg);
/** Returns the place of two texts, or nullopt if one of them is no number as well. */
[[nodiscard]] std::optional<LatLon> scenePlaceOf(std::string_view latitude,
                                                 std::string_view longitude);

} // namespace berg
