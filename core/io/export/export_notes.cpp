#include "core/io/export/export_notes.h"

#include "core/base/number_text.h"
#include "core/base/translate_noop.h"
#include "core/io/export/export_files.h"
#include "core/io/export/mission_items.h"
#include "core/scenario/fence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace berg {

namespace {

constexpr std::string_view kArduPlane = "ArduPlane";
constexpr std::string_view kMissionPlanner = "Mission Planner";
constexpr std::string_view kGroundStations = "QGroundControl, Mission Planner";

constexpr std::array<Named<ExportNoteKind>, 16> kNoteIds{{
    {ExportNoteKind::OneFileEach, "one-file-each"},
    {ExportNoteKind::NoTimes, "no-times"},
    {ExportNoteKind::NoFence, "no-fence"},
    {ExportNoteKind::NoNoFly, "no-no-fly-areas"},
    {ExportNoteKind::NoHeights, "no-heights"},
    {ExportNoteKind::FenceAcross180, "fence-across-180"},
    {ExportNoteKind::VisitsOnly, "visits-only"},
    {ExportNoteKind::PathAsWaypoints, "path-as-waypoints"},
    {ExportNoteKind::AcceptanceCut, "acceptance-cut"},
    {ExportNoteKind::LoiterInSteps, "loiter-in-steps"},
    {ExportNoteKind::WholeSpeed, "whole-speed"},
    {ExportNoteKind::ChoiceNotUsed, "choice-not-used"},
    {ExportNoteKind::NothingToFly, "nothing-to-fly"},
    {ExportNoteKind::LegsCross, "legs-cross"},
    {ExportNoteKind::LaterSorties, "later-sorties"},
    {ExportNoteKind::OptionNotUsed, "option-not-used"},
}};

std::string_view idOf(ExportNoteKind kind)
{
    return std::ranges::find(kNoteIds, kind, &Named<ExportNoteKind>::value)->name;
}

class NoteList
{
public:
    void add(ExportNoteKind kind, std::string_view tool = {}, double value = 0, double limit = 0)
    {
        m_notes.push_back(
            {.kind = kind, .id = idOf(kind), .tool = tool, .value = value, .limit = limit});
    }

    std::vector<ExportNote> take() { return std::move(m_notes); }

private:
    std::vector<ExportNote> m_notes;
};

bool fenceCrosses180(const ExportContent& content)
{
    const auto crosses = [&](const std::vector<Point>& corners_m) {
        return geographicPolygon(content.frame, corners_m).size() > 1;
    };
    return (content.geofence && !content.area_m.empty() && crosses(content.area_m)) ||
           std::ranges::any_of(closedAreas(content), crosses, &NoFlyArea::corners_m);
}

/** What the autopilots' own storage makes of the numbers. */
void addAutopilotNotes(NoteList& notes, const ExportContent& content)
{
    double reach_m = 0;
    double circle_m = 0;
    double speed_mps = 0;
    double shown_mps = 0;
    for (const ExportUav& uav : content.uavs) {
        reach_m = std::max(reach_m, uav.reach_m);
        circle_m = std::max(circle_m, uav.circle_m);
        const double whole_mps = std::max(1.0, std::round(uav.uav.spec.airspeed_mps));
        if (whole_mps != uav.uav.spec.airspeed_mps) {
            speed_mps = uav.uav.spec.airspeed_mps;
            shown_mps = whole_mps;
        }
    }
    const bool waypointsAreCut = content.options.loiterTurns == 0 &&
                                 (content.what != ExportWhat::Path || content.options.acceptance_m);
    if (reach_m > kLargestByte_m && waypointsAreCut)
        notes.add(ExportNoteKind::AcceptanceCut, kArduPlane, reach_m, kLargestByte_m);
    if (circle_m > kLargestByte_m)
        notes.add(ExportNoteKind::LoiterInSteps, kArduPlane, circle_m,
                  loiterRadius_m({.uav = {}, .circle_m = circle_m}));
    if (speed_mps > 0)
        notes.add(ExportNoteKind::WholeSpeed, kMissionPlanner, speed_mps, shown_mps);
}

void addMissionNotes(NoteList& notes, const ExportContent& content)
{
    if (content.what == ExportWhat::Track)
        notes.add(ExportNoteKind::VisitsOnly);
    if (content.what == ExportWhat::Path) {
        std::size_t waypoints = 0;
        for (const ExportUav& uav : content.uavs)
            waypoints = std::max(waypoints, pathCorners(uav).size());
        notes.add(ExportNoteKind::PathAsWaypoints, {}, static_cast<double>(waypoints));
    }
    addAutopilotNotes(notes, content);
}

void addOptionNotes(NoteList& notes, const ExportHolds& holds, const ExportContent& content)
{
    struct Option
    {
        ExportOption option;
        std::string_view name; ///< on the command line
        bool isGiven;
    };
    const ExportOptions& options = content.options;
    const Option all[] = {
        {ExportOption::Uav, "uav", !options.uav.empty()},
        {ExportOption::Altitude, "altitude", options.altitude_m.has_value()},
        {ExportOption::Airspeed, "speed", options.airspeed_mps.has_value()},
        {ExportOption::Acceptance, "acceptance", options.acceptance_m.has_value()},
        {ExportOption::Loiter, "loiter", options.loiterTurns > 0},
        {ExportOption::ReturnHome,
         options.returnHome.value_or(true) ? "return-home" : "no-return-home",
         options.returnHome.has_value()}};
    for (const Option& one : all)
        if (one.isGiven && !holds.dependsOn(one.option, content))
            notes.add(ExportNoteKind::OptionNotUsed, one.name);
}

} // namespace

