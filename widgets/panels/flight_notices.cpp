#include "widgets/panels/flight_notices.h"

#include "widgets/model/asset_approach.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <span>

namespace berg {
namespace {

struct FlightNotices
{
    Q_DECLARE_TR_FUNCTIONS(FlightNotices)
};

QString nameOf(const Iceberg& iceberg)
{
    return QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name);
}

/** The event log until the instant shown. */
std::span<const MissionEvent> eventsOf(const FlightRecord& record)
{
    return std::span(record.history.events).first(record.eventsShown());
}

/** The first plan after a failure is what was made in place of the one that failed. */
bool isPlannerFailing(const FlightRecord& record)
{
    const std::span<const MissionEvent> events = eventsOf(record);
    int plansSince = 0;
    for (auto event = events.rbegin(); event != events.rend() && plansSince < 2; ++event) {
        if (event->kind == EventKind::PlannerFailed)
            return true;
        plansSince += event->kind == EventKind::Planned ? 1 : 0;
    }
    return false;
}

bool isLateForHome(const FlightRecord& record)
{
    const std::span<const MissionEvent> events = eventsOf(record);
    const auto last = std::find_if(events.rbegin(), events.rend(), [](const MissionEvent& event) {
        return event.kind == EventKind::LateHome || event.kind == EventKind::Landed;
    });
    return last != events.rend() && last->kind == EventKind::LateHome;
}

/** An iceberg on its way into the inner ring. */
struct Entry
{
    std::size_t iceberg = 0;
    double entry_s = 0; ///< from now
};

/** The soonest first. */
std::vector<Entry> entriesOf(const MissionSnapshot& shown)
{
    std::vector<Entry> entries;
    if (!shown.asset)
        return entries;
    for (std::size_t i = 0; i < shown.world.tracks.size(); ++i)
        if (const auto approach = approachOf(shown, i); approach && approach->entry_s)
            entries.push_back({.iceberg = i, .entry_s = *approach->entry_s});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.entry_s < b.entry_s; });
    return entries;
}

/** The one found last to be on its way. */
const Entry& newestOf(const std::vector<Entry>& entries, std::span<const MissionEvent> events)
{
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (event->kind != EventKind::Alarm)
            continue;
        const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& one) {
            return static_cast<int>(one.iceberg) == event->iceberg;
        });
        if (entry != entries.end())
            return *entry;
    }
    return entries.front();
}

std::optional<FlightNotice> alarmNotice(const FlightRecord& record, const QLocale& locale)
{
    const MissionSnapshot& shown = record.shown();
    const std::vector<Entry> entries = entriesOf(shown);
    if (entries.empty())
        return std::nullopt;
    const auto sentence = [&](const Entry& entry) {
        return ringEntryText(nameOf(shown.icebergs[entry.iceberg]), entry.entry_s, locale);
    };
    FlightNotice notice{.icon = IconName::Warning,
                        .text = sentence(newestOf(entries, eventsOf(record))),
                        .toolTip = {}};
    if (entries.size() == 1)
        return notice;
    notice.text =
        FlightNotices::tr("%1, and %n more", nullptr, static_cast<int>(entries.size()) - 1)
            .arg(notice.text);
    QStringList all;
    for (const Entry& entry : entries)
        all << sentence(entry);
    notice.toolTip = all.join(QChar(u'\n'));
    return notice;
}

QString modeText(const MissionSnapshot& shown, const QLocale& locale)
{
    switch (shown.world.mode) {
    case FlightMode::Search:
        if (!shown.world.search)
            return {};
        return FlightNotices::tr("Searching for %1")
            .arg(nameOf(shown.icebergs[static_cast<std::size_t>(shown.world.search->iceberg)]));
    case FlightMode::Home:
        return FlightNotices::tr("Returning home");
    case FlightMode::Ground:
        return FlightNotices::tr("On the ground, takes off in %1")
            .arg(roughDurationText(shown.world.ground_s, locale));
    case FlightMode::Idle:
    case FlightMode::Leg:
    case FlightMode::RunOut:
    case FlightMode::Circle:
        break;
    }
    return {};
}

} // namespace

std::vector<FlightNotice> flightNotices(const FlightRecord& record, const QLocale& locale)
{
    std::vector<FlightNotice> notices;
    if (isPlannerFailing(record))
        notices.push_back(
            {.icon = IconName::Warning,
             .text = FlightNotices::tr("The planner failed: the last plan is flown on"),
             .toolTip = FlightNotices::tr("It is asked again when the next plan is needed.")});
    if (!record.inFlight())
        return notices;
    if (isLateForHome(record))
        notices.push_back({.icon = IconName::Warning,
                           .text = FlightNotices::tr("Home cannot be reached in time any more"),
                           .toolTip = FlightNotices::tr("The wind has changed on the way.")});
    if (std::optional<FlightNotice> alarm = alarmNotice(record, locale))
        notices.push_back(*std::move(alarm));
    if (const QString mode = modeText(record.shown(), locale); !mode.isEmpty())
        notices.push_back({.icon = IconName::Hint, .text = mode, .toolTip = {}});
    return notices;
}

} // namespace berg
