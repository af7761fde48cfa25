#include "core/base/error.h"
#include "core/io/files/run_json.h"
#include "core/io/files/run_keyframe.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

std::string entry(const std::string& list, std::size_t i)
{
    return list + '[' + std::to_string(i) + ']';
}

/** Name and value of a number of a keyframe. */
using ReplayField = std::pair<std::string, double>;

/** Adds the numbers of a list, named by their index. */
template <class Numbers>
void addList(std::vector<ReplayField>& fields, const std::string& name, const Numbers& numbers)
{
    for (std::size_t i = 0; i < numbers.size(); ++i)
        fields.emplace_back(entry(name, i), numbers[i]);
}

/** Adds every number of one UAV, the most instructive differences first. */
void addFields(std::vector<ReplayField>& fields, const std::string& at, const UavState& uav)
{
    const auto add = [&](const char* name, double value) { fields.emplace_back(at + name, value); };
    add("position_m[0]", uav.pose.position_m.x());
    add("position_m[1]", uav.pose.position_m.y());
    add("psi_rad", uav.pose.psi_rad);
    add("u_radps", uav.u_radps);
    add("cross_track_m", uav.crossTrack_m);
    add("mode", static_cast<double>(uav.mode));
    add("target", uav.target.value_or(kNoIcebergInFile));
    add("last_reached", uav.lastReached.value_or(kNoIcebergInFile));
    add("flown_m", uav.flown_m);
    addList(fields, at + "guidance", guidanceNumbers(uav.guidance));
    add("run_out_m", uav.runOut_m);
    add("misses", uav.misses);
    add("aim", uav.aim ? 1.0 : 0.0);
    add("search", uav.search ? 1.0 : 0.0);
    add("aloft_s", uav.aloft_s);
    add("ground_s", uav.ground_s);
    add("withheld_s", uav.withheld_s);
    add("via_m", uav.via_m ? 1.0 : 0.0);
    add("members", static_cast<double>(uav.members.size()));
    add("members_by_s", uav.membersBy_s);
    if (uav.aim) {
        addList(fields, at + "aim", legNumbers(*uav.aim));
        add("aim[7]", uav.aim->end_s.value_or(-1));
    }
    addList(fields, at + "members", uav.members);
}

/** Returns every number of a keyframe. */
std::vector<ReplayField> fieldsOf(const WorldState& state)
{
    std::vector<ReplayField> fields;
    for (std::size_t i = 0; i < state.uavs.size(); ++i)
        addFields(fields, i == 0 ? "" : entry("other_uavs", i - 1) + '.', state.uavs[i]);
    fields.insert(fields.end(), {{"sigma_sum_m2", state.sigmaSum_m2},
                                 {"zeta_m2s", state.zeta_m2s},
                                 {"closest_m", state.closest_m.value_or(-1)},
                                 {"apart", static_cast<double>(state.unclustered.size())},
                                 {"tracks", static_cast<double>(state.tracks.size())}});
    addList(fields, "apart", state.unclustered);
    for (std::size_t i = 0; i < state.tracks.size(); ++i) {
        addList(fields, entry("tracks", i), trackNumbers(state.tracks[i]));
        fields.push_back({entry(entry("tracks", i), 17), state.tracks[i].seen_s});
    }
    return fields;
}

/** Returns the state without times of last sightings, where an older file has none. */
WorldState withoutUnrecordedTimes(WorldState state, const WorldState& recorded)
{
    for (std::size_t i = 0; i < std::min(state.tracks.size(), recorded.tracks.size()); ++i)
        if (recorded.tracks[i].seen_s < 0)
            state.tracks[i].seen_s = recorded.tracks[i].seen_s;
    return state;
}

Issue differs(std::string field, IssueId id, std::vector<IssueArgument> arguments)
{
    return {Severity::Error, std::move(field), {id, std::move(arguments)}};
}

/**
 * Compares keyframes. A long replay records keyframes at intervals of its own (`Recorder`), so some
 * keyframes of older files have no counterpart and are skipped; a flight that differs there differs
 * in all later keyframes as well.
 */
void compareKeyframes(const RunFile& recorded, const RunFile& replayed, std::vector<Issue>& issues)
{
    const auto interval = static_cast<std::int64_t>(
        std::llround(replayed.options.keyframeInterval_s / replayed.scenario.dt_s));
    const bool isThinned = replayed.keyframes.size() > 1 &&
                           replayed.keyframes[1].step > std::max<std::int64_t>(1, interval);
    auto other = replayed.keyframes.begin();
    for (std::size_t i = 0; i < recorded.keyframes.size(); ++i) {
        const WorldState& keyframe = recorded.keyframes[i];
        const std::string path = entry("keyframes", i);
        const double time_s = static_cast<double>(keyframe.step) * recorded.scenario.dt_s;
        other = std::find_if(other, replayed.keyframes.end(),
                             [&](const WorldState& state) { return state.step >= keyframe.step; });
        if (other == replayed.keyframes.end() || (!isThinned && other->step != keyframe.step)) {
            issues.push_back(differs(path, IssueId::ReplayTooShort, {time_s}));
            return;
        }
        if (*other == keyframe || (isThinned && other->step != keyframe.step))
            continue;
        const WorldState flown = withoutUnrecordedTimes(*other, keyframe);
        if (flown == keyframe)
            continue;
        const std::vector<ReplayField> left = fieldsOf(keyframe);
        const std::vector<ReplayField> right = fieldsOf(flown);
        const auto [a, b] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
        if (a == left.end() || b == right.end()) // the details of a search or path differ
            issues.push_back(differs(path, IssueId::ReplayedOther, {time_s}));
        else
            issues.push_back(differs(path + '.' + a->first, IssueId::ReplayedNumber,
                                     {time_s, a->second, b->second}));
        return;
    }
}

