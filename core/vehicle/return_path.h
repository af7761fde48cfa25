#pragma once

#include "core/vehicle/geofence.h"

#include <cstdint>

namespace berg {

/** Command rate of an autopilot: it holds a turn rate for `steps` time steps of `dt_s`. */
struct CommandClock
{
    double dt_s = 0.1;
    std::int64_t steps = 1;

    [[nodiscard]] double command_s() const { return static_cast<double>(steps) * dt_s; }
};

/**
 * A path home inside the fence, as the sequence of commands that fly it. It proves that one exists.
 */
struct ReturnPath
{
    /** Equal commands in a row. */
    struct Part
    {
        double rate_radps = 0;
        std::int64_t commands = 0; ///< number of consecutive commands at that rate
        bool operator==(const Part&) const = default;
    };

    std::vector<Part> parts;

    /** Returns the number of commands of the path. */
    [[nodiscard]] std::int64_t commands() const;
    /**
     * Removes the first command and returns its turn rate; returns 0 (straight on) if none is left.
     */
    double takeNext_radps();
    bool operator==(const ReturnPath&) const = default;
};

/**
 * Searches for paths home that stay `kFenceMargin_m` inside a fence: turns at the limit and
 * straight lines, round the fence's corners. Each candidate is checked as it will be flown, command
 * by command and at every instant: the distance to the fence gives the time in which the UAV cannot
 * reach it. A path that is found is safe; a path may exist although none is found.
 */
class ReturnSearch
{
public:
    /**
     * Borrows `fence`, which must outlive the search; its wind and airspeed must be those of the
     * UAV.
     */
    ReturnSearch(const Geofence& fence, const CommandClock& clock, const Point& home_m);

    /**
     * Returns whether the UAV stays `kFenceMargin_m` inside during `commands` commands at one rate.
     */
    [[nodiscard]] bool isInside(const DubinsState& from, double rate_radps,
                                std::int64_t commands) const;
    /** Returns the state of the UAV after those commands. */
    [[nodiscard]] DubinsState after(const DubinsState& from, double rate_radps,
                                    std::int64_t commands) const;

    /**
     * Returns the quickest of a few candidates (a turn, a straight line, round the corners), or
     * nullopt if none is safe. Cheap enough to call at every command.
     */
    [[nodiscard]] std::optional<ReturnPath> quickPath(const DubinsState& from) const;
    /**
     * Returns `quickPath`, or else the quickest of many candidates that first make room for the
     * turn by a straight line or a turn. Returns nullopt if none is safe, which takes milliseconds.
     */
    [[nodiscard]] std::optional<ReturnPath> anyPath(const DubinsState& from) const;

private:
    struct Trial
    {
        DubinsState at;
        ReturnPath path;
        std::int64_t commands = 0;
    };
    struct Found
    {
        std::optional<ReturnPath> path;
        std::int64_t commands = 0;
        int triesLeft = 0;
    };

    [[nodiscard]] bool add(Trial& trial, double rate_radps, std::int64_t commands) const;
    [[nodiscard]] bool turnTo(Trial& trial, const Point& place_m, double side) const;
    [[nodiscard]] bool pointAt(Trial& trial, const Point& place_m) const;
    [[nodiscard]] bool flyStraight(Trial& trial, const Point& place_m, bool isHome) const;
    void extend(const Trial& trial, int depth, Found& found) const;
    void follow(const Trial& trial, std::span<const Point> corners_m, int depth,
                Found& found) const;

    const Geofence& m_fence;
    CommandClock m_clock;
    Point m_home_m;
    int m_deepest;
};

/** Distance that a path home keeps from the fence. */
inline constexpr double kFenceMargin_m = 1;

} // namespace berg
