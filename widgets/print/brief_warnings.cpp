#include "widgets/print/brief_warnings.h"

#include "core/checks/validate.h"
#include "core/io/export/mission_checks.h"
#include "core/permit/daylight.h"
#include "core/scenario/limits.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/print/brief_table.h"
#include "widgets/print/export_picture.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/export_text.h"
#include "widgets/words/issue_text.h"
#include "widgets/words/plan_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMostNames = 60; // names per list; more than fit on the lines

/** Scenario as exported: chosen altitudes and speeds, the present wind, printable names. */
Scenario exportedScenario(const ExportContent& content)
{
    Scenario scenario = *content.scenario;
    scenario.wind_mps = content.wind_mps;
    for (const ExportUav& uav : content.uavs) {
        UavSpec& spec = scenario.uavs.at(uav.row).spec;
        spec.altitude_m = uav.uav.spec.altitude_m;
        spec.airspeed_mps = uav.uav.spec.airspeed_mps;
    }
    for (Uav& uav : scenario.uavs)
        uav.name = printable(titleOf(uav)).toStdString();
    for (Iceberg& iceberg : scenario.icebergs)
        iceberg.name = printable(titleOf(iceberg)).toStdString();
    return scenario;
}

/** Findings of this severity; equal ones for several icebergs or UAVs are one line. */
QStringList issueLines(const Scenario& scenario, const std::vector<Issue>& issues,
                       Severity severity)
{
    QStringList texts;
    std::map<QString, std::vector<const Issue*>> alike;
    for (const Issue& issue : issues) {
        if (issue.severity != severity)
            continue;
        const QString text = issueText(issue).simplified();
        if (!alike.contains(text))
            texts << text;
        alike[text].push_back(&issue);
    }
    QStringList lines;
    for (const QString& text : texts) {
        const std::vector<const Issue*>& issuesOfText = alike[text];
        if (issuesOfText.size() == 1) {
            lines << issueLine(*issuesOfText.front(), scenario).simplified();
            continue;
        }
        QStringList names;
        for (const Issue* const issue : issuesOfText)
            names << issueOwner(*issue, scenario).simplified();
        lines << FlightBrief::tr("%1 (%2): %3")
                     .arg(text)
                     .arg(names.size())
                     .arg(names.first(std::min<qsizetype>(names.size(), kMostNames)).join(u", "_s));
    }
    return lines;
}

bool isIdle(const ExportUav& uav)
{
    return std::ranges::all_of(uav.visits, [](const Visit& visit) { return !visit.iceberg; });
}

bool visitsNothing(const ExportContent& content)
{
    return std::ranges::all_of(content.uavs, isIdle);
}

/** "Lost (2): B04, B07" for the icebergs that pass `test`; empty if none does. */
template <class Test>
QStringList namedLine(const QString& sentence, const ExportContent& content, const Test& test)
{
    QStringList names;
    int count = 0;
    for (std::size_t i = 0; i < content.icebergs.size(); ++i) {
        if (!test(i))
            continue;
        if (++count <= kMostNames)
            names << printable(titleOf(content.icebergs[i].iceberg));
    }
    if (count == 0)
        return {};
    if (count > kMostNames)
        names << u"…"_s;
    return {sentence.arg(count).arg(names.join(u", "_s))};
}

/** Icebergs in the asset's inner ring or on course for it, in order of entry. */
QStringList alarmLines(const ExportContent& content, const QLocale& locale)
{
    std::multimap<double, QString> entries;
    for (const ExportIceberg& one : content.icebergs)
        if (const auto entry_s = ringEntry_s(content, one))
            entries.emplace(*entry_s,
                            ringEntryText(printable(titleOf(one.iceberg)), *entry_s, locale));
    QStringList lines;
    for (const auto& [entry_s, line] : entries)
        lines << line;
    return lines;
}

QStringList icebergLines(const ExportContent& content)
{
    const auto is = [&content](IcebergState state) {
        return [&content, state](std::size_t i) {
            return content.icebergs[i].isListed && content.icebergs[i].state == state;
        };
    };
    QStringList lines =
        namedLine(FlightBrief::tr("Lost, not found where expected (%1): %2"), content,
                  is(IcebergState::Lost)) +
        namedLine(FlightBrief::tr("Search given up (%1): %2"), content, is(IcebergState::GivenUp));
    // Exports of one leg or of some UAVs omit icebergs intentionally.
    if (content.what == ExportScope::FirstLeg ||
        content.uavs.size() < content.scenario->uavs.size())
        return lines;
    const std::vector<bool> visited = visitedIcebergs(content);
    lines << namedLine(
        content.what == ExportScope::Track ? FlightBrief::tr("Not visited (%1): %2")
                                           : FlightBrief::tr("Not in the order (%1): %2"),
        content, [&](std::size_t i) { return content.icebergs[i].isListed && !visited[i]; });
    return lines;
}

