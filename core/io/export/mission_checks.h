#pragma once

#include "core/io/export/export_notes.h"

#include <vector>

namespace berg {

/**
 * Checks the missions of all UAVs that visit anything, before they are written: climb and first
 * leg, legs of take-off, return and landing, distances between items, number of items, airspace at
 * the altitudes flown, endurance with climb and landing. Returns each kind of finding at most once
 * with the worst case; for a track none, as it was flown.
 */
[[nodiscard]] std::vector<ExportNote> missionChecks(const ExportContent& content);

} // namespace berg
