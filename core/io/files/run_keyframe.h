#pragma once

// Private to core/io: reads and writes the keyframes of a run file, with helpers for its other
// parts.

#include "core/io/text/json_reader.h"
#include "core/sim/simulation.h"

namespace berg {

/** Largest count that a run may hold; it keeps every index an int. */
inline constexpr std::int64_t kLargestCount = 1'000'000'000;
/** Limits of the sums of a run: finite and not negative. */
inline constexpr Limits kAmount{.low = 0, .high = 1e300};

/** Converts a whole number that was read within limits that fit an int. */
[[nodiscard]] inline int asInt(std::int64_t value)
{
    return static_cast<int>(value);
}

/** Iceberg index in a run file that stands for no iceberg. */
inline constexpr int kNoIcebergInFile = -1;

/** Limits that the parts of a run file are checked against. */
struct RunContext
{
    double flownUntil_s = 0;
    std::int64_t lastStep = 0;
    std::size_t icebergsAtStart = 0;
    std::size_t icebergs = 0; ///< including those added in flight
    std::size_t uavs = 1;
    Point current_mps = Point::Zero();

    /** Returns the range of iceberg indices, `kNoIcebergInFile` included. */
    [[nodiscard]] WholeLimits indices() const
    {
        return {.low = kNoIcebergInFile, .high = static_cast<std::int64_t>(icebergs) - 1};
    }
};

/**
 * Returns a member that is an iceberg index, or nullopt if it is `kNoIcebergInFile` or missing.
 * Adds a fault and returns nullopt for any other value.
 */
[[nodiscard]] std::optional<int> icebergOrNone(ObjectReader& object, const char* member,
                                               const RunContext& context);

/** Returns the numbers of a track for the arrays of `keyframeText`, in any observer model. */
[[nodiscard]] std::vector<double> trackNumbers(const Track& track);
/** Returns the numbers of the line-of-sight guidance for the arrays of `keyframeText`. */
[[nodiscard]] std::vector<double> guidanceNumbers(const LosGuidance& guidance);
/** Returns the numbers of a leg for `legText`, without the end of a hold, which comes last. */
[[nodiscard]] std::vector<double> legNumbers(const AimedLeg& leg);

/**
 * Returns the JSON array of a leg in rad, m and s: [iceberg, turn, line start east, north, abeam
 * east, north, sighting time], and the end time of a hold.
 */
[[nodiscard]] std::string legText(const AimedLeg& leg);

/** Reads the array of `legText`; what cannot be read adds a fault and becomes 0. */
[[nodiscard]] AimedLeg readLeg(const Json& value, const std::string& path, Faults& faults,
                               const RunContext& context);

/**
 * Reads an array of iceberg indices and marks them in `seen`, which has `context.icebergs` entries;
 * an iceberg marked already is a fault.
 */
[[nodiscard]] std::vector<int> readIcebergs(const Json& value, const std::string& path,
                                            Faults& faults, const RunContext& context,
                                            std::vector<bool>& seen);

/**
 * Returns the JSON text of a keyframe, which has at least one UAV, on one line, its tracks below
 * it. Numbers that belong together are arrays: `guidance` is [lookahead, integral gain, turn gain,
 * leg start east, north, integral], each of `tracks` is [anchor east, north, time, velocity east,
 * north, sigma, q, 1 when in view, ...]; `aim`, if present, is a leg.
 */
[[nodiscard]] std::string keyframeText(const WorldState& state);

/** Returns the JSON object of a pose of a real aircraft. */
[[nodiscard]] std::string fixText(const PoseFix& fix);
/** Reads the member `fixes` of a run; errors add faults. */
[[nodiscard]] std::vector<PoseFix> readFixes(ObjectReader& run, const RunContext& context);

/** Reads the object of `keyframeText` and checks it against `context`; errors add faults. */
[[nodiscard]] WorldState readKeyframe(const Json& value, const std::string& path, Faults& faults,
                                      const RunContext& context);

} // namespace berg
