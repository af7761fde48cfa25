#include "widgets/panels/plan/plan_rows.h"

#include "core/base/angles.h"
#include "core/checks/drift_advice.h"
#include "core/mission/planned_visits.h"
#include "core/permit/daylight.h"
#include "core/scenario/utc_time.h"
#include "core/sim/leg_flight.h"
#include "widgets/theme/declination.h"
#include "widgets/words/object_names.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

PlanForecast forecastOf(const MissionSnapshot& now, const Scenario& scenario)
{
    OrdersByUav orders = ordersOf(now);
    for (std::size_t uav = 0; uav < orders.size(); ++uav)
        if (!now.world.uavs[uav].isPlanned())
            orders[uav].clear();
    return forecastPlan(forecastStart(now), orders, std::max(0.0, scenario.duration_s - now.time_s),
                        now.plan->uavs.front().clusters);
}

/** Returns the row of an iceberg with its present values. */
PlanRow rowOf(const MissionSnapshot& now, IcebergIndex iceberg)
{
    const std::size_t index = toIndex(iceberg);
    return {.id = now.icebergs[index].id,
            .name = shownName(now.icebergs[index]),
            .sigma_m2 = now.world.tracks[index].sigma_m2,
            .isAssigned = index < now.assigned.size() && now.assigned[index]};
}

/** Computes the courses of straight legs of one scenario. */
class CourseFinder
{
public:
    explicit CourseFinder(const Scenario& scenario)
        : m_frame(scenario.origin), m_start(parseUtc(scenario.startUtc))
    {
    }

    [[nodiscard]] std::optional<LegCourse> courseOf(const Point& from_m, const Point& to_m,
                                                    double leg_s) const
    {
        const Point leg_m = to_m - from_m;
        if (leg_s <= 0 || leg_m.isZero(0))
            return std::nullopt;
        const LatLon from = m_frame.toGeographic(from_m);
        return LegCourse{.true_deg = headingFromPsi(std::atan2(leg_m.y(), leg_m.x()) -
                                                    m_frame.trueNorth_rad(from)),
                         .declination_deg = shownDeclination_deg(from, m_start),
                         .groundSpeed_mps = leg_m.norm() / leg_s};
    }

private:
    LocalFrame m_frame;
    std::optional<UtcTime> m_start;
};

std::vector<PlanRow> straightRows(const MissionSnapshot& now, const RouteForecast& route,
                                  const SensorSpec& sensor)
{
    std::vector<PlanRow> rows;
    for (const ForecastVisit& visit : route.visits) {
        PlanRow& row = rows.emplace_back(rowOf(now, visit.iceberg));
        row.number = static_cast<int>(rows.size());
        row.leg_m = visit.leg_m;
        row.arrival_s = visit.arrival_s;
        row.arrivalSigma_m2 = visit.arrivalSigma_m2;
        row.chance = chanceInView(sensor, std::sqrt(visit.arrivalSigma_m2), visit.spread_m);
    }
    return rows;
}

/** Adds the courses to the rows of a route that begins at `from_m`. */
void addCourses(std::vector<PlanRow>& rows, const RouteForecast& route, Point from_m,
                const CourseFinder& finder)
{
    double before_s = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ForecastVisit& visit = route.visits[k];
        rows[k].course =
            finder.courseOf(std::exchange(from_m, visit.place_m), visit.place_m,
                            visit.arrival_s - std::exchange(before_s, visit.arrival_s));
    }
}

void leaveUnseen(PlanRow& row)
{
    row.isSeen = false;
    row.leg_m = row.arrival_s = row.arrivalSigma_m2 = 0;
    row.chance.reset();
    row.course.reset();
}

/** Clears the times of icebergs after the return home, which belong to later sorties. */
void leaveForNextSortie(std::vector<PlanRow>& rows, const UavPlan& plan)
{
    const int flown = plan.thisSortie.value_or(static_cast<int>(rows.size()));
    for (PlanRow& row : rows)
        if (row.number > flown)
            leaveUnseen(row);
}

/**
 * Ends the section with the run, in `left_s`. Legs after the end are not summed: long orders would
 * reach their last icebergs days later, far away.
 */
void endWithRun(PlanSection& section, double left_s)
{
    double before_s = 0;
    const auto takeUnfinished = [&](double leg_m, double arrival_s) {
        section.unfinished = {.leg_m = leg_m * (left_s - before_s) / (arrival_s - before_s),
                              .arrival_s = left_s};
    };
    for (PlanRow& row : section.rows) {
        if (!row.isSeen)
            continue;
        if (row.arrival_s <= left_s) {
            before_s = row.arrival_s;
            continue;
        }
        if (!section.unfinished)
            takeUnfinished(row.leg_m, row.arrival_s);
        leaveUnseen(row);
    }
    if (!section.returns || section.returns->arrival_s <= left_s)
        return;
    if (!section.unfinished)
        takeUnfinished(section.returns->leg_m, section.returns->arrival_s);
    section.returns.reset();
}

