#pragma once

#include "core/earth/geodesy.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Position data of one NMEA 0183 sentence; members that it does not contain are empty. */
struct NmeaFix
{
    std::string talker;   ///< Two letters, such as "GP" (GPS) or "AI" (AIS).
    std::string sentence; ///< "GGA", "RMC" or "VTG".
    std::optional<LatLon> place;
    std::optional<double> altitude_m;    ///< Above mean sea level; GGA.
    std::optional<double> speed_mps;     ///< Over ground; RMC, VTG.
    std::optional<double> course_deg;    ///< Over ground from true north, 0 to 360; RMC, VTG.
    std::optional<double> timeOfDay_s;   ///< UTC; GGA, RMC.
    std::optional<std::int64_t> unix_us; ///< With the date, which only RMC contains.
};

/** Statistics of a reader's lines. */
struct NmeaCounts
{
    std::uint64_t fixes = 0;
    std::uint64_t withoutFix = 0;   ///< Sentences of a receiver without a position.
    std::uint64_t badChecksums = 0; ///< Wrong or missing checksum.
    std::uint64_t malformed = 0;    ///< Correct checksum, but unreadable fields.
    std::uint64_t others = 0;       ///< Other sentences, and lines that are no sentence.
};

/**
 * Reads positions of GPS receivers, trackers and ships from a stream of NMEA 0183 sentences: GGA,
 * RMC and VTG of any talker, with a correct checksum. Lines beyond 256 bytes count as others.
 * Memory: one line.
 */
class NmeaReader
{
public:
    /** Processes bytes of the stream and returns the fixes of the lines that they complete. */
    [[nodiscard]] std::vector<NmeaFix> feed(std::span<const std::uint8_t> bytes);

    [[nodiscard]] const NmeaCounts& counts() const { return m_counts; }

private:
    [[nodiscard]] std::optional<NmeaFix> fixOf(std::string_view line);

    std::string m_line;
    bool m_isTooLong = false; ///< The rest of this line is ignored.
    NmeaCounts m_counts;
};

/** Returns a sentence with its checksum and line end, for content such as "GPVTG,90.0,T,,M,...". */
[[nodiscard]] std::string nmeaSentence(std::string_view content);

} // namespace berg
