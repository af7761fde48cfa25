#pragma once

// Private to core/io: readers of tables and the detection of their formats. The readers throw as
// `readSightingRows`. Each `is...` returns true if the content looks like the format; it may still
// turn out to be broken.

#include "core/io/import/fields/import_source.h"
#include "core/io/text/csv_reader.h"

namespace berg {

/**
 * Returns a reader of the rows of a table from its header on, without a separator line (`sep=;`),
 * comments and titles above it. Uses `headerLine` and `mapping` of the options; `text` must outlive
 * the reader.
 */
[[nodiscard]] CsvReader tableReader(std::string_view text, const ReadOptions& options = {});

/** Reads any table with a header, with columns by their names or as mapped. */
[[nodiscard]] SightingTable readAnyCsv(const ImportText& source);
[[nodiscard]] bool isAnyCsv(std::string_view text);

/**
 * Reads IIP sightings, NSIDC G00807: season, number, date, time, latitude, longitude, method, size,
 * shape, source, by position because the words of the header vary; with or without header. An
 * iceberg's id is `season-number`; the time is HHMM without leading zeros; a date must lie in the
 * season, October of the previous year to September, with a margin of a month.
 */
[[nodiscard]] SightingTable readIip(const ImportText& source);
[[nodiscard]] bool isIip(std::string_view text);

/** Reads standardised beacons of the Canadian Ice Service: beacon_id, datetime_data, position. */
[[nodiscard]] SightingTable readCisBeacon(const ImportText& source);
[[nodiscard]] bool isCisBeacon(std::string_view text);

/**
 * Reads the Antarctic list of the US National Ice Center, including "grounded" among the remarks.
 */
[[nodiscard]] SightingTable readUsnic(const ImportText& source);
[[nodiscard]] bool isUsnic(std::string_view text);

} // namespace berg
