#include "widgets/model/event_text.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct EventText
{
    Q_DECLARE_TR_FUNCTIONS(EventText)
};

QString sentence(const MissionEvent& event, const QString& iceberg)
{
    switch (event.kind) {
    case EventKind::Planned:
        return iceberg.isEmpty() ? EventText::tr("Every iceberg is in view: circling")
                                 : EventText::tr("Planned: next %1").arg(iceberg);
    case EventKind::Reached:
        return EventText::tr("%1 reached").arg(iceberg);
    case EventKind::Sighted:
        return EventText::tr("%1 in view").arg(iceberg);
    case EventKind::Appeared:
        return EventText::tr("%1 appeared").arg(iceberg);
    case EventKind::Intervention:
        return EventText::tr("Trade-off or policy changed");
    }
    return {};
}

} // namespace

QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs)
{
    QString name;
    if (event.iceberg >= 0 && static_cast<std::size_t>(event.iceberg) < icebergs.size()) {
        const Iceberg& iceberg = icebergs[static_cast<std::size_t>(event.iceberg)];
        name = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name);
    }
    return u"%1  %2"_s.arg(clockText(event.time_s), sentence(event, name));
}

} // namespace berg
