#pragma once

// Private to core/io: converts the sightings of one iceberg to its entry in the scenario.

#include "core/io/import/scenario/import_scenario.h"

namespace berg {

/** Returns true if the position is finite and within the plane of a scenario. */
[[nodiscard]] bool onPlane(const Point& position_m);

/** Rounds to a centimetre, because further digits are noise that is hard to read. */
[[nodiscard]] Point toCentimetre(const Point& position_m);

/** A sighting in the scenario's plane. */
struct PlacedSighting
{
    const Sighting* sighting = nullptr;
    Fix fix;               ///< its time in seconds from t = 0
    bool timeKnown = true; ///< whether the file gives a time; if not, t = 0 is assumed
};

/** All sightings of one iceberg, in the order of the file. */
struct SightedIceberg
{
    std::string id;
    std::vector<PlacedSighting> sightings;
};

/** Inputs shared by all icebergs of an import. */
struct IcebergInputs
{
    const ImportOptions& options;
    const LocalFrame& frame;
    Point current_mps = Point::Zero();
    bool hasStart = false; ///< t = 0 is a known instant
};

/** Scenario entry of an iceberg, and the report about it. */
struct IcebergEntry
{
    Iceberg iceberg;
    ImportedIceberg report;
};
/**
 * Returns the entry of an iceberg with at least one sighting: `known` (the scenario's iceberg with
 * this id, null for a new one) with the sightings applied. `report.outcome` is Added, Updated,
 * Unchanged or LeftOut; the entry is valid unless it is LeftOut.
 */
[[nodiscard]] IcebergEntry entryOf(const SightedIceberg& sighted, const Iceberg* known,
                                   const IcebergInputs& inputs);

} // namespace berg
