#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

#include <string>

namespace berg {

/**
 * Returns the size code of ice services ("SM") of an iceberg: of its length, else of twice its
 * radius if that is not the radius of new icebergs; "GEN" (not known) for others.
 */
[[nodiscard]] std::string sizeCodeOf(const Iceberg& iceberg);

/**
 * Writes the sightings of a flight in the ten columns of the International Ice Patrol (NSIDC
 * G00807), which `readIip` reads: season, number, date (month first), time (HHMM without leading
 * zeros), latitude and longitude (five decimals), method, size, shape, source. There is a row for
 * each time that an iceberg came into view, with its position then, to the sample of the record: an
 * ice service fits the drift to repeated sightings, and the last row of a number is the newest.
 * Sightings that somebody else has reported are left out. The number is that of the id ("2021-301"
 * in season 2021, or digits alone); icebergs with other ids have the free numbers from 1. Throws
 * `Error{InvalidInput}` if nothing was flown or the scenario has no start time.
 */
void writeSightings(const ExportContent& content, const TextSink& put);

} // namespace berg
