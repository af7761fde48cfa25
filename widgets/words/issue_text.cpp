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

constexpr const char* kHeightField = "uavs.altitude_m";

/** How the user is told. */
struct SentenceRow
{
    IssueId id = {};
    const char* text =
        nullptr;      ///< %1 stands for the field, %2, %3, ... for the arguments of the reason
    int distance = 0; ///< which of them is a distance, told in the user's unit; 0: none
    int clock = 0;    ///< which of them is a time, told as mm:ss or h:mm:ss; 0: none
    int height = 0;   ///< likewise a height, whatever the field is
};

struct IssueText
{
    Q_DECLARE_TR_FUNCTIONS(IssueText)

public:
    using enum IssueId;
    static constexpr std::array<SentenceRow, kScenarioIssueIds> kSentences{{
        {NotUtf8, QT_TR_NOOP("%1 must be UTF-8 text.")},
        {NotFinite, QT_TR_NOOP("%1 must be a finite number.")},
        {NotFinitePair, QT_TR_NOOP("The wind must be two finite numbers.")},
        {OutOfRange, QT_TR_NOOP("%1 must be from %2 to %3, not %4.")},
        {OutOfOpenRange, QT_TR_NOOP("%1 must be above %2 and at most %3, not %4.")},
        {NotUtcTime,
         QT_TR_NOOP("The start must be a UTC date and time such as 2024-05-01T06:00:00Z.")},
        {AreaCorners, QT_TR_NOOP("The area must have from 3 to %2 corners, not %3.")},
        {AreaNotSimple, QT_TR_NOOP("The area must neither touch nor cross itself.")},
        {NoFlyCount, QT_TR_NOOP("A scenario holds at most %2 no-fly areas, not %3.")},
        {AirspaceCount, QT_TR_NOOP("A scenario holds at most %2 airspace areas, not %3.")},
        {IdEmpty, QT_TR_NOOP("The id must not be empty.")},
        {IdTaken, QT_TR_NOOP("The id \"%2\" is taken already.")},
        {UavCount, QT_TR_NOOP("A scenario holds from 1 to %2 UAVs, not %3.")},
        {IcebergCount, QT_TR_NOOP("A scenario holds at most %2 icebergs, not %3.")},
        {TrackPoints, QT_TR_NOOP("The recorded track must have from 2 to %2 points, not %3.")},
        {TrackPlaces, QT_TR_NOOP("The recorded track has %2 times, but %3 places.")},
        {TrackNotRising, QT_TR_NOOP("The times of the recorded track must rise.")},
        {MoreFaults, QT_TR_NOOP("There are %2 more errors.")},
        {StepTooLong, QT_TR_NOOP("The time step must not be longer than the run.")},
        {AutopilotTooSlow, QT_TR_NOOP("With a limited endurance, the time between two commands of "
                                      "the autopilot must be at most %2, not %3.")},
        {FenceNoArea, QT_TR_NOOP("A geofence needs an area.")},
        {FenceCorners, QT_TR_NOOP("A geofence has at most %2 corners, not %3.")},
        {OutsideFence, QT_TR_NOOP("Must be inside the area, which is a geofence.")},
        {NoFlyCorners, QT_TR_NOOP("With the geofence and the stand-off ring, the no-fly areas at "
                                  "the altitude of a UAV have at most %2 corners, not %3.")},
        {InsideNoFly, QT_TR_NOOP("Must be outside the no-fly area \"%2\".")},
        {InsideStandoff, QT_TR_NOOP("Must be outside the stand-off ring round the asset.")},
        {UnknownUav, QT_TR_NOOP("There is no UAV \"%2\" in this scenario.")},
        {WindTooFast, QT_TR_NOOP("The wind must be slower than the UAV flies.")},
        {StrongWind, QT_TR_NOOP("The UAV will make little way against this wind.")},
        {DriftTooFast, QT_TR_NOOP("Drifts so fast that the UAV may not catch up with it.")},
        {SensorIntervalTooShort,
         QT_TR_NOOP("The sensor interval must not be shorter than the time step.")},
        {CeilingTooLow, QT_TR_NOOP("The ceiling must be above the floor.")},
        {AirspaceTimes, QT_TR_NOOP("The airspace \"%3\" ends before it begins.")},
        {NothingToFly,
         QT_TR_NOOP("The endurance must be longer than reserve, climb and landing together.")},
        {NoIcebergs, QT_TR_NOOP("There are no icebergs yet, so there is nothing to plan.")},
        {AppearsTooLate, QT_TR_NOOP("Appears after the end of the run, so it is never planned.")},
        {UnknownMembers, QT_TR_NOOP("The file holds members that this version does not know, "
                                    "\"%2\" to begin with. They are kept, but not used.")},
        {AreaNoFence,
         QT_TR_NOOP("Icebergs outside the area are not monitored; the UAV may fly beyond it.")},
        {VelocitySdUnused,
         QT_TR_NOOP("In flight, the velocity's deviation counts with the Kalman filter only.")},
        {SeenLongAgo, QT_TR_NOOP("Seen %2 h ago: may be %3 away (%4 × the field of view)."), 3},
        {OutOfViewNext, QT_TR_NOOP("With these drifts and a round of %2 minutes, %3 of %4 icebergs "
                                   "will be out of view at the next visit.")},
        {SameLayer,
         QT_TR_NOOP("Starts too near another UAV of the same altitude layer: they fly "
                    "apart first. Let their altitudes differ by %2."),
         0, 0, 2},
        {NoPathHome, QT_TR_NOOP("The endurance is too short for the path home from the start.")},
        {NoRoundTrip,
         QT_TR_NOOP("The endurance is too short for the path to the nearest iceberg and back.")},
        {HomeUnused, QT_TR_NOOP("Without a limited endurance, home is used only when you order a "
                                "return or export with the return home.")},
        {HomeNearFence, QT_TR_NOOP("Home is so near the geofence or a no-fly area that the UAV "
                                   "cannot take off there again and be sure to come home.")},
        {NoSafeReturn,
         QT_TR_NOOP("For its heading, the UAV has no path home inside the geofence and outside "
                    "no-fly areas from where it starts: no start is safe.")},
        {StartNearFence, QT_TR_NOOP("The UAV starts so near the geofence or a no-fly area, for its "
                                    "heading, that it cannot turn in time.")},
        {ShutOff, QT_TR_NOOP("So near the geofence, or in a no-fly area, that the UAV cannot come "
                             "as near as it has to.")},
        {SlowAutopilot, QT_TR_NOOP("The time between two commands of the autopilot is too long for "
                                   "the UAV to follow a leg.")},
        {WindLimit, QT_TR_NOOP("The wind is above the limit of this UAV: %2, limit %3.")},
        {GustLimit, QT_TR_NOOP("The gusts are above the limit of this UAV: %2, limit %3.")},
        {Icing, QT_TR_NOOP("Icing conditions at its altitude: not for this UAV.")},
        {CrowdedReturn,
         QT_TR_NOOP(
             "On the way home this UAV may have to wait %2 for others of its altitude layer, "
             "longer than its reserve. Separate altitudes, or a greater reserve, avoid it."),
         0, 2},
        {RecoverySlot,
         QT_TR_NOOP(
             "Other UAVs of this altitude layer land on the same pad, so this UAV is planned "
             "home %2 early, in a recovery slot of its own. Separate altitudes or pads "
             "avoid it."),
         0, 2},
        {ThinReserve,
         QT_TR_NOOP("With the usual errors in wind and airspeed, 1 flight in 20 uses %2 or more of "
                    "the reserve to come home."),
         0, 2},
        {MayNotReturn, QT_TR_NOOP("With the usual errors in wind and airspeed, in 1 flight in 20 "
                                  "the wind is too strong to come home.")},
        {NoContact, QT_TR_NOOP("The plan leads out of the range of the ground station for %2."), 0,
         2},
        {DarkTakeOff, QT_TR_NOOP("Takes off in the dark, at %2 UTC: civil twilight begins at "
                                 "%3 UTC.")},
        {DarkLanding, QT_TR_NOOP("Lands in the dark, at %2 UTC: civil twilight ends at %3 UTC.")},
        {AirspaceEntered,
         QT_TR_NOOP("The operation may enter the airspace \"%2\", which begins at %3."), 0, 0, 3},
        {FenceUnplanned,
         QT_TR_NOOP(
             "This policy plans without geofence and no-fly areas; they are kept in flight.")},
        {UavOutside, QT_TR_NOOP("Starts outside the area.")},
        {WideTurn, QT_TR_NOOP("The turn radius is larger than half the field of view, so that an "
                              "iceberg may be missed.")},
        {ReachInsideTurn, QT_TR_NOOP("The radius that counts as reached is smaller than the turn "
                                     "radius, so that the UAV flies on and comes back.")},
        {ReachBeyondView, QT_TR_NOOP("The acceptance radius is larger than half the field of view, "
                                     "so that icebergs count as reached that are not seen.")},
        {OutsideArea, QT_TR_NOOP("Lies outside the area.")},
        {LeavesArea, QT_TR_NOOP("Drifts out of the area before the end of the run.")},
        {SamePlace, QT_TR_NOOP("Lies where another iceberg lies. Is it the same one?")},
        {OutOfReach,
         QT_TR_NOOP("So far away that the UAV cannot get there before the end of the run.")},
        {TooShort, QT_TR_NOOP("The run is over before the UAV can get to the first iceberg.")},
        {Fast, QT_TR_NOOP("Drifts faster than icebergs do. Is the unit right?")},
        {TrackShort,
         QT_TR_NOOP("Its recorded track ends before the run does; from then on it stands still.")},
        {TrackFar, QT_TR_NOOP("Its recorded track begins so far from the estimate that the UAV "
                              "will not see it there.")},
        {AssetInIce, QT_TR_NOOP("The asset lies inside an iceberg.")},
        {NoSigma,
         QT_TR_NOOP(
             "No iceberg is uncertain at the start, so distance alone makes the first plan.")},
        {BeyondProof,
         QT_TR_NOOP("More icebergs than can be proven optimal; the plan comes with a bound.")},
        {ClustersIgnored,
         QT_TR_NOOP("This policy plans icebergs one by one; nearby icebergs are not grouped.")},
        {SolverUnable, QT_TR_NOOP("This solver cannot plan so many icebergs. Choose Automatic.")},
        {LongProof,
         QT_TR_NOOP("Proving the optimum of so many icebergs can take a minute and more.")},
    }};
};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < IssueText::kSentences.size(); ++i)
        if (static_cast<std::size_t>(IssueText::kSentences[i].id) != i)
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
    if (id >= IssueText::kSentences.size()) {
        for (const IssueArgument& argument : issue.reason.arguments)
            texts << argumentText(issue, argument, locale);
        const bool hasDetail =
            !texts.empty() && englishWords(issue.reason.id).find('%') == std::string_view::npos;
        return filledIn(issueWords(issue.reason.id), texts) +
               (hasDetail ? u": \"%1\""_s.arg(texts[0]) : QString());
    }
    const SentenceRow& sentence = IssueText::kSentences.at(id);
    texts << fieldName(issue.field);
    for (const IssueArgument& argument : issue.reason.arguments) {
        const auto number = static_cast<int>(texts.size()) + 1;
        const auto* const metres = std::get_if<std::int64_t>(&argument);
        const auto* const time_s = std::get_if<double>(&argument);
        texts << (metres != nullptr && number == sentence.distance
                      ? distanceText(static_cast<double>(*metres), locale, 2)
                  : time_s != nullptr && number == sentence.clock ? clockText(*time_s)
                  : number == sentence.height ? fieldValue(kHeightField, argument, locale)
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
    QString place = QString::fromStdString(issue.field);
    for (const auto& [start, text] :
         {std::pair("line ", QT_TRANSLATE_NOOP("IssueText", "line %1")),
          std::pair("feature ", QT_TRANSLATE_NOOP("IssueText", "feature %1")),
          std::pair("packet ", QT_TRANSLATE_NOOP("IssueText", "packet %1"))})
        if (issue.field.starts_with(start)) {
            place = IssueText::tr(text).arg(place.section(u' ', 1));
            break;
        }
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
