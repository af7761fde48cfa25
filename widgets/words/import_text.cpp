#include "widgets/words/import_text.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>
#include <QDateTime>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ImportWords
{
    Q_DECLARE_TR_FUNCTIONS(ImportWords)
};

constexpr double kHour_s = 3600;
constexpr double kDay_s = 24 * kHour_s;

/** Of the codes that mean something else for sightings than for files of ours. */
QString errorSentence(ErrorCode code)
{
    switch (code) {
    case ErrorCode::FileTooLarge:
        return ImportWords::tr(
            "The file is too large to be imported. Split it, or leave out what is not "
            "needed.");
    case ErrorCode::SyntaxError:
        return ImportWords::tr(
            "The file is broken. Correct it at the place named, or export it again.");
    case ErrorCode::WrongFormat:
        return ImportWords::tr(
            "This is no file of sightings that can be recognised. If it is a table, "
            "name its columns for latitude and longitude.");
    case ErrorCode::InvalidInput:
        return ImportWords::tr("Nothing of it can be used like this.");
    case ErrorCode::FileNotFound:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileUnwritable:
    case ErrorCode::UnsupportedVersion:
    case ErrorCode::Unsupported:
    case ErrorCode::SolverFailed:
    case ErrorCode::ReplayMismatch:
        return errorText(code);
    }
    return {};
}

bool isTaken(SceneNote note)
{
    return note == SceneNote::UavsTaken || note == SceneNote::AreaTaken ||
           note == SceneNote::FenceTaken || note == SceneNote::AssetTaken ||
           note == SceneNote::NoFlyTaken;
}

/** Part of a scene, with the reason where it is left out. */
QString sceneWords(const SceneFinding& finding)
{
    const auto count = static_cast<int>(finding.count);
    switch (finding.note) {
    case SceneNote::UavsTaken:
        return ImportWords::tr("%n UAVs", nullptr, count);
    case SceneNote::AreaTaken:
        return ImportWords::tr("the area");
    case SceneNote::FenceTaken:
        return ImportWords::tr("the area as geofence");
    case SceneNote::AssetTaken:
        return ImportWords::tr("the asset");
    case SceneNote::NoFlyTaken:
        return ImportWords::tr("%n no-fly areas", nullptr, count);
    case SceneNote::InUse:
        return ImportWords::tr("UAVs, area and asset (the scenario has its own)");
    case SceneNote::UavsTooMany:
        return ImportWords::tr("%n UAVs (too many)", nullptr, count);
    case SceneNote::UavsTooFar:
        return ImportWords::tr("%n UAVs (more than 1000 km from the origin)", nullptr, count);
    case SceneNote::AreaUnreadable:
        return ImportWords::tr("an area (unreadable)");
    case SceneNote::AreaCorners:
        return ImportWords::tr("the area (too few or too many corners)");
    case SceneNote::AreaTooFar:
        return ImportWords::tr("the area (more than 1000 km from the origin)");
    case SceneNote::AreaCrossing:
        return ImportWords::tr("the area (touches or crosses itself)");
    case SceneNote::AreaInParts:
        return ImportWords::tr("the area (in several parts)");
    case SceneNote::AreasMore:
        return ImportWords::tr("%n further areas", nullptr, count);
    case SceneNote::AreaHoles:
        return ImportWords::tr("%n holes of the area", nullptr, count);
    case SceneNote::FenceCircles:
        return ImportWords::tr("%n circles of the geofence", nullptr, count);
    case SceneNote::FenceCorners:
        return ImportWords::tr("the geofence (too many corners)");
    case SceneNote::FenceOutside:
        return ImportWords::tr("the geofence (a UAV starts or lands outside)");
    case SceneNote::NoFlyUnfit:
        return ImportWords::tr(
            "%n no-fly areas (a UAV starts or lands in them, or their heights are wrong)", nullptr,
            count);
    case SceneNote::RallyPoints:
        return ImportWords::tr("%n rally points", nullptr, count);
    case SceneNote::AssetsMore:
        return ImportWords::tr("%n further assets", nullptr, count);
    case SceneNote::AssetTooFar:
        return ImportWords::tr("the asset (more than 1000 km from the origin)");
    case SceneNote::NumberWrong:
        return ImportWords::tr("%n numbers out of range", nullptr, count);
    }
    return {};
}

} // namespace

