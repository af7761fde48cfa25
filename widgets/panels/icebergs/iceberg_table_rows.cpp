#include "widgets/panels/icebergs/iceberg_table_rows.h"

#include "core/tracking/position_error.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/panels/plan/plan_rows.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <unordered_map>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IcebergRowText
{
    Q_DECLARE_TR_FUNCTIONS(IcebergRowText)
};

constexpr std::array kEditorNumbers{IcebergColumn::Speed,     IcebergColumn::Direction,
                                    IcebergColumn::DriftEast, IcebergColumn::DriftNorth,
                                    IcebergColumn::Sigma0,    IcebergColumn::Growth,
                                    IcebergColumn::Observed,  IcebergColumn::Appears};

// Decimals of minutes of angle.
constexpr int kAnglesInFlight = 2; ///< about 20 m, as positions run in flight

void put(IcebergTableRow& row, IcebergColumn column, std::optional<double> value)
{
    row.values[static_cast<std::size_t>(column)] = value;
}

void putApproach(IcebergTableRow& row, const std::optional<AssetApproach>& approach)
{
    if (!approach)
        return;
    put(row, IcebergColumn::AssetDistance, approach->closest.distance_m);
    put(row, IcebergColumn::AssetTime, approach->closest.time_s);
    row.ringEntry_s = approach->entry_s;
}

void putPlace(IcebergTableRow& row, const LocalFrame& frame, const Point& position_m)
{
    put(row, IcebergColumn::East, position_m.x());
    put(row, IcebergColumn::North, position_m.y());
    const LatLon place = frame.toGeographic(position_m);
    put(row, IcebergColumn::Latitude, place.latitude_deg);
    put(row, IcebergColumn::Longitude, place.longitude_deg);
}

/** Returns the arrival times of all orders, by id. */
std::unordered_map<std::string, double> arrivalsOf(const FlightRecord& record)
{
    std::unordered_map<std::string, double> arrivals_s;
    for (const PlanSection& section : planSections(record.shown(), record.scenario))
        for (const PlanRow& row : section.rows)
            if (row.isSeen) // otherwise it is on a later sortie
                arrivals_s.emplace(row.id, row.arrival_s);
    return arrivals_s;
}

/** Returns how often each iceberg was reached until the time shown, by index. */
std::vector<int> visitsOf(const FlightRecord& record)
{
    std::vector<int> visits(record.shown().icebergs.size());
    const std::size_t count = record.eventsShown();
    for (std::size_t i = 0; i < count; ++i) {
        const MissionEvent& event = record.history.events[i];
        if (event.kind == EventKind::Reached && event.iceberg &&
            toIndex(*event.iceberg) < visits.size())
            ++visits[toIndex(*event.iceberg)];
    }
    return visits;
}

/** Place of an iceberg in the orders. */
struct PlaceInOrder
{
    int place = 1; ///< from 1
    int uav = 0;   ///< UAV of the order
};

/** Returns the places of the icebergs, by index; nullopt for an iceberg in no order. */
std::vector<std::optional<PlaceInOrder>> placesOf(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    std::vector<std::optional<PlaceInOrder>> places(shown.icebergs.size());
    if (record.isOver()) // nothing of the plan is left
        return places;
    const OrdersByUav orders = ordersOf(shown);
    for (std::size_t uav = 0; uav < orders.size(); ++uav)
        for (std::size_t k = 0; k < orders[uav].size(); ++k)
            places[toIndex(orders[uav][k])] =
                PlaceInOrder{.place = static_cast<int>(k) + 1, .uav = static_cast<int>(uav)};
    return places;
}

IcebergStanding stateOf(const MissionSnapshot& shown, IcebergIndex iceberg, bool isInOrder)
{
    const Track& track = shown.world.tracks[toIndex(iceberg)];
    if (track.left)
        return IcebergStanding::Left;
    if (!shown.active[toIndex(iceberg)])
        return IcebergStanding::Later;
    if (track.inView)
        return IcebergStanding::InView;
    if (track.status == TrackStatus::GivenUp)
        return IcebergStanding::GivenUp;
    if (track.status == TrackStatus::Lost)
        return std::ranges::any_of(shown.world.uavs,
                                   [&](const UavState& uav) {
                                       return uav.search && uav.search->iceberg == iceberg;
                                   })
                   ? IcebergStanding::Searched
                   : IcebergStanding::Lost;
    const bool isFlownTo = std::ranges::any_of(shown.world.uavs, [&](const UavState& uav) {
        return uav.target == iceberg && uav.mode != FlightMode::Search;
    });
    if (isFlownTo)
        return IcebergStanding::Target;
    return isInOrder ? IcebergStanding::Planned : IcebergStanding::Unplanned;
}

