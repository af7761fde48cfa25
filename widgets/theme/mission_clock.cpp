#include "widgets/theme/mission_clock.h"

#include "core/scenario/scenario.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QTimeZone>

#include <chrono>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr qint64 kMilli = 1000;
constexpr qint64 kMinute_s = 60;

struct MissionClockText
{
    Q_DECLARE_TR_FUNCTIONS(MissionClockText)
};

/** Date and time, rounded to whole seconds. */
QDateTime instant(UtcTime start, double time_s)
{
    const double start_ms = static_cast<double>(start.time_since_epoch().count());
    return QDateTime::fromSecsSinceEpoch(std::llround(start_ms / kMilli + time_s),
                                         QTimeZone::utc());
}

/** "+1" on the day after the start; empty on the same day. */
QString dayText(UtcTime start, const QDateTime& instant)
{
    const qint64 later = berg::instant(start, 0).date().daysTo(instant.date());
    return later > 0 ? u" +%1"_s.arg(later) : QString();
}

QString elapsedAhead(double ahead_s)
{
    return MissionClockText::tr("in %1").arg(clockText(ahead_s));
}

} // namespace

bool MissionClock::isUtc() const
{
    return start && shownUnits().times == TimeForm::Utc;
}

double MissionClock::midnight_s() const
{
    using namespace std::chrono;
    return start ? duration<double>(floor<days>(*start) - *start).count() : 0;
}

QString MissionClock::text(double time_s) const
{
    if (!isUtc() || !std::isfinite(time_s))
        return clockText(time_s);
    const QDateTime at = instant(*start, time_s);
    return at.toString(u"HH:mm:ss'Z'"_s) + dayText(*start, at);
}

QString MissionClock::columnText(double time_s) const
{
    return text(time_s).remove(u'Z');
}

QString MissionClock::dateText(double time_s) const
{
    if (!isUtc() || !std::isfinite(time_s))
        return clockText(time_s);
    return instant(*start, time_s).toString(u"yyyy-MM-dd HH:mm:ss 'UTC'"_s);
}

QString MissionClock::details(double time_s) const
{
    if (!start || !std::isfinite(time_s))
        return {};
    const QString form = u"yyyy-MM-dd HH:mm:ss"_s;
    const QDateTime utc = instant(*start, time_s);
    const QDateTime local = utc.toLocalTime();
    return MissionClockText::tr("%1 UTC\n%2 local time (%3)\n%4 after the start")
        .arg(utc.toString(form), local.toString(form), local.timeZoneAbbreviation(),
             clockText(time_s));
}

QString MissionClock::toolTip(double time_s) const
{
    return start ? details(time_s) : text(time_s);
}

MissionClock clockOf(const Scenario& scenario)
{
    return {.start = parseUtc(scenario.startUtc)};
}

QString TimesAhead::text(double ahead_s) const
{
    return clock.isUtc() ? clock.text(now_s + ahead_s) : elapsedAhead(ahead_s);
}

QString TimesAhead::widest(double last_s) const
{
    constexpr double kHour_s = 3600;
    const double hours = (last_s + 0.5) / kHour_s;
    const int digits = hours < 1 ? 0 : 1 + static_cast<int>(std::log10(hours));
    QString widest = text(clock.isUtc() ? last_s : std::pow(10, digits) * kHour_s - 1);
    for (QChar& c : widest)
        if (c.isDigit())
            c = u'8';
    return widest;
}

QString TimesAhead::minuteInBrackets(double ahead_s) const
{
    if (!clock.isUtc() || !std::isfinite(ahead_s))
        return {};
    const QDateTime at = instant(*clock.start, now_s + ahead_s + kMinute_s / 2.0);
    return at.toString(u" (HH:mm'Z'"_s) + dayText(*clock.start, at) + u')';
}

QString TimesAhead::toolTip(double ahead_s) const
{
    return clock.start ? elapsedAhead(ahead_s) + u'\n' + clock.details(now_s + ahead_s) : QString();
}

} // namespace berg
