#pragma once

#include <array>
#include <string_view>

namespace berg {

/** A size class of the ice services, by the length at the waterline (MANICE; canada.ca). */
struct IcebergSize
{
    std::string_view name; ///< in words, "bergy-bit"
    std::string_view code; ///< of charts and reports, "bb"
    double length_m = 0;   ///< middle of the class; for the open class its lower limit
};

/** The classes, smallest first. */
inline constexpr std::array<IcebergSize, 6> kIcebergSizes{{
    {"growler", "gr", 2.5},
    {"bergy-bit", "bb", 10},
    {"small", "sm", 37.5},
    {"medium", "med", 90},
    {"large", "lg", 160},
    {"very-large", "vlg", 200},
}};

/**
 * Returns the class of a length at the waterline >= 0: below 5 m, below 15 m, to 60 m, to 120 m,
 * below 200 m, from 200 m (MANICE; canada.ca, which ends the class before at 200 m).
 */
[[nodiscard]] const IcebergSize& sizeOfLength(double length_m);

/** Length from which ice is an iceberg; shorter pieces are bergy bits and growlers. */
inline constexpr double kShortestIceberg_m = 15;

/** Dimensions of an iceberg that follow from its length. */
struct IcebergDimensions
{
    double length_m = 0; ///< at the waterline
    double draft_m = 0;
    double sail_m2 = 0; ///< cross-section above the water
    double keel_m2 = 0; ///< cross-section below it: length x draft
    bool operator==(const IcebergDimensions&) const = default;
};

/**
 * Returns the dimensions of an iceberg of this length > 0: draft 1.78 L^0.71 (profiles of C-CORE)
 * and sail 0.077 L^2 (Barker et al. 2004, Determination of Iceberg Draft, Mass and Cross-Sectional
 * Areas, ISOPE), as in C-CORE's operational forecaster (c-core-labs/drift-forecasting). Barker et
 * al. fit the sail below 65 m and use a straight line above, which gives larger sails.
 */
[[nodiscard]] IcebergDimensions dimensionsOfLength(double length_m);

} // namespace berg
