#include "widgets/print/brief_content.h"

#include "core/earth/sun.h"
#include "widgets/print/brief_warnings.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"
#include "widgets/words/policy_words.h"
#include "widgets/words/weather_words.h"

#include <algorithm>
#include <functional>
#include <iterator>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMinuteDecimals = 2;

QString startText(const ExportContent& content)
{
    if (!content.start)
        return FlightBrief::tr("Times count from the start of the run");
    const QString text = QString::fromStdString(utcText(*content.start, 0)); // 2026-05-01T12:...
    return FlightBrief::tr("Start %1 %2 UTC").arg(text.left(10), text.mid(11, 8));
}

/** "8.2 m/s from 245°" by true north at the UAV's start. */
QString windText(const ExportContent& content, const QLocale& locale)
{
    if (content.wind_mps.isZero(0))
        return FlightBrief::tr("No wind");
    const ShownUnit unit = speedUnit();
    const Point wind_mps =
        eastNorth_mps(content, content.wind_mps, content.uavs.front().uav.position_m);
    return FlightBrief::tr("%1 %2 from %3")
        .arg(fixedText(unit.fromSi(wind_mps.norm()), 1, locale), unit.name, bearingText(-wind_mps));
}

QString currentText(const ExportContent& content, const QLocale& locale)
{
    const ShownUnit unit = speedUnit();
    const Point current_mps =
        eastNorth_mps(content, content.scenario->current_mps, content.uavs.front().uav.position_m);
    return FlightBrief::tr("%1 %2 towards %3")
        .arg(fixedText(unit.fromSi(current_mps.norm()), 2, locale), unit.name,
             bearingText(current_mps));
}

QString icebergsText(const ExportContent& content)
{
    const std::vector<bool> visited = visitedIcebergs(content);
    std::size_t all = 0; // includes visited icebergs that have left since
    for (std::size_t i = 0; i < visited.size(); ++i)
        all += visited[i] || content.icebergs[i].isListed ? std::size_t{1} : std::size_t{0};
    return FlightBrief::tr("%1 of %2").arg(std::ranges::count(visited, true)).arg(all);
}

/** Interval on one day: "10:59 to 19:40", "all day", "not on this day". */
QString spanText(const SunSpan& span)
{
    const auto clock = [](SunTime time) {
        return QString::fromStdString(utcText(time, 0)).mid(11, 5);
    };
    if (span.begin && span.end)
        return FlightBrief::tr("%1 to %2").arg(clock(*span.begin), clock(*span.end));
    if (span.begin)
        return FlightBrief::tr("from %1").arg(clock(*span.begin));
    if (span.end)
        return FlightBrief::tr("until %1").arg(clock(*span.end));
    return span.isAboveAtNoon ? FlightBrief::tr("all day") : FlightBrief::tr("not on this day");
}

/** Sun, civil twilight and declination at the first UAV's start; without a date only the latter. */
std::vector<BriefFact> placeFacts(const ExportContent& content, const QLocale& locale)
{
    std::vector<BriefFact> facts;
    const LatLon place = content.frame.toGeographic(content.uavs.front().uav.position_m);
    if (content.start) {
        facts.push_back({FlightBrief::tr("Sun up, UTC"),
                         spanText(sunSpan(*content.start, place, kSunrise_deg))});
        facts.push_back({FlightBrief::tr("Civil twilight, UTC"),
                         spanText(sunSpan(*content.start, place, kCivilTwilight_deg))});
    }
    if (const auto declination_deg = briefDeclination_deg(content))
        facts.push_back({shownUnits().north == NorthForm::Model
                             ? FlightBrief::tr("Declination, WMM2025")
                             : FlightBrief::tr("Declination"),
                         declinationText(*declination_deg, locale)});
    return facts;
}

/** Verdict on the weather along the printed paths. */
QString weatherFact(const ExportContent& content, const QLocale& locale)
{
    const Scenario& scenario = *content.scenario;
    std::vector<std::vector<FlightPlace>> flights(scenario.uavs.size());
    for (const ExportUav& uav : content.uavs) {
        std::vector<FlightPlace>& flight = flights.at(uav.row);
        flight.push_back({.time_s = uav.start_s, .position_m = uav.uav.position_m});
        for (const Visit& visit : uav.visits)
            if (visit.time_s > flight.back().time_s)
                flight.push_back({.time_s = visit.time_s, .position_m = visit.position_m});
    }
    return weatherText(scenario, weatherAlong(scenario, flights), locale);
}

