#pragma once

// Private to core/io: the keyframes of a run file and what its parts share.

#include "core/io/text/json_reader.h"
#include "core/sim/simulation.h"

namespace berg {

/** Largest count of anything a run may hold; keeps every index an int. */
inline constexpr std::int64_t kLargestCount = 1'000'000'000;
/** Sums of a run: finite, whatever was flown. */
inline constexpr Limits kAmount{.low = 0, .high = 1e300};

/** A whole number read within limits that fit. */
[[nodiscard]] inline int asInt(std::int64_t value)
{
    return static_cast<int>(value);
}

/** What the parts of a run file are checked against. */
struct RunContext
{
    double flownUntil_s = 0;
    std::int64_t lastStep = 0;
    std::size_t icebergsAtStart = 0;
    std::size_t icebergs = 0; ///< those added in flight included
    std::size_t uavs = 1;
    Point current_mps = Point::Zero();

    /** Indices of icebergs; -1 means none. */
    [[nodiscard]] WholeLimits indices() const
    {
        return {.low = -1, .high = static_cast<std::int64_t>(icebergs) - 1};
    }
};

/** A member that is the index of an iceberg; -1, which it is when it is missing: none. */
[[nodiscard]] int icebergOrNone(ObjectReader& object, const char* member,
                                const RunContext& context);

/** What the arrays of a keyframe hold: see `keyframeText`; of a track in any model. */
[[nodiscard]] std::vector<double> trackNumbers(const Track& track);
[[nodiscard]] std::vector<double> guidanceNumbers(const LosGuidance& guidance);
/** Without the end of a hold, which comes last. */
[[nodiscard]] std::vector<double> legNumbers(const AimedLeg& leg);

/** A leg as an array: [iceberg, turn, line start east, north, abeam east, north, sighting time]. */
[[nodiscard]] std::string legText(const AimedLeg& leg);

[[nodiscard]] AimedLeg readLeg(const Json& value, const std::string& path, Faults& faults,
                               const RunContext& context);

/** An array of icebergs by index; one that is `seen` already, or given twice, is a fault. */
[[nodiscard]] std::vector<int> readIcebergs(const Json& value, const std::string& path,
                                            Faults& faults, const RunContext& context,
                                            std::vector<bool>& seen);

/**
 * One keyframe on one line, its tracks below it. Numbers that always come together are arrays:
 * `guidance` is [lookahead, integral gain, turn gain, leg start east, north, integral], each of
 * `tracks` is [anchor east, north, time, velocity east, north, sigma, q, 1 when in view]; `aim`,
 * when there is one, is a leg.
 */
[[nodiscard]] std::string keyframeText(const WorldState& state);

[[nodiscard]] WorldState readKeyframe(const Json& value, const std::string& path, Faults& faults,
                                      const RunContext& context);

} // namespace berg
