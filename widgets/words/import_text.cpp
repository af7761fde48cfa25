#include "widgets/words/import_text.h"

#include "core/plan/solve/names.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QTimeZone>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ImportWords
{
    Q_DECLARE_TR_FUNCTIONS(ImportWords)

public:
    static constexpr Named<ImportNote> kNotes[]{
        {ImportNote::VelocityUnknown, QT_TR_NOOP("velocity unknown")},
        {ImportNote::TimeUnknown, QT_TR_NOOP("no time: counts as seen at the start")},
        {ImportNote::VelocityGiven, QT_TR_NOOP("velocity from the file")},
        {ImportNote::VelocityClamped, QT_TR_NOOP("velocity limited to 5 m/s per axis")},
        {ImportNote::GrowthEstimated, QT_TR_NOOP("q estimated")},
        {ImportNote::GrowthClamped, QT_TR_NOOP("q limited to 10⁶ m²/s")},
        {ImportNote::Stationary, QT_TR_NOOP("stationary")},
        {ImportNote::Repeated, QT_TR_NOOP("several sightings at one time")},
        {ImportNote::Jumped, QT_TR_NOOP("sightings at impossible places not used")},
        {ImportNote::TrackAttached, QT_TR_NOOP("recorded track")},
        {ImportNote::NoTrack, QT_TR_NOOP("no track: not sighted after the start")},
        {ImportNote::Older, QT_TR_NOOP("older than what the scenario has")},
        {ImportNote::SeenLater, QT_TR_NOOP("sighted only after the start")},
        {ImportNote::DriftedAway, QT_TR_NOOP("more than 1000 km from the origin at the start")},
        {ImportNote::TooMany, QT_TR_NOOP("the scenario is full")},
        {ImportNote::IdTaken, QT_TR_NOOP("a UAV has this id")},
    };

    static constexpr Named<ImportOutcome> kOutcomes[]{
        {ImportOutcome::Added, QT_TR_NOOP("new")},
        {ImportOutcome::Updated, QT_TR_NOOP("updated")},
        {ImportOutcome::Unchanged, QT_TR_NOOP("unchanged")},
        {ImportOutcome::LeftOut, QT_TR_NOOP("left out")},
    };

    static constexpr Named<SightingField> kFields[]{
        {SightingField::Id, QT_TR_NOOP("Id")},
        {SightingField::Name, QT_TR_NOOP("Name")},
        {SightingField::Date, QT_TR_NOOP("Date")},
        {SightingField::Time, QT_TR_NOOP("Time")},
        {SightingField::Latitude, QT_TR_NOOP("Latitude")},
        {SightingField::Longitude, QT_TR_NOOP("Longitude")},
        {SightingField::Speed, QT_TR_NOOP("Speed")},
        {SightingField::Direction, QT_TR_NOOP("Direction")},
        {SightingField::Sigma, QT_TR_NOOP("Uncertainty σ")},
        {SightingField::Growth, QT_TR_NOOP("Growth q")},
        {SightingField::Length, QT_TR_NOOP("Length")},
        {SightingField::Radius, QT_TR_NOOP("Radius")},
        {SightingField::Area, QT_TR_NOOP("Area")},
        {SightingField::SizeClass, QT_TR_NOOP("Size class")},
        {SightingField::Remarks, QT_TR_NOOP("Remarks")},
    };

    /** With the reason where it is left out; counts are told with those that begin with one. */
    static constexpr Named<SceneNote> kScene[]{
        {SceneNote::UavsTaken, QT_TR_N_NOOP("%n UAVs")},
        {SceneNote::AreaTaken, QT_TR_NOOP("the area")},
        {SceneNote::FenceTaken, QT_TR_NOOP("the area as geofence")},
        {SceneNote::AssetTaken, QT_TR_NOOP("the asset")},
        {SceneNote::NoFlyTaken, QT_TR_N_NOOP("%n no-fly areas")},
        {SceneNote::InUse, QT_TR_NOOP("UAVs, area and asset (the scenario has its own)")},
        {SceneNote::UavsTooMany, QT_TR_N_NOOP("%n UAVs (too many)")},
        {SceneNote::UavsTooFar, QT_TR_N_NOOP("%n UAVs (more than 1000 km from the origin)")},
        {SceneNote::AreaUnreadable, QT_TR_NOOP("an area (unreadable)")},
        {SceneNote::AreaCorners, QT_TR_NOOP("the area (too few or too many corners)")},
        {SceneNote::AreaTooFar, QT_TR_NOOP("the area (more than 1000 km from the origin)")},
        {SceneNote::AreaCrossing, QT_TR_NOOP("the area (touches or crosses itself)")},
        {SceneNote::AreaInParts, QT_TR_NOOP("the area (in several parts)")},
        {SceneNote::AreasMore, QT_TR_N_NOOP("%n further areas")},
        {SceneNote::AreaHoles, QT_TR_N_NOOP("%n holes of the area")},
        {SceneNote::FenceCircles, QT_TR_N_NOOP("%n circles of the geofence")},
        {SceneNote::FenceCorners, QT_TR_NOOP("the geofence (too many corners)")},
        {SceneNote::FenceOutside, QT_TR_NOOP("the geofence (a UAV starts or lands outside)")},
        {SceneNote::NoFlyUnfit,
         QT_TR_N_NOOP(
             "%n no-fly areas (a UAV starts or lands in them, or their heights are wrong)")},
        {SceneNote::RallyPoints, QT_TR_N_NOOP("%n rally points")},
        {SceneNote::AssetsMore, QT_TR_N_NOOP("%n further assets")},
        {SceneNote::AssetTooFar, QT_TR_NOOP("the asset (more than 1000 km from the origin)")},
        {SceneNote::NumberWrong, QT_TR_N_NOOP("%n numbers out of range")},
    };

    static constexpr Named<std::string_view> kFormats[]{
        {"kml", QT_TR_NOOP("KML (Google Earth)")},
        {"kmz", QT_TR_NOOP("KMZ (KML, packed)")},
        {"czml", QT_TR_NOOP("CZML (Cesium)")},
        {"gpx", QT_TR_NOOP("GPX (waypoints, routes and tracks)")},
        {"plan", QT_TR_NOOP("QGroundControl plan")},
        {"wpl", QT_TR_NOOP("ArduPilot mission (QGC WPL)")},
        {"metno", QT_TR_NOOP("MET Norway (GeoJSON)")},
        {"geojson", QT_TR_NOOP("GeoJSON (QGIS)")},
        {"iip", QT_TR_NOOP("International Ice Patrol (CSV)")},
        {"cis-beacon", QT_TR_NOOP("Canadian Ice Service (CSV)")},
        {"usnic", QT_TR_NOOP("US National Ice Center (CSV)")},
        {"csv", QT_TR_NOOP("Any table (CSV)")},
    };

    /** Of the codes that mean something else for sightings than for files of ours. */
    static constexpr Named<ErrorCode> kErrors[]{
        {ErrorCode::FileTooLarge,
         QT_TR_NOOP(
             "The file is too large to be imported. Split it, or leave out what is not needed.")},
        {ErrorCode::SyntaxError,
         QT_TR_NOOP("The file is broken. Correct it at the place named, or export it again.")},
        {ErrorCode::WrongFormat,
         QT_TR_NOOP("This is no file of sightings that can be recognised. If it is a table, name "
                    "its columns for latitude and longitude.")},
        {ErrorCode::InvalidInput, QT_TR_NOOP("Nothing of it can be used like this.")},
    };
};
static_assert(std::size(ImportWords::kNotes) == std::size_t(ImportNote::IdTaken) + 1);
static_assert(std::size(ImportWords::kOutcomes) == std::size_t(ImportOutcome::LeftOut) + 1);
static_assert(std::size(ImportWords::kFields) == kSightingFieldNames.size());
static_assert(std::size(ImportWords::kScene) == std::size_t(SceneNote::NumberWrong) + 1);