std::vector<BriefFact> flightFacts(const ExportContent& content, const QLocale& locale)
{
    PathTotals total;
    for (const ExportUav& uav : content.uavs) {
        const PathTotals path = pathTotals(uav);
        total.length_m += path.length_m;
        total.time_s = std::max(total.time_s, path.time_s);
        total.end_s = std::max(total.end_s, path.end_s);
    }
    std::vector<BriefFact> facts{{FlightBrief::tr("Wind, true"), windText(content, locale)}};
    if (!content.scenario->current_mps.isZero(0))
        facts.push_back({FlightBrief::tr("Current, true"), currentText(content, locale)});
    if (hasWeatherLimits(*content.scenario))
        facts.push_back({FlightBrief::tr("Weather and limits"), weatherFact(content, locale)});
    facts.push_back({content.what == ExportScope::Track ? FlightBrief::tr("Distance")
                                                        : FlightBrief::tr("This sortie"),
                     distanceText(total.length_m, locale)});
    // The duration of a track includes time on the ground between sorties.
    facts.push_back({content.what == ExportScope::Track ? FlightBrief::tr("Duration")
                                                        : FlightBrief::tr("Time of flight"),
                     clockText(total.time_s)});
    facts.push_back({content.start ? FlightBrief::tr("End, UTC") : FlightBrief::tr("End"),
                     briefClock(content, total.end_s)});
    std::ranges::move(placeFacts(content, locale), std::back_inserter(facts));
    return facts;
}

std::vector<BriefFact> planningFacts(const ExportContent& content, const QLocale& locale)
{
    return {{FlightBrief::tr("Icebergs"), icebergsText(content)},
            {FlightBrief::tr("Planned by"), policyText(content.planner, locale)},
            {content.what == ExportScope::Track ? FlightBrief::tr("Last plan")
                                                : FlightBrief::tr("Order of visits"),
             planWords(content, locale)}};
}

/** A column of the table of UAVs. */
struct UavColumn
{
    QString caption;
    std::function<QString(const ExportUav&)> text;
};

/** Columns of every fleet. */
std::vector<UavColumn> commonColumns(const ExportContent& content, const QLocale& locale)
{
    return {
        {FlightBrief::tr("UAV"), [](const ExportUav& uav) { return printable(titleOf(uav.uav)); }},
        {FlightBrief::tr("Altitude"),
         [&locale](const ExportUav& uav) { return heightText(uav.uav.spec.altitude_m, locale); }},
        {FlightBrief::tr("Airspeed"),
         [&locale](const ExportUav& uav) {
             return speedText(uav.uav.spec.airspeed_mps, locale, 3);
         }},
        {FlightBrief::tr("Turn radius"),
         [&locale](const ExportUav& uav) {
             return distanceText(turnRadius_m(uav.uav.spec), locale, 3, DistanceUnit::Metric);
         }},
        {FlightBrief::tr("Acceptance radius"),
         [&locale](const ExportUav& uav) {
             return distanceText(uav.reach_m, locale, 3, DistanceUnit::Metric);
         }},
        {FlightBrief::tr("Home"), [&content, &locale](const ExportUav& uav) {
             return placeText(content.frame.toGeographic(uav.home_m), kMinuteDecimals, locale);
         }}};
}

void addOwnTotals(std::vector<UavColumn>& columns, ExportScope what, const QLocale& locale)
{
    columns.push_back(
        {FlightBrief::tr("Icebergs"), [](const ExportUav& uav) {
             return QString::number(std::ranges::count_if(
                 uav.visits, [](const Visit& visit) { return visit.iceberg.has_value(); }));
         }});
    columns.push_back(
        {what == ExportScope::Track ? FlightBrief::tr("Distance") : FlightBrief::tr("This sortie"),
         [&locale](const ExportUav& uav) {
             return distanceText(pathTotals(uav).length_m, locale);
         }});
    columns.push_back({FlightBrief::tr("Time"),
                       [](const ExportUav& uav) { return clockText(pathTotals(uav).time_s); }});
}

QString timeOrNone(const std::optional<double>& time_s)
{
    return time_s ? marginText(*time_s) : u"–"_s;
}

std::vector<QStringList> rowsOf(const std::vector<UavColumn>& columns, const ExportContent& content)
{
    std::vector<QStringList> rows(1 + content.uavs.size());
    for (const UavColumn& column : columns) {
        rows.front() << column.caption;
        for (std::size_t uav = 0; uav < content.uavs.size(); ++uav)
            rows[uav + 1] << column.text(content.uavs[uav]);
    }
    return rows;
}

/** Rows of endurance, reserve, margin at home and time without radio contact; empty if endurance
 * is unlimited and there is no ground station. */
