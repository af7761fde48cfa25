#include "core/base/issue.h"

#include "core/base/number_text.h"
#include "core/base/translate_noop.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace berg {

namespace {

constexpr std::array<std::string_view, 10> kKinds{
    "null",  "an object", "an array",      "a string",    "true",
    "false", "a number",  "true or false", "two numbers", "pairs of numbers"};

std::string argumentText(const IssueArgument& argument)
{
    if (const auto* const number = std::get_if<double>(&argument))
        return numberText(*number);
    if (const auto* const count = std::get_if<std::int64_t>(&argument))
        return std::to_string(*count);
    if (const auto* const kind = std::get_if<ValueKind>(&argument))
        return std::string(englishWords(*kind));
    return std::get<std::string>(argument);
}

struct Pattern
{
    IssueId id;
    std::string_view text; ///< %1, %2, ... stand for the arguments
};

constexpr std::array<Pattern, kIssueIds> kPatterns{{
    {IssueId::NotUtf8, QT_TRANSLATE_NOOP("IssueText", "must be UTF-8 text")},
    {IssueId::NotFinite, QT_TRANSLATE_NOOP("IssueText", "must be a finite number")},
    {IssueId::NotFinitePair, QT_TRANSLATE_NOOP("IssueText", "must be two finite numbers")},
    {IssueId::OutOfRange, QT_TRANSLATE_NOOP("IssueText", "must be from %1 to %2, not %3")},
    {IssueId::OutOfOpenRange,
     QT_TRANSLATE_NOOP("IssueText", "must be above %1 and at most %2, not %3")},
    {IssueId::NotUtcTime,
     QT_TRANSLATE_NOOP("IssueText", "must be a UTC date and time such as 2024-05-01T06:00:00Z")},
    {IssueId::AreaCorners,
     QT_TRANSLATE_NOOP("IssueText", "must have from 3 to %1 corners, not %2")},
    {IssueId::AreaNotSimple,
     QT_TRANSLATE_NOOP("IssueText", "must be a polygon that neither touches nor crosses itself")},
    {IssueId::NoFlyCount, QT_TRANSLATE_NOOP("IssueText", "must hold at most %1 areas, not %2")},
    {IssueId::AirspaceCount,
     QT_TRANSLATE_NOOP("IssueText", "must hold at most %1 airspaces, not %2")},
    {IssueId::IdEmpty, QT_TRANSLATE_NOOP("IssueText", "must not be empty")},
    {IssueId::IdTaken, QT_TRANSLATE_NOOP("IssueText", "\"%1\" is the id of %2 already")},
    {IssueId::UavCount, QT_TRANSLATE_NOOP("IssueText", "must hold from 1 to %1 UAVs, not %2")},
    {IssueId::IcebergCount,
     QT_TRANSLATE_NOOP("IssueText", "must hold at most %1 icebergs, not %2")},
    {IssueId::TrackPoints,
     QT_TRANSLATE_NOOP("IssueText", "must have from 2 to %1 entries, not %2")},
    {IssueId::TrackPlaces,
     QT_TRANSLATE_NOOP("IssueText", "must have one entry for each of time_s: %1, not %2")},
    {IssueId::TrackNotRising,
     QT_TRANSLATE_NOOP("IssueText", "must be later than the entry before")},
    {IssueId::MoreFaults, QT_TRANSLATE_NOOP("IssueText", "and %1 more faults")},
    {IssueId::StepTooLong, QT_TRANSLATE_NOOP("IssueText", "must not be longer than duration_s")},
    {IssueId::AutopilotTooSlow,
     QT_TRANSLATE_NOOP("IssueText", "must be at most %1 where the endurance is limited, not %2")},
    {IssueId::FenceNoArea, QT_TRANSLATE_NOOP("IssueText", "needs an area, area_m, to stay inside")},
    {IssueId::FenceCorners,
     QT_TRANSLATE_NOOP("IssueText", "must have at most %1 corners to be a geofence, not %2")},
    {IssueId::OutsideFence,
     QT_TRANSLATE_NOOP("IssueText", "must be inside the area, which is a geofence")},
    {IssueId::NoFlyCorners,
     QT_TRANSLATE_NOOP("IssueText",
                       "must have, with the geofence and the stand-off ring, at most %1 corners "
                       "at the altitude of a UAV, not %2")},
    {IssueId::InsideNoFly,
     QT_TRANSLATE_NOOP("IssueText", "must be outside the no-fly area \"%1\"")},
    {IssueId::InsideStandoff,
     QT_TRANSLATE_NOOP("IssueText", "must be outside the stand-off ring round the asset")},
    {IssueId::UnknownUav,
     QT_TRANSLATE_NOOP("IssueText", "\"%1\" is the id of no UAV of this scenario")},
    {IssueId::WindTooFast,
     QT_TRANSLATE_NOOP("IssueText",
                       "must be slower than the UAV flies: wind of %1 m/s, airspeed of %2 %3 m/s")},
    {IssueId::StrongWind,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "the UAV will make little way against it: wind of %1 m/s, airspeed of %2 %3 m/s")},
    {IssueId::DriftTooFast,
     QT_TRANSLATE_NOOP("IssueText", "drifts so fast that the UAV may not catch up with it")},
    {IssueId::SensorIntervalTooShort,
     QT_TRANSLATE_NOOP("IssueText", "must not be shorter than the time step dt_s")},
    {IssueId::CeilingTooLow,
     QT_TRANSLATE_NOOP("IssueText", "must be above the floor of %1 m, not %2 m")},
    {IssueId::AirspaceTimes, QT_TRANSLATE_NOOP("IssueText", "must not be earlier than %1")},
    {IssueId::NothingToFly,
     QT_TRANSLATE_NOOP("IssueText",
                       "must be longer than reserve, climb and landing: %1 s, not above %2 s")},
    {IssueId::NoIcebergs, QT_TRANSLATE_NOOP("IssueText", "none yet, so there is nothing to plan")},
    {IssueId::AppearsTooLate, QT_TRANSLATE_NOOP("IssueText", "is after the end of the run")},
    {IssueId::UnknownMembers,
     QT_TRANSLATE_NOOP("IssueText",
                       "members that this version does not know are not used: \"%1\"")},
    {IssueId::AreaNoFence,
     QT_TRANSLATE_NOOP("IssueText",
                       "icebergs outside it are not monitored; the UAV may fly beyond it")},
    {IssueId::VelocitySdUnused,
     QT_TRANSLATE_NOOP("IssueText", "is used in flight with the observer kalman only")},
    {IssueId::SeenLongAgo,
     QT_TRANSLATE_NOOP("IssueText", "%1 h old: may be %2 m away (%3 x the field of view)")},
    {IssueId::OutOfViewNext,
     QT_TRANSLATE_NOOP("IssueText",
                       "with these drifts and a round of %1 minutes, %2 of %3 icebergs will "
                       "be out of view at the next visit")},
    {IssueId::SameLayer,
     QT_TRANSLATE_NOOP("IssueText",
                       "starts within separation_m of another UAV whose altitude differs by less "
                       "than %1 m")},
    {IssueId::NoPathHome,
     QT_TRANSLATE_NOOP("IssueText", "is too short for the path home from the start")},
    {IssueId::NoRoundTrip,
     QT_TRANSLATE_NOOP("IssueText", "is too short for the path to the nearest iceberg and back")},
    {IssueId::HomeUnused,
     QT_TRANSLATE_NOOP("IssueText",
                       "is used, without a limited endurance, only when you order a return or "
                       "export with the return home")},
    {IssueId::HomeNearFence,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "is so near the geofence or a no-fly area that the UAV cannot take off there again and be "
         "sure to come home")},
    {IssueId::NoSafeReturn,
     QT_TRANSLATE_NOOP("IssueText", "has, for this heading, no path home inside the geofence and "
                                    "outside no-fly areas, so that no "
                                    "start is safe")},
    {IssueId::StartNearFence,
     QT_TRANSLATE_NOOP("IssueText",
                       "is so near the geofence or a no-fly area, for this heading, that "
                       "the UAV cannot turn in time")},
    {IssueId::ShutOff,
     QT_TRANSLATE_NOOP("IssueText",
                       "is so near the geofence or in a no-fly area that the UAV, to be within "
                       "the acceptance radius, cannot be sent there")},
    {IssueId::SlowAutopilot,
     QT_TRANSLATE_NOOP("IssueText",
                       "is so long between two commands that the UAV cannot follow a leg")},
    {IssueId::WindLimit,
     QT_TRANSLATE_NOOP("IssueText", "must not be exceeded: wind of %1 m/s, limit %2 m/s")},
    {IssueId::GustLimit,
     QT_TRANSLATE_NOOP("IssueText", "must not be exceeded: gusts of %1 m/s, limit %2 m/s")},
    {IssueId::Icing,
     QT_TRANSLATE_NOOP("IssueText",
                       "the UAV must not be flown in icing conditions, which this weather brings")},
    {IssueId::CrowdedReturn,
     QT_TRANSLATE_NOOP("IssueText",
                       "is less reserve than waiting for the other UAVs of the altitude layer "
                       "may take, %1 s")},
    {IssueId::RecoverySlot,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "keeps %1 s free for its recovery slot: other UAVs of the altitude layer land on "
         "the same pad")},
    {IssueId::ThinReserve,
     QT_TRANSLATE_NOOP("IssueText",
                       "in one flight of twenty %1 s of the reserve are used to come home")},
    {IssueId::MayNotReturn,
     QT_TRANSLATE_NOOP("IssueText", "in one flight of twenty the wind is too strong to come home")},
    {IssueId::NoContact,
     QT_TRANSLATE_NOOP("IssueText",
                       "the plan leads out of the range of the ground station for %1 s")},
    {IssueId::DarkTakeOff,
     QT_TRANSLATE_NOOP("IssueText",
                       "takes off in the dark, at %1 UTC: civil twilight begins at %2 UTC")},
    {IssueId::DarkLanding,
     QT_TRANSLATE_NOOP("IssueText", "lands in the dark, at %1 UTC: civil twilight ends at %2 UTC")},
    {IssueId::AirspaceEntered,
     QT_TRANSLATE_NOOP("IssueText",
                       "the operation may enter the airspace \"%1\", which begins at %2 m")},
    {IssueId::FenceUnplanned,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "this policy plans without geofence and no-fly areas; they are kept in flight")},
    {IssueId::UavOutside, QT_TRANSLATE_NOOP("IssueText", "the UAV starts outside the area")},
    {IssueId::WideTurn,
     QT_TRANSLATE_NOOP("IssueText", "the turn radius is larger than half the field of view, so "
                                    "that an iceberg may be missed")},
    {IssueId::ReachInsideTurn,
     QT_TRANSLATE_NOOP("IssueText",
                       "is smaller than the turn radius, so that the UAV flies on and comes back")},
    {IssueId::ReachBeyondView,
     QT_TRANSLATE_NOOP("IssueText", "is larger than half the field of view, so that icebergs count "
                                    "as reached that are not seen")},
    {IssueId::OutsideArea, QT_TRANSLATE_NOOP("IssueText", "lies outside the area")},
    {IssueId::LeavesArea,
     QT_TRANSLATE_NOOP("IssueText", "drifts out of the area before the end of the run")},
    {IssueId::SamePlace,
     QT_TRANSLATE_NOOP("IssueText", "lies where another iceberg lies: the same one?")},
    {IssueId::OutOfReach,
     QT_TRANSLATE_NOOP("IssueText",
                       "is so far away that the UAV cannot get there before the end of the run")},
    {IssueId::TooShort,
     QT_TRANSLATE_NOOP("IssueText", "is over before the UAV can get to the first iceberg")},
    {IssueId::Fast,
     QT_TRANSLATE_NOOP("IssueText", "drifts faster than icebergs do: is the unit right?")},
    {IssueId::TrackShort,
     QT_TRANSLATE_NOOP("IssueText",
                       "ends before the run does; from then on the iceberg stands still")},
    {IssueId::TrackFar,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "begins so far from the estimate that the UAV will not see the iceberg there")},
    {IssueId::AssetInIce, QT_TRANSLATE_NOOP("IssueText", "lies inside an iceberg")},
    {IssueId::NoSigma,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "no iceberg is uncertain at the start, so distance alone makes the first plan")},
    {IssueId::BeyondProof,
     QT_TRANSLATE_NOOP("IssueText",
                       "more than can be proven optimal; the plan comes with a bound")},
    {IssueId::ClustersIgnored,
     QT_TRANSLATE_NOOP("IssueText",
                       "the policy plans icebergs one by one; nearby icebergs are not grouped")},
    {IssueId::SolverUnable,
     QT_TRANSLATE_NOOP("IssueText", "cannot plan so many icebergs; the back end auto can")},
    {IssueId::LongProof,
     QT_TRANSLATE_NOOP("IssueText",
                       "proving the optimum of so many icebergs can take a minute and more")},