/** Returns the sort key of a state; smaller is further up. */
double stateOrder(IcebergStanding state, const std::optional<PlaceInOrder>& place)
{
    constexpr double kBehindAll = 1e6;
    if (state == IcebergStanding::Planned)
        return place.value().place;
    const int fromPlanned = static_cast<int>(state) - static_cast<int>(IcebergStanding::Planned);
    return fromPlanned < 0 ? fromPlanned + 1 : kBehindAll + fromPlanned - 1;
}

QString orDash(const QString& text)
{
    return text.isEmpty() ? u"–"_s : text;
}

/** Returns the time to the closest approach; "> 1 h" if it still approaches at the horizon. */
QString approachTimeText(double time_s)
{
    if (time_s <= 0)
        return IcebergRowText::tr("now");
    return time_s < kApproachHorizon_s ? clockText(time_s) : IcebergRowText::tr("> 1 h");
}

/** Returns a position without its unit, to about 0.1 m, or 1 m in flight. */
QString positionText(double position_m, bool inFlight, const QLocale& locale)
{
    const bool isNautical = shownUnits().distance == DistanceUnit::Nautical;
    const int decimals = inFlight ? 0 : 1;
    return fixedText(distanceUnit().fromSi(position_m), decimals + (isNautical ? 2 : 0), locale);
}

QString cellNumberText(const IcebergTableRow& row, double value, IcebergColumn column,
                       bool inFlight, const QLocale& locale)
{
    switch (column) {
    case IcebergColumn::East:
    case IcebergColumn::North:
        return positionText(value, inFlight, locale);
    case IcebergColumn::AssetDistance:
        return positionText(value, true, locale);
    case IcebergColumn::AssetTime:
        return approachTimeText(value);
    case IcebergColumn::Speed:
    case IcebergColumn::DriftEast:
    case IcebergColumn::DriftNorth:
        return fixedText(speedUnit().fromSi(value), 2, locale);
    case IcebergColumn::Direction:
        return u"%1"_s.arg(static_cast<int>(std::lround(value)) % 360, 3, 10, QChar(u'0'));
    case IcebergColumn::Sigma:
    case IcebergColumn::Sigma0:
    case IcebergColumn::Growth:
        return significantText(value, 3, locale);
    case IcebergColumn::Radius95:
        return radius95Text(row.value(IcebergColumn::Sigma).value_or(0), locale);
    case IcebergColumn::Unseen:
        return clockText(value);
    case IcebergColumn::Arrival:
        return row.times.text(value);
    case IcebergColumn::Visits:
    case IcebergColumn::Observed:
    case IcebergColumn::Appears:
        return fixedText(value, 0, locale);
    case IcebergColumn::Latitude:
        return latitudeText(value, inFlight ? kAnglesInFlight : kPlaceDecimals, locale);
    case IcebergColumn::Longitude:
        return longitudeText(value, inFlight ? kAnglesInFlight : kPlaceDecimals, locale);
    case IcebergColumn::Name:
    case IcebergColumn::State:
    case IcebergColumn::Uav:
        break;
    }
    return {};
}

QString nameToolTip(const IcebergTableRow& row, const QLocale& locale)
{
    QString text =
        IcebergRowText::tr("%1 (id %2)").arg(row.label(), QString::fromStdString(row.id));
    if (row.ringEntry_s)
        text += u'\n' + ringEntryText(row.label(), *row.ringEntry_s, locale, row.times);
    return text;
}

} // namespace

std::vector<IcebergTableRow> editorRows(const Scenario& scenario)
{
    std::vector<IcebergTableRow> rows;
    rows.reserve(scenario.icebergs.size());
    const LocalFrame frame(scenario.origin);
    const MissionClock clock = clockOf(scenario);
    for (const Iceberg& iceberg : scenario.icebergs) {
        IcebergTableRow& row = rows.emplace_back();
        row.id = iceberg.id;
        row.name = QString::fromStdString(iceberg.name);
        row.times = {.clock = clock};
        for (const IcebergColumn column : kEditorNumbers)
            put(row, column, icebergNumber(iceberg, column));
        putPlace(row, frame, iceberg.position_m);
        putApproach(row, approachOf(scenario, iceberg));
    }
    return rows;
}

