#include "widgets/panels/inspector/issue_text.h"

#include "core/scenario/advice.h"

#include <QCoreApplication>
#include <QStringList>

#include <charconv>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IssueText
{
    Q_DECLARE_TR_FUNCTIONS(IssueText)
};

/** "icebergs[3].q_m2ps" is "icebergs.q_m2ps". */
std::string withoutIndices(const std::string& field)
{
    std::string name;
    bool inside = false;
    for (const char c : field) {
        inside = inside || c == '[';
        if (!inside)
            name += c;
        inside = inside && c != ']';
    }
    return name;
}

/** What the core advises and how the user is told. */
struct AdviceText
{
    std::string_view message;
    const char* text;
};

constexpr AdviceText kAdviceTexts[] = {
    {advised::kUnknownMembers,
     QT_TRANSLATE_NOOP("IssueText", "The file holds members that this version does not know. They "
                                    "are kept, but not used.")},
    {advised::kAreaNoFence,
     QT_TRANSLATE_NOOP("IssueText",
                       "Icebergs outside the area are not monitored; the UAV may fly beyond "
                       "it.")},
    {advised::kVelocitySdUnused,
     QT_TRANSLATE_NOOP("IssueText",
                       "The velocity's deviation counts with the Kalman filter only.")},
    {advised::kSameLayer,
     QT_TRANSLATE_NOOP("IssueText", "Starts near another UAV in the same altitude layer: let their "
                                    "altitudes differ by 30 m.")},
    {advised::kNoWayHome,
     QT_TRANSLATE_NOOP("IssueText", "The endurance is too short for the way home from the start.")},
    {advised::kHomeUnused,
     QT_TRANSLATE_NOOP("IssueText", "Home counts with a limited endurance only.")},
    {advised::kHomeNearFence,
     QT_TRANSLATE_NOOP("IssueText", "Home is so near the geofence that the UAV cannot take off "
                                    "there again and be sure to come home.")},
    {advised::kNoSafeReturn,
     QT_TRANSLATE_NOOP("IssueText", "For its heading, the UAV has no path home inside the geofence "
                                    "from where it starts: no start is safe.")},
    {advised::kSlowAutopilot,
     QT_TRANSLATE_NOOP("IssueText", "The time between two commands of the autopilot is too long "
                                    "for the UAV to follow a leg.")},
    {advised::kStartNearFence,
     QT_TRANSLATE_NOOP("IssueText", "The UAV starts so near the geofence, for its heading, that it "
                                    "cannot turn inside it.")},
    {advised::kShutOff,
     QT_TRANSLATE_NOOP("IssueText", "So near the geofence that the UAV cannot come as near as it "
                                    "has to.")},
    {advised::kFenceNoArea, QT_TRANSLATE_NOOP("IssueText", "A geofence needs an area.")},
    {advised::kOutsideFence,
     QT_TRANSLATE_NOOP("IssueText", "Must be inside the area, which is a geofence.")},
    {advised::kFenceUnplanned,
     QT_TRANSLATE_NOOP("IssueText",
                       "This policy plans without the geofence; it is kept in flight.")},
    {advised::kNoRoundTrip,
     QT_TRANSLATE_NOOP("IssueText", "The endurance is too short for the way to the nearest iceberg "
                                    "and back.")},
    {advised::kUavOutside, QT_TRANSLATE_NOOP("IssueText", "Starts outside the area.")},
    {advised::kWideTurn,
     QT_TRANSLATE_NOOP("IssueText", "The turn radius is larger than half the field of view, so "
                                    "that an iceberg may be missed.")},
    {advised::kClustersIgnored,
     QT_TRANSLATE_NOOP("IssueText", "This policy plans icebergs one by one: several in one field "
                                    "of view are not planned as one point.")},
    {advised::kClustersOneUav,
     QT_TRANSLATE_NOOP("IssueText", "Icebergs are planned as one point for one UAV only; with "
                                    "several each is planned by itself.")},
    {advised::kReachInsideTurn,
     QT_TRANSLATE_NOOP("IssueText", "The radius that counts as reached is smaller than the turn "
                                    "radius, so that the UAV flies on and comes back.")},
    {advised::kOutsideArea, QT_TRANSLATE_NOOP("IssueText", "Lies outside the area.")},
    {advised::kLeavesArea,
     QT_TRANSLATE_NOOP("IssueText", "Drifts out of the area before the end of the run.")},
    {advised::kSamePlace,
     QT_TRANSLATE_NOOP("IssueText", "Lies where another iceberg lies. Is it the same one?")},
    {advised::kOutOfReach,
     QT_TRANSLATE_NOOP("IssueText",
                       "So far away that the UAV cannot get there before the end of the run.")},
    {advised::kTooShort,
     QT_TRANSLATE_NOOP("IssueText",
                       "The run is over before the UAV can get to the first iceberg.")},
    {advised::kFast,
     QT_TRANSLATE_NOOP("IssueText", "Drifts faster than icebergs do. Is the unit right?")},
    {advised::kTrackShort,
     QT_TRANSLATE_NOOP("IssueText", "Its recorded track ends before the run does; from then on it "
                                    "stands still.")},
    {advised::kTrackFar,
     QT_TRANSLATE_NOOP("IssueText", "Its recorded track begins so far from the estimate that the "
                                    "UAV will not see it there.")},
    {advised::kAssetInIce, QT_TRANSLATE_NOOP("IssueText", "The asset lies inside an iceberg.")},
    {advised::kNoSigma,
     QT_TRANSLATE_NOOP("IssueText", "No iceberg is uncertain at the start, so distance alone makes "
                                    "the first plan.")},
    {advised::kBeyondProof,
     QT_TRANSLATE_NOOP("IssueText", "More icebergs than can be proven optimal; the plan comes with "
                                    "a bound.")},
    {advised::kSolverUnable,
     QT_TRANSLATE_NOOP("IssueText", "This solver cannot plan so many icebergs. Choose Automatic.")},
    {advised::kLongProof,
     QT_TRANSLATE_NOOP("IssueText", "Proving the optimum of so many icebergs can take a minute and "
                                    "more.")},
};

