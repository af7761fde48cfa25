#include "widgets/charts/uav_charts.h"

#include "core/base/angles.h"
#include "core/vehicle/uav_spec.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>

#include <functional>
#include <set>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MissionCharts
{
    Q_DECLARE_TR_FUNCTIONS(MissionCharts)
};

void addUavLines(TimeChartContent& content, const FlightRecord& record, const QString& unit,
                 const QString& column)
{
    for (std::size_t i = 0; i < record.scenario.uavs.size(); ++i) {
        const Uav& uav = record.scenario.uavs[i];
        content.lines.push_back({.label = shownName(uav),
                                 .points = {},
                                 .role = LineRole::Uav,
                                 .unit = unit,
                                 .key = QString::fromStdString(uav.id) + u'_' + column,
                                 .uav = static_cast<int>(i)});
    }
}

/** Adds one line for a single UAV, or a line per UAV of a fleet. */
void addReadings(TimeChartContent& content, const FlightRecord& record, const QString& unit,
                 const QString& column)
{
    if (areDistinguished(record.scenario.uavs))
        return addUavLines(content, record, unit, column);
    content.lines.push_back({.label = content.title,
                             .points = {},
                             .role = LineRole::Signed,
                             .unit = unit,
                             .key = column});
}

/** "Osprey 12.3 km, Gannet 11.9 km" of the newest sample; "12.3 km" for a single UAV. */
QString readings(const FlightRecord& record, const std::function<QString(const UavSample&)>& text)
{
    QStringList all;
    const std::vector<UavSample>& uavs = record.history.samples.back().uavs;
    for (std::size_t i = 0; i < uavs.size(); ++i)
        all << (nameInFleet(record.scenario.uavs, static_cast<int>(i)) + u' ' + text(uavs[i]))
                   .trimmed();
    return all.join(u", "_s);
}

/** Distinct turn rate limits. */
std::set<double> limits_degps(const FlightRecord& record)
{
    std::set<double> limits_degps;
    for (const Uav& uav : record.scenario.uavs)
        limits_degps.insert(degFromRad(maxTurnRate_radps(uav.spec)));
    return limits_degps;
}

} // namespace

void fillDistance(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Distance flown");
    const QString unit = longDistanceUnit().name;
    content.leftTitle = MissionCharts::tr("Distance through the air, %1").arg(unit);
    if (!hasFlown(record))
        return;
    const QString column =
        shownUnits().distance == DistanceUnit::Nautical ? u"flown_nmi"_s : u"flown_km"_s;
    const QString flown = distanceText(record.history.samples.back().flown_m, locale);
    content.lines.push_back({.label = flown,
                             .points = {},
                             .role = LineRole::Accumulated,
                             .name = MissionCharts::tr("Flown"),
                             .unit = unit,
                             .key = column});
    content.summary = MissionCharts::tr("Distance flown until %1: %2.")
                          .arg(content.clock.text(record.now.time_s), flown);
    if (!areDistinguished(record.scenario.uavs))
        return;
    content.lines.back().label = MissionCharts::tr("All %1").arg(flown);
    content.lines.back().name = MissionCharts::tr("All");
    addUavLines(content, record, unit, column);
    content.summary +=
        u' ' +
        readings(record, [&](const UavSample& uav) { return distanceText(uav.flown_m, locale); }) +
        u'.';
}

void fillTurnRate(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Turn rate");
    content.leftTitle = MissionCharts::tr("Turn rate, °/s, positive to the left");
    if (!hasFlown(record) || record.scenario.uavs.empty())
        return;
    const QString unit = MissionCharts::tr("°/s");
    addReadings(content, record, unit, u"turn_rate_degps"_s);
    QStringList limits;
    for (const double limit_degps : limits_degps(record)) {
        const QString limit = significantText(limit_degps, 3, locale);
        limits << limit + u' ' + unit;
        content.references.push_back(
            {.value = limit_degps, .label = MissionCharts::tr("Limit %1 °/s").arg(limit)});
        content.references.push_back({.value = -limit_degps, .label = {}});
    }
    const auto text = [&](const UavSample& uav) {
        return significantText(degFromRad(uav.u_radps), 3, locale) + u' ' + unit;
    };
    content.summary = MissionCharts::tr("Turn rate at %1: %2; limit: %3.")
                          .arg(content.clock.text(record.now.time_s), readings(record, text),
                               limits.join(u", "_s));
}

void fillCrossTrack(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    content.title = MissionCharts::tr("Cross-track error");
    content.leftTitle = MissionCharts::tr("Cross-track error, m, positive to the left");
    if (!hasFlown(record))
        return;
    const QString unit = MissionCharts::tr("m");
    addReadings(content, record, unit, u"cross_track_m"_s);
    content.references = {{.value = 0, .label = {}}};
    const auto text = [&](const UavSample& uav) {
        return significantText(uav.crossTrack_m, 3, locale) + u' ' + unit;
    };
    content.summary = MissionCharts::tr("Cross-track error at %1: %2.")
                          .arg(content.clock.text(record.now.time_s), readings(record, text));
}

std::optional<double> uavChartValue(ChartKind kind, const Sample& sample, std::size_t line)
{
    if (kind == ChartKind::Distance && line == 0)
        return longDistanceUnit().fromSi(sample.flown_m);
    const std::size_t place = kind == ChartKind::Distance ? line - 1 : line;
    if (place >= sample.uavs.size())
        return std::nullopt;
    const UavSample& uav = sample.uavs[place];
    if (kind == ChartKind::Distance)
        return longDistanceUnit().fromSi(uav.flown_m);
    return kind == ChartKind::TurnRate ? degFromRad(uav.u_radps) : uav.crossTrack_m;
}

} // namespace berg
