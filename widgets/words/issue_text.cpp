#include "widgets/words/issue_text.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/field_names.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <cerrno>
#include <charconv>
#include <system_error>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IssueText
{
    Q_DECLARE_TR_FUNCTIONS(IssueText)
};

/** How the user is told. */
struct SentenceRow
{
    IssueId id = {};
    const char* text =
        nullptr;      ///< %1 stands for the field, %2, %3, ... for the arguments of the reason
    int distance = 0; ///< which of them is a distance, told in the user's unit; 0: none
};

constexpr std::array<SentenceRow, kScenarioIssueIds> kSentences{{
    {IssueId::NotUtf8, QT_TRANSLATE_NOOP("IssueText", "%1 must be UTF-8 text.")},
    {IssueId::NotFinite, QT_TRANSLATE_NOOP("IssueText", "%1 must be a finite number.")},
    {IssueId::NotFinitePair,
     QT_TRANSLATE_NOOP("IssueText", "The wind must be two finite numbers.")},
    {IssueId::OutOfRange, QT_TRANSLATE_NOOP("IssueText", "%1 must be from %2 to %3, not %4.")},
    {IssueId::OutOfOpenRange,
     QT_TRANSLATE_NOOP("IssueText", "%1 must be above %2 and at most %3, not %4.")},
    {IssueId::NotUtcTime,
     QT_TRANSLATE_NOOP("IssueText",
                       "The start must be a UTC date and time such as 2024-05-01T06:00:00Z.")},
    {IssueId::AreaCorners,
     QT_TRANSLATE_NOOP("IssueText", "The area must have from 3 to %2 corners, not %3.")},
    {IssueId::AreaNotSimple,
     QT_TRANSLATE_NOOP("IssueText", "The area must neither touch nor cross itself.")},
    {IssueId::NoFlyCount,
     QT_TRANSLATE_NOOP("IssueText", "A scenario holds at most %2 no-fly areas, not %3.")},
    {IssueId::AirspaceCount,
     QT_TRANSLATE_NOOP("IssueText", "A scenario holds at most %2 airspace areas, not %3.")},
    {IssueId::IdEmpty, QT_TRANSLATE_NOOP("IssueText", "The id must not be empty.")},
    {IssueId::IdTaken, QT_TRANSLATE_NOOP("IssueText", "The id \"%2\" is taken already.")},
    {IssueId::UavCount,
     QT_TRANSLATE_NOOP("IssueText", "A scenario holds from 1 to %2 UAVs, not %3.")},
    {IssueId::IcebergCount,
     QT_TRANSLATE_NOOP("IssueText", "A scenario holds at most %2 icebergs, not %3.")},
    {IssueId::TrackPoints,
     QT_TRANSLATE_NOOP("IssueText", "The recorded track must have from 2 to %2 points, not %3.")},
    {IssueId::TrackPlaces,
     QT_TRANSLATE_NOOP("IssueText", "The recorded track has %2 times, but %3 places.")},
    {IssueId::TrackNotRising,
     QT_TRANSLATE_NOOP("IssueText", "The times of the recorded track must rise.")},
    {IssueId::MoreFaults, QT_TRANSLATE_NOOP("IssueText", "There are %2 more errors.")},
    {IssueId::StepTooLong,
     QT_TRANSLATE_NOOP("IssueText", "The time step must not be longer than the run.")},
    {IssueId::AutopilotTooSlow,
     QT_TRANSLATE_NOOP("IssueText", "With a limited endurance, the time between two commands of "
                                    "the autopilot must be at most %2, not %3.")},
    {IssueId::FenceNoArea, QT_TRANSLATE_NOOP("IssueText", "A geofence needs an area.")},
    {IssueId::FenceCorners,
     QT_TRANSLATE_NOOP("IssueText", "A geofence has at most %2 corners, not %3.")},
    {IssueId::OutsideFence,
     QT_TRANSLATE_NOOP("IssueText", "Must be inside the area, which is a geofence.")},
    {IssueId::NoFlyCorners,
     QT_TRANSLATE_NOOP("IssueText", "With the geofence and the stand-off ring, the no-fly areas at "
                                    "the altitude of a UAV have at most %2 corners, not %3.")},
    {IssueId::InsideNoFly,
     QT_TRANSLATE_NOOP("IssueText", "Must be outside the no-fly area \"%2\".")},
    {IssueId::InsideStandoff,
     QT_TRANSLATE_NOOP("IssueText", "Must be outside the stand-off ring round the asset.")},
    {IssueId::UnknownUav,
     QT_TRANSLATE_NOOP("IssueText", "There is no UAV \"%2\" in this scenario.")},
    {IssueId::WindTooFast,
     QT_TRANSLATE_NOOP("IssueText", "The wind must be slower than the UAV flies.")},
    {IssueId::StrongWind,
     QT_TRANSLATE_NOOP("IssueText", "The UAV will make little way against this wind.")},
    {IssueId::DriftTooFast,
     QT_TRANSLATE_NOOP("IssueText", "Drifts so fast that the UAV may not catch up with it.")},
    {IssueId::SensorIntervalTooShort,
     QT_TRANSLATE_NOOP("IssueText", "The sensor interval must not be shorter than the time step.")},
    {IssueId::CeilingTooLow,
     QT_TRANSLATE_NOOP("IssueText", "The ceiling must be above the floor.")},
    {IssueId::NothingToFly,
     QT_TRANSLATE_NOOP("IssueText",
                       "The endurance must be longer than reserve, climb and landing together.")},
    {IssueId::NoIcebergs,
     QT_TRANSLATE_NOOP("IssueText", "There are no icebergs yet, so there is nothing to plan.")},
    {IssueId::AppearsTooLate,
     QT_TRANSLATE_NOOP("IssueText", "Appears after the end of the run, so it is never planned.")},
    {IssueId::UnknownMembers,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "The file holds members that this version does not know, \"%2\" to begin with. They are "
         "kept, but not used.")},
    {IssueId::AreaNoFence,
     QT_TRANSLATE_NOOP("IssueText",
                       "Icebergs outside the area are not monitored; the UAV may fly beyond it.")},
    {IssueId::VelocitySdUnused,
     QT_TRANSLATE_NOOP("IssueText",
                       "In flight, the velocity's deviation counts with the Kalman filter only.")},
    {IssueId::SeenLongAgo,
     QT_TRANSLATE_NOOP("IssueText", "Seen %2 h ago: may be %3 away (%4 × the field of view)."), 3},
    {IssueId::OutOfViewNext,
     QT_TRANSLATE_NOOP("IssueText", "With these drifts and a round of %2 minutes, %3 of %4 "
                                    "icebergs will be out of view at the next visit.")},
    {IssueId::SameLayer,
     QT_TRANSLATE_NOOP("IssueText", "Starts too near another UAV of the same altitude layer: they "
                                    "fly apart first. Let their altitudes differ by 30 m.")},
    {IssueId::NoPathHome,
     QT_TRANSLATE_NOOP("IssueText",
                       "The endurance is too short for the path home from the start.")},
    {IssueId::NoRoundTrip,
     QT_TRANSLATE_NOOP("IssueText",
                       "The endurance is too short for the path to the nearest iceberg and back.")},
    {IssueId::HomeUnused,
     QT_TRANSLATE_NOOP("IssueText", "Without a limited endurance, home is used only when you order "
                                    "a return or export with the return home.")},
    {IssueId::HomeNearFence,
     QT_TRANSLATE_NOOP("IssueText", "Home is so near the geofence or a no-fly area that the UAV "
                                    "cannot take off there again and be sure to come home.")},
    {IssueId::NoSafeReturn,
     QT_TRANSLATE_NOOP("IssueText", "For its heading, the UAV has no path home inside the geofence "
                                    "and outside no-fly areas from where it starts: no start is "
                                    "safe.")},
    {IssueId::StartNearFence,
     QT_TRANSLATE_NOOP("IssueText", "The UAV starts so near the geofence or a no-fly area, for its "
                                    "heading, that it cannot turn in time.")},
    {IssueId::ShutOff,
     QT_TRANSLATE_NOOP(
         "IssueText", "So near the geofence, or in a no-fly area, that the UAV cannot come as near "
                      "as it has to.")},
    {IssueId::SlowAutopilot,
     QT_TRANSLATE_NOOP("IssueText", "The time between two commands of the autopilot is too long "
                                    "for the UAV to follow a leg.")},
    {IssueId::WindLimit,
     QT_TRANSLATE_NOOP("IssueText", "The wind is above the limit of this UAV: %2, limit %3.")},
    {IssueId::GustLimit,
     QT_TRANSLATE_NOOP("IssueText", "The gusts are above the limit of this UAV: %2, limit %3.")},
    {IssueId::Icing,
     QT_TRANSLATE_NOOP("IssueText", "Icing conditions at its altitude: not for this UAV.")},
    {IssueId::CrowdedReturn,
     QT_TRANSLATE_NOOP("IssueText",
                       "On the way home this UAV may have to wait %2 for others of its "
                       "altitude layer, longer than its reserve. Separate altitudes, "
                       "or a greater reserve, avoid it.")},
    {IssueId::ThinReserve,
     QT_TRANSLATE_NOOP("IssueText",
                       "With wind and airspeed off their values, one flight in twenty uses %2 or "
                       "more of the reserve to come home.")},
    {IssueId::MayNotReturn,
     QT_TRANSLATE_NOOP("IssueText",
                       "With wind and airspeed off their values, in one flight in twenty the wind "
                       "is too strong to come home.")},
    {IssueId::NoContact,
     QT_TRANSLATE_NOOP("IssueText",
                       "The plan leads out of the range of the ground station for %2.")},
    {IssueId::AirspaceEntered,
     QT_TRANSLATE_NOOP("IssueText",
                       "The operation may enter the airspace \"%2\", which begins at %3.")},
    {IssueId::FenceUnplanned,
     QT_TRANSLATE_NOOP("IssueText",
                       "This policy plans without geofence and no-fly areas; they are kept in "
                       "flight.")},
    {IssueId::UavOutside, QT_TRANSLATE_NOOP("IssueText", "Starts outside the area.")},
    {IssueId::WideTurn,
     QT_TRANSLATE_NOOP("IssueText", "The turn radius is larger than half the field of view, so "
                                    "that an iceberg may be missed.")},
    {IssueId::ReachInsideTurn,
     QT_TRANSLATE_NOOP("IssueText", "The radius that counts as reached is smaller than the turn "
                                    "radius, so that the UAV flies on and comes back.")},
    {IssueId::ReachBeyondView,
     QT_TRANSLATE_NOOP("IssueText", "The acceptance radius is larger than half the field of view, "
                                    "so that icebergs count as reached that are not seen.")},
    {IssueId::OutsideArea, QT_TRANSLATE_NOOP("IssueText", "Lies outside the area.")},
    {IssueId::LeavesArea,
     QT_TRANSLATE_NOOP("IssueText", "Drifts out of the area before the end of the run.")},
    {IssueId::SamePlace,
     QT_TRANSLATE_NOOP("IssueText", "Lies where another iceberg lies. Is it the same one?")},
    {IssueId::OutOfReach,
     QT_TRANSLATE_NOOP("IssueText",
                       "So far away that the UAV cannot get there before the end of the run.")},
    {IssueId::TooShort,
     QT_TRANSLATE_NOOP("IssueText",
                       "The run is over before the UAV can get to the first iceberg.")},
    {IssueId::Fast,
     QT_TRANSLATE_NOOP("IssueText", "Drifts faster than icebergs do. Is the unit right?")},
    {IssueId::TrackShort,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "Its recorded track ends before the run does; from then on it stands still.")},
    {IssueId::TrackFar,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "Its recorded track begins so far from the estimate that the UAV will not see it there.")},
    {IssueId::AssetInIce, QT_TRANSLATE_NOOP("IssueText", "The asset lies inside an iceberg.")},
    {IssueId::NoSigma,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "No iceberg is uncertain at the start, so distance alone makes the first plan.")},
    {IssueId::BeyondProof,
     QT_TRANSLATE_NOOP("IssueText",
                       "More icebergs than can be proven optimal; the plan comes with a bound.")},
    {IssueId::ClustersIgnored,
     QT_TRANSLATE_NOOP("IssueText", "This policy plans icebergs one by one; nearby icebergs are "
                                    "not grouped.")},
    {IssueId::SolverUnable,
     QT_TRANSLATE_NOOP("IssueText", "This solver cannot plan so many icebergs. Choose Automatic.")},
    {IssueId::LongProof,
     QT_TRANSLATE_NOOP("IssueText",
                       "Proving the optimum of so many icebergs can take a minute and more.")},
}};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < kSentences.size(); ++i)
        if (static_cast<std::size_t>(kSentences[i].id) != i)
            return false;
    return true;
}
static_assert(isInOrder(), "a row for each id, in their order");

