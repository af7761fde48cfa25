#include "widgets/words/import_text.h"

#include "core/io/import/import_formats.h"
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
        {SightingField::Source, QT_TR_NOOP("Source")},
    };

    static constexpr Named<VelocitySource> kVelocitySources[]{
        {VelocitySource::Nothing, QT_TR_NOOP("unknown")},
        {VelocitySource::Fixes, QT_TR_NOOP("positions")},
        {VelocitySource::File, QT_TR_NOOP("file")},
        {VelocitySource::Both, QT_TR_NOOP("both")},
    };
};
static_assert(std::size(ImportWords::kOutcomes) == std::size_t(ImportOutcome::LeftOut) + 1);
static_assert(std::size(ImportWords::kFields) == kSightingFieldNames.size());
static_assert(std::size(ImportWords::kVelocitySources) == std::size_t(VelocitySource::Both) + 1);

constexpr double kHour_s = 3600;
constexpr double kDay_s = 24 * kHour_s;

} // namespace

QString importNoteSentence(ImportNote note)
{
    return coreWords(importNoteText(note));
}

QString velocitySourceText(const ImportedIceberg& iceberg, const QLocale& locale)
{
    const QString from =
        ImportWords::tr(nameOf(ImportWords::kVelocitySources, iceberg.velocityFrom).c_str());
    return iceberg.velocityFrom == VelocitySource::Nothing
               ? from
               : ImportWords::tr("%1, %2", "source, age")
                     .arg(from, ageText(iceberg.velocityAge_s, locale));
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
    const ImportFormat* const format = findImportFormat(id);
    return format == nullptr ? QString::fromUtf8(id.data(), qsizetype(id.size()))
                             : ImportWords::tr(format->name);
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
    add(result.noted.count, QT_TRANSLATE_N_NOOP("ImportWords", "%n rows changed"));
    return parts.isEmpty() ? ImportWords::tr("Nothing to import") : parts.join(u", "_s);
}

QString sceneSummary(const std::vector<SceneFinding>& findings)
{
    QStringList parts;
    for (const SceneFinding& finding : findings) {
        const QString words = coreWords(sceneNotePattern(finding.note), finding.count);
        parts << (finding.detail.empty()
                      ? words
                      : u"%1: %2"_s.arg(words, QString::fromStdString(finding.detail)));
    }
    return parts.isEmpty() ? QString()
                           : ImportWords::tr("From the file: %1").arg(parts.join(u"; "_s));
}

QString farSightingsText(const ImportResult& result, bool isInto)
{
    const auto count = static_cast<int>(result.tooFar);
    if (count == 0)
        return {};
    return isInto ? ImportWords::tr("%n sightings are more than 1000 km from the origin of this "
                                    "scenario. Import them into a new one, or choose others with "
                                    "Inside.",
                                    nullptr, count)
                  : ImportWords::tr("%n sightings are more than 1000 km from the origin, which is "
                                    "in their densest group. Choose others with Inside.",
                                    nullptr, count);
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
        u"%1: %2"_s.arg(QString::fromStdString(error.subject()), importErrorText(error.code()))};
    for (const Issue& issue : error.issues())
        if (issue.reason.id != IssueId::UnknownFormat) // the sentence of the code already says so
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
    const double whole_s = 60 * minutes; // rounded first, so that 24 h become a day
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
