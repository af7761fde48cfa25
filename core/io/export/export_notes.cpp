#include "core/io/export/export_notes.h"

#include "core/base/translate_noop.h"
#include "core/io/export/export_files.h"
#include "core/io/export/maps/map_writers.h"
#include "core/io/export/mission_checks.h"
#include "core/io/export/missions/mission_ends.h"
#include "core/scenario/fence.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace berg {

namespace {

constexpr std::string_view kArduPlane = "ArduPlane";
constexpr std::string_view kArduCopter = "ArduCopter";
constexpr std::string_view kArduPilotName = "ArduPilot";
constexpr std::string_view kPx4Name = "PX4";
constexpr std::string_view kMissionPlanner = "Mission Planner";
constexpr double kSecondsPerMinute = 60;
constexpr std::string_view kGroundStations = "QGroundControl, Mission Planner";

/** All that is known of a kind of note. */
struct NoteRow
{
    ExportNoteKind kind;
    std::string_view id; ///< name for scripts
    ExportEffect effect;
    std::string_view words; ///< English words with %1, %2, ... for the arguments
};
// clang-format off
constexpr NoteRow kNoteWords[]{
    {ExportNoteKind::OneFileEach, "one-file-each", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "a file holds one UAV: %1 files are written, named after the UAVs")},
    {ExportNoteKind::NoTimes, "no-times", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "the scenario has no start time, so the file has no dates")},
    {ExportNoteKind::NoFence, "no-fence", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "the geofence is left out: the format has no place for it")},
    {ExportNoteKind::NoNoFly, "no-no-fly-areas", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "no-fly areas and the stand-off ring are left out: the format has no place for them")},
    {ExportNoteKind::NoHeights, "no-heights", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "no-fly areas have no heights: those at the altitude of the UAV are written")},
    {ExportNoteKind::FenceAcross180, "fence-across-180", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 may draw the fence the long way round: it crosses the antimeridian")},
    {ExportNoteKind::VisitsOnly, "visits-only", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "the places where icebergs were reached are written, not the track")},
    {ExportNoteKind::PathAsWaypoints, "path-as-waypoints", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "the path becomes %1 waypoints within %2 m of it")},
    {ExportNoteKind::AcceptanceCut, "acceptance-cut", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 keeps acceptance radii up to %3 m: %2 m becomes %3 m")},
    {ExportNoteKind::LoiterInSteps, "loiter-in-steps", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 keeps loiter radii above 255 m in steps of 10 m: %2 m becomes %3 m")},
    {ExportNoteKind::WholeSpeed, "whole-speed", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 reads the cruise speed as a whole number: %2 m/s becomes %3 m/s; the speed in the mission is exact")},
    {ExportNoteKind::ChoiceNotUsed, "choice-not-used", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "the file is about the whole flight, whatever is chosen to be exported")},
    {ExportNoteKind::NothingToFly, "nothing-to-fly", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "UAVs without an iceberg to visit: %1")},
    {ExportNoteKind::LegsCross, "legs-cross", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "straight legs that lead out of the geofence or through a no-fly area: %1; export the path instead, which leads round")},
    {ExportNoteKind::LaterSorties, "later-sorties", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "only this sortie is exported; icebergs left for later sorties: %1")},
    {ExportNoteKind::NoTakeOffItem, "no-take-off-item", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "there is no take-off item: launch the UAV by hand and start the mission in the air")},
    {ExportNoteKind::ReturnAdded, "return-added", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "after the last iceberg the mission returns home, %1 m that the plan does not include")},
    {ExportNoteKind::EndsLoitering, "ends-loitering", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "the mission ends in an endless loiter: command the return yourself")},
    {ExportNoteKind::LoiterAsTime, "loiter-as-time", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 has no loiter by turns: the time that they take is written")},
    {ExportNoteKind::NoLoiterTurns, "no-loiter-turns", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "loiter turns are left out: a VTOL or multirotor flies over each iceberg")},
    {ExportNoteKind::AcceptanceIgnored, "acceptance-ignored", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "%1 uses the acceptance radius of its parameter %2, not that of the file")},
    {ExportNoteKind::FenceOff, "fence-off", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "%1 keeps to the fence only if its parameter %2 says so")},
    {ExportNoteKind::HomeRowForOther, "home-row", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "the first row is home, which %1 does not have: upload the file with QGroundControl")},
    {ExportNoteKind::ClimbTooShort, "climb-too-short", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "the first iceberg is %2 m from the start, but the climb takes %1 m")},
    {ExportNoteKind::FirstLegFar, "first-leg-far", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "the first iceberg is %2 m from the start: %1 may refuse more than %3 m (MIS_DIST_1WP)")},
    {ExportNoteKind::EndsCross, "ends-cross", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "legs of take-off, return and landing that lead out of the geofence or through a no-fly area: %1")},
    {ExportNoteKind::ApproachOverLand, "approach-over-land", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "the landing approach leads over land")},
    {ExportNoteKind::ApproachSteep, "approach-steep", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "the landing approach descends at %1°, more than the usual %2°: make it longer or lower")},
    {ExportNoteKind::WaypointsClose, "waypoints-close", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "waypoints within their acceptance radius of the one before, which the UAV may skip: %1")},
    {ExportNoteKind::TooManyItems, "too-many-items", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "the mission has %2 items; %1 holds about %3")},
    {ExportNoteKind::AirspaceOnTheWay, "airspace-on-the-way", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "airspace areas that the mission enters at its altitudes: %1")},
    {ExportNoteKind::EnduranceShort, "endurance-short", ExportEffect::Check, QT_TRANSLATE_NOOP("IssueText", "with climb, return and landing the mission takes %1 min; the endurance without reserve is %2 min")},
    {ExportNoteKind::LineTimesLeft, "line-times-left", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "the times along paths and tracks are left out: the format has no place for them")},
    {ExportNoteKind::ShapefileNames, "shapefile-names", ExportEffect::Changed, QT_TRANSLATE_NOOP("IssueText", "there is a Shapefile each for points, lines and areas; names of properties are cut to 10 letters, texts to 254 bytes")},
    {ExportNoteKind::DrawingOnly, "drawing-only", ExportEffect::LeftOut, QT_TRANSLATE_NOOP("IssueText", "coordinates are metres of EPSG:%1; names, numbers and times are left out")},
    {ExportNoteKind::OptionNotUsed, "option-not-used", ExportEffect::Note, QT_TRANSLATE_NOOP("IssueText", "nothing in the file depends on %1")},
};
// clang-format on
static_assert(std::size(kNoteWords) == std::size_t(ExportNoteKind::OptionNotUsed) + 1);

