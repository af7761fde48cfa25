#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/io/import/receivers/photo_exif.h"
#include "core/mission/mission.h"

#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace berg {

/** A photograph of a flight. */
struct Photo
{
    std::string name; ///< of its file
    PhotoData data;
};

/** A photograph with its place. */
struct PlacedPhoto
{
    std::string name;
    std::size_t line = 0; ///< number among the photographs, from 1: that of its sighting
    LatLon place;
    bool isOnTrack = false; ///< placed by its time on the flown track, because it has no position
    std::optional<UtcTime> time;
    std::optional<double> direction_deg; ///< of view, clockwise from true north
    std::string iceberg;                 ///< id of its iceberg
    bool isNew = false;                  ///< no iceberg of the run was near
};

/** Yield of the photographs of a flight. */
struct PhotoYield
{
    std::size_t photos = 0;
    std::size_t positioned = 0;  ///< with a position of their own
    std::size_t onTrack = 0;     ///< placed on the flown track by their time
    std::size_t near = 0;        ///< near an iceberg of the run
    std::size_t fresh = 0;       ///< placed photographs near none
    std::size_t newIcebergs = 0; ///< groups of these
    std::vector<PlacedPhoto> placed;
    SightingTable table; ///< a sighting for each placed photograph; the others are rejected
};

/** Flight and settings with which photographs are compared. */
struct PhotoRun
{
    const Mission* mission = nullptr; ///< a recorded flight; null if there is none
    std::optional<std::size_t> uav;   ///< row of the UAV with the camera; nullopt for the first
};

/**
 * Turns photographs into sightings. One without a position is placed where the UAV was at its time,
 * at the nearest recorded instant of the flight. One with a time is of the nearest iceberg of the
 * run whose estimate at that time is within half the diagonal of the field of view plus the radius
 * of its 95 % position circle. Others are new icebergs: "photo" and a number, the same for those
 * within that half diagonal and ten minutes of the one before. Throws as `instantAt`, and `Stopped`
 * if a stop is requested. Cost: a minute of flight for each photograph with a time.
 */
[[nodiscard]] PhotoYield photoYield(std::span<const Photo> photos, const PhotoRun& run,
                                    const std::stop_token& stop = {});

/** Returns the JSON object of the counts and an entry for each placed photograph. */
[[nodiscard]] std::string photoYieldJson(const PhotoYield& yield);

/** Returns true if the bytes are a photograph that the import reads (JPEG). */
[[nodiscard]] bool isPhotograph(std::string_view bytes);

} // namespace berg
