#include "widgets/words/time_entry.h"

#include "core/io/import/fields/import_time.h"
#include "widgets/theme/typed_quantity.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct TimeEntry
{
    Q_DECLARE_TR_FUNCTIONS(TimeEntry)
};

constexpr double kDay_s = 86400;

double secondsBetween(UtcTime from, UtcTime to)
{
    return std::chrono::duration<double>(to - from).count();
}

/**
 * Returns the seconds from `start` to the typed UTC time; a time of day alone means the instant
 * nearest to `near_s`.
 */
std::optional<double> readUtc(const QString& text, UtcTime start, double near_s)
{
    static const QRegularExpression laterDay(u"^(.*?)\\s*\\+(\\d{1,3})$"_s);
    const QRegularExpressionMatch later = laterDay.match(text);
    const bool saysDay = later.hasMatch() && later.captured(1).endsWith(u'Z', Qt::CaseInsensitive);
    const std::string typed = (saysDay ? later.captured(1) : text).toStdString();
    if (const auto time = parseTypedTime(typed))
        return secondsBetween(start, *time);
    const auto clock = parseTimeOfDay(typed);
    if (!clock)
        return std::nullopt;
    const double first_s =
        secondsBetween(start, std::chrono::floor<std::chrono::days>(start) + *clock);
    const double days =
        saysDay ? later.captured(2).toDouble() : std::round((near_s - first_s) / kDay_s);
    return first_s + days * kDay_s;
}

} // namespace

std::variant<UtcTime, QString> readTime(const QString& text, std::optional<UtcTime> day)
{
    const std::string typed = text.trimmed().toStdString();
    if (hasTwoReadings(typed))
        return TimeEntry::
            tr("The day and month of \"%1\" are ambiguous. Type the date like 2026-11-29 12:00.")
                .arg(text.trimmed());
    if (const auto time = parseTypedTime(typed))
        return *time;
    if (const auto clock = parseTimeOfDay(typed)) {
        if (day)
            return UtcTime(std::chrono::floor<std::chrono::days>(*day)) + *clock;
        return TimeEntry::tr("\"%1\" has no date. Type it like 2026-11-29 12:00.")
            .arg(text.trimmed());
    }
    return TimeEntry::tr("\"%1\" is not a date and time. Type it like 2026-11-29 12:00 or 29 Nov "
                         "2026 12:00.")
        .arg(text.trimmed());
}

std::optional<double> readInstant(const QString& text, const MissionClock& clock, double near_s)
{
    QString typed = text.trimmed();
    if (typed.endsWith(u"UTC"_s, Qt::CaseInsensitive))
        typed = typed.chopped(3).trimmed() + u'Z';
    const std::optional<double> elapsed_s = clockValue(typed);
    if (elapsed_s || !clock.start)
        return elapsed_s;
    const std::optional<double> utc_s = readUtc(typed, *clock.start, near_s);
    return utc_s && *utc_s >= 0 ? utc_s : std::nullopt;
}

} // namespace berg