/** Visits of a plan that miss an iceberg with a probability of 10 % or more. */
QStringList missLines(const ExportContent& content, const QLocale& locale)
{
    constexpr double kReportedBelow = 0.9;
    QStringList names;
    for (const ExportUav& uav : content.uavs)
        for (const Visit& visit : uav.visits) {
            if (!visit.iceberg)
                continue;
            double chance = 1;
            for (const IcebergIndex iceberg : icebergsOf(visit))
                chance = std::min(chance, chanceInView(content, uav, visit, iceberg).value_or(1));
            if (chance < kReportedBelow && names.size() < kMostNames)
                names << printable(titleOf(content, visit)) + u' ' + chanceText(chance, locale);
        }
    if (names.isEmpty())
        return names;
    return {
        FlightBrief::tr("Probability of being in view on arrival: %1").arg(names.join(u", "_s))};
}

/** UAVs without an iceberg while others have one. */
QStringList idleLines(const ExportContent& content)
{
    QStringList names;
    for (const ExportUav& uav : content.uavs)
        if (isIdle(uav))
            names << printable(titleOf(uav.uav));
    if (names.isEmpty() || visitsNothing(content))
        return {};
    return {FlightBrief::tr("Nothing to visit for %1").arg(names.join(u", "_s))};
}

QStringList planLines(const ExportContent& content, const QLocale& locale)
{
    if (content.what == ExportScope::Track || visitsNothing(content) || content.plan.fellBack ||
        !traitsOf(content.planner.policy).solves() ||
        content.plan.outcome.status == SolveStatus::Optimal)
        return {};
    return {
        FlightBrief::tr("The order is not proven optimal: %1.").arg(planWords(content, locale))};
}

/** Returns whether two UAVs are too close in altitude to pass each other. */
bool sharesLayer(const ExportContent& content)
{
    std::vector<double> altitudes_m;
    for (const ExportUav& uav : content.uavs)
        altitudes_m.push_back(uav.uav.spec.altitude_m);
    std::ranges::sort(altitudes_m);
    return std::ranges::adjacent_find(altitudes_m, [](double low_m, double high_m) {
               return high_m - low_m < kLayerHeight_m;
           }) != altitudes_m.end();
}

QStringList ruleLines(const ExportContent& content, const QLocale& locale)
{
    QStringList lines;
    if (const std::size_t crossing = legsThatCross(content); crossing > 0)
        lines << FlightBrief::tr("Straight legs that leave the geofence or cross a no-fly area: "
                                 "%1. The UAV flies around.")
                     .arg(crossing);
    if (content.geofence)
        lines << FlightBrief::tr("Geofence in force: stay inside the area.");
    for (const NoFlyArea& area : content.noFly)
        lines << (area.name.empty() ? FlightBrief::tr("No-fly area: %1.")
                                          .arg(heightsText(area.floor_m, area.ceiling_m, locale))
                                    : FlightBrief::tr("No-fly area %1: %2.")
                                          .arg(printable(area.name),
                                               heightsText(area.floor_m, area.ceiling_m, locale)));
    if (content.standoff)
        lines << FlightBrief::tr("Stand-off from the asset: %1, %2.")
                     .arg(distanceText(content.asset->standoff_m, locale, 3, DistanceUnit::Metric),
                          heightsText(0, content.standoff->ceiling_m, locale));
    if (content.scenario->separation_m > 0 && sharesLayer(content))
        lines << FlightBrief::tr("UAVs share an altitude layer: keep them %1 apart. They do not "
                                 "avoid each other.")
                     .arg(distanceText(content.scenario->separation_m, locale, 3,
                                       DistanceUnit::Metric));
    return lines;
}

/** Take-off (before the flight) and landing outside daylight; empty without a date. */
std::vector<Issue> darkIssues(const ExportContent& content, const ExportUav& uav)
{
    if (!content.start || isIdle(uav))
        return {};
    const auto at = [&](double time_s) {
        return *content.start + std::chrono::milliseconds(std::llround(1000 * time_s));
    };
    const double landing_s = uav.uav.spec.endurance_s > 0 ? uav.uav.spec.landing_s : 0;
    return daylightIssues(
        uav.row, {.takeOff = content.now_s > 0 ? std::nullopt : std::optional(at(uav.start_s)),
                  .landing = at(pathTotals(uav).end_s + landing_s),
                  .from = content.frame.toGeographic(uav.uav.position_m),
                  .to = content.frame.toGeographic(uav.home_m)});
}

