#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** An area of an ice chart in which the ice is of one kind. */
struct IceArea
{
    std::string label; ///< the chart's words or codes, e.g. "4-6/10, SA 87"; may be empty
    /** Share of the surface that ice covers, in tenths; nullopt if the chart has no value. */
    std::optional<double> concentration_tenths;
    bool isFast = false; ///< true if the ice is fast to a shore and does not drift
    /** Outline and holes, closed implicitly; a place is inside that an odd number of them holds. */
    std::vector<std::vector<Point>> outlines_m;
    std::string extraJson;
    bool operator==(const IceArea&) const = default;
};

/** An ice chart below the icebergs of a map. It does not affect the flight. */
struct IceChart
{
    std::string source;  ///< file or service that it comes from
    std::string dateUtc; ///< ISO 8601 with Z; if empty, the chart has no date
    std::vector<IceArea> areas;
    std::string extraJson;
    bool operator==(const IceChart&) const = default;
};

/** Class of concentration in the WMO colour code for ice charts (WMO/TD-No. 1215). */
enum class IceClass : std::uint8_t
{
    IceFree,
    OpenWater, ///< less than 1/10, also bergy water
    VeryOpen,  ///< 1/10 to 3/10
    Open,      ///< 4/10 to 6/10
    Close,     ///< 7/10 to 8/10
    VeryClose, ///< 9/10 to 10/10
    Fast,
    Unknown ///< ice without a value for its concentration
};
inline constexpr std::size_t kIceClasses = 8;

/** Returns the class of an area. */
[[nodiscard]] IceClass classOf(const IceArea& area);
/** Returns the colour of a class in the WMO colour code, 0xRRGGBB. */
[[nodiscard]] std::uint32_t wmoColour(IceClass iceClass);

/**
 * Returns the tenths of a code of SIGRID-3 for concentrations (WMO/TD-No. 1214, table 4.1): 0 for
 * 00 and 55 (ice free), 0.5 for 01 (open water) and 02 (bergy water), 1 to 9 for 10 to 90, 9.5 for
 * 91 (more than 9), 10 for 92, and the middle of a range such as 46 (4 to 6) or 81 (8 to 10).
 * Returns nullopt for any other code, such as 99 (unknown).
 */
[[nodiscard]] std::optional<double> tenthsOfSigrid(int code);

/** Charts older than this at the start are called old, because ice moves. */
inline constexpr double kOldIceChart_s = 48 * 3600.0;

/**
 * Returns the age of the chart at the start, s, negative for a later chart. Returns nullopt if one
 * of the times is unknown.
 */
[[nodiscard]] std::optional<double> ageOf_s(const IceChart& chart, std::string_view startUtc);

} // namespace berg
