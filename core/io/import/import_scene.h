#pragma once

#include "core/base/geodesy.h"
#include "core/io/text/utc_time.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace berg {

// What a file of sightings says about the scene beside the icebergs.

/** A UAV, as far as the file tells. */
struct SceneUav
{
    std::string id;
    std::string name;
    std::optional<LatLon> start;
    std::optional<LatLon> home;        ///< where it lands
    std::optional<double> heading_deg; ///< true, clockwise from north
    std::optional<double> airspeed_mps;
    std::optional<double> altitude_m;
};

struct SceneArea
{
    /** Exterior rings, closed or not; several of one polygon that is cut at the antimeridian. */
    std::vector<std::vector<LatLon>> rings; ///< longitudes in [-180, 180]
    bool geofence = false;
    bool isNoFly = false; ///< with the members below
    std::string name = {};
    std::optional<double> floor_m = {};
    std::optional<double> ceiling_m = {};
};

struct SceneAsset
{
    std::string name;
    LatLon place;
    std::optional<UtcTime> time;       ///< when it is there; none: at the start
    std::optional<Point> velocity_mps; ///< true east and north
    std::optional<double> range_m;
    std::optional<double> standoff_m = {};
    std::optional<double> standoffCeiling_m = {};
};

/** What is worth knowing of it. */
enum class SceneNote
{
    UavsTaken,
    AreaTaken,
    FenceTaken, ///< the area, as a geofence
    AssetTaken,
    NoFlyTaken,
    InUse, ///< nothing taken: the scenario holds icebergs, an asset or an area already
    UavsTooMany,
    UavsTooFar, ///< more than 1000 km east, west, north or south of the origin
    AreaUnreadable,
    AreaCorners,  ///< fewer than three or too many
    AreaTooFar,   ///< likewise
    AreaCrossing, ///< touches or crosses itself
    AreaInParts,
    AreasMore, ///< further ones left out
    AreaHoles,
    FenceCircles,
    FenceCorners, ///< too many, so that the area is no geofence
    FenceOutside, ///< a UAV starts or lands outside, so that the area is no geofence
    NoFlyUnfit,   ///< a UAV starts or lands inside, or its heights are wrong
    RallyPoints,  ///< several, so that home is where the mission starts
    AssetsMore,
    AssetTooFar,
    NumberWrong
};

struct SceneFinding
{
    SceneNote note = SceneNote::UavsTaken;
    std::size_t count = 1;
    std::string detail; ///< the first number that is wrong, with its name in the file
    bool operator==(const SceneFinding&) const = default;
};

/** English words of a finding: "2 UAVs taken over". */
[[nodiscard]] std::string sceneFindingText(const SceneFinding& finding);

/** Counts a finding that is there already. */
void addFinding(std::vector<SceneFinding>& findings, SceneNote note, std::string detail = {});

struct FileScene
{
    std::vector<SceneUav> uavs;
    std::optional<SceneArea> area;
    std::vector<SceneArea> noFly;
    std::optional<SceneAsset> asset;
    std::vector<SceneFinding> findings; ///< what of the file is none of these

    [[nodiscard]] bool isEmpty() const
    {
        return uavs.empty() && !area && noFly.empty() && !asset && findings.empty();
    }
    /** The new UAV; null, and a finding, when there are as many as a scenario holds. */
    SceneUav* addUav();
    /** Further ones are findings, and so are outlines that are too long. */
    void addArea(SceneArea added);
    void addAsset(SceneAsset added);
};

/** Longitude in [-180, 180]; none for what is out of range (longitudes up to 360) or not finite. */
[[nodiscard]] std::optional<LatLon> scenePlace(double latitude_deg, double longitude_deg);

} // namespace berg