/**
 * Adds a row for each lost iceberg that the plan searches for; it is in no order until it is found.
 */
void addSearches(std::vector<PlanRow>& rows, const MissionSnapshot& now, const UavPlan& plan)
{
    std::map<IcebergIndex, PlanRow> byIceberg;
    for (PlannedSearch search : plan.outlook->searches) {
        if (search.time_s <= now.time_s)
            continue;
        search.time_s -= now.time_s;
        PlanRow& row =
            byIceberg.try_emplace(search.iceberg, rowOf(now, search.iceberg)).first->second;
        // The iceberg is at only one of the places.
        row.chance = row.chance.value_or(0) + search.chance;
        row.searches.push_back(search);
        row.arrival_s = row.searches.front().time_s;
        row.arrivalSigma_m2 =
            now.world.tracks[toIndex(search.iceberg)].sigmaAfter_m2(row.arrival_s);
    }
    for (auto& [iceberg, row] : byIceberg)
        rows.push_back(std::move(row));
}

/** Returns whether the paths end before that time, with a margin for rounding. */
bool isBeyond(const std::vector<AimedPath>& paths, double time_s)
{
    constexpr double kRounding_s = 0.5;
    return !paths.empty() && time_s > paths.back().points.back().time_s + kRounding_s;
}

/** Returns the rows by time; icebergs that the plan does not see come last. */
std::vector<PlanRow> aimedRows(const MissionSnapshot& now, const UavPlan& plan)
{
    const std::vector<AimedPath> paths = pathsAhead(now, plan.uav);
    const std::vector<double>& sightings_s = plan.outlook->sightings_s;
    std::vector<PlanRow> rows;
    double before_m = 0;
    for (std::size_t k = 0; k < plan.order.size(); ++k) {
        const IcebergIndex iceberg = plan.order[k];
        PlanRow& row = rows.emplace_back(rowOf(now, iceberg));
        row.number = static_cast<int>(k) + 1;
        row.isSeen = k < sightings_s.size();
        if (!row.isSeen)
            continue;
        const Track& track = now.world.tracks[toIndex(iceberg)];
        row.arrival_s = std::max(0.0, sightings_s[k] - now.time_s);
        row.arrivalSigma_m2 = track.sigmaAfter_m2(row.arrival_s);
        row.isLater = isBeyond(paths, sightings_s[k]) && !plan.laterVisits.empty();
        if (row.isLater)
            continue; // its leg is not planned yet
        const double path_m = lengthUntil_m(paths, sightings_s[k]);
        row.leg_m = path_m - std::exchange(before_m, path_m);
    }
    addSearches(rows, now, plan);
    std::ranges::stable_sort(rows, {}, [](const PlanRow& row) {
        return row.isSeen ? row.arrival_s : std::numeric_limits<double>::infinity();
    });
    return rows;
}

/** Rows beyond the aimed legs have the first visit of the patrol. */
void addLaterVisits(std::vector<PlanRow>& rows, const MissionSnapshot& now,
                    std::span<const std::vector<double>> visits)
{
    for (PlanRow& row : rows) {
        const std::optional<IcebergIndex> iceberg = indexOfId(now.icebergs, row.id);
        if (!iceberg)
            continue;
        const double after_s = now.time_s + (row.isSeen ? row.arrival_s : 0);
        const auto& times_s = visits[toIndex(*iceberg)];
        const auto next = std::upper_bound(times_s.begin(), times_s.end(), after_s);
        if (next != times_s.end())
            row.again_s = *next - now.time_s;
    }
}

/**
 * Returns the last leg as in exports: to home with a limited endurance, to the start of a closed
 * route.
 */
std::optional<ReturnLeg> returnOf(const MissionSnapshot& now, const Uav& uav, const UavPlan& plan)
{
    const auto seen = static_cast<std::size_t>(
        std::max(0, plan.thisSortie.value_or(static_cast<int>(plan.order.size()))));
    const bool isLimited = uav.spec.endurance_s > 0;
    const bool isClosed =
        now.planner.route == Route::Closed && traitsOf(now.planner.policy).usesTau && seen > 0;
    if (!isLimited && !isClosed)
        return std::nullopt;
    const auto place = static_cast<std::size_t>(plan.uav);
    LegFlight flight =
        flyAhead(forecastStart(now), place,
                 std::span(plan.order).first(std::min(seen, plan.order.size())), plan.clusters);
    const Point from_m = flight.position_m();
    flight.flyTo(isLimited ? uav.home_m.value_or(uav.position_m)
                           : now.world.uavs[place].pose.position_m,
                 Point::Zero());
    return ReturnLeg{.leg_m = (flight.position_m() - from_m).norm(), .arrival_s = flight.time_s()};
}

