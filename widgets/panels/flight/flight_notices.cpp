#include "widgets/panels/flight/flight_notices.h"

#include "core/scenario/limits.h"
#include "widgets/document/selection.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/event_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <span>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct FlightNotices
{
    Q_DECLARE_TR_FUNCTIONS(FlightNotices)
};

/** Returns the events up to the instant shown. */
std::span<const MissionEvent> eventsOf(const FlightRecord& record)
{
    return std::span(record.history.events).first(record.eventsShown());
}

/**
 * The first plan after a failure is the substitute for the failed one, so a second plan ends it.
 */
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

/** Returns the text with the name of the UAV in front if there are several. */
QString ofUav(const FlightRecord& record, int uav, const QString& text)
{
    const QString name = nameInFleet(record.scenario.uavs, uav);
    return name.isEmpty() ? text : u"%1: %2"_s.arg(name, text);
}

/** Returns the sentence of an event that lasts. */
QString sentence(const FlightRecord& record, const MissionEvent& event, const QLocale& locale)
{
    return eventSentence(event, record.now.icebergs, record.scenario.uavs, locale);
}

const std::string& idOf(const FlightRecord& record, int uav)
{
    return record.scenario.uavs[static_cast<std::size_t>(uav)].id;
}

bool isLateForHome(const FlightRecord& record, int uav)
{
    const std::span<const MissionEvent> events = eventsOf(record);
    const auto last =
        std::find_if(events.rbegin(), events.rend(), [uav](const MissionEvent& event) {
            return event.uav == uav &&
                   (event.kind == EventKind::LateHome || event.kind == EventKind::Landed);
        });
    return last != events.rend() && last->kind == EventKind::LateHome;
}

void addLate(std::vector<FlightNotice>& notices, const FlightRecord& record, const QLocale& locale)
{
    for (int uav = 0; uav < static_cast<int>(record.scenario.uavs.size()); ++uav)
        if (isLateForHome(record, uav))
            notices.push_back(
                {.kind = NoticeKind::LateHome,
                 .about = {idOf(record, uav)},
                 .text = sentence(record, {.kind = EventKind::LateHome, .uav = uav}, locale),
                 .toolTip = FlightNotices::tr("The wind changed in flight.")});
}

/** Adds UAVs aloft in one altitude layer that are nearer to each other than the set separation. */
void addClose(std::vector<FlightNotice>& notices, const FlightRecord& record, const QLocale& locale)
{
    const std::vector<Uav>& uavs = record.scenario.uavs;
    const std::vector<UavState>& states = record.shown().world.uavs;
    const std::size_t count = std::min(uavs.size(), states.size());
    const auto isAloft = [&](std::size_t k) { return states[k].mode != FlightMode::Ground; };
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b) {
            const double distance_m =
                (states[a].pose.position_m - states[b].pose.position_m).norm();
            const double layers_m = std::abs(uavs[a].spec.altitude_m - uavs[b].spec.altitude_m);
            if (!isAloft(a) || !isAloft(b) || layers_m >= kLayerHeight_m ||
                distance_m >= record.scenario.separation_m)
                continue;
            notices.push_back(
                {.kind = NoticeKind::UavsClose,
                 .about = {uavs[a].id, uavs[b].id},
                 .text = sentence(record,
                                  {.kind = EventKind::Close,
                                   .uav = static_cast<int>(a),
                                   .otherUav = static_cast<int>(b),
                                   .distance_m = distance_m},
                                  locale),
                 .toolTip =
                     FlightNotices::tr(
                         "They fly at about the same altitude. The required separation is %1.")
                         .arg(distanceText(record.scenario.separation_m, locale))});
        }
}

/** Adds UAVs aloft in wind above their limit, or in wind that leaves them little headway. */
void addWind(std::vector<FlightNotice>& notices, const FlightRecord& record, const QLocale& locale)
{
    const std::vector<Uav>& uavs = record.scenario.uavs;
    const MissionSnapshot& shown = record.shown();
    for (std::size_t k = 0; k < std::min(uavs.size(), shown.motions.size()); ++k) {
        const std::optional<double>& limit_mps = uavs[k].weather.wind_mps;
        const double wind_mps = shown.motions[k].wind_mps.norm();
        const double airspeed_mps = uavs[k].spec.airspeed_mps;
        const bool isAboveLimit = limit_mps && wind_mps > *limit_mps;
        if ((!isAboveLimit && wind_mps < kStrongWindShare * airspeed_mps) ||
            shown.world.uavs[k].mode == FlightMode::Ground)
            continue;
        const QString text = isAboveLimit
                                 ? FlightNotices::tr("Wind above its limit: %1, limit %2")
                                 : FlightNotices::tr("Makes little headway: wind %1, airspeed %2");
        notices.push_back(
            {.kind = NoticeKind::WindLimit,
             .about = {uavs[k].id},
             .text =
                 ofUav(record, static_cast<int>(k),
                       text.arg(speedText(wind_mps, locale, 3),
                                speedText(isAboveLimit ? *limit_mps : airspeed_mps, locale, 3)))});
    }
}

/** An iceberg on its way into the inner ring. */
struct RingEntry
{
    IcebergIndex iceberg;
    double entry_s = 0; ///< time from now, s
};

/** Returns the icebergs entering the ring, soonest first. */
std::vector<RingEntry> entriesOf(const MissionSnapshot& shown)
{
    std::vector<RingEntry> entries;
    if (!shown.asset)
        return entries;
    for (const IcebergIndex i : IcebergRange(shown.world.tracks.size()))
        if (const auto approach = approachOf(shown, i); approach && approach->entry_s)
            entries.push_back({.iceberg = i, .entry_s = *approach->entry_s});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const RingEntry& a, const RingEntry& b) { return a.entry_s < b.entry_s; });
    return entries;
}