QString importNoteSentence(ImportNote note)
{
    switch (note) {
    case ImportNote::VelocityUnknown:
        return ImportWords::tr("velocity unknown");
    case ImportNote::TimeUnknown:
        return ImportWords::tr("no time: counts as seen at the start");
    case ImportNote::VelocityGiven:
        return ImportWords::tr("velocity from the file");
    case ImportNote::VelocityClamped:
        return ImportWords::tr("velocity limited to 5 m/s per axis");
    case ImportNote::GrowthEstimated:
        return ImportWords::tr("q estimated");
    case ImportNote::GrowthClamped:
        return ImportWords::tr("q limited to 10⁶ m²/s");
    case ImportNote::Stationary:
        return ImportWords::tr("stationary");
    case ImportNote::Repeated:
        return ImportWords::tr("several sightings at one time");
    case ImportNote::Jumped:
        return ImportWords::tr("sightings at impossible places not used");
    case ImportNote::TrackAttached:
        return ImportWords::tr("recorded track");
    case ImportNote::NoTrack:
        return ImportWords::tr("no track: not sighted after the start");
    case ImportNote::Older:
        return ImportWords::tr("older than what the scenario has");
    case ImportNote::SeenLater:
        return ImportWords::tr("sighted only after the start");
    case ImportNote::DriftedAway:
        return ImportWords::tr("more than 1000 km from the origin at the start");
    case ImportNote::TooMany:
        return ImportWords::tr("the scenario is full");
    case ImportNote::IdTaken:
        return ImportWords::tr("a UAV has this id");
    }
    return {};
}

QString importOutcomeWord(ImportOutcome outcome)
{
    switch (outcome) {
    case ImportOutcome::Added:
        return ImportWords::tr("new");
    case ImportOutcome::Updated:
        return ImportWords::tr("updated");
    case ImportOutcome::Unchanged:
        return ImportWords::tr("unchanged");
    case ImportOutcome::LeftOut:
        return ImportWords::tr("left out");
    }
    return {};
}

QString sightingFieldName(SightingField field)
{
    switch (field) {
    case SightingField::Id:
        return ImportWords::tr("Id");
    case SightingField::Name:
        return ImportWords::tr("Name");
    case SightingField::Date:
        return ImportWords::tr("Date");
    case SightingField::Time:
        return ImportWords::tr("Time");
    case SightingField::Latitude:
        return ImportWords::tr("Latitude");
    case SightingField::Longitude:
        return ImportWords::tr("Longitude");
    case SightingField::Speed:
        return ImportWords::tr("Speed");
    case SightingField::Direction:
        return ImportWords::tr("Direction");
    case SightingField::Sigma:
        return ImportWords::tr("Uncertainty σ");
    case SightingField::Growth:
        return ImportWords::tr("Growth q");
    case SightingField::Length:
        return ImportWords::tr("Length");
    case SightingField::Radius:
        return ImportWords::tr("Radius");
    case SightingField::Area:
        return ImportWords::tr("Area");
    case SightingField::SizeClass:
        return ImportWords::tr("Size class");
    case SightingField::Remarks:
        return ImportWords::tr("Remarks");
    }
    return {};
}

QString importFormatName(std::string_view id)
{
    if (id == "kml")
        return ImportWords::tr("KML (Google Earth)");
    if (id == "kmz")
        return ImportWords::tr("KMZ (KML, packed)");
    if (id == "czml")
        return ImportWords::tr("CZML (Cesium)");
    if (id == "gpx")
        return ImportWords::tr("GPX (waypoints, routes and tracks)");
    if (id == "plan")
        return ImportWords::tr("QGroundControl plan");
    if (id == "wpl")
        return ImportWords::tr("ArduPilot mission (QGC WPL)");
    if (id == "metno")
        return ImportWords::tr("MET Norway (GeoJSON)");
    if (id == "geojson")
        return ImportWords::tr("GeoJSON (QGIS)");
    if (id == "iip")
        return ImportWords::tr("International Ice Patrol (CSV)");
    if (id == "cis-beacon")
        return ImportWords::tr("Canadian Ice Service (CSV)");
    if (id == "usnic")
        return ImportWords::tr("US National Ice Center (CSV)");
    if (id == "csv")
        return ImportWords::tr("Any table (CSV)");
    return QString::fromUtf8(id.data(), qsizetype(id.size()));
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
    QString report =
        u"%1: %2"_s.arg(QString::fromStdString(error.subject()), errorSentence(error.code()));
    return report + u'\n' + issueLines(error).join(u'\n');
}

QString utcTimeText(UtcTime time)
{
    return QDateTime::fromMSecsSinceEpoch(time.time_since_epoch().count(), Qt::UTC)
        .toString(u"yyyy-MM-dd HH:mm"_s);
}

QString ageText(double age_s, const QLocale& locale)
{
    const double minutes = std::round(age_s / 60);
    const auto whole = [&](double value) { return fixedText(std::floor(value), 0, locale); };
    if (age_s >= kDay_s)
        return ImportWords::tr("%1 d %2 h")
            .arg(whole(age_s / kDay_s), whole(std::fmod(age_s, kDay_s) / kHour_s));
    if (minutes >= 60)
        return ImportWords::tr("%1 h %2 min")
            .arg(whole(minutes / 60), whole(std::fmod(minutes, 60)));
    return ImportWords::tr("%1 min").arg(whole(minutes));
}

} // namespace berg