#define ISSUE(id, words) {IssueId::id, words},
#include "core/base/reading_issues.inc"
#undef ISSUE
}};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < kPatterns.size(); ++i)
        if (static_cast<std::size_t>(kPatterns[i].id) != i)
            return false;
    return true;
}
static_assert(isInOrder(), "a row for each id, in their order");

} // namespace

std::string_view englishWords(IssueId id)
{
    return kPatterns.at(static_cast<std::size_t>(id)).text;
}

std::string_view englishWords(ValueKind kind)
{
    return kKinds.at(static_cast<std::size_t>(kind));
}

std::string filledIn(std::string_view pattern, const std::vector<IssueArgument>& arguments)
{
    const auto argument = [&](char number) {
        const auto i = static_cast<std::size_t>(number - '1');
        return i < arguments.size() ? argumentText(arguments[i]) : std::string();
    };
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i)
        if (pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' &&
            pattern[i + 1] <= '9')
            text += argument(pattern[++i]);
        else
            text += pattern[i];
    const bool hasDetail = !arguments.empty() && pattern.find('%') == pattern.npos;
    return hasDetail ? text + ": \"" + argument('1') + '"' : text;
}

std::string englishText(const IssueReason& reason)
{
    return filledIn(englishWords(reason.id), reason.arguments);
}

bool hasErrors(const std::vector<Issue>& issues)
{
    return std::any_of(issues.begin(), issues.end(),
                       [](const Issue& i) { return i.severity == Severity::Error; });
}

} // namespace berg
