#pragma once

// Private to core/io: readers of what receivers, radars and cameras record, and the detection of
// their formats. The readers throw as `readSightingRows`. Each `is...` returns true if the content
// looks like the format; it may still turn out to be broken.

#include "core/io/import/fields/import_source.h"

namespace berg {

/**
 * Reads a log of NMEA 0183 sentences: icebergs are the radar targets (TLL, TTM) and the aids of AIS
 * (message 21) whose name says ice. Own position, heading and date come from the same log
 * (`NmeaReader`). A radar target that a ship with AIS explains is rejected, as is every line that
 * is broken; lines that begin with `#` are comments. An id is "radar" and the number of the target,
 * with a further number if that was used again after 30 minutes of silence; of an aid it is its
 * MMSI.
 */
[[nodiscard]] SightingTable readNmea(const ImportText& source);
[[nodiscard]] bool isNmea(std::string_view text);

/**
 * Reads a photograph (JPEG) as one sighting at the position of its EXIF data. Throws `Error`
 * Unsupported in a build without libexiv2 and InvalidInput for data that cannot be read; a
 * photograph without a position is a rejected row.
 */
[[nodiscard]] SightingTable readPhoto(const ImportText& source);
[[nodiscard]] bool isPhoto(std::string_view bytes);

} // namespace berg
