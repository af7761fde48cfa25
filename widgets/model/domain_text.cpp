#include "widgets/model/domain_text.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

namespace berg {
namespace {

struct DomainText
{
    Q_DECLARE_TR_FUNCTIONS(DomainText)
};

} // namespace

QString policyText(const PlannerSettings& settings, const QLocale& locale)
{
    switch (settings.policy) {
    case PolicyKind::Visitation:
        return DomainText::tr("Weighted visiting order, trade-off τ %1")
            .arg(fixedText(settings.tau, 2, locale));
    case PolicyKind::Path:
        return DomainText::tr("Shortest path, repeated");
    case PolicyKind::Tour:
        return DomainText::tr("Shortest round tour, repeated");
    case PolicyKind::Nearest:
        return DomainText::tr("Nearest iceberg first");
    case PolicyKind::Uncertainty:
        return DomainText::tr("Most uncertain iceberg first");
    case PolicyKind::Latency:
        return DomainText::tr("Least waiting time, weighted by uncertainty");
    case PolicyKind::Coverage:
        return DomainText::tr("Best predicted coverage");
    }
    return {};
}

} // namespace berg
