#pragma once

// Private to core/io: sightings in tables of comma-separated values.

#include "core/io/import/import_formats.h"

namespace berg {

/** Any table with a header: columns by their names, or as mapped. */
[[nodiscard]] SightingTable readAnyCsv(const ImportText& source);
[[nodiscard]] bool isAnyCsv(std::string_view text);

/**
 * IIP sightings, NSIDC G00807: season, number, date, time, latitude, longitude, method, size,
 * shape, source, by position because the header's words vary; with or without header. An iceberg's
 * id is `season-number`; the time is HHMM without leading zeros; a date must lie in the season,
 * October of the year before to September, give or take a month.
 */
[[nodiscard]] SightingTable readIip(const ImportText& source);
[[nodiscard]] bool isIip(std::string_view text);

/** Standardised beacons of the Canadian Ice Service: beacon_id, datetime_data, position. */
[[nodiscard]] SightingTable readCisBeacon(const ImportText& source);
[[nodiscard]] bool isCisBeacon(std::string_view text);

/** Antarctic list of the US National Ice Center; "grounded" among the remarks is kept. */
[[nodiscard]] SightingTable readUsnic(const ImportText& source);
[[nodiscard]] bool isUsnic(std::string_view text);

} // namespace berg
