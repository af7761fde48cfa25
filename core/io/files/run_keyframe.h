#pragma once

// Private to core/io: reads and writes the keyframes of a run file, with helpers for its other
// parts.

#include "core/io/files/members.h"
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
/** Returns the number in a run file of an iceberg or of no iceberg. */
[[nodiscard]] inline int numberInFile(const std::optional<IcebergIndex>& iceberg)
{
    return iceberg ? iceberg->number() : kNoIcebergInFile;
}

inline constexpr std::array<Named<FlightMode>, 8> kModeNames{{
    {FlightMode::Idle, "idle"},
    {FlightMode::Leg, "leg"},
    {FlightMode::RunOut, "run-out"},
    {FlightMode::Circle, "circle"},
    {FlightMode::Search, "search"},
    {FlightMode::Home, "home"},
    {FlightMode::Ground, "ground"},
    {FlightMode::Hold, "hold"},
}};
constexpr const auto& namesOf(FlightMode /*value*/)
{
    return kModeNames;
}
constexpr const auto& namesOf(FlightOrder /*value*/)
{
    return kFlightOrderNames;
}

/** Limits that the parts of a run file are checked against. */
struct RunContext
{
    double flownUntil_s = 0;
    std::int64_t lastStep = 0;
    std::size_t icebergsAtStart = 0;
    std::size_t icebergs = 0; ///< including those added in flight
    std::size_t uavs = 1;
    Point current_mps = Point::Zero();
    std::vector<bool> forced = {}; ///< by iceberg: `Track::isForced`; those left out are not

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
[[nodiscard]] std::optional<IcebergIndex> icebergOrNone(ObjectReader& object, const char* member,
                                                        const RunContext& context);

/** Appends the values that a function names. */
struct NumberWriter
{
    std::vector<double> numbers{};

    void operator()(const Point& value)
    {
        numbers.push_back(value.x());
        numbers.push_back(value.y());
    }
    void operator()(IcebergIndex value) { numbers.push_back(value.number()); }
    template <class Value>
    void operator()(const Value& value)
    {
        numbers.push_back(static_cast<double>(value));
    }
};

/** Names the numbers of a leg except the end of a hold, which comes last. */
template <class Io, class L>
void legNumbers(Io& io, L& leg)
{
    io(leg.iceberg);
    io(leg.turn_rad);
    io(leg.from_m);
    io(leg.abeam_m);
    io(leg.sighting_s);
}

/** Names the numbers of the line-of-sight guidance. */
template <class Io, class G>
void guidanceNumbers(Io& io, G& guidance)
{
    io(guidance.gains.lookahead_m);
    io(guidance.gains.integral_mps);
    io(guidance.gains.turn_1ps);
    io(guidance.start_m);
    io(guidance.integral_s);
}

/** Names the numbers that every track has. */
template <class Io, class T>
void trackNumbers(Io& io, T& track)
{
    io(track.anchor_m);
    io(track.anchor_s);
    io(track.velocity_mps);
    io(track.sigma_m2);
    io(track.q_m2ps);
    io(track.inView);
}

/** Names the numbers of a track's filter, which a file lacks if they have their default values. */
template <class Io, class T>
void filterNumbers(Io& io, T& track)
{
    io(track.mixed_m2ps);
    io(track.velocity_m2ps2);
    io(track.presence);
    io(track.status);
    io(track.left);
}

/** Names the members of a UAV in the order of the file. */
template <class Io, class U>
void uavMembers(Io& io, U& uav)
{
    io("position_m", uav.pose.position_m);
    io("psi_rad", uav.pose.psi_rad);
    io("u_radps", uav.u_radps);
    io("cross_track_m", uav.crossTrack_m);
    io("flown_m", uav.flown_m, {.limits = kAmount});
    io("mode", uav.mode);
    io("target", uav.target);
    io("last_reached", uav.lastReached);
    io("alone", uav.isAlone, {.isWritten = uav.isAlone});
    io("guidance", uav.guidance);
    io("run_out_m", uav.runOut_m);
    io.whole("misses", uav.misses, {.low = 0, .high = kLargestCount});
    io("aim", uav.aim);
    io("search", uav.search);
    io("members", uav.members);
    io("members_by_s", uav.membersBy_s, {.isWritten = !uav.members.empty()});
    io("aloft_s", uav.aloft_s, {.limits = kAmount, .isWritten = uav.aloft_s != 0});
    io("ground_s", uav.ground_s, {.limits = kAmount, .isWritten = uav.ground_s != 0});
    io("withheld_s", uav.withheld_s, {.limits = kAmount, .isWritten = uav.withheld_s != 0});
    io("via_m", uav.via_m);
    io("return_path", uav.returnPath);
    io("order", uav.order, {.isWritten = uav.order != FlightOrder::None});
    io("hold_m", uav.hold_m, {.isWritten = uav.hold_m != Point(Point::Zero())});
}

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
[[nodiscard]] IcebergList readIcebergs(const Json& value, const std::string& path, Faults& faults,
                                       const RunContext& context, std::vector<bool>& seen);

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
