#include "widgets/words/time_entry.h"

#include "core/io/import/import_time.h"

#include <QCoreApplication>

namespace berg {
namespace {

struct TimeEntry
{
    Q_DECLARE_TR_FUNCTIONS(TimeEntry)
};

} // namespace

std::variant<UtcTime, QString> readTime(const QString& text, std::optional<UtcTime> day)
{
    const std::string typed = text.trimmed().toStdString();
    if (hasTwoReadings(typed))
        return TimeEntry::tr("Day and month of \"%1\" can be read either way. Type it like "
                             "2026-11-29 12:00.")
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

} // namespace berg