// The words of the other ids, for lupdate.
#define ISSUE(id, words)
#include "core/base/reading_issues.inc"
#undef ISSUE

QString kindText(ValueKind kind)
{
    switch (kind) {
    case ValueKind::Null:
        return u"null"_s;
    case ValueKind::Object:
        return IssueText::tr("an object");
    case ValueKind::Array:
        return IssueText::tr("an array");
    case ValueKind::String:
        return IssueText::tr("a string");
    case ValueKind::True:
        return u"true"_s;
    case ValueKind::False:
        return u"false"_s;
    case ValueKind::Number:
        return IssueText::tr("a number");
    case ValueKind::Boolean:
        return IssueText::tr("true or false");
    case ValueKind::TwoNumbers:
        return IssueText::tr("two numbers");
    case ValueKind::Pairs:
        return IssueText::tr("pairs of numbers");
    }
    return {};
}

constexpr std::pair<int, const char*> kRefusals[] = {
#define REFUSAL(number, words) {number, words},
#include "core/base/refusals.inc"
#undef REFUSAL
};

bool isRefusal(IssueId id)
{
    return id == IssueId::CannotOpen || id == IssueId::CannotRead || id == IssueId::CannotWrite;
}

QString argumentText(const Issue& issue, const IssueArgument& argument, const QLocale& locale)
{
    if (const auto* const words = std::get_if<std::string>(&argument);
        words != nullptr && isRefusal(issue.reason.id))
        for (const auto& [number, text] : kRefusals)
            if (*words == std::generic_category().message(number))
                return QCoreApplication::translate("IssueText", text);
    if (const auto* const kind = std::get_if<ValueKind>(&argument))
        return kindText(*kind);
    return fieldValue(issue.field, argument, locale);
}

