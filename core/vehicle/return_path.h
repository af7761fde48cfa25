#pragma once

#include "core/vehicle/geofence.h"

#include <cstdint>

namespace berg {

/** How an autopilot commands: a turn rate, held for so many time steps. */
struct CommandClock
{
    double dt_s = 0.1;
    std::int64_t steps = 1;

    [[nodiscard]] double command_s() const { return static_cast<double>(steps) * dt_s; }
};

/** A path home inside the fence, as the commands that fly it: the proof that there is one. */
struct ReturnPath
{
    struct Part
    {
        double rate_radps = 0;
        std::int64_t commands = 0; ///< in a row
        bool operator==(const Part&) const = default;
    };

    std::vector<Part> parts;

    [[nodiscard]] std::int64_t commands() const;
    /** Takes the first of the commands off; straight on when none is left. */
    double takeNext_radps();
    bool operator==(const ReturnPath&) const = default;
};

/**
 * Looks for paths home that stay `kFenceMargin_m` inside a fence: turns at the limit and straight
 * lines, round the fence's corners. Each is checked as it will be flown, command by command and at
 * every instant: how far the fence is says how long the UAV cannot meet it. A path found is one;
 * one that is not found may exist all the same.
 */
class ReturnSearch
{
public:
    /** `fence` outlives the search; its wind and airspeed are those of the UAV. */
    ReturnSearch(const Geofence& fence, const CommandClock& clock, const Point& home_m);

    /** Whether the UAV stays inside on so many commands at one rate. */
    [[nodiscard]] bool isInside(const DubinsState& from, double rate_radps,
                                std::int64_t commands) const;
    /** Where it is after them. */
    [[nodiscard]] DubinsState after(const DubinsState& from, double rate_radps,
                                    std::int64_t commands) const;

    /** The quickest of few: turn, straight on, round the corners. For every command. */
    [[nodiscard]] std::optional<ReturnPath> quickPath(const DubinsState& from) const;
    /** That, or else the quickest of many that begin with a straight line or a turn, to have room
     * for it. Takes milliseconds when there is none. */
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

/** So far from the fence a path home stays. */
inline constexpr double kFenceMargin_m = 1;

} // namespace berg