QString adviceText(const std::string& message)
{
    for (const AdviceText& advice : kAdviceTexts)
        if (advice.message == message)
            return QCoreApplication::translate("IssueText", advice.text);
    return {};
}

/** Of the findings that do not come from `advice`; those are told by their field. */
QString findingText(const Issue& issue)
{
    const std::string field = withoutIndices(issue.field);
    switch (issue.severity) {
    case Severity::Error:
        if (field == "wind_mps")
            return IssueText::tr("The wind must be slower than the UAV flies.");
        break;
    case Severity::Warning:
        if (field == "icebergs.velocity_mps")
            return IssueText::tr("Drifts so fast that the UAV may not catch up with it.");
        if (field == "wind_mps")
            return IssueText::tr("The UAV will make little way against this wind.");
        if (field == "planner.policy")
            return IssueText::tr("This version cannot fly the policy chosen.");
        break;
    case Severity::Hint:
        if (field == "icebergs")
            return IssueText::tr("There are no icebergs yet, so there is nothing to plan.");
        if (field == "icebergs.appears_s")
            return IssueText::tr("Appears after the end of the run, so it is never planned.");
        break;
    }
    return {};
}

template <class Object>
QString nameOfEntry(const Issue& issue, std::string_view list, const std::vector<Object>& objects)
{
    const int index = issueIndex(issue, list);
    if (index < 0 || index >= static_cast<int>(objects.size()))
        return {};
    const Object& object = objects[static_cast<std::size_t>(index)];
    return QString::fromStdString(object.name.empty() ? object.id : object.name);
}

} // namespace

QString issueText(const Issue& issue)
{
    QString text = adviceText(issue.message);
    if (text.isEmpty())
        text = findingText(issue);
    if (!text.isEmpty())
        return text;
    return u"%1: %2"_s.arg(QString::fromStdString(issue.field),
                           QString::fromStdString(issue.message));
}

QString issueLine(const Issue& issue, const Scenario& scenario)
{
    QString owner = nameOfEntry(issue, "icebergs", scenario.icebergs);
    if (owner.isEmpty())
        owner = nameOfEntry(issue, "uavs", scenario.uavs);
    return owner.isEmpty() ? issueText(issue) : u"%1: %2"_s.arg(owner, issueText(issue));
}

IssueCounts countIssues(const std::vector<Issue>& issues)
{
    IssueCounts counts;
    for (const Issue& issue : issues)
        ++(issue.severity == Severity::Error     ? counts.errors
           : issue.severity == Severity::Warning ? counts.warnings
                                                 : counts.hints);
    return counts;
}

QString countsText(const IssueCounts& counts)
{
    QStringList parts;
    if (counts.errors > 0)
        parts << (counts.errors == 1 ? IssueText::tr("1 error")
                                     : IssueText::tr("%n errors", nullptr, counts.errors));
    if (counts.warnings > 0)
        parts << (counts.warnings == 1 ? IssueText::tr("1 warning")
                                       : IssueText::tr("%n warnings", nullptr, counts.warnings));
    if (parts.isEmpty() && counts.hints > 0)
        parts << (counts.hints == 1 ? IssueText::tr("1 hint")
                                    : IssueText::tr("%n hints", nullptr, counts.hints));
    return parts.join(u", "_s);
}

int issueIndex(const Issue& issue, std::string_view list)
{
    const std::string_view field = issue.field;
    if (!field.starts_with(list) || field.substr(list.size()).substr(0, 1) != "[")
        return -1;
    const std::string_view number = field.substr(list.size() + 1);
    int index = -1;
    std::from_chars(number.data(), number.data() + number.size(), index);
    return index;
}

} // namespace berg
