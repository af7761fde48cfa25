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

/** Collects name and value of every number of the members that `uavMembers` names. */
struct ReplayNumbers
{
    std::string at; ///< path of the object
    std::vector<ReplayField>& fields;

    void add(const std::string& name, double value) { fields.emplace_back(at + name, value); }
    void addList(const std::string& name, const std::vector<double>& numbers)
    {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            add(entry(name, i), numbers[i]);
    }

    template <class Value>
    void operator()(const char* name, const Value& value, const MemberRule& /*rule*/ = {})
    {
        add(name, static_cast<double>(value));
    }
    /** Adds whether there is a value, because the numbers of the other state may be missing. */
    template <class Value>
    void operator()(const char* name, const std::optional<Value>& value)
    {
        add(name, value ? 1 : 0);
        if constexpr (std::is_same_v<Value, Point>)
            if (value)
                (*this)(name, *value);
    }
    void operator()(const char* name, const std::optional<AimedLeg>& leg)
    {
        add(name, leg ? 1 : 0);
        if (!leg)
            return;
        NumberWriter io;
        legNumbers(io, *leg);
        io(leg->end_s.value_or(-1));
        addList(name, io.numbers);
    }
    void operator()(const char* name, const Point& value, const MemberRule& /*rule*/ = {})
    {
        addList(name, std::vector{value.x(), value.y()});
    }
    void operator()(const char* name, const LosGuidance& guidance)
    {
        NumberWriter io;
        guidanceNumbers(io, guidance);
        addList(name, io.numbers);
    }
    void operator()(const char* name, const IcebergList& icebergs)
    {
        add(name, static_cast<double>(icebergs.size()));
        NumberWriter io;
        for (const IcebergIndex iceberg : icebergs)
            io(iceberg);
        addList(name, io.numbers);
    }
    void operator()(const char* name, const std::optional<IcebergIndex>& iceberg)
    {
        add(name, numberInFile(iceberg));
    }
    void whole(const char* name, int value, const WholeLimits& /*limits*/) { add(name, value); }
};

/** Returns every number of a keyframe. */
std::vector<ReplayField> replayFieldsOf(const WorldState& state)
{
    std::vector<ReplayField> fields;
    for (std::size_t i = 0; i < state.uavs.size(); ++i) {
        ReplayNumbers io{i == 0 ? "" : entry("other_uavs", i - 1) + '.', fields};
        uavMembers(io, state.uavs[i]);
    }
    ReplayNumbers io{"", fields};
    io("sigma_sum_m2", state.sigmaSum_m2);
    io("zeta_m2s", state.zeta_m2s);
    io.add("closest_m", state.closest_m.value_or(-1));
    io.add("tracks", static_cast<double>(state.tracks.size()));
    io("apart", state.unclustered);
    for (std::size_t i = 0; i < state.tracks.size(); ++i) {
        NumberWriter track;
        trackNumbers(track, state.tracks[i]);
        filterNumbers(track, state.tracks[i]);
        io.addList(entry("tracks", i), track.numbers);
        io.add(entry(entry("tracks", i), 17), state.tracks[i].seen_s);
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
        const std::vector<ReplayField> left = replayFieldsOf(keyframe);
        const std::vector<ReplayField> right = replayFieldsOf(flown);
        const auto [a, b] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
        if (a == left.end() || b == right.end()) // the details of a search or path differ
            issues.push_back(differs(path, IssueId::ReplayedOther, {time_s}));
        else
            issues.push_back(differs(path + '.' + a->first, IssueId::ReplayedNumber,
                                     {time_s, a->second, b->second}));
        return;
    }
}

/** Returns what a run file has of the plans: for each UAV, the time and its part. */
std::vector<std::pair<double, UavPlan>> linesOf(const std::vector<PlanPointer>& plans)
{
    std::vector<std::pair<double, UavPlan>> lines;
    for (const PlanPointer& plan : plans)
        for (const UavPlan& own : plan->uavs)
            lines.emplace_back(plan->time_s, UavPlan{.uav = own.uav,
                                                     .order = own.order,
                                                     .clusters = own.clusters,
                                                     .legs = own.legs});
    return lines;
}

void comparePlans(const RunFile& recorded, const RunFile& replayed, std::vector<Issue>& issues)
{
    const auto left = linesOf(recorded.plans);
    const auto right = linesOf(replayed.plans);
    const auto [a, b] = std::ranges::mismatch(left, right);
    if (a == left.end() && b == right.end())
        return;
    if (a == left.end() || b == right.end()) {
        issues.push_back(differs("plans", IssueId::ReplayedTotal,
                                 {countOf(left.size()), countOf(right.size())}));
        return;
    }
    const std::string path = entry("plans", static_cast<std::size_t>(a - left.begin()));
    const double time_s = a->first;
    const UavPlan& before = a->second;
    const UavPlan& now = b->second;
    const auto number = [&](const char* field, const IssueArgument& one,
                            const IssueArgument& other) {
        issues.push_back(differs(path + field, IssueId::ReplayedNumber, {time_s, one, other}));
    };
    const auto other = [&](const char* field) {
        issues.push_back(differs(path + field, IssueId::ReplayedOther, {time_s}));
    };
    if (a->first != b->first)
        number(".time_s", a->first, b->first);
    else if (before.uav != now.uav)
        number(".uav", before.uav, now.uav);
    else if (before.target() != now.target())
        number(".target", numberInFile(before.target()), numberInFile(now.target()));
    else if (before.clusters != now.clusters)
        other(".clusters");
    else
        other(before.order == now.order ? ".legs" : ".order");
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

bool RunFile::operator==(const RunFile& other) const
{
    return scenario == other.scenario && options == other.options &&
           flownUntil_s == other.flownUntil_s && interventions == other.interventions &&
           fixes == other.fixes && linesOf(plans) == linesOf(other.plans) &&
           keyframes == other.keyframes && metrics == other.metrics;
}

RunFile runOf(const Mission& mission)
{
    RunFile run{.scenario = mission.scenario(),
                .options = mission.options(),
                .flownUntil_s = mission.simulation().time_s(),
                .interventions = mission.interventions(),
                .fixes = mission.poseTracks().until(mission.simulation().time_s()),
                .plans = mission.plans(),
                .keyframes = {},
                .metrics = mission.metrics()};
    for (const Simulation& keyframe : mission.recorder().keyframes())
        run.keyframes.push_back(keyframe.state());
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