/** Returns the entry that was detected last. */
const RingEntry& newestOf(const std::vector<RingEntry>& entries,
                          std::span<const MissionEvent> events)
{
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (event->kind != EventKind::Alarm)
            continue;
        const auto entry = std::find_if(entries.begin(), entries.end(), [&](const RingEntry& one) {
            return one.iceberg == event->iceberg;
        });
        if (entry != entries.end())
            return *entry;
    }
    return entries.front();
}

std::optional<FlightNotice> alarmNotice(const FlightRecord& record, const QLocale& locale)
{
    const MissionSnapshot& shown = record.shown();
    const std::vector<RingEntry> entries = entriesOf(shown);
    if (entries.empty())
        return std::nullopt;
    const auto sentence = [&](const RingEntry& entry) {
        return ringEntryText(shownName(shown.icebergs[toIndex(entry.iceberg)]), entry.entry_s,
                             locale, timesOf(record));
    };
    FlightNotice notice{.kind = NoticeKind::RingEntry,
                        .about = {kAssetKey},
                        .text = sentence(newestOf(entries, eventsOf(record)))};
    for (const RingEntry& entry : entries)
        notice.about.push_back(shown.icebergs[toIndex(entry.iceberg)].id);
    if (entries.size() == 1)
        return notice;
    notice.text =
        FlightNotices::tr("%1, and %n more", nullptr, static_cast<int>(entries.size()) - 1)
            .arg(notice.text);
    QStringList all;
    for (const RingEntry& entry : entries)
        all << sentence(entry);
    notice.toolTip = all.join(QChar(u'\n'));
    return notice;
}

/** Adds a notice for each lost iceberg, because each is acknowledged separately. */
void addLost(std::vector<FlightNotice>& notices, const MissionSnapshot& shown)
{
    for (std::size_t i = 0; i < shown.world.tracks.size(); ++i) {
        const TrackStatus status = shown.world.tracks[i].status;
        if (status != TrackStatus::Lost && status != TrackStatus::GivenUp)
            continue;
        const QString text = status == TrackStatus::Lost
                                 ? FlightNotices::tr("%1 is lost")
                                 : FlightNotices::tr("%1 is lost; the search was abandoned");
        notices.push_back(
            {.kind = NoticeKind::LostIceberg,
             .about = {shown.icebergs[i].id},
             .text = text.arg(shownName(shown.icebergs[i])),
             .toolTip = FlightNotices::tr("It was not in view where it was expected.")});
    }
}

QString modeText(const FlightRecord& record, const UavState& uav, const QLocale& locale)
{
    const MissionSnapshot& shown = record.shown();
    switch (uav.mode) {
    case FlightMode::Search:
        if (!uav.search)
            return {};
        return FlightNotices::tr("Searching for %1")
            .arg(shownName(shown.icebergs[toIndex(uav.search->iceberg)]));
    case FlightMode::Home:
        return sentence(record, {.kind = EventKind::HomeBound}, locale);
    case FlightMode::Hold:
        return FlightNotices::tr("Holding as ordered");
    case FlightMode::Ground:
        if (uav.order != FlightOrder::None)
            return FlightNotices::tr("On the ground. Choose Resume to continue");
        return FlightNotices::tr("On the ground, takes off in %1")
            .arg(roughDurationText(uav.ground_s, locale) +
                 timesOf(record).minuteInBrackets(uav.ground_s));
    case FlightMode::Idle:
    case FlightMode::Leg:
    case FlightMode::RunOut:
    case FlightMode::Circle:
        break;
    }
    return {};
}

} // namespace

NoticeRank rankOf(NoticeKind kind)
{
    switch (kind) {
    case NoticeKind::UavsClose:
    case NoticeKind::LateHome:
    case NoticeKind::RingEntry:
    case NoticeKind::ContactLost:
    case NoticeKind::Battery:
        return NoticeRank::Alarm;
    case NoticeKind::PlannerFailed:
    case NoticeKind::WindLimit:
    case NoticeKind::LostIceberg:
    case NoticeKind::PilotTookOver:
    case NoticeKind::OnBoard:
        return NoticeRank::Warning;
    case NoticeKind::Mode:
        return NoticeRank::Note;
    }
    return NoticeRank::Note;
}

std::vector<FlightNotice> flightNotices(const FlightRecord& record, const QLocale& locale)
{
    std::vector<FlightNotice> notices;
    if (isPlannerFailing(record))
        notices.push_back(
            {.kind = NoticeKind::PlannerFailed,
             .text = sentence(record, {.kind = EventKind::PlannerFailed}, locale),
             .toolTip = FlightNotices::tr("It runs again when the next plan is needed.")});
    if (!record.inFlight())
        return notices;
    addClose(notices, record, locale);
    addWind(notices, record, locale);
    addLate(notices, record, locale);
    if (std::optional<FlightNotice> alarm = alarmNotice(record, locale))
        notices.push_back(*std::move(alarm));
    addLost(notices, record.shown());
    const std::vector<UavState>& uavs = record.shown().world.uavs;
    for (std::size_t k = 0; k < uavs.size(); ++k)
        if (const QString mode = modeText(record, uavs[k], locale); !mode.isEmpty())
            notices.push_back({.kind = NoticeKind::Mode,
                               .about = {idOf(record, static_cast<int>(k))},
                               .text = ofUav(record, static_cast<int>(k), mode)});
    return notices;
}

} // namespace berg