void comparePlans(const RunFile& recorded, const RunFile& replayed, std::vector<Issue>& issues)
{
    const auto [a, b] = std::mismatch(recorded.plans.begin(), recorded.plans.end(),
                                      replayed.plans.begin(), replayed.plans.end());
    const auto i = static_cast<std::size_t>(a - recorded.plans.begin());
    if (a == recorded.plans.end() && b == replayed.plans.end())
        return;
    if (a == recorded.plans.end() || b == replayed.plans.end()) {
        issues.push_back(differs("plans", IssueId::ReplayedTotal,
                                 {countOf(recorded.plans.size()), countOf(replayed.plans.size())}));
        return;
    }
    const std::string path = entry("plans", i);
    const double time_s = a->time_s;
    const auto number = [&](const char* field, const IssueArgument& before,
                            const IssueArgument& now) {
        issues.push_back(differs(path + field, IssueId::ReplayedNumber, {time_s, before, now}));
    };
    const auto other = [&](const char* field) {
        issues.push_back(differs(path + field, IssueId::ReplayedOther, {time_s}));
    };
    if (a->time_s != b->time_s)
        number(".time_s", a->time_s, b->time_s);
    else if (a->uav != b->uav)
        number(".uav", a->uav, b->uav);
    else if (a->target != b->target)
        number(".target", a->target.value_or(kNoIcebergInFile),
               b->target.value_or(kNoIcebergInFile));
    else if (a->clusters != b->clusters)
        other(".clusters");
    else
        other(a->order == b->order ? ".legs" : ".order");
}

void compareMetrics(const RunFile& recorded, const RunFile& replayed, std::vector<Issue>& issues)
{
    const auto compare = [&](const std::string& field, double a, double b) {
        if (a != b)
            issues.push_back(differs(field, IssueId::ReplayedTotal, {a, b}));
    };
    compare("flown_until_s", recorded.flownUntil_s, replayed.flownUntil_s);
    compare("metrics.zeta_m2s", recorded.metrics.zeta_m2s, replayed.metrics.zeta_m2s);
    compare("metrics.visits", recorded.metrics.visits, replayed.metrics.visits);
    compare("metrics.replans", recorded.metrics.replans, replayed.metrics.replans);
    compare("metrics.flown_m", recorded.metrics.flown_m, replayed.metrics.flown_m);
}

} // namespace

RunFile runOf(const Mission& mission)
{
    RunFile run{.scenario = mission.scenario(),
                .options = mission.options(),
                .flownUntil_s = mission.simulation().time_s(),
                .interventions = mission.interventions(),
                .fixes = mission.poseTracks().until(mission.simulation().time_s()),
                .plans = {},
                .keyframes = {},
                .metrics = mission.metrics()};
    for (const Simulation& keyframe : mission.recorder().keyframes())
        run.keyframes.push_back(keyframe.state());
    for (const PlanEvent& plan : mission.plans())
        run.plans.push_back({.time_s = plan.time_s,
                             .uav = plan.uav,
                             .target = plan.target,
                             .order = plan.order,
                             .clusters = plan.clusters,
                             .legs = plan.legs});
    return run;
}

Mission replay(const RunFile& run, const std::stop_token& stop,
               const std::function<void(double)>& onProgress, SampleSink sink)
{
    Mission mission(run.scenario, run.options);
    mission.restoreFixes(run.fixes);
    if (sink)
        mission.streamSamplesTo(std::move(sink));
    for (std::size_t i = 0; i < run.interventions.size(); ++i) {
        if (mission.advance(run.interventions[i].time_s, stop, onProgress) ==
            AdvanceStatus::Cancelled)
            return mission;
        try {
            mission.intervene(run.interventions[i]);
        } catch (const Error& error) { // the mission does not know the index of the intervention
            std::vector<Issue> issues = error.issues();
            for (Issue& issue : issues)
                issue.field = entryPath("interventions", i) + '.' + issue.field;
            throw Error(error.code(), error.subject(), std::move(issues));
        }
    }
    mission.advance(run.flownUntil_s, stop, onProgress);
    return mission;
}

std::vector<Issue> compareRun(const RunFile& recorded, const RunFile& replayed)
{
    std::vector<Issue> issues;
    compareKeyframes(recorded, replayed, issues);
    comparePlans(recorded, replayed, issues);
    compareMetrics(recorded, replayed, issues);
    if (!issues.empty() && recorded.options.timeLimit_s)
        issues.push_back({Severity::Warning, "options.time_limit_s", {IssueId::ReplayByClock}});
    return issues;
}

} // namespace berg
