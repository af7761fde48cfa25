#pragma once

#include <cstddef>
#include <cstdint>

namespace berg {

/** Permitted range of a number. */
struct Limits
{
    double low = 0;
    double high = 0;
    bool above = false; ///< true if `low` itself is excluded
};

// These sizes bound the memory and time of planning and checking.
inline constexpr std::size_t kMostIcebergs = 1000;
inline constexpr std::size_t kMostUavs = 100;
inline constexpr std::size_t kMostAreaCorners = 2000;
inline constexpr std::size_t kMostNoFlyAreas = 100;
inline constexpr std::size_t kMostAirspaceAreas = 200;
inline constexpr std::size_t kMostIceAreas = 500;
inline constexpr std::size_t kMostIceCorners = 20'000; ///< of all areas of an ice chart together
/** Share of the airspeed: in stronger wind a UAV makes little headway. */
inline constexpr double kStrongWindShare = 0.7;
/** UAVs whose altitudes differ by less than this are in one layer and must be separated. */
inline constexpr double kLayerHeight_m = 30;
inline constexpr std::size_t kMostTrackPoints = 10'000; ///< points of one iceberg's track
inline constexpr std::size_t kMostForecastPlaces = 10'000;
/** Entries of a forecast: places times their times. */
inline constexpr std::size_t kMostForecastEntries = 200'000;

inline constexpr double kLargestCoordinate_m = 1e6;
inline constexpr double kLargestVelocity_mps = 5; ///< per component, of an iceberg or the current
// These limits keep every sum of a run finite where the file format sets no upper limit.
inline constexpr double kLargestLength_m = 1e6;
inline constexpr double kLargestTime_s = 1e9;
inline constexpr double kLargestGrowth_m2ps = 1e6;
inline constexpr double kLargestSigma_m2 = 1e12;
/** Largest integer that every reader of JSON represents exactly. */
inline constexpr std::int64_t kLargestSeed = std::int64_t{1} << 53;

/**
 * Permitted values of the numbers of a scenario. `validate`, readers and input fields use this one
 * list, and a test compares it with the page about scenario files.
 */
namespace limits {
inline constexpr Limits kLatitude_deg{.low = -90, .high = 90};
inline constexpr Limits kLongitude_deg{.low = -180, .high = 180};
inline constexpr Limits kDuration_s{.low = 0, .high = 604800, .above = true};
inline constexpr Limits kTimeStep_s{.low = 0.01, .high = 1};
inline constexpr Limits kCoordinate_m{.low = -kLargestCoordinate_m, .high = kLargestCoordinate_m};
inline constexpr Limits kVelocity_mps{.low = -kLargestVelocity_mps, .high = kLargestVelocity_mps};
inline constexpr Limits kSpeed_mps{.low = 0, .high = kLargestVelocity_mps};
inline constexpr Limits kLength_m{.low = 0, .high = kLargestLength_m};
inline constexpr Limits kCeiling_m{.low = 0, .high = kLargestLength_m, .above = true};
inline constexpr Limits kTime_s{.low = 0, .high = kLargestTime_s};
inline constexpr Limits kTrackTime_s{.low = -kLargestTime_s, .high = kLargestTime_s};
inline constexpr Limits kGrowth_m2ps{.low = 0, .high = kLargestGrowth_m2ps};
inline constexpr Limits kSigma_m2{.low = 0, .high = kLargestSigma_m2};
// No aircraft is slower or smaller; lower values make flights that never end.
inline constexpr Limits kAirspeed_mps{.low = 1, .high = 1000};
inline constexpr Limits kExtent_m{.low = 1, .high = kLargestLength_m}; ///< field of view, altitude
/** A UAV may also have no limit. */
inline constexpr Limits kEndurance_s{.low = 1, .high = kLargestTime_s};
inline constexpr Limits kReservePercent{.low = 0, .high = 90};
inline constexpr Limits kWindSpeed_mps{.low = 0, .high = 150}; ///< about the strongest gust known
/** East or north part of a wind. */
inline constexpr Limits kWindVelocity_mps{.low = -150, .high = 150};
inline constexpr Limits kPercent{.low = 0, .high = 100};
/** A growler to the largest tabular iceberg known. */
inline constexpr Limits kIcebergLength_m{.low = 0.1, .high = 300'000};
inline constexpr Limits kTemperature_degC{.low = -90, .high = 60};
inline constexpr Limits kBank_deg{.low = 1, .high = 80};
inline constexpr Limits kPitch_deg{.low = 0, .high = 45};
inline constexpr Limits kCourse_deg{.low = 0, .high = 360, .above = true};
inline constexpr Limits kTrigger_s{.low = 0.1, .high = 3600};
inline constexpr Limits kAutopilot_s{.low = 0, .high = 60};
inline constexpr Limits kAssetVelocity_mps{.low = -50, .high = 50};
inline constexpr Limits kGain{.low = 0, .high = 1e6};
inline constexpr Limits kSensorInterval_s{.low = 0, .high = 60};
inline constexpr Limits kDetection{.low = 0, .high = 1, .above = true};
inline constexpr Limits kTau{.low = 0, .high = 100};
inline constexpr Limits kPlanningDelay_s{.low = 0, .high = 3600};
inline constexpr Limits kSmallError_m{.low = 0, .high = 1000}; ///< error of a position or height
inline constexpr Limits kReaction_s{.low = 0, .high = 600};
inline constexpr Limits kTenths{.low = 0, .high = 10};
inline constexpr Limits kPart{.low = 0, .high = 10}; ///< factor of a term in a formula
} // namespace limits

} // namespace berg
