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
        return (event.detail == kReported ? EventText::tr("%1 reported seen")
                                          : EventText::tr("%1 in view"))
            .arg(iceberg);
    case EventKind::Appeared:
        return EventText::tr("%1 appeared").arg(iceberg);
    case EventKind::PlannerFailed:
        return EventText::tr("The planner failed: the last plan is flown on");
    case EventKind::Alarm:
        return EventText::tr("%1 is on its way into the inner ring").arg(iceberg);
    case EventKind::Intervention:
        if (event.detail == kWindChanged)
            return EventText::tr("Wind changed");
        if (event.detail == kAssetChanged)
            return EventText::tr("What is to be protected has changed");
        return EventText::tr("Trade-off or policy changed");
    case EventKind::Left:
        return EventText::tr("%1 has left the area").arg(iceberg);
    case EventKind::Lost:
        return EventText::tr("%1 is lost: not where it should be").arg(iceberg);
    case EventKind::Found:
        return EventText::tr("%1 found again").arg(iceberg);
    case EventKind::GivenUp:
        return EventText::tr("Search for %1 given up").arg(iceberg);
    case EventKind::HomeBound:
        return EventText::tr("Returning home");
    case EventKind::Landed:
        return EventText::tr("Landed");
    case EventKind::TookOff:
        return EventText::tr("Took off");
    case EventKind::LateHome:
        return EventText::tr("The wind has changed: home cannot be reached in time");
    }
    return {};
}

QString nameOf(int index, const std::vector<Iceberg>& icebergs)
{
    if (index < 0 || static_cast<std::size_t>(index) >= icebergs.size())
        return {};
    const Iceberg& iceberg = icebergs[static_cast<std::size_t>(index)];
    return QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name);
}

} // namespace

QString eventSentence(const MissionEvent& event, const std::vector<Iceberg>& icebergs)
{
    return sentence(event, nameOf(event.iceberg, icebergs));
}

QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs)
{
    return u"%1  %2"_s.arg(clockText(event.time_s), eventSentence(event, icebergs));
}

QString planReasonText(PlanReason reason)
{
    switch (reason) {
    case PlanReason::None:
        return {};
    case PlanReason::Start:
        return EventText::tr("take-off");
    case PlanReason::TargetReached:
        return EventText::tr("iceberg reached");
    case PlanReason::OutOfView:
        return EventText::tr("iceberg out of view again");
    case PlanReason::Appeared:
        return EventText::tr("new iceberg");
    case PlanReason::Intervention:
        return EventText::tr("changed in flight");
    case PlanReason::Sighted:
        return EventText::tr("iceberg sighted on the way");
    case PlanReason::Overdue:
        return EventText::tr("sighting overdue");
    case PlanReason::Left:
        return EventText::tr("iceberg left the area");
    case PlanReason::Lost:
        return EventText::tr("iceberg lost");
    case PlanReason::Found:
        return EventText::tr("lost iceberg found");
    case PlanReason::GivenUp:
        return EventText::tr("search given up");
    case PlanReason::TakeOff:
        return EventText::tr("next sortie");
    }
    return {};
}

QString planOrderText(const PlanEvent& plan, const std::vector<Iceberg>& icebergs)
{
    QStringList names;
    for (const int iceberg : plan.order)
        names << nameOf(iceberg, icebergs);
    return names.join(u", "_s);
}

} // namespace berg