/** Loiter turns take time that legs and arrivals do not include. */
QStringList loiterLines(const ExportContent& content, const QLocale& locale)
{
    if (content.options.loiterTurns == 0)
        return {};
    double each_s = 0;
    double all_s = 0;
    QStringList tooLong;
    for (const ExportUav& uav : content.uavs) {
        const double turns_s = content.options.loiterTurns * 2 * std::numbers::pi * uav.circle_m /
                               uav.uav.spec.airspeed_mps;
        const auto visits = std::ranges::count_if(
            uav.visits, [](const Visit& visit) { return visit.iceberg.has_value(); });
        const double own_s = turns_s * static_cast<double>(visits);
        each_s = std::max(each_s, turns_s);
        all_s = std::max(all_s, own_s);
        if (uav.uav.spec.endurance_s > 0 &&
            pathTotals(uav).time_s + own_s > usableEndurance_s(uav.uav.spec))
            tooLong << printable(titleOf(uav.uav));
    }
    QStringList lines{
        FlightBrief::tr("Times do not include the loiter turns, which add %1 at each iceberg, %2 "
                        "in total.")
            .arg(roughDurationText(each_s, locale), roughDurationText(all_s, locale))};
    if (!tooLong.isEmpty())
        lines << FlightBrief::tr("With the loiter turns the endurance is too short: %1")
                     .arg(tooLong.join(u", "_s));
    return lines;
}

/** Findings about the missions that the autopilots fly. */
QStringList missionLines(const ExportContent& content, const QLocale& locale)
{
    QStringList lines;
    for (const ExportNote& note : missionChecks(content))
        lines << FlightBrief::tr("Autopilot mission: %1.").arg(exportNoteText(note, locale));
    return lines;
}

} // namespace

std::vector<bool> visitedIcebergs(const ExportContent& content)
{
    std::vector<bool> visited(content.icebergs.size());
    for (const ExportUav& uav : content.uavs)
        for (const Visit& visit : uav.visits)
            if (visit.iceberg)
                for (const IcebergIndex index : icebergsOf(visit))
                    visited.at(toIndex(index)) = true;
    return visited;
}

PlannedPath plannedPath(const ExportContent& content, const ExportUav& uav)
{
    const UavSpec& spec = uav.uav.spec;
    PlannedPath path{.places_m = {uav.uav.position_m}, .wind_mps = content.wind_mps};
    for (const Visit& visit : uav.visits)
        if (visit.iceberg)
            path.places_m.push_back(visit.position_m);
    path.thisSortie = path.places_m.size();
    path.fence = fenceOf(*content.scenario, spec.altitude_m,
                         {.airspeed_mps = spec.airspeed_mps,
                          .limit_radps = maxTurnRate_radps(spec),
                          .wind_mps = content.wind_mps});
    return path;
}

QString planWords(const ExportContent& content, const QLocale& locale)
{
    if (visitsNothing(content))
        return FlightBrief::tr("Nothing to visit");
    if (content.plan.fellBack)
        return FlightBrief::tr("Solver limit reached; previous plan kept");
    if (traitsOf(content.planner.policy).method == PolicyMethod::OneByOne)
        return FlightBrief::tr("Chosen one iceberg at a time");
    switch (content.plan.outcome.status) {
    case SolveStatus::Optimal:
        return FlightBrief::tr("Proven optimal");
    case SolveStatus::Feasible:
        return content.plan.gap ? FlightBrief::tr("Within %1 % of optimal")
                                      .arg(gapText(*content.plan.gap, locale))
                                : FlightBrief::tr("Best order found");
    case SolveStatus::None:
        return FlightBrief::tr("Not planned by a solver");
    }
    return {};
}

QStringList briefWarnings(const ExportContent& content, const QLocale& locale)
{
    const Scenario scenario = exportedScenario(content);
    std::vector<Issue> issues = validate(scenario);
    if (content.what != ExportScope::Track)
        for (const ExportUav& uav : content.uavs) {
            const PlannedPath path = plannedPath(content, uav);
            std::ranges::move(sortieIssues(uav.row, sortieOutlook(scenario, uav.uav, path),
                                           lowMargin_s(uav.uav, path)),
                              std::back_inserter(issues));
            std::ranges::move(darkIssues(content, uav), std::back_inserter(issues));
        }
    QStringList lines;
    for (const QString& line : issueLines(scenario, issues, Severity::Error))
        lines << FlightBrief::tr("Error: %1").arg(line);
    if (content.plan.fellBack && !visitsNothing(content))
        lines << FlightBrief::tr("The planner reached its limit without an order. The UAV flies "
                                 "the rest of the previous plan, or to the nearest iceberg.");
    lines << loiterLines(content, locale) << missionLines(content, locale)
          << alarmLines(content, locale) << ruleLines(content, locale) << missLines(content, locale)
          << icebergLines(content) << issueLines(scenario, issues, Severity::Warning)
          << idleLines(content) << planLines(content, locale);
    return lines;
}

} // namespace berg