PlanOutlook aimedOutlook(const MissionSnapshot& shown, const Scenario& scenario)
{
    constexpr double kRounding_s = 1e-6; // times are multiples of the step
    const AimedOutlook& aimed = *shown.plan->uavs.front().outlook;
    PlanOutlook outlook{.zeta_m2s = shown.plan->zeta_m2s + aimed.zeta_m2s, .isAimed = true};
    if (const std::optional<RevisitGap> gap = longestGap(
            plannedVisits(shown.plans, shown.icebergs.size(), shown.time_s), shown.world.tracks)) {
        outlook.longestGap_s = gap->gap_s;
        outlook.longestGapName = shownName(shown.icebergs[toIndex(gap->iceberg)]);
    }
    if (aimed.until_s < scenario.duration_s - kRounding_s)
        outlook.until_s = aimed.until_s;
    else if (shown.time_s > aimed.until_s - kRounding_s)
        outlook.zeta_m2s = shown.metrics.zeta_m2s; // already flown
    return outlook;
}

/** Adds the bound; for a time before the end it needs the complete curve. */
void addBound(PlanOutlook& outlook, const KnownBound& bound)
{
    if (!bound.zeta_m2s || (outlook.until_s && !bound.whole))
        return;
    outlook.bound_m2s = outlook.until_s ? bound.whole->by_m2s(*outlook.until_s) : bound.zeta_m2s;
    outlook.boundShare = bound.share;
    if (bound.whole)
        outlook.isBoundFromRates =
            bound.whole->by(outlook.until_s.value_or(bound.whole->curve.back().time_s)).isFromRates;
}

QString namesOf(const IcebergList& order, const std::vector<Iceberg>& icebergs)
{
    QStringList names;
    for (const IcebergIndex iceberg : order)
        names << shownName(icebergs[toIndex(iceberg)]);
    return names.join(u", "_s);
}

/** Adds the latest change; changes of several UAVs are summed. */
void addChange(PlanOutlook& outlook, const FlightRecord& record)
{
    const std::vector<Uav>& uavs = record.scenario.uavs;
    QStringList before;
    for (int uav = 0; uav < static_cast<int>(uavs.size()); ++uav) {
        const std::optional<ShownChange> change = record.changeShown(uav);
        if (!change || (outlook.change && change->time_s < outlook.changed_s))
            continue;
        if (!change->paths.empty()) {
            outlook.change.reset(); // straight legs do not measure a former plan with paths
            return;
        }
        QString names = namesOf(change->change.before, record.shown().icebergs);
        if (const QString name = nameInFleet(uavs, uav); !name.isEmpty())
            names = u"%1: %2"_s.arg(name, names);
        if (outlook.change && change->time_s == outlook.changed_s) {
            outlook.change->distance_m += change->change.distance_m;
        } else {
            outlook.change = change->change;
            outlook.changed_s = change->time_s;
            before.clear();
        }
        before << names;
    }
    outlook.before = before.join(u"; "_s);
}

std::optional<PlanOutlook> predictedOutlook(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    if (!shown.plan || record.scenario.uavs.empty())
        return std::nullopt;
    if (shown.plan->uavs.front().outlook)
        return aimedOutlook(shown, record.scenario);
    for (std::size_t uav = 0; uav < shown.plans.size(); ++uav)
        if (const UavPlan* plan = planOf(shown, static_cast<int>(uav)); plan && !plan->legs.empty())
            return std::nullopt; // straight legs would predict too high a zeta
    PlanOutlook outlook{.zeta_m2s =
                            shown.metrics.zeta_m2s + forecastOf(shown, record.scenario).zeta_m2s};
    addChange(outlook, record);
    return outlook;
}

} // namespace

double PlanSection::length_m() const
{
    double length_m = returns ? returns->leg_m : 0;
    if (unfinished)
        length_m += unfinished->leg_m;
    for (const PlanRow& row : rows)
        length_m += row.leg_m;
    return length_m;
}

double PlanSection::lastArrival_s() const
{
    double last_s = returns ? returns->arrival_s : 0;
    if (unfinished)
        last_s = unfinished->arrival_s;
    for (const PlanRow& row : rows)
        last_s = std::max(last_s, row.arrival_s); // 0 for icebergs that are not seen
    return last_s;
}

