#include "widgets/words/event_text.h"

#include "core/io/results/event_words.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"
#include "widgets/words/policy_words.h"
#include "widgets/words/report_language.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct EventText
{
    Q_DECLARE_TR_FUNCTIONS(EventText)
};

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
    const EventNames names{
        .iceberg = nameOf(event.iceberg, icebergs).toStdString(),
        .uav = nameInFleet(uavs, event.uav).toStdString(),
        .otherUav = nameInFleet(uavs, event.otherUav).toStdString(),
        .distance = distanceText(event.distance_m, locale).toStdString(),
        .entry = clockText(event.entry_s).toStdString(),
        .planner =
            shortPolicyText({.policy = event.policy, .tau = event.tau}, locale).toStdString()};
    const ReportWords words = reportLanguage();
    return QString::fromStdString(eventSentence(
        event, names, [&words](std::string_view english) { return words.said(english); }));
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
