#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace berg {

enum class Severity
{
    Error,
    Warning,
    Hint
};

/** What a finding says. Its arguments, in order, are in the comment. */
enum class IssueId
{
    Free, ///< nothing but `Issue::message` says it

    // One field by itself.
    NotUtf8,
    NotFinite,
    NotFinitePair,
    OutOfRange,     ///< lowest, highest, value
    OutOfOpenRange, ///< what it must be above, highest, value
    NotUtcTime,
    AreaCorners, ///< most, count
    AreaNotSimple,
    NoFlyCount, ///< most, count
    IdEmpty,
    IdTaken,      ///< the id, path of its owner
    UavCount,     ///< most, count
    IcebergCount, ///< most, count
    TrackPoints,  ///< most, count
    TrackPlaces,  ///< count of times, of places
    TrackNotRising,
    MoreFaults, ///< count

    // Fields that do not fit together.
    StepTooLong,
    AutopilotTooSlow, ///< longest, value
    FenceNoArea,
    FenceCorners, ///< most, count
    OutsideFence,
    NoFlyCorners, ///< most, count
    InsideNoFly,  ///< its name or path
    InsideStandoff,
    UnknownUav,  ///< the id
    WindTooFast, ///< wind, id of the UAV, its airspeed
    StrongWind,  ///< the same
    DriftTooFast,
    SensorIntervalTooShort,
    CeilingTooLow, ///< floor, ceiling
    NothingToFly,  ///< endurance, what of it is not for flying at altitude

    // Advice.
    NoIcebergs,
    AppearsTooLate,
    UnknownMembers,
    AreaNoFence,
    VelocitySdUnused,
    SeenLongAgo,   ///< hours, standard deviation in metres, in fields of view
    OutOfViewNext, ///< minutes of a round, icebergs out of view, of so many
    SameLayer,
    NoPathHome,
    NoRoundTrip,
    HomeUnused,
    HomeNearFence,
    NoSafeReturn,
    StartNearFence,
    ShutOff,
    SlowAutopilot,
    WindLimit, ///< wind, limit
    GustLimit, ///< gusts, limit
    Icing,
    CrowdedReturn, ///< seconds that waiting for other UAVs may take
    ThinReserve,   ///< seconds of the reserve that are used
    NoContact,     ///< seconds
    FenceUnplanned,
    UavOutside,
    WideTurn,
    ReachInsideTurn,
    ReachBeyondView,
    OutsideArea,
    LeavesArea,
    SamePlace,
    OutOfReach,
    TooShort,
    Fast,
    TrackShort,
    TrackFar,
    AssetInIce,
    NoSigma,
    BeyondProof,
    ClustersIgnored,
    SolverUnable,
    LongProof ///< the last
};
inline constexpr int kIssueIds = static_cast<int>(IssueId::LongProof) + 1;

/** In SI, as in the file. */
using IssueArgument = std::variant<double, std::int64_t, std::string>;

struct IssueReason
{
    IssueId id = IssueId::Free;
    std::vector<IssueArgument> arguments = {};
    bool operator==(const IssueReason&) const = default;
};

/** The reason in English, without field and file: for the command line and for files. */
[[nodiscard]] std::string englishText(const IssueReason& reason);

/** One finding about a scenario or a file. */
struct Issue
{
    Severity severity = Severity::Error;
    std::string field;       ///< path of the field, e.g. `icebergs[3].q_m2ps`; empty for the whole
    std::string message;     ///< English reason without field and file
    IssueReason reason = {}; ///< what `message` says; the window makes its sentence from it
    bool operator==(const Issue&) const = default;
};

/** The finding, with its message. */
[[nodiscard]] Issue issueOf(Severity severity, std::string field, IssueReason reason);

/** True when at least one finding is an error. */
[[nodiscard]] bool hasErrors(const std::vector<Issue>& issues);

/** Shortest text that reads back as `value`, in the C locale; for messages. */
[[nodiscard]] std::string shortText(double value);

} // namespace berg