std::vector<PlanSection> planSections(const MissionSnapshot& now, const Scenario& scenario)
{
    std::vector<PlanSection> sections;
    const PlanForecast forecast =
        now.plan && !scenario.uavs.empty() ? forecastOf(now, scenario) : PlanForecast{};
    const CourseFinder finder(scenario);
    const std::vector<std::vector<double>> visits =
        plannedVisits(now.plans, now.icebergs.size(), now.time_s);
    const std::size_t uavs = std::min(scenario.uavs.size(), now.world.uavs.size());
    for (std::size_t u = 0; u < uavs; ++u) {
        const int place = static_cast<int>(u);
        PlanSection& section = sections.emplace_back();
        section.uav = scenario.uavs[u].id;
        section.name = nameInFleet(scenario.uavs, place);
        section.place = place;
        section.isOver = now.time_s > scenario.duration_s - scenario.dt_s / 2;
        section.isPlanned = now.world.uavs[u].isPlanned();
        section.mode = now.world.uavs[u].mode;
        const UavPlan* plan = planOf(now, place);
        if (plan == nullptr || section.isOver || !section.isPlanned || u >= forecast.uavs.size())
            continue;
        section.rows =
            plan->outlook
                ? aimedRows(now, *plan)
                : straightRows(now, forecast.uavs[u],
                               {.fov_m = scenario.uavs[u].fov_m, .shape = scenario.fovShape});
        if (!plan->outlook)
            addCourses(section.rows, forecast.uavs[u], now.world.uavs[u].pose.position_m, finder);
        leaveForNextSortie(section.rows, *plan);
        addLaterVisits(section.rows, now, visits);
        if (plan->outlook)
            continue; // it ends with the run
        section.returns = returnOf(now, scenario.uavs[u], *plan);
        endWithRun(section, scenario.duration_s - now.time_s);
    }
    return sections;
}

std::vector<Issue> darkFlights(const MissionSnapshot& now, const Scenario& scenario,
                               const std::vector<PlanSection>& sections)
{
    using std::chrono::milliseconds;
    std::vector<Issue> issues;
    const std::optional<UtcTime> start = parseUtc(scenario.startUtc);
    const LocalFrame frame(scenario.origin);
    for (const PlanSection& section : sections) {
        if (!start || section.rows.empty())
            continue;
        const auto uav = static_cast<std::size_t>(section.place);
        const Uav& own = scenario.uavs[uav];
        const bool isLimited = own.spec.endurance_s > 0;
        const double landing_s =
            now.time_s + section.lastArrival_s() + (isLimited ? own.spec.landing_s : 0);
        const auto at = [&](double time_s) {
            return *start + milliseconds(std::llround(1000 * time_s));
        };
        std::ranges::move(
            daylightIssues(uav, {.takeOff = now.time_s > 0 ? std::nullopt : std::optional(*start),
                                 .landing = at(landing_s),
                                 .from = frame.toGeographic(own.position_m),
                                 .to = frame.toGeographic(own.home_m.value_or(own.position_m))}),
            std::back_inserter(issues));
    }
    return issues;
}

double planLength_m(const std::vector<PlanSection>& sections)
{
    double length_m = 0;
    for (const PlanSection& section : sections)
        length_m += section.length_m();
    return length_m;
}

double planEnd_s(const std::vector<PlanSection>& sections)
{
    double last_s = 0;
    for (const PlanSection& section : sections)
        last_s = std::max(last_s, section.lastArrival_s());
    return last_s;
}

double lastTime_s(const std::vector<PlanSection>& sections)
{
    double last_s = planEnd_s(sections);
    for (const PlanSection& section : sections)
        for (const PlanRow& row : section.rows)
            last_s = std::max(last_s, row.again_s.value_or(0));
    return last_s;
}

bool hasRows(const std::vector<PlanSection>& sections)
{
    return std::ranges::any_of(sections, [](const PlanSection& s) { return !s.rows.empty(); });
}

bool comesHome(const std::vector<PlanSection>& sections)
{
    return std::ranges::any_of(sections,
                               [](const PlanSection& s) { return s.returns.has_value(); });
}

std::optional<PlanOutlook> planOutlook(const FlightRecord& record)
{
    std::optional<PlanOutlook> outlook =
        record.isOver() ? PlanOutlook{.zeta_m2s = record.shown().metrics.zeta_m2s, .isOver = true}
                        : predictedOutlook(record);
    if (!outlook)
        return outlook;
    outlook->isInFlight = record.inFlight();
    addBound(*outlook, record.boundOfFlight());
    return outlook;
}

} // namespace berg
