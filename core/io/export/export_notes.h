#pragma once

#include "core/base/issue.h"
#include "core/io/export/formats.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Property of an export that the user should know: content that the format leaves out, or that a
 * tool will change.
 */
enum class ExportNoteKind
{
    OneFileEach,    ///< value: number of UAVs, each in a file of its own
    NoTimes,        ///< the scenario has no start time, so there are no dates
    NoFence,        ///< the format has no place for the geofence
    NoNoFly,        ///< the format has no place for no-fly areas and the stand-off ring
    NoHeights,      ///< no-fly areas lose their heights: those at the altitude of the UAV are
                    ///< exported for every height
    FenceAcross180, ///< ground stations may draw a fence across the antimeridian the long way round
    VisitsOnly,     ///< a track is exported as waypoints where icebergs were reached
    PathAsWaypoints,   ///< value: number of waypoints that represent the path
    AcceptanceCut,     ///< value: requested radius in m, limit: stored radius in m
    LoiterInSteps,     ///< value: necessary radius in m, limit: stored radius in m
    WholeSpeed,        ///< value: speed in m/s, limit: displayed speed in m/s
    ChoiceNotUsed,     ///< the chosen scope is irrelevant, because the file covers the whole flight
    NothingToFly,      ///< value: number of UAVs without anything to visit
    LegsCross,         ///< value: number of straight legs that cross the fence or a no-fly area
    LaterSorties,      ///< value: number of icebergs that the endurance leaves for later sorties
    NoTakeOffItem,     ///< the UAV is launched by hand, so the mission has no take-off item
    ReturnAdded,       ///< value: distance in m from the last iceberg to home, outside the plan
    EndsLoitering,     ///< the mission ends in an endless loiter
    LoiterAsTime,      ///< tool: its loiters have a duration instead of turns
    NoLoiterTurns,     ///< a VTOL or multirotor flies over the icebergs without circles
    AcceptanceIgnored, ///< tool: it uses an acceptance radius of its own
    FenceOff,          ///< tool: it keeps a fence only with a parameter
    HomeRowForOther,   ///< tool: it has no home in row 0
    // Findings of `missionChecks`
    ClimbTooShort, ///< value: length of the climb in m, limit: distance of the first iceberg in m
    FirstLegFar,   ///< tool; value: distance of the first iceberg in m, limit: accepted one
    EndsCross,     ///< value: number of legs of take-off, return and landing that cross the
                   ///< fence or a no-fly area
    ApproachOverLand, ///< the landing approach is not over water
    ApproachSteep,    ///< value: slope of the landing in degrees, limit: usual one
    WaypointsClose,   ///< value: number of waypoints within their acceptance radius of another
    TooManyItems,     ///< tool; value: number of items, limit: number that it holds
    AirspaceOnTheWay, ///< value: number of airspace areas entered at the altitudes flown
    EnduranceShort,   ///< value: time of the mission in s, limit: endurance without reserve in s
    LineTimesLeft,    ///< lines have no times of their points
    ShapefileNames,   ///< names of properties are cut to ten letters, texts to 254 bytes
    DrawingOnly,      ///< value: EPSG code of the coordinates; there are no names or properties
    OptionNotUsed     ///< tool: the given option, on which nothing in the file depends
};

/** Effect of an export on requested content. */
enum class ExportEffect
{
    Check,   ///< the mission may not fly as planned
    Note,    ///< nothing is lost
    Changed, ///< changed by the tool or the format
    LeftOut
};

struct ExportNote
{
    ExportNoteKind kind = ExportNoteKind::NoTimes;
    std::string_view id;   ///< id of the kind for translations and scripts, e.g. "acceptance-cut"
    std::string_view tool; ///< tool that causes the change; empty if the format does
    double value = 0;
    double limit = 0;
    bool operator==(const ExportNote&) const = default;
};

/** Returns a note with the id of its kind. */
[[nodiscard]] ExportNote exportNote(ExportNoteKind kind, std::string_view tool = {},
                                    double value = 0, double limit = 0);

/**
 * Returns the notes about an export, each kind at most once (except one for each unused option)
 * with the worst case of the UAVs.
 */
[[nodiscard]] std::vector<ExportNote> exportNotes(const ExportFormat& format,
                                                  const ExportContent& content);

/**
 * Returns the number of straight legs that lead out of the geofence or through a no-fly area, which
 * a flight would avoid; 0 for a path, which avoids them already.
 */
[[nodiscard]] std::size_t legsThatCross(const ExportContent& content);

/** Returns the effect that a note reports. */
[[nodiscard]] ExportEffect effectOf(ExportNoteKind kind);
/** Returns an English sentence with %1, %2, ... for the arguments. */
[[nodiscard]] std::string_view notePattern(ExportNoteKind kind);
/** Returns the arguments of the note's sentence. */
[[nodiscard]] std::vector<IssueArgument> noteArguments(const ExportNote& note);

} // namespace berg