std::size_t legsThatCross(const ExportContent& content)
{
    if (content.what == ExportWhat::Path || content.what == ExportWhat::Track)
        return 0;
    std::size_t crossing = 0;
    for (const ExportUav& uav : content.uavs) {
        const UavSpec& spec = uav.uav.spec;
        const auto fence = fenceOf(*content.scenario, spec.altitude_m,
                                   {.airspeed_mps = spec.airspeed_mps,
                                    .limit_radps = maxTurnRate_radps(spec),
                                    .wind_mps = content.wind_mps});
        Point from_m = uav.uav.position_m;
        for (const Visit& visit : uav.visits) {
            crossing += fence && fence->clearance_m(from_m, visit.position_m) == 0 ? 1U : 0U;
            from_m = visit.position_m;
        }
    }
    return crossing;
}

std::vector<ExportNote> exportNotes(const ExportFormat& format, const ExportContent& content)
{
    NoteList notes;
    const ExportHolds& holds = format.holds;
    if (const std::size_t files = fileCount(format, content); files > 1)
        notes.add(ExportNoteKind::OneFileEach, {}, static_cast<double>(files));
    addOptionNotes(notes, holds, content);
    if (holds.flownOnly) {
        if (content.options.what)
            notes.add(ExportNoteKind::ChoiceNotUsed);
        return notes.take();
    }
    const auto idle = std::ranges::count_if(
        content.uavs, [](const ExportUav& uav) { return uav.visits.empty() && uav.track.empty(); });
    if (idle > 0)
        notes.add(ExportNoteKind::NothingToFly, {}, static_cast<double>(idle));
    std::size_t later = 0;
    for (const ExportUav& uav : content.uavs)
        later += uav.laterSorties;
    if (later > 0)
        notes.add(ExportNoteKind::LaterSorties, {}, static_cast<double>(later));
    if (const std::size_t crossing = legsThatCross(content); crossing > 0)
        notes.add(ExportNoteKind::LegsCross, {}, static_cast<double>(crossing));
    if (holds.times && !content.start)
        notes.add(ExportNoteKind::NoTimes);
    if (content.geofence && !holds.fence)
        notes.add(ExportNoteKind::NoFence);
    const std::vector<NoFlyArea> closed = closedAreas(content);
    if (!closed.empty() && !holds.fence)
        notes.add(ExportNoteKind::NoNoFly);
    else if (holds.mission && std::ranges::any_of(closed, hasHeights))
        notes.add(ExportNoteKind::NoHeights);
    if (holds.mission && holds.fence && fenceCrosses180(content))
        notes.add(ExportNoteKind::FenceAcross180, kGroundStations);
    if (holds.mission)
        addMissionNotes(notes, content);
    return notes.take();
}