constexpr double kHour_s = 3600;
constexpr double kDay_s = 24 * kHour_s;

QString errorSentence(ErrorCode code)
{
    const std::string own = nameOf(ImportWords::kErrors, code);
    return own.empty() ? errorText(code) : ImportWords::tr(own.c_str());
}

bool isTaken(SceneNote note)
{
    return note == SceneNote::UavsTaken || note == SceneNote::AreaTaken ||
           note == SceneNote::FenceTaken || note == SceneNote::AssetTaken ||
           note == SceneNote::NoFlyTaken;
}

/** Part of a scene. */
QString sceneWords(const SceneFinding& finding)
{
    const std::string english = nameOf(ImportWords::kScene, finding.note);
    const int count = english.starts_with("%n") ? static_cast<int>(finding.count) : -1;
    return ImportWords::tr(english.c_str(), nullptr, count);
}

} // namespace

QString importNoteSentence(ImportNote note)
{
    return ImportWords::tr(nameOf(ImportWords::kNotes, note).c_str());
}

QString importOutcomeWord(ImportOutcome outcome)
{
    return ImportWords::tr(nameOf(ImportWords::kOutcomes, outcome).c_str());
}

QString sightingFieldName(SightingField field)
{
    return ImportWords::tr(nameOf(ImportWords::kFields, field).c_str());
}