std::vector<IcebergTableRow> flightRows(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    const std::unordered_map<std::string, double> arrivals_s = arrivalsOf(record);
    const std::vector<int> visits = visitsOf(record);
    const std::vector<std::optional<PlaceInOrder>> places = placesOf(record);
    std::vector<IcebergTableRow> rows;
    rows.reserve(shown.icebergs.size());
    const LocalFrame frame(record.scenario.origin);
    const TimesAhead times = timesOf(record);
    for (const IcebergIndex index : IcebergRange(shown.icebergs.size())) {
        const std::size_t i = toIndex(index);
        const Iceberg& iceberg = shown.icebergs[i];
        const Track& track = shown.world.tracks[i];
        IcebergTableRow& row = rows.emplace_back();
        row.id = iceberg.id;
        row.name = QString::fromStdString(iceberg.name);
        row.times = times;
        const std::optional<PlaceInOrder>& place = places[i];
        row.state = stateOf(shown, index, place.has_value());
        put(row, IcebergColumn::State, stateOrder(row.state, place));
        if (place) {
            row.uav = nameInFleet(record.scenario.uavs, place->uav);
            put(row, IcebergColumn::Uav, place->uav);
        }
        if (row.state == IcebergStanding::Later)
            put(row, IcebergColumn::Appears, iceberg.appears_s);
        if (!shown.active[i] || track.left)
            continue;
        putApproach(row, approachOf(shown, index));
        putPlace(row, frame, record.estimate_m(index));
        put(row, IcebergColumn::Sigma, track.sigma_m2);
        put(row, IcebergColumn::Radius95, radius95_m(track.sigma_m2));
        const double since_s = std::max(track.seen_s, iceberg.appears_s);
        put(row, IcebergColumn::Unseen, track.inView ? 0 : shown.time_s - since_s);
        if (const auto arrival = arrivals_s.find(iceberg.id); arrival != arrivals_s.end())
            put(row, IcebergColumn::Arrival, arrival->second);
        put(row, IcebergColumn::Visits, visits[i]);
        put(row, IcebergColumn::Speed, track.velocity_mps.norm());
    }
    return rows;
}

QString stateText(const IcebergTableRow& row)
{
    switch (row.state) {
    case IcebergStanding::InView:
        return IcebergRowText::tr("in view");
    case IcebergStanding::Target:
        return row.uav.isEmpty() ? IcebergRowText::tr("target")
                                 : IcebergRowText::tr("target of %1").arg(row.uav);
    case IcebergStanding::Planned: {
        const QString place = QString::number(row.value(IcebergColumn::State).value_or(0));
        return row.uav.isEmpty() ? IcebergRowText::tr("number %1 in the order").arg(place)
                                 : IcebergRowText::tr("number %1 of %2").arg(place, row.uav);
    }
    case IcebergStanding::Searched:
        return IcebergRowText::tr("lost, being searched for");
    case IcebergStanding::Lost:
        return IcebergRowText::tr("lost");
    case IcebergStanding::GivenUp:
        return IcebergRowText::tr("search abandoned");
    case IcebergStanding::Left:
        return IcebergRowText::tr("left or removed");
    case IcebergStanding::Unplanned:
        return IcebergRowText::tr("not in the order");
    case IcebergStanding::Later:
        return IcebergRowText::tr("not appeared yet");
    }
    return {};
}

QString cellText(const IcebergTableRow& row, IcebergColumn column, bool inFlight,
                 const QLocale& locale)
{
    if (column == IcebergColumn::Name)
        return row.label();
    if (column == IcebergColumn::State)
        return stateText(row);
    if (column == IcebergColumn::Uav)
        return orDash(row.uav);
    const std::optional<double> value = row.value(column);
    return orDash(value ? cellNumberText(row, *value, column, inFlight, locale) : QString());
}

QString cellToolTip(const IcebergTableRow& row, IcebergColumn column, const QLocale& locale)
{
    const std::optional<double> value = row.value(column);
    switch (column) {
    case IcebergColumn::Name:
        return nameToolTip(row, locale);
    case IcebergColumn::AssetDistance:
    case IcebergColumn::AssetTime:
        return row.value(IcebergColumn::AssetTime) == kApproachHorizon_s
                   ? IcebergRowText::tr(
                         "It is still approaching after one hour; this is its distance then.")
                   : QString();
    case IcebergColumn::State:
        return row.state == IcebergStanding::Later
                   ? IcebergRowText::tr("Appears at %1")
                         .arg(row.times.clock.text(row.value(IcebergColumn::Appears).value_or(0)))
                   : QString();
    case IcebergColumn::Sigma:
    case IcebergColumn::Sigma0:
        return value ? IcebergRowText::tr("%1, a standard deviation of %2 m along each axis")
                           .arg(uncertaintyText(*value, locale),
                                significantText(std::sqrt(*value), 3, locale))
                     : QString();
    case IcebergColumn::Arrival:
        return value ? row.times.toolTip(*value) : QString();
    case IcebergColumn::Appears:
        return value && *value > 0 ? row.times.clock.details(*value) : QString();
    case IcebergColumn::Direction:
        return value ? QString() : IcebergRowText::tr("It does not drift.");
    case IcebergColumn::Uav:
    case IcebergColumn::Radius95:
    case IcebergColumn::Unseen:
    case IcebergColumn::Visits:
    case IcebergColumn::East:
    case IcebergColumn::North:
    case IcebergColumn::Speed:
    case IcebergColumn::DriftEast:
    case IcebergColumn::DriftNorth:
    case IcebergColumn::Growth:
    case IcebergColumn::Observed:
    case IcebergColumn::Latitude:
    case IcebergColumn::Longitude:
        break;
    }
    return {};
}

} // namespace berg