std::string_view notePattern(ExportNoteKind kind)
{
    switch (kind) {
    case ExportNoteKind::OneFileEach:
        return QT_TRANSLATE_NOOP(
            "CommandLine", "a file holds one UAV: %1 files are written, named after the UAVs");
    case ExportNoteKind::NoTimes:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "the scenario has no start time, so the file has no dates");
    case ExportNoteKind::NoFence:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "the geofence is left out: the format has no place for it");
    case ExportNoteKind::NoNoFly:
        return QT_TRANSLATE_NOOP(
            "CommandLine",
            "no-fly areas and the stand-off ring are left out: the format has no place for them");
    case ExportNoteKind::NoHeights:
        return QT_TRANSLATE_NOOP(
            "CommandLine",
            "no-fly areas have no heights: those at the altitude of the UAV are written");
    case ExportNoteKind::FenceAcross180:
        return QT_TRANSLATE_NOOP(
            "CommandLine", "%1 may draw the fence the long way round: it crosses the antimeridian");
    case ExportNoteKind::VisitsOnly:
        return QT_TRANSLATE_NOOP(
            "CommandLine", "the places where icebergs were reached are written, not the track");
    case ExportNoteKind::PathAsWaypoints:
        return QT_TRANSLATE_NOOP("CommandLine", "the path becomes %1 waypoints within %2 m of it");
    case ExportNoteKind::AcceptanceCut:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "%1 keeps acceptance radii up to %3 m: %2 m becomes %3 m");
    case ExportNoteKind::LoiterInSteps:
        return QT_TRANSLATE_NOOP(
            "CommandLine", "%1 keeps loiter radii above 255 m in steps of 10 m: %2 m becomes %3 m");
    case ExportNoteKind::WholeSpeed:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "%1 reads the cruise speed as a whole number: %2 m/s becomes %3 "
                                 "m/s; the speed in the mission is exact");
    case ExportNoteKind::ChoiceNotUsed:
        return QT_TRANSLATE_NOOP(
            "CommandLine", "the file is about the whole flight, whatever is chosen to be exported");
    case ExportNoteKind::NothingToFly:
        return QT_TRANSLATE_NOOP("CommandLine", "UAVs without an iceberg to visit: %1");
    case ExportNoteKind::LegsCross:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "straight legs that lead out of the geofence or through a no-fly "
                                 "area: %1; the path (--what path) leads round");
    case ExportNoteKind::LaterSorties:
        return QT_TRANSLATE_NOOP(
            "CommandLine",
            "this sortie alone is written: icebergs of the order left for later ones: %1");
    case ExportNoteKind::OptionNotUsed:
        return QT_TRANSLATE_NOOP("CommandLine",
                                 "--%1 is not used: nothing in the file depends on it");
    }
    throw std::logic_error("notePattern: unknown kind");
}

std::vector<IssueArgument> noteArguments(const ExportNote& note)
{
    const std::string tool(note.tool);
    const std::string value = fixedText(note.value, 0);
    const std::string limit = fixedText(note.limit, 0);
    switch (note.kind) {
    case ExportNoteKind::OneFileEach:
    case ExportNoteKind::NothingToFly:
    case ExportNoteKind::LegsCross:
    case ExportNoteKind::LaterSorties:
        return {value};
    case ExportNoteKind::FenceAcross180:
    case ExportNoteKind::OptionNotUsed:
        return {tool};
    case ExportNoteKind::PathAsWaypoints:
        return {value, fixedText(kPathTolerance_m, 0)};
    case ExportNoteKind::AcceptanceCut:
    case ExportNoteKind::LoiterInSteps:
        return {tool, value, limit};
    case ExportNoteKind::WholeSpeed:
        return {tool, fixedText(note.value, 2), limit};
    case ExportNoteKind::NoTimes:
    case ExportNoteKind::NoFence:
    case ExportNoteKind::NoNoFly:
    case ExportNoteKind::NoHeights:
    case ExportNoteKind::VisitsOnly:
    case ExportNoteKind::ChoiceNotUsed:
        return {};
    }
    throw std::logic_error("noteArguments: unknown kind");
}

} // namespace berg