std::vector<QStringList> sortieRows(const ExportContent& content)
{
    const bool isPlanned = content.what != ExportScope::Track;
    const auto addLimited = [](std::vector<UavColumn>& columns, const QString& caption,
                               const auto& time_s) {
        columns.push_back({caption, [time_s](const ExportUav& uav) {
                               return timeOrNone(uav.uav.spec.endurance_s > 0
                                                     ? std::optional<double>(time_s(uav))
                                                     : std::nullopt);
                           }});
    };
    const auto outlook = [&content](const ExportUav& uav) {
        return sortieOutlook(*content.scenario, uav.uav, plannedPath(content, uav));
    };
    std::vector<UavColumn> columns{
        {FlightBrief::tr("UAV"), [](const ExportUav& uav) { return printable(titleOf(uav.uav)); }}};
    if (std::ranges::any_of(content.uavs,
                            [](const ExportUav& uav) { return uav.uav.spec.endurance_s > 0; })) {
        addLimited(columns,
                   content.now_s > 0 ? FlightBrief::tr("Endurance left")
                                     : FlightBrief::tr("Endurance"),
                   [](const ExportUav& uav) { return uav.uav.spec.endurance_s; });
        addLimited(columns, FlightBrief::tr("Climb and landing"), [](const ExportUav& uav) {
            return uav.uav.spec.climb_s + uav.uav.spec.landing_s;
        });
        addLimited(columns, FlightBrief::tr("Reserve"),
                   [](const ExportUav& uav) { return reserve_s(uav.uav.spec); });
        if (isPlanned) {
            addLimited(columns, FlightBrief::tr("Home, above the reserve"),
                       [outlook](const ExportUav& uav) { return *outlook(uav).margin_s; });
            addLimited(columns, FlightBrief::tr("In 1 flight of 20"),
                       [&content](const ExportUav& uav) {
                           return *lowMargin_s(uav.uav, plannedPath(content, uav));
                       });
        }
    }
    if (isPlanned && std::ranges::any_of(
                         content.uavs, [](const ExportUav& uav) { return uav.slot_s.has_value(); }))
        columns.push_back({FlightBrief::tr("Recovery slot"), [&content](const ExportUav& uav) {
                               return uav.slot_s ? briefClock(content, *uav.slot_s) : u"–"_s;
                           }});
    if (content.scenario->groundStation && isPlanned)
        columns.push_back({FlightBrief::tr("Out of radio range"), [outlook](const ExportUav& uav) {
                               return clockText(outlook(uav).noContact_s);
                           }});
    return columns.size() > 1 ? rowsOf(columns, content) : std::vector<QStringList>();
}

std::vector<QStringList> uavRows(const ExportContent& content, const QLocale& locale)
{
    std::vector<UavColumn> columns = commonColumns(content, locale);
    if (content.options.loiterTurns > 0)
        columns.insert(columns.end() - 1,
                       {FlightBrief::tr("Loiter turns"), [&content](const auto&) {
                            return QString::number(content.options.loiterTurns);
                        }});
    if (areDistinguished(content.uavs))
        addOwnTotals(columns, content.what, locale);
    return rowsOf(columns, content);
}

QString footText(ExportScope what)
{
    return what == ExportScope::Track
               ? FlightBrief::tr(
                     "Positions are WGS 84. Icebergs drift: each is listed where it was when "
                     "reached. Courses and distances are over ground.")
               : FlightBrief::tr("Positions are WGS 84. Icebergs drift: each is listed where it is "
                                 "expected at arrival. Courses and distances are over ground.");
}

} // namespace

BriefContent briefContent(const ExportContent& content, const QLocale& locale)
{
    BriefContent brief{.title = pageTitle(content),
                       .about = pathsText(content),
                       .start = startText(content),
                       .origin =
                           FlightBrief::tr("Origin %1")
                               .arg(placeText(content.frame.origin(), kMinuteDecimals, locale)),
                       .flight = flightFacts(content, locale),
                       .planning = planningFacts(content, locale),
                       .uavs = uavRows(content, locale),
                       .sorties = sortieRows(content),
                       .weather = briefWeather(content, locale),
                       .captions = briefCaptions(content),
                       .routes = {},
                       .warnings = briefWarnings(content, locale),
                       .notes = printable(content.scenario->notes),
                       .foot = footText(content.what)};
    brief.warnings = brief.weather.warnings + brief.warnings;
    for (std::size_t uav = 0; uav < content.uavs.size(); ++uav)
        if (BriefRoute route = briefRoute(content, uav, locale); route.rows.size() > 1)
            brief.routes.push_back(std::move(route));
    if (brief.routes.empty())
        brief.routes.push_back(briefRoute(content, 0, locale));
    return brief;
}

} // namespace berg
