#pragma once

#include "core/earth/geodesy.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Content of an AIS message (ITU-R M.1371) that Bergwatch uses; members it lacks are empty. */
struct AisMessage
{
    int type = 0;           ///< 1, 2, 3: position of a ship; 5: its name; 21: an aid or other mark
    std::uint32_t mmsi = 0; ///< number of the station, at most 2^30 - 1
    std::string name;       ///< types 5 and 21; printable ASCII
    std::optional<LatLon> place;
    std::optional<double> speed_mps;   ///< over ground
    std::optional<double> course_deg;  ///< over ground from true north, [0, 360)
    std::optional<double> heading_deg; ///< true, [0, 360)
    std::optional<int> second;         ///< of the minute of UTC, 0 to 59
    bool operator==(const AisMessage&) const = default;
};

/** Whether an AIS message could be read. */
enum class AisOutcome
{
    Read,
    OtherType, ///< a whole message of a type that is not used
    Malformed  ///< too short for its type, characters that are none of AIS, or no place on Earth
};

/** Result of `aisMessageOf`; the message is only set if it was read. */
struct AisReading
{
    AisOutcome outcome = AisOutcome::Malformed;
    AisMessage message;
};

/**
 * Reads the payload of `!AIVDM` sentences, joined if there are several: six bits a character, the
 * last `fillBits` of them unused.
 */
[[nodiscard]] AisReading aisMessageOf(std::string_view payload, int fillBits);

/** Returns true if a word of the name says ice: ICE, ICEBERG, BERG, BERGY, GROWLER, FLOE. */
[[nodiscard]] bool saysIce(std::string_view name);

} // namespace berg
