#pragma once

#include "core/base/issue.h"
#include "core/io/export/formats.h"

#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** What a format leaves out, or a tool will change. */
enum class ExportNoteKind
{
    OneFileEach,    ///< value: UAVs, each in a file of its own
    NoTimes,        ///< the scenario has no start time, so there are no dates
    NoFence,        ///< the format has no place for the geofence
    NoNoFly,        ///< nor for no-fly areas and the stand-off ring
    NoHeights,      ///< of no-fly areas: those at the altitude of the UAV, at every height
    FenceAcross180, ///< ground stations may draw a fence across the antimeridian the long way round
    VisitsOnly,     ///< of a track: waypoints where icebergs were reached
    PathAsWaypoints, ///< value: waypoints that stand for the path
    AcceptanceCut,   ///< value m wanted, limit m kept
    LoiterInSteps,   ///< value m needed, limit m kept
    WholeSpeed,      ///< value m/s, limit m/s shown
    ChoiceNotUsed,   ///< what is to be exported does not matter: it is the whole flight
    NothingToFly,    ///< value: UAVs without anything to visit
    LegsCross,       ///< value: straight legs that the fence or a no-fly area is in the way of
    LaterSorties,    ///< value: icebergs of the orders that the endurance leaves for them
    OptionNotUsed    ///< tool: the option that was given, on which nothing in the file depends
};

struct ExportNote
{
    ExportNoteKind kind = ExportNoteKind::NoTimes;
    std::string_view id;   ///< of the kind, for translations and scripts, e.g. "acceptance-cut"
    std::string_view tool; ///< whose doing it is; empty: the format's
    double value = 0;
    double limit = 0;
    bool operator==(const ExportNote&) const = default;
};

/** What the user should know before writing this; each kind at most once (but one for each
 * option), the worst case of the UAVs. */
[[nodiscard]] std::vector<ExportNote> exportNotes(const ExportFormat& format,
                                                  const ExportContent& content);

/** Straight legs that lead out of the geofence or through a no-fly area, where a flight goes round:
 * of the path, which is flown round, none. */
[[nodiscard]] std::size_t legsThatCross(const ExportContent& content);

/** A sentence in English, with %1, %2, ... for the arguments. */
[[nodiscard]] std::string_view notePattern(ExportNoteKind kind);
[[nodiscard]] std::vector<IssueArgument> noteArguments(const ExportNote& note);

} // namespace berg