const NoteRow& noteRow(ExportNoteKind kind)
{
    return *std::ranges::find(kNoteWords, kind, &NoteRow::kind);
}

class NoteList
{
public:
    void add(ExportNoteKind kind, std::string_view tool = {}, double value = 0, double limit = 0)
    {
        m_notes.push_back(exportNote(kind, tool, value, limit));
    }
    void add(const std::vector<ExportNote>& notes)
    {
        m_notes.insert(m_notes.end(), notes.begin(), notes.end());
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

bool isMultirotorUav(const ExportUav& uav)
{
    return uav.uav.aircraft.airframe == Airframe::Multirotor;
}

/** Returns true if the visits are waypoints, whose acceptance radius is written. */
bool writesAcceptance(const ExportContent& content, const ExportUav& uav)
{
    const bool hasCircles =
        content.options.loiterTurns > 0 && uav.uav.aircraft.airframe == Airframe::FixedWing;
    return content.what == ExportScope::Path ? content.options.acceptance_m.has_value()
                                             : !hasCircles && !isOverflown(uav);
}

/** Adds notes about numbers that the storage of autopilots changes. */
void addAutopilotNotes(NoteList& notes, const ExportContent& content)
{
    double reach_m = 0;
    double circle_m = 0;
    double loiter_m = 0;
    double speed_mps = 0;
    double shown_mps = 0;
    for (const ExportUav& uav : content.uavs) {
        if (!isArduPilot(uav))
            continue;
        if (!isMultirotorUav(uav) && writesAcceptance(content, uav))
            reach_m = std::max(reach_m, uav.reach_m);
        if (!isMultirotorUav(uav) && uav.circle_m > circle_m) {
            circle_m = uav.circle_m;
            loiter_m = loiterRadius_m(uav);
        }
        const double whole_mps = std::max(1.0, std::round(uav.uav.spec.airspeed_mps));
        if (whole_mps != uav.uav.spec.airspeed_mps) {
            speed_mps = uav.uav.spec.airspeed_mps;
            shown_mps = whole_mps;
        }
    }
    if (reach_m > kLargestByte_m)
        notes.add(ExportNoteKind::AcceptanceCut, kArduPlane, reach_m, kLargestByte_m);
    if (circle_m > kLargestByte_m)
        notes.add(ExportNoteKind::LoiterInSteps, kArduPlane, circle_m, loiter_m);
    if (speed_mps > 0)
        notes.add(ExportNoteKind::WholeSpeed, kMissionPlanner, speed_mps, shown_mps);
}

/** Adds how each autopilot treats waypoints and circles. */
void addDialectNotes(NoteList& notes, const ExportContent& content)
{
    const auto any = [&](const auto& test) { return std::ranges::any_of(content.uavs, test); };
    const bool hasTurns = content.options.loiterTurns > 0 && content.what != ExportScope::Path;
    const auto isFixedWing = [](const ExportUav& uav) {
        return uav.uav.aircraft.airframe == Airframe::FixedWing;
    };
    if (hasTurns &&
        any([&](const ExportUav& uav) { return isFixedWing(uav) && !isArduPilot(uav); }))
        notes.add(ExportNoteKind::LoiterAsTime, kPx4Name);
    if (hasTurns && any([&](const ExportUav& uav) { return !isFixedWing(uav); }))
        notes.add(ExportNoteKind::NoLoiterTurns);
    if (any([](const ExportUav& uav) { return isArduPilot(uav) && isMultirotorUav(uav); }))
        notes.add(ExportNoteKind::AcceptanceIgnored, kArduCopter);
}

/** Adds how missions begin and end. */
void addEndNotes(NoteList& notes, const ExportContent& content)
{
    double return_m = 0;
    bool isByHand = false;
    bool endsLoitering = false;
    for (const ExportUav& uav : content.uavs) {
        isByHand = isByHand || (!uav.isAloft && uav.uav.aircraft.takeOff == TakeOffMethod::Hand);
        if (endItems(content, uav).back().command == LinkCommandId::kLoiterUnlimited)
            endsLoitering = true;
        else
            return_m = std::max(return_m, (uav.home_m - lastPlace_m(content, uav)).norm());
    }
    if (isByHand)
        notes.add(ExportNoteKind::NoTakeOffItem);
    if (return_m > 1)
        notes.add(ExportNoteKind::ReturnAdded, {}, return_m);
    if (endsLoitering)
        notes.add(ExportNoteKind::EndsLoitering);
}

/** Adds what the autopilots need before they use fence and home of the file. */
void addSetUpNotes(NoteList& notes, const ExportContent& content, bool holdsFence)
{
    const bool hasPx4 = !std::ranges::all_of(content.uavs, isArduPilot);
    const bool hasFence =
        (content.geofence && !content.area_m.empty()) || !closedAreas(content).empty();
    if (!holdsFence && hasPx4)
        notes.add(ExportNoteKind::HomeRowForOther, kPx4Name);
    if (holdsFence && hasFence)
        notes.add(ExportNoteKind::FenceOff, hasPx4 ? kPx4Name : kArduPilotName);
}

/** Returns the parameter of an autopilot that decides what the note is about. */
std::string parameterOf(const ExportNote& note)
{
    if (note.kind == ExportNoteKind::FenceOff)
        return note.tool == kPx4Name ? "GF_ACTION" : "FENCE_ENABLE";
    return "WPNAV_RADIUS";
}

void addMissionNotes(NoteList& notes, const ExportCapabilities& holds, const ExportContent& content)
{
    if (content.what == ExportScope::Track)
        notes.add(ExportNoteKind::VisitsOnly);
    if (content.what == ExportScope::Path) {
        std::size_t waypoints = 0;
        for (const ExportUav& uav : content.uavs)
            waypoints = std::max(waypoints, pathCorners(uav).size());
        notes.add(ExportNoteKind::PathAsWaypoints, {}, static_cast<double>(waypoints));
    }
    addAutopilotNotes(notes, content);
    addDialectNotes(notes, content);
    addEndNotes(notes, content);
    addSetUpNotes(notes, content, holds.fence);
    notes.add(missionChecks(content));
}

void addOptionNotes(NoteList& notes, const ExportCapabilities& holds, const ExportContent& content)
{
    struct Option
    {
        ExportOption option;
        std::string_view name; ///< on the command line
        bool isGiven;
    };
    const ExportOptions& options = content.options;
    const Option all[] = {
        {ExportOption::Uav, "uav", options.uav.has_value()},
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

ExportNote exportNote(ExportNoteKind kind, std::string_view tool, double value, double limit)
{
    return {.kind = kind, .id = noteRow(kind).id, .tool = tool, .value = value, .limit = limit};
}

std::size_t legsThatCross(const ExportContent& content)
{
    if (content.what == ExportScope::Path || content.what == ExportScope::Track)
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
    const ExportCapabilities& holds = format.holds;
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
    const bool hasLines = content.what == ExportScope::Path || content.what == ExportScope::Track;
    if (holds.gis && hasLines)
        notes.add(ExportNoteKind::LineTimesLeft);
    if (format.id == "shapefile")
        notes.add(ExportNoteKind::ShapefileNames);
    if (format.id == "dxf")
        notes.add(ExportNoteKind::DrawingOnly, {},
                  static_cast<double>(utmEpsg(content.frame.origin())));
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
        addMissionNotes(notes, holds, content);
    return notes.take();
}

ExportEffect effectOf(ExportNoteKind kind)
{
    return noteRow(kind).effect;
}

std::string_view notePattern(ExportNoteKind kind)
{
    return noteRow(kind).words;
}

std::vector<IssueArgument> noteArguments(const ExportNote& note)
{
    const std::string tool(note.tool);
    switch (note.kind) {
    case ExportNoteKind::OneFileEach:
    case ExportNoteKind::NothingToFly:
    case ExportNoteKind::LegsCross:
    case ExportNoteKind::LaterSorties:
    case ExportNoteKind::EndsCross:
    case ExportNoteKind::WaypointsClose:
    case ExportNoteKind::AirspaceOnTheWay:
    case ExportNoteKind::DrawingOnly:
        return {note.value};
    case ExportNoteKind::ReturnAdded:
        return {std::round(note.value)};
    case ExportNoteKind::ClimbTooShort:
        return {std::round(note.value), std::round(note.limit)};
    case ExportNoteKind::ApproachSteep:
        return {std::round(10 * note.value) / 10, note.limit};
    case ExportNoteKind::EnduranceShort:
        return {std::ceil(note.value / kSecondsPerMinute),
                std::floor(note.limit / kSecondsPerMinute)};
    case ExportNoteKind::FenceAcross180:
    case ExportNoteKind::LoiterAsTime:
    case ExportNoteKind::HomeRowForOther:
        return {tool};
    case ExportNoteKind::AcceptanceIgnored:
    case ExportNoteKind::FenceOff:
        return {tool, parameterOf(note)};
    case ExportNoteKind::OptionNotUsed:
        return {FieldPath{"--" + tool}};
    case ExportNoteKind::PathAsWaypoints:
        return {note.value, kPathTolerance_m};
    case ExportNoteKind::AcceptanceCut:
    case ExportNoteKind::LoiterInSteps:
    case ExportNoteKind::FirstLegFar:
    case ExportNoteKind::TooManyItems:
        return {tool, std::round(note.value), std::round(note.limit)};
    case ExportNoteKind::WholeSpeed:
        return {tool, std::round(100 * note.value) / 100, note.limit};
    case ExportNoteKind::NoTimes:
    case ExportNoteKind::NoFence:
    case ExportNoteKind::NoNoFly:
    case ExportNoteKind::NoHeights:
    case ExportNoteKind::VisitsOnly:
    case ExportNoteKind::ChoiceNotUsed:
    case ExportNoteKind::NoTakeOffItem:
    case ExportNoteKind::EndsLoitering:
    case ExportNoteKind::NoLoiterTurns:
    case ExportNoteKind::ApproachOverLand:
    case ExportNoteKind::LineTimesLeft:
    case ExportNoteKind::ShapefileNames:
        return {};
    }
    throw std::logic_error("noteArguments: unknown kind");
}

} // namespace berg
