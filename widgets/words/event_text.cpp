#include "widgets/words/event_text.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct EventText
{
    Q_DECLARE_TR_FUNCTIONS(EventText)
};

QString orderSentence(FlightOrder order)
{
    switch (order) {
    case FlightOrder::None:
        return EventText::tr("Told to resume");
    case FlightOrder::ReturnNow:
        return EventText::tr("Told to return now");
    case FlightOrder::HoldHere:
        return EventText::tr("Told to hold here");
    }
    return {};
}

QString changeSentence(const MissionEvent& event, const QString& iceberg)
{
    switch (event.changed) {
    case ChangedPart::Planner:
        return EventText::tr("Trade-off or policy changed");
    case ChangedPart::Wind:
        return EventText::tr("Wind changed");
    case ChangedPart::Asset:
        return EventText::tr("The protected asset has changed");
    case ChangedPart::Assignment:
        return EventText::tr("Any UAV may visit %1").arg(iceberg);
    case ChangedPart::Order:
        return orderSentence(event.order);
    case ChangedPart::Removal:
        return EventText::tr("%1 removed").arg(iceberg);
    }
    return {};
}

QString sentence(const MissionEvent& event, const QString& iceberg, const QLocale& locale)
{
    switch (event.kind) {
    case EventKind::Planned:
        return iceberg.isEmpty() ? EventText::tr("Every iceberg is in view: circling")
                                 : EventText::tr("Planned: next %1").arg(iceberg);
    case EventKind::Reached:
        return EventText::tr("%1 reached").arg(iceberg);
    case EventKind::Sighted:
        return (event.reported ? EventText::tr("%1 reported seen") : EventText::tr("%1 in view"))
            .arg(iceberg);
    case EventKind::Appeared:
        return EventText::tr("%1 appeared").arg(iceberg);
    case EventKind::PlannerFailed:
        return EventText::tr("The planner failed: continuing with the previous plan");
    case EventKind::Alarm:
        return EventText::tr("%1 will enter the inner ring").arg(iceberg);
    case EventKind::Intervention:
        return changeSentence(event, iceberg);
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
        return EventText::tr("Home cannot be reached in time");
    case EventKind::Close:
        return EventText::tr("Close to another UAV: %1")
            .arg(distanceText(event.distance_m, locale));
    case EventKind::LeftFence:
        return EventText::tr("Outside the geofence");
    case EventKind::BackInside:
        return EventText::tr("Back inside the geofence");
    }
    return {};
}

/** Of several UAVs, what this one did. */
QString fleetSentence(const MissionEvent& event, const QString& iceberg, const QString& uav,
                      const std::vector<Uav>& uavs, const QLocale& locale)
{
    if (event.kind == EventKind::Planned)
        return iceberg.isEmpty() ? EventText::tr("%1 has nothing to visit: circling").arg(uav)
                                 : EventText::tr("%1 flies to %2 next").arg(uav, iceberg);
    const QString other = nameInFleet(uavs, event.otherUav);
    if (event.kind == EventKind::Close && !other.isEmpty())
        return EventText::tr("%1 and %2 are %3 apart")
            .arg(uav, other, distanceText(event.distance_m, locale));
    if (event.kind == EventKind::Intervention && event.changed == ChangedPart::Assignment)
        return EventText::tr("%1 given to %2").arg(iceberg, uav);
    return u"%1: %2"_s.arg(uav, sentence(event, iceberg, locale));
}

QString nameOf(int index, const std::vector<Iceberg>& icebergs)
{
    if (index < 0 || static_cast<std::size_t>(index) >= icebergs.size())
        return {};
    return shownName(icebergs[static_cast<std::size_t>(index)]);
}

} // namespace

QString eventSentence(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                      const std::vector<Uav>& uavs, const QLocale& locale)
{
    const QString iceberg = nameOf(event.iceberg, icebergs);
    const QString uav = nameInFleet(uavs, event.uav);
    return uav.isEmpty() ? sentence(event, iceberg, locale)
                         : fleetSentence(event, iceberg, uav, uavs, locale);
}

QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                  const std::vector<Uav>& uavs, const QLocale& locale)
{
    return u"%1  %2"_s.arg(clockText(event.time_s), eventSentence(event, icebergs, uavs, locale));
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
        return EventText::tr("iceberg sighted en route");
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
    case PlanReason::HoldFlown:
        return EventText::tr("end of hold");
    case PlanReason::SeenByOther:
        return EventText::tr("seen by another UAV");
    case PlanReason::Fleet:
        return EventText::tr("another UAV needed a plan");
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