QString importFormatName(std::string_view id)
{
    const std::string name = nameOf(ImportWords::kFormats, id);
    return name.empty() ? QString::fromUtf8(id.data(), qsizetype(id.size()))
                        : ImportWords::tr(name.c_str());
}

QString importSummary(const ImportResult& result)
{
    QStringList parts;
    const auto add = [&](std::size_t count, const char* text) {
        if (count > 0)
            parts << ImportWords::tr(text, nullptr, static_cast<int>(count));
    };
    add(result.added, QT_TRANSLATE_N_NOOP("ImportWords", "%n new"));
    add(result.updated, QT_TRANSLATE_N_NOOP("ImportWords", "%n updated"));
    add(result.unchanged, QT_TRANSLATE_N_NOOP("ImportWords", "%n unchanged"));
    add(result.leftOut, QT_TRANSLATE_N_NOOP("ImportWords", "%n left out"));
    add(result.outsideArea, QT_TRANSLATE_N_NOOP("ImportWords", "%n sightings outside the area"));
    add(result.outsideTime, QT_TRANSLATE_N_NOOP("ImportWords", "%n sightings outside the time"));
    add(result.rejected.count, QT_TRANSLATE_N_NOOP("ImportWords", "%n rows rejected"));
    return parts.isEmpty() ? ImportWords::tr("Nothing to import") : parts.join(u", "_s);
}

QString sceneSummary(const std::vector<SceneFinding>& findings)
{
    QStringList taken;
    QStringList leftOut;
    for (const SceneFinding& finding : findings)
        (isTaken(finding.note) ? taken : leftOut) << sceneWords(finding);
    QStringList lines;
    if (!taken.isEmpty())
        lines << ImportWords::tr("Also from the file: %1").arg(taken.join(u", "_s));
    if (!leftOut.isEmpty())
        lines << ImportWords::tr("Left out: %1").arg(leftOut.join(u", "_s));
    return lines.join(u'\n');
}

QString guessedDateText(const std::string& date, std::size_t line)
{
    return ImportWords::tr("Line %1: %2 is read month first, which nothing in the file tells. "
                           "Choose under Dates if the day comes first.")
        .arg(QString::number(line), QString::fromStdString(date));
}

QString importErrorReport(const Error& error)
{
    if (const QStringList lines = optionIssueLines(error, "import"); !lines.empty())
        return lines.join(u'\n');
    QStringList report{
        u"%1: %2"_s.arg(QString::fromStdString(error.subject()), errorSentence(error.code()))};
    for (const Issue& issue : error.issues())
        if (issue.reason.id != IssueId::UnknownFormat) // the sentence says it
            report << placedIssueText(issue);
    return report.join(u'\n');
}

QString utcTimeText(UtcTime time)
{
    return QDateTime::fromMSecsSinceEpoch(time.time_since_epoch().count(), QTimeZone::utc())
        .toString(u"yyyy-MM-dd HH:mm"_s);
}

QString ageText(double age_s, const QLocale& locale)
{
    const double minutes = std::round(age_s / 60);
    const double whole_s = 60 * minutes; // 24 h of it are a day
    const auto whole = [&](double value) { return fixedText(std::floor(value), 0, locale); };
    if (whole_s >= kDay_s)
        return ImportWords::tr("%1 d %2 h")
            .arg(whole(whole_s / kDay_s), whole(std::fmod(whole_s, kDay_s) / kHour_s));
    if (minutes >= 60)
        return ImportWords::tr("%1 h %2 min")
            .arg(whole(minutes / 60), whole(std::fmod(minutes, 60)));
    return ImportWords::tr("%1 min").arg(whole(minutes));
}

} // namespace berg
