#include "widgets/flight/compared_run.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kRounding_s = 1e-6; // times are whole steps

struct ComparedRunText
{
    Q_DECLARE_TR_FUNCTIONS(ComparedRunText)
};

Sample sampleOf(const MissionSnapshot& now)
{
    const WorldState& world = now.world;
    return {.time_s = now.time_s,
            .uavs = uavSamples(world),
            .sigmaSum_m2 = world.sigmaSum_m2,
            .zeta_m2s = world.zeta_m2s,
            .flown_m = world.flown_m()};
}

std::vector<IcebergSample> rowOf(const MissionSnapshot& now)
{
    std::vector<IcebergSample> row;
    for (std::size_t i = 0; i < now.world.tracks.size(); ++i)
        row.push_back({.sigma_m2 = now.world.tracks[i].sigma_m2,
                       .inView = now.world.tracks[i].inView,
                       .active = now.active[i]});
    return row;
}

int countUntil(const std::vector<double>& times_s, double until_s)
{
    return static_cast<int>(
        std::upper_bound(times_s.begin(), times_s.end(), until_s + kRounding_s) - times_s.begin());
}

} // namespace

ComparedRun comparedRun(const FlightRecord& record)
{
    const MissionSnapshot& now = record.now;
    ComparedRun run{.scenario = record.scenario,
                    .planner = now.planner,
                    .worldChanges = now.worldChanges,
                    .metrics = now.metrics,
                    .flown_s = now.time_s,
                    .samples = record.history.samples,
                    .icebergs = now.icebergs};
    if (run.samples.empty() || run.samples.back().time_s < now.time_s - kRounding_s) {
        // Stopped between two samples.
        std::vector<std::vector<IcebergSample>> rows = record.history.rows;
        run.samples.push_back(sampleOf(now));
        rows.push_back(rowOf(now));
        run.unseen = unseenIntervals(run.samples, rows);
    } else {
        run.unseen = unseenIntervals(run.samples, record.history.rows);
    }
    for (const PlanPointer& plan : record.history.plans)
        if (plan->isCounted)
            run.plans_s.push_back(plan->time_s);
    run.uavVisits_s.resize(record.scenario.uavs.size());
    for (const MissionEvent& event : record.history.events) {
        if (event.kind == EventKind::Reached) {
            run.visits_s.push_back(event.time_s);
            if (event.uav)
                run.uavVisits_s[static_cast<std::size_t>(*event.uav)].push_back(event.time_s);
        } else if (event.kind == EventKind::Intervention) {
            run.wasChanged = run.wasChanged || (event.changed != ChangedPart::Wind &&
                                                event.changed != ChangedPart::Asset &&
                                                event.changed != ChangedPart::Removal);
        }
    }
    return run;
}

QString runName(const ComparedRun& run, const QLocale& locale)
{
    if (!run.name.isEmpty())
        return run.name;
    const QString policy = shortPolicyText(run.planner, locale);
    const bool stopped = run.flown_s < run.scenario.duration_s - kRounding_s;
    const QString end = clockText(run.flown_s);
    if (run.wasChanged)
        return stopped ? ComparedRunText::tr("%1, changed in flight, to %2").arg(policy, end)
                       : ComparedRunText::tr("%1, changed in flight").arg(policy);
    return stopped ? ComparedRunText::tr("%1, to %2").arg(policy, end) : policy;
}

bool isSameWorld(const ScenarioWorld& a, const ScenarioWorld& b)
{
    return a == b;
}

bool isComparable(const ComparedRun& a, const ComparedRun& b)
{
    return isSameWorld(a.scenario, b.scenario) && a.worldChanges == b.worldChanges;
}

bool isSamePlanner(const PlannerSettings& a, const PlannerSettings& b)
{
    PlannerSettings other = b;
    if (!traitsOf(a.policy).usesTau)
        other.tau = a.tau;
    return a == other;
}

bool isSameRun(const ComparedRun& a, const ComparedRun& b)
{
    return isComparable(a, b) && isSamePlanner(a.scenario.planner, b.scenario.planner) &&
           isSamePlanner(a.planner, b.planner) && a.wasChanged == b.wasChanged &&
           a.flown_s == b.flown_s && a.metrics == b.metrics;
}

RunFigures figuresAt(const ComparedRun& run, double until_s)
{
    RunFigures figures{.visits = countUntil(run.visits_s, until_s),
                       .plans = countUntil(run.plans_s, until_s)};
    const auto after = std::lower_bound(
        run.samples.begin(), run.samples.end(), until_s - kRounding_s,
        [](const Sample& sample, double time_s) { return sample.time_s < time_s; });
    if (after != run.samples.end()) {
        const Sample& to = *after;
        const Sample& from = after == run.samples.begin() ? to : *(after - 1);
        const double span_s = to.time_s - from.time_s;
        const double part =
            span_s > 0 && to.time_s > until_s + kRounding_s ? (until_s - from.time_s) / span_s : 1;
        const auto between = [part](double a, double b) {
            return part == 1 ? b : std::lerp(a, b, part);
        };
        figures.zeta_m2s = between(from.zeta_m2s, to.zeta_m2s);
        figures.flown_m = between(from.flown_m, to.flown_m);
        for (std::size_t i = 0; i < to.uavs.size(); ++i)
            figures.uavs.push_back({.visits = countUntil(run.uavVisits_s.at(i), until_s),
                                    .flown_m = between(from.uavs[i].flown_m, to.uavs[i].flown_m)});
    }
    if (until_s > 0)
        figures.meanSigmaSum_m2 = figures.zeta_m2s / until_s;
    for (const std::vector<UnseenInterval>& intervals : run.unseen)
        figures.unseen.push_back(unseenTime(intervals, until_s));
    const auto longest = std::max_element(
        figures.unseen.begin(), figures.unseen.end(),
        [](const UnseenTime& a, const UnseenTime& b) { return a.longest_s < b.longest_s; });
    if (longest != figures.unseen.end() && longest->longest_s > 0)
        figures.longestUnseen = static_cast<std::size_t>(longest - figures.unseen.begin());
    return figures;
}

} // namespace berg
