#include "core/io/words/event_words.h"

#include "core/base/issue.h"
#include "core/base/translate_noop.h"

namespace berg {

namespace {

std::string_view orderWords(FlightOrder order)
{
    switch (order) {
    case FlightOrder::None:
        return QT_TRANSLATE_NOOP("EventText", "Told to resume");
    case FlightOrder::ReturnNow:
        return QT_TRANSLATE_NOOP("EventText", "Told to return now");
    case FlightOrder::HoldHere:
        return QT_TRANSLATE_NOOP("EventText", "Told to hold here");
    }
    return {};
}

/** %1 is the iceberg, %2 policy and tau. */
std::string_view changeWords(const MissionEvent& event)
{
    switch (event.changed) {
    case ChangedPart::Planner:
        return QT_TRANSLATE_NOOP("EventText", "Planned from now on by: %2");
    case ChangedPart::Wind:
        return QT_TRANSLATE_NOOP("EventText", "Wind changed");
    case ChangedPart::Asset:
        return QT_TRANSLATE_NOOP("EventText", "The protected asset has changed");
    case ChangedPart::Assignment:
        return QT_TRANSLATE_NOOP("EventText", "Any UAV may visit %1");
    case ChangedPart::Order:
        return orderWords(event.order);
    case ChangedPart::Removal:
        return QT_TRANSLATE_NOOP("EventText", "%1 removed");
    }
    return {};
}

/** %1 is the iceberg, %2 policy and tau, %3 a distance, %4 a time. */
std::string_view wordsOf(const MissionEvent& event, bool hasIceberg)
{
    switch (event.kind) {
    case EventKind::Planned:
        if (event.fellBack && hasIceberg)
            return QT_TRANSLATE_NOOP("EventText", "Previous plan kept: next %1");
        return hasIceberg ? QT_TRANSLATE_NOOP("EventText", "Planned: next %1")
                          : QT_TRANSLATE_NOOP("EventText", "Nothing to visit now: circling");
    case EventKind::Reached:
        return QT_TRANSLATE_NOOP("EventText", "%1 reached");
    case EventKind::Sighted:
        return event.reported ? QT_TRANSLATE_NOOP("EventText", "%1 reported seen")
                              : QT_TRANSLATE_NOOP("EventText", "%1 in view");
    case EventKind::Appeared:
        return event.reported ? QT_TRANSLATE_NOOP("EventText", "%1 added")
                              : QT_TRANSLATE_NOOP("EventText", "%1 appeared");
    case EventKind::PlannerFailed:
        return QT_TRANSLATE_NOOP("EventText",
                                 "The planner failed: continuing with the previous plan");
    case EventKind::Alarm:
        return QT_TRANSLATE_NOOP("EventText", "%1 will enter the inner ring in %4");
    case EventKind::Intervention:
        return changeWords(event);
    case EventKind::Left:
        return QT_TRANSLATE_NOOP("EventText", "%1 has left the area");
    case EventKind::Lost:
        return QT_TRANSLATE_NOOP("EventText", "%1 is lost: not where it should be");
    case EventKind::Found:
        return QT_TRANSLATE_NOOP("EventText", "%1 found again");
    case EventKind::GivenUp:
        return QT_TRANSLATE_NOOP("EventText", "Search for %1 given up");
    case EventKind::HomeBound:
        return QT_TRANSLATE_NOOP("EventText", "Returning home");
    case EventKind::Landed:
        return QT_TRANSLATE_NOOP("EventText", "Landed");
    case EventKind::TookOff:
        return QT_TRANSLATE_NOOP("EventText", "Took off");
    case EventKind::LateHome:
        return QT_TRANSLATE_NOOP("EventText", "Home cannot be reached in time");
    case EventKind::Close:
        return QT_TRANSLATE_NOOP("EventText", "Close to another UAV: %3");
    case EventKind::LeftFence:
        return QT_TRANSLATE_NOOP("EventText", "Outside the geofence");
    case EventKind::BackInside:
        return QT_TRANSLATE_NOOP("EventText", "Back inside the geofence");
    }
    return {};
}

} // namespace

std::string eventSentence(const MissionEvent& event, const EventNames& names,
                          const std::function<std::string(std::string_view)>& said)
{
    const auto fill = [&said](std::string_view english, const std::vector<std::string>& arguments) {
        if (english.find('%') == english.npos) // `filledIn` would append what it has
            return said(english);
        return filledIn(said(english), {arguments.begin(), arguments.end()});
    };
    const auto own = [&] {
        return fill(wordsOf(event, !names.iceberg.empty()),
                    {names.iceberg, names.planner, names.distance, names.entry});
    };
    if (names.uav.empty())
        return own();
    if (event.kind == EventKind::Planned && !event.fellBack)
        return fill(names.iceberg.empty()
                        ? QT_TRANSLATE_NOOP("EventText", "%1 has nothing to visit: circling")
                        : QT_TRANSLATE_NOOP("EventText", "%1 flies to %2 next"),
                    {names.uav, names.iceberg});
    if (event.kind == EventKind::Close && !names.otherUav.empty())
        return fill(QT_TRANSLATE_NOOP("EventText", "%1 and %2 are %3 apart"),
                    {names.uav, names.otherUav, names.distance});
    if (event.kind == EventKind::Intervention && event.changed == ChangedPart::Assignment)
        return fill(QT_TRANSLATE_NOOP("EventText", "%1 assigned to %2"),
                    {names.iceberg, names.uav});
    return names.uav + ": " + own();
}

} // namespace berg
