#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
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
    // One field by itself.
    NotUtf8,
    NotFinite,
    NotFinitePair,
    OutOfRange,     ///< lowest, highest, value
    OutOfOpenRange, ///< what it must be above, highest, value
    NotUtcTime,
    AreaCorners, ///< most, count
    AreaNotSimple,
    NoFlyCount,    ///< most, count
    AirspaceCount, ///< the same
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
    AirspaceTimes, ///< the field that it is before, kind and name of the airspace
    NothingToFly,  ///< endurance, what of it is not for flying at altitude

    // Advice.
    NoIcebergs,
    AppearsTooLate,
    UnknownMembers, ///< the first one's name
    AreaNoFence,
    VelocitySdUnused,
    SeenLongAgo,   ///< hours, standard deviation in metres, in fields of view
    OutOfViewNext, ///< minutes of a round, icebergs out of view, of so many
    SameLayer,     ///< least difference of altitudes, metres
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
    RecoverySlot,  ///< seconds of the endurance that are withheld for it
    ThinReserve,   ///< seconds of the reserve that are used
    MayNotReturn,
    NoContact,       ///< seconds
    DarkTakeOff,     ///< its time, when civil twilight begins: "06:40", or with another date before
    DarkLanding,     ///< its time, when civil twilight ended, likewise
    AirspaceEntered, ///< its kind and name, floor in metres
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
    LongProof,

// Readers, writers and solvers: their words are in the file.
#define ISSUE(id, words) id,
#include "core/base/reading_issues.inc"
#undef ISSUE
};
/** Of scenarios: the window has a sentence of its own for each. */
inline constexpr int kScenarioIssueIds = static_cast<int>(IssueId::LongProof) + 1;
inline constexpr int kIssueIds = static_cast<int>(IssueId::PolicyNotFlown) + 1;

/** What a value of a file is, or must be. */
enum class ValueKind
{
    Null,
    Object,
    Array,
    String,
    True,
    False,
    Number,
    Boolean,    ///< true or false
    TwoNumbers, ///< an array of them
    Pairs       ///< an array of an even count of numbers
};

/** In SI, as in the file. */
using IssueArgument = std::variant<double, std::int64_t, std::string, ValueKind>;

[[nodiscard]] inline IssueArgument countOf(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

struct IssueReason
{
    IssueId id = IssueId::Verbatim;
    std::vector<IssueArgument> arguments = {};
    bool operator==(const IssueReason&) const = default;
};

/**
 * The words of an id in English, with %1, %2, ... for its arguments. Without such a place, what it
 * has for an argument follows the words in quotes.
 */
[[nodiscard]] std::string_view englishWords(IssueId id);
/** "an array" */
[[nodiscard]] std::string_view englishWords(ValueKind kind);

/** Such words, in whatever language, with the arguments; one that is missing is empty text. */
[[nodiscard]] std::string filledIn(std::string_view pattern,
                                   const std::vector<IssueArgument>& arguments);

/** The reason in English, without field and file: for JSON and for files. */
[[nodiscard]] std::string englishText(const IssueReason& reason);

/** One finding about a scenario or a file. */
struct Issue
{
    Severity severity = Severity::Error;
    /** Path such as `icebergs[3].q_m2ps`, or `line 3` of a table; empty for the whole. */
    std::string field;
    IssueReason reason = {};

    [[nodiscard]] std::string message() const { return englishText(reason); }
    bool operator==(const Issue&) const = default;
};

/** True when at least one finding is an error. */
[[nodiscard]] bool hasErrors(const std::vector<Issue>& issues);

} // namespace berg
