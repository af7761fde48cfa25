#pragma once

#include "tests/support/files/plan_rules.h"

#include <QSet>

#include <cmath>

// Rules by which autopilots accept the mission of a `.plan` file, taken from their sources:
// ArduPilot (AP_Mission, ArduPlane), PX4 (mavlink_mission.cpp, FeasibilityChecker.cpp). They read
// numbers from the file and nothing from our writer.

namespace berg::test {

namespace autopilot_rules {

using plan_rules::items;
using plan_rules::unless;

inline constexpr int kWaypoint = 16;
inline constexpr int kLoiterTurns = 18;
inline constexpr int kReturn = 20;
inline constexpr int kLand = 21;
inline constexpr int kTakeOff = 22;
inline constexpr int kLoiterToAltitude = 31;
inline constexpr int kVtolTakeOff = 84;
inline constexpr int kVtolLand = 85;
inline constexpr int kLandStart = 189;

inline int commandOf(const QJsonValue& item)
{
    return item["command"_L1].toInt();
}

inline bool isPlaced(const QJsonValue& item)
{
    return item["frame"_L1].toInt() != 2;
}

inline double paramOf(const QJsonValue& item, int number)
{
    return item["params"_L1].toArray().at(number - 1).toDouble();
}

inline bool isHovering(const PlanText& plan)
{
    return plan_rules::mission(plan)["vehicleType"_L1].toInt() == 2;
}

inline bool isFixedWing(const PlanText& plan)
{
    return plan_rules::mission(plan)["vehicleType"_L1].toInt() == 1;
}

/** Returns the distance of two items, m, on a sphere; enough for a hundred kilometres. */
inline double distance_m(const QJsonValue& a, const QJsonValue& b)
{
    constexpr double kDegree_m = 111'200;
    const double north_m = kDegree_m * (paramOf(b, 5) - paramOf(a, 5));
    const double east_m =
        kDegree_m * (paramOf(b, 6) - paramOf(a, 6)) * std::cos(paramOf(a, 5) * M_PI / 180);
    return std::hypot(north_m, east_m);
}

inline QString onlyCommands(const PlanText& plan, const QSet<int>& placed,
                            const QSet<int>& unplaced)
{
    for (const QJsonValue& item : items(plan))
        if (!(isPlaced(item) ? placed : unplaced).contains(commandOf(item)))
            return u"command %1 in frame %2"_s.arg(commandOf(item)).arg(item["frame"_L1].toInt());
    return {};
}

/** PX4 refuses the upload of any other command, and of these in another kind of frame. */
inline QString px4Commands(const PlanText& plan)
{
    return onlyCommands(plan, {16, 17, 19, 21, 22, 31, 84, 85},
                        {20, 177, 178, 189, 205, 206, 214, 2000, 2001});
}

/** ArduPilot refuses the upload of any other command. */
inline QString arduPilotCommands(const PlanText& plan)
{
    return onlyCommands(plan, {16, 17, 18, 19, 21, 22, 31, 84, 85},
                        {20, 177, 178, 189, 205, 206, 2000, 2001});
}

/** Numbers that ArduPlane stores in 8 bits. */
inline QString arduPilotStorage(const PlanText& plan)
{
    if (isHovering(plan))
        return {};
    for (const QJsonValue& item : items(plan)) {
        const bool isWaypoint = commandOf(item) == kWaypoint;
        if (isWaypoint && (paramOf(item, 2) > 255 || paramOf(item, 3) > 255))
            return u"acceptance radius %1"_s.arg(paramOf(item, 2));
        if (commandOf(item) == kLoiterTurns && paramOf(item, 1) > 255)
            return u"turns %1"_s.arg(paramOf(item, 1));
        const double radius_m = paramOf(item, 3);
        if (commandOf(item) == kLoiterTurns && radius_m > 255 && std::fmod(radius_m, 10) != 0)
            return u"radius %1"_s.arg(radius_m);
    }
    return {};
}

/** NaN is refused, except for the yaw of a waypoint, take-off or landing. */
inline QString arduPilotNan(const PlanText& plan)
{
    for (const QJsonValue& item : items(plan))
        for (const QJsonValue& param : item["params"_L1].toArray())
            if (param.isNull())
                return u"command %1"_s.arg(commandOf(item));
    return {};
}

/** The take-off is the first item with a position and higher than the acceptance radius. */
inline QString takeOffFirst(const PlanText& plan)
{
    bool isFirst = true;
    for (const QJsonValue& item : items(plan)) {
        const bool isTakeOff = commandOf(item) == kTakeOff || commandOf(item) == kVtolTakeOff;
        if (isTakeOff && !isFirst)
            return u"take-off is not first"_s;
        if (isTakeOff && paramOf(item, 7) < 11)
            return u"take-off altitude %1"_s.arg(paramOf(item, 7));
        isFirst = isFirst && !isPlaced(item);
    }
    return {};
}

/** The airframe takes off and lands with its own commands. */
inline QString ownCommands(const PlanText& plan)
{
    const bool isVtol = !isHovering(plan) && !isFixedWing(plan);
    for (const QJsonValue& item : items(plan)) {
        const int command = commandOf(item);
        if ((command == kVtolTakeOff || command == kVtolLand) && !isVtol)
            return u"command %1 is for a VTOL"_s.arg(command);
        if ((command == kTakeOff || command == kLand) && isVtol)
            return u"command %1 is not for a VTOL"_s.arg(command);
        if (command == kLoiterTurns && !isFixedWing(plan))
            return u"loiter circles"_s;
    }
    return {};
}

/**
 * A land start is followed by a landing and by no return; a fixed wing lands from a loiter or a
 * waypoint, outside that circle, on a slope of 5 degrees at most.
 */
inline QString landing(const PlanText& plan)
{
    const QJsonArray all = items(plan);
    int starts = 0;
    for (qsizetype i = 0; i < all.size(); ++i) {
        const int command = commandOf(all[i]);
        starts += command == kLandStart ? 1 : 0;
        if (command == kReturn && starts > 0)
            return u"return after land start"_s;
        if (command == kLandStart && i + 2 >= all.size())
            return u"land start without landing"_s;
        if (command != kLand && command != kVtolLand)
            continue;
        if (i == 0 || !isPlaced(all[i - 1]))
            return u"landing without approach"_s;
        if (!isFixedWing(plan))
            continue;
        const bool isCircle = commandOf(all[i - 1]) == kLoiterToAltitude;
        if (!isCircle && commandOf(all[i - 1]) != kWaypoint)
            return u"landing after command %1"_s.arg(commandOf(all[i - 1]));
        const double radius_m = isCircle ? std::abs(paramOf(all[i - 1], 2)) : 0;
        const double length_m = distance_m(all[i - 1], all[i]);
        if (length_m <= radius_m)
            return u"landing inside the circle"_s;
        const double slope = (paramOf(all[i - 1], 7) - paramOf(all[i], 7)) /
                             std::sqrt(length_m * length_m - radius_m * radius_m);
        if (slope <= 0 || slope > std::tan(5.1 * M_PI / 180))
            return u"slope %1"_s.arg(slope);
    }
    return unless(starts <= 1, u"several land starts"_s);
}

/** The camera is off when the mission ends. */
inline QString cameraOffAtTheEnd(const PlanText& plan)
{
    bool isOn = false;
    for (const QJsonValue& item : items(plan)) {
        if (commandOf(item) == 206)
            isOn = paramOf(item, 1) > 0;
        if (commandOf(item) == 2000 || commandOf(item) == 2001)
            isOn = commandOf(item) == 2000;
    }
    return unless(!isOn, u"camera stays on"_s);
}

} // namespace autopilot_rules

/** Returns the rules of the autopilot that the plan names. */
inline std::vector<PlanRule> autopilotRules(const PlanText& plan)
{
    using namespace autopilot_rules;
    std::vector<PlanRule> rules{{"take-off first", takeOffFirst},
                                {"commands of the airframe", ownCommands},
                                {"landing", landing},
                                {"camera", cameraOffAtTheEnd}};
    if (plan_rules::mission(plan)["firmwareType"_L1].toInt() == 12)
        rules.push_back({"commands of PX4", px4Commands});
    else
        rules.insert(rules.end(), {{"commands of ArduPilot", arduPilotCommands},
                                   {"storage of ArduPlane", arduPilotStorage},
                                   {"NaN", arduPilotNan}});
    return rules;
}

} // namespace berg::test
