#include "widgets/print/page_text.h"

#include "widgets/print/printable_text.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/words/policy_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>
#include <QTimeZone>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PageText
{
    Q_DECLARE_TR_FUNCTIONS(PageText)
};

} // namespace

QString pageTitle(const ExportContent& content)
{
    const QString name = printable(content.name);
    return name.isEmpty() ? PageText::tr("Untitled") : name;
}

QString pathsText(const ExportContent& content)
{
    const QString now = MissionClock{.start = content.start}.text(content.now_s);
    switch (content.what) {
    case ExportScope::FirstLeg:
        return content.now_s > 0 ? PageText::tr("First leg at %1").arg(now)
                                 : PageText::tr("First leg");
    case ExportScope::Order:
        return content.now_s > 0 ? PageText::tr("Planned order at %1").arg(now)
                                 : PageText::tr("Planned order");
    case ExportScope::Path:
        return content.now_s > 0 ? PageText::tr("Planned path with turns at %1").arg(now)
                                 : PageText::tr("Planned path with turns");
    case ExportScope::Track:
        return PageText::tr("Flown until %1").arg(now);
    }
    return {};
}

QString pageSubtitle(const ExportContent& content, const QString& what, const QLocale& locale)
{
    QStringList parts{what, policyText(content.planner, locale)};
    if (content.start) {
        const qint64 start_ms = content.start->time_since_epoch().count();
        const QDateTime start = QDateTime::fromMSecsSinceEpoch(start_ms, QTimeZone::utc());
        parts << PageText::tr("Start %1 UTC").arg(start.toString(u"yyyy-MM-dd HH:mm:ss"_s));
    }
    return parts.join(u" · "_s);
}

} // namespace berg