/** With `%1`, `%2`, ... in place of them; what the texts themselves hold stays as it is. */
QString filledIn(const QString& sentence, const QStringList& texts)
{
    QString filled;
    for (qsizetype i = 0; i < sentence.size(); ++i)
        if (sentence[i] == u'%' && i + 1 < sentence.size() && sentence[i + 1].isDigit())
            filled += texts.value(sentence[++i].digitValue() - 1);
        else
            filled += sentence[i];
    return filled;
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

QString issueText(const Issue& issue, const QLocale& locale)
{
    const auto id = static_cast<std::size_t>(issue.reason.id);
    QStringList texts;
    if (id >= kSentences.size()) {
        for (const IssueArgument& argument : issue.reason.arguments)
            texts << argumentText(issue, argument, locale);
        const bool hasDetail =
            !texts.empty() && englishWords(issue.reason.id).find('%') == std::string_view::npos;
        return filledIn(issueWords(issue.reason.id), texts) +
               (hasDetail ? u": \"%1\""_s.arg(texts[0]) : QString());
    }
    const SentenceRow& sentence = kSentences.at(id);
    texts << fieldName(issue.field);
    for (const IssueArgument& argument : issue.reason.arguments) {
        const auto* const metres = std::get_if<std::int64_t>(&argument);
        texts << (metres != nullptr && texts.size() + 1 == sentence.distance
                      ? distanceText(static_cast<double>(*metres), locale, 2)
                      : argumentText(issue, argument, locale));
    }
    return filledIn(QCoreApplication::translate("IssueText", sentence.text), texts);
}

QString issueWords(IssueId id)
{
    return QCoreApplication::translate("IssueText", englishWords(id).data());
}

QString placedIssueText(const Issue& issue)
{
    constexpr std::string_view kLine = "line ";
    QString place = QString::fromStdString(issue.field);
    if (issue.field.starts_with(kLine))
        place = IssueText::tr("line %1").arg(place.sliced(kLine.size()));
    const QString text = issueText(issue);
    return place.isEmpty() || text.startsWith(place) ? text : u"%1: %2"_s.arg(place, text);
}

QStringList issueLines(const Error& error)
{
    QStringList lines;
    for (const Issue& issue : error.issues())
        lines << placedIssueText(issue);
    return lines;
}

QStringList optionIssueLines(const Error& error, const std::string& dialog)
{
    QStringList lines;
    for (Issue issue : error.issues()) {
        issue.field = dialog + '.' + (error.subject() == dialog ? issue.field : error.subject());
        const QString option = fieldName(issue.field);
        if (option == QString::fromStdString(issue.field))
            return {};
        for (IssueArgument& argument : issue.reason.arguments)
            if (auto* const other = std::get_if<std::string>(&argument))
                if (const QString name = fieldName(dialog + '.' + *other);
                    !name.startsWith(QString::fromStdString(dialog + '.')))
                    *other = '"' + name.toStdString() + '"';
        const QString text = issueText(issue);
        lines << (text.startsWith(option) ? text : u"%1: %2"_s.arg(option, text));
    }
    return lines;
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
        parts << IssueText::tr("%n errors", nullptr, counts.errors);
    if (counts.warnings > 0)
        parts << IssueText::tr("%n warnings", nullptr, counts.warnings);
    if (parts.isEmpty() && counts.hints > 0)
        parts << IssueText::tr("%n hints", nullptr, counts.hints);
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
