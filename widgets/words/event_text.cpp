#include "widgets/words/event_text.h"

#include "core/io/words/event_words.h"
#include "core/plan/solve/names.h"
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

public:
    static constexpr Named<PlanReason> kReasons[]{
        {PlanReason::Start, QT_TR_NOOP("take-off")},
        {PlanReason::TargetReached, QT_TR_NOOP("iceberg reached")},
        {PlanReason::OutOfView, QT_TR_NOOP("iceberg out of view again")},
        {PlanReason::Appeared, QT_TR_NOOP("new iceberg")},
        {PlanReason::Intervention, QT_TR_NOOP("changed in flight")},
        {PlanReason::Sighted, QT_TR_NOOP("iceberg sighted en route")},
        {PlanReason::Overdue, QT_TR_NOOP("sighting overdue")},
        {PlanReason::Left, QT_TR_NOOP("iceberg left the area")},
        {PlanReason::Lost, QT_TR_NOOP("iceberg lost")},
        {PlanReason::Found, QT_TR_NOOP("lost iceberg found")},
        {PlanReason::GivenUp, QT_TR_NOOP("search given up")},
        {PlanReason::TakeOff, QT_TR_NOOP("next sortie")},
        {PlanReason::HoldFlown, QT_TR_NOOP("end of hold")},
        {PlanReason::SeenByOther, QT_TR_NOOP("seen by another UAV")},
        {PlanReason::Fleet, QT_TR_NOOP("another UAV needed a plan")},
    };
};
// All reasons except None.
static_assert(std::size(EventText::kReasons) == std::size_t(PlanReason::Fleet));

QString icebergName(const std::optional<IcebergIndex>& index, const std::vector<Iceberg>& icebergs)
{
    if (!index || toIndex(*index) >= icebergs.size())
        return {};
    return shownName(icebergs[toIndex(*index)]);
}

} // namespace

QString eventSentence(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                      const std::vector<Uav>& uavs, const QLocale& locale)
{
    const EventNames names{
        .iceberg = icebergName(event.iceberg, icebergs).toStdString(),
        .uav = nameInFleet(uavs, event.uav).toStdString(),
        .otherUav = nameInFleet(uavs, event.otherUav).toStdString(),
        .distance = distanceText(event.distance_m, locale).toStdString(),
        .entry = clockText(event.entry_s).toStdString(),
        .planner =
            shortPolicyText({.policy = event.policy, .tau = event.tau}, locale).toStdString()};
    const ReportWords words = reportLanguage();
    return QString::fromStdString(eventSentence(
        event, names, [&words](std::string_view english) { return words.translated(english); }));
}

QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                  const std::vector<Uav>& uavs, const QLocale& locale, const MissionClock& clock)
{
    return u"%1  %2"_s.arg(clock.text(event.time_s), eventSentence(event, icebergs, uavs, locale));
}

QString planReasonText(PlanReason reason)
{
    const std::string english = nameOf(EventText::kReasons, reason);
    return english.empty() ? QString() : EventText::tr(english.c_str());
}

QString planOrderText(const UavPlan& plan, const std::vector<Iceberg>& icebergs)
{
    QStringList names;
    for (const IcebergIndex iceberg : plan.order)
        names << icebergName(iceberg, icebergs);
    return names.join(u", "_s);
}

} // namespace berg
