#pragma once

// Private to core/io: from the sightings of one iceberg to its entry in the scenario.

#include "core/io/import/import_scenario.h"

namespace berg {

/** Whether a scenario may hold it. */
[[nodiscard]] bool onPlane(const Point& position_m);

/** To a centimetre: the noise of further digits would only be hard to read. */
[[nodiscard]] Point toCentimetre(const Point& position_m);

/** A sighting in the scenario's plane. */
struct PlacedSighting
{
    const Sighting* sighting = nullptr;
    Fix fix;               ///< its time in seconds from t = 0
    bool timeKnown = true; ///< otherwise taken as of t = 0
};

/** All that was sighted of one iceberg, in the order of the file. */
struct SightedIceberg
{
    std::string id;
    std::vector<PlacedSighting> sightings;
};

/** What the entry is made with. */
struct IcebergSetting
{
    const ImportOptions& options;
    const LocalFrame& frame;
    Point current_mps = Point::Zero();
    bool hasStart = false; ///< t = 0 is an instant
};

/**
 * Entry of an iceberg sighted at least once: `known` (the one of this id in the scenario, null for
 * a new one) brought up to date. `outcome` is Added, Updated, Unchanged or LeftOut; the entry
 * counts unless it is LeftOut.
 */
struct IcebergEntry
{
    Iceberg iceberg;
    ImportedIceberg report;
};
[[nodiscard]] IcebergEntry entryOf(const SightedIceberg& sighted, const Iceberg* known,
                                   const IcebergSetting& setting);

} // namespace berg
