#include "core/io/files/run_json.h"

#include "core/base/version.h"
#include "core/checks/scenario_warnings.h"
#include "core/checks/validate.h"
#include "core/io/files/members.h"
#include "core/io/files/run_keyframe.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/file_set.h"
#include "core/scenario/flight_weather.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-run";
constexpr Limits kInterval_s{.low = 0, .high = 1e9, .above = true};

/** Names the members of the options. */
template <class Io, class O>
void optionMembers(Io io, O& options)
{
    io.whole("work_limit", options.workLimit, {.low = 1, .high = std::int64_t{1} << 53});
    io("time_limit_s", options.timeLimit_s, {.limits = kInterval_s});
    io("gap", options.gap, {.limits = Limits{.low = 0, .high = 1}});
    io("warm_start", options.warmStart);
    io("record", options.record);
    io("sample_interval_s", options.sampleInterval_s, {.limits = kInterval_s});
    io("keyframe_interval_s", options.keyframeInterval_s, {.limits = kInterval_s});
}

/** Names the members of an intervention after its time. */
template <class Io, class I>
void interventionMembers(Io io, I& change)
{
    io("tau", change.tau, {.limits = limits::kTau});
    io("policy", change.policy);
    io("wind_mps", change.wind_mps);
    io.one("asset", change.asset);
    io.one("appears", change.appears);
    io("seen", change.seen);
    io("seen_age_s", change.seenAge_s,
       {.limits = limits::kTime_s, .isWritten = change.seenAge_s != 0});
    io("removed", change.removed);
    io.part("assigned", change.assigned, [](auto members, auto& assigned) {
        members("iceberg", assigned.iceberg, {.isNeeded = true});
        members("uav", assigned.uav);
    });
    io.part("commanded", change.commanded, [](auto members, auto& commanded) {
        members("uav", commanded.uav, {.isNeeded = true});
        members("order", commanded.order);
    });
    io.part("home", change.home, [](auto members, auto& home) {
        members("uav", home.uav, {.isNeeded = true});
        members("place_m", home.place_m, {.isNeeded = true});
    });
}

/** Names the members of the metrics. */
template <class Io, class M>
void metricMembers(Io io, M& metrics)
{
    constexpr WholeLimits kCount{.low = 0, .high = kLargestCount};
    io("zeta_m2s", metrics.zeta_m2s, {.limits = kAmount});
    io.whole("visits", metrics.visits, kCount);
    io.whole("replans", metrics.replans, kCount);
    io("flown_m", metrics.flown_m, {.limits = kAmount});
}

std::string interventionText(const Intervention& intervention)
{
    JsonObject object;
    object.add("time_s", intervention.time_s);
    interventionMembers(MemberWriter{object}, intervention);
    object.addExtra(intervention.extraJson);
    return object.inLine();
}

/** Returns a line for each UAV of the plan. */
std::string planText(const PlanPointer& plan)
{
    const std::vector<std::string> lines = textsOf(plan->uavs, [&plan](const UavPlan& own) {
        JsonObject object;
        object.add("time_s", plan->time_s);
        object.addUnless("uav", own.uav, 0);
        object.add("target", numberInFile(own.target()));
        object.addText("order", jsonArrayOf(own.order));
        if (!own.clusters.empty())
            object.addText("clusters", jsonArray(textsOf(own.clusters, jsonArrayOf<IcebergIndex>)));
        if (!own.legs.empty())
            object.addText("legs", jsonArray(textsOf(own.legs, legText)));
        return object.inLine();
    });
    return joined(lines, ",\n  ");
}

/** Reads a time within the run that is not before the time of the previous entry. */
double readTime(ObjectReader& object, double flownUntil_s, double before_s)
{
    const Json* value = object.need("time_s");
    const double time_s = object.number("time_s", before_s, Limits{.low = 0, .high = flownUntil_s});
    if (value != nullptr && time_s < before_s)
        object.faults().add(object.path("time_s"), {IssueId::NotRising});
    return std::max(time_s, before_s);
}

std::vector<Intervention> readInterventions(ObjectReader& run, double flownUntil_s)
{
    double before_s = 0;
    return readEach(run, "interventions", [&](const Json& value, const std::string& path) {
        ObjectReader object(value, path, run.faults());
        Intervention intervention;
        intervention.time_s = before_s = readTime(object, flownUntil_s, before_s);
        interventionMembers(MemberReader{object}, intervention);
        intervention.extraJson = object.unknown();
        return intervention;
    });
}

/** Number of icebergs of the whole run, including those that appear in flight. */
std::size_t icebergCount(const RunFile& file)
{
    return file.scenario.icebergs.size() + static_cast<std::size_t>(std::ranges::count_if(
                                               file.interventions, [](const Intervention& change) {
                                                   return change.appears.has_value();
                                               }));
}

/** Checks that icebergs and UAVs named by interventions exist at that time. */
void checkReferences(const RunFile& file, Faults& faults)
{
    if (icebergCount(file) > kMostIcebergs)
        return; // `checkAppearing` adds the fault
    std::vector<Iceberg> there = file.scenario.icebergs;
    std::set<std::string> removed;
    for (std::size_t i = 0; i < file.interventions.size(); ++i) {
        const Intervention& change = file.interventions[i];
        if (i > 0 && file.interventions[i - 1].removed)
            removed.insert(*file.interventions[i - 1].removed);
        if (change.appears)
            there.push_back(*change.appears);
        const auto isThere = [&](const std::string& id) {
            return std::ranges::any_of(there, [&](const Iceberg& iceberg) {
                return iceberg.id == id && iceberg.appears_s <= change.time_s + file.scenario.dt_s;
            });
        };
        const auto isMonitored = [&](const std::string& id) {
            return isThere(id) && !removed.contains(id);
        };
        for (const Issue& fault : unknownNames(
                 change, file.scenario.uavs, {.isMonitored = isMonitored, .isRemovable = isThere}))
            faults.add(entryPath("interventions", i) + '.' + fault.field, fault.reason);
    }
}

/** Checks that wind and asset of interventions would be valid in a scenario. */
void checkSurroundings(const RunFile& file, Faults& faults)
{
    Scenario after;                  // without parts that are slow to check and do not change
    if (!file.scenario.uavs.empty()) // the slowest UAV decides
        after.uavs.push_back(*std::ranges::min_element(
            file.scenario.uavs, {}, [](const Uav& uav) { return uav.spec.airspeed_mps; }));
    for (std::size_t i = 0; i < file.interventions.size(); ++i) {
        const Intervention& change = file.interventions[i];
        if (!change.wind_mps && !change.asset)
            continue;
        after.wind_mps = change.wind_mps.value_or(file.scenario.wind_mps);
        after.asset = change.asset ? change.asset : file.scenario.asset;
        for (const Issue& issue : validate(after))
            if (issue.severity == Severity::Error)
                faults.add(entryPath("interventions", i) + '.' + issue.field, issue.reason);
    }
}

/** Checks that a replay records a limited amount: short intervals are for short runs. */
void checkRecording(const RunFile& file, Faults& faults)
{
    constexpr std::size_t kMostKeyframeTracks = 500'000;
    constexpr std::size_t kMostSampleTracks = 50'000'000;
    const MissionOptions usual;
    const auto bodies = static_cast<double>(file.scenario.icebergs.size() +
                                            file.scenario.uavs.size() + file.interventions.size());
    const auto check = [&](const char* field, double interval_s, double usual_s, std::size_t most) {
        const double step_s = std::max(interval_s, file.scenario.dt_s);
        const double least_s =
            std::min(usual_s, file.flownUntil_s * bodies / static_cast<double>(readLimit(most)));
        if (step_s < least_s)
            faults.add(std::string("options.") + field,
                       {IssueId::RecordTooFine, {std::ceil(least_s), interval_s, doubledLimits()}});
    };
    check("keyframe_interval_s", file.options.keyframeInterval_s, usual.keyframeInterval_s,
          kMostKeyframeTracks);
    check("sample_interval_s", file.options.sampleInterval_s, usual.sampleInterval_s,
          kMostSampleTracks);
}

/** Checks icebergs of interventions against the scenario like its own icebergs. */
void checkAppearing(const RunFile& file, Faults& faults)
{
    if (const std::size_t count = icebergCount(file); count > kMostIcebergs) {
        faults.add("interventions",
                   {IssueId::RunIcebergCount, {countOf(kMostIcebergs), countOf(count)}});
        return;
    }
    Scenario after = file.scenario;
    std::vector<std::size_t> origin; // intervention that each further iceberg comes from
    for (std::size_t i = 0; i < file.interventions.size(); ++i)
        if (file.interventions[i].appears) {
            after.icebergs.push_back(*file.interventions[i].appears);
            origin.push_back(i);
        }
    if (origin.empty())
        return;
    for (const Issue& issue : validate(after)) {
        if (issue.severity != Severity::Error)
            continue;
        for (std::size_t k = 0; k < origin.size(); ++k) {
            const std::string path = entryPath("icebergs", file.scenario.icebergs.size() + k);
            const std::string field = entryPath("interventions", origin[k]) + ".appears" +
                                      issue.field.substr(std::min(path.size(), issue.field.size()));
            if (issue.field.starts_with(path + '.') && !faults.has(field))
                faults.add(field, issue.reason);
        }
    }
}

/** Reads groups of at least two icebergs; no iceberg may be in two groups. */
std::vector<IcebergList> readClusters(ObjectReader& object, const RunContext& context)
{
    std::vector<bool> seen(context.icebergs, false);
    return readEach(object, "clusters", [&](const Json& value, const std::string& path) {
        IcebergList members = readIcebergs(value, path, object.faults(), context, seen);
        if (members.size() < 2)
            object.faults().add(path, {IssueId::LeastEntries, {2}});
        return members;
    });
}

/** Makes the order begin with the target, as in every file that Bergwatch writes. */
void startWith(IcebergList& order, std::optional<IcebergIndex> target)
{
    std::erase_if(order, [target](IcebergIndex iceberg) { return !target || iceberg == *target; });
    if (target)
        order.insert(order.begin(), *target);
}

std::vector<PlanPointer> readPlans(ObjectReader& run, const RunContext& context)
{
    double before_s = 0;
    return readEach(run, "plans", [&](const Json& value, const std::string& path) {
        ObjectReader object(value, path, run.faults());
        run.faults().take(sizeof(Plan) + sizeof(UavPlan));
        UavPlan own;
        before_s = readTime(object, context.flownUntil_s, before_s);
        own.uav = asInt(object.whole(
            "uav", 0, {.low = 0, .high = static_cast<std::int64_t>(context.uavs) - 1}));
        const std::optional<IcebergIndex> target = icebergOrNone(object, "target", context);
        std::vector<bool> seen(context.icebergs, false);
        if (const Json* order = object.find("order"))
            own.order = readIcebergs(*order, object.path("order"), run.faults(), context, seen);
        startWith(own.order, target);
        own.clusters = readClusters(object, context);
        own.legs = readEach(object, "legs", [&](const Json& leg, const std::string& at) {
            return readLeg(leg, at, run.faults(), context);
        });
        return std::make_shared<const Plan>(Plan{.time_s = before_s, .uavs = {std::move(own)}});
    });
}

std::vector<WorldState> readKeyframes(ObjectReader& run, const RunContext& context)
{
    std::optional<std::int64_t> before;
    return readEach(run, "keyframes", [&](const Json& value, const std::string& path) {
        WorldState keyframe = readKeyframe(value, path, run.faults(), context);
        if (!run.faults().has(path + ".step") && before && keyframe.step <= *before)
            run.faults().add(path + ".step", {IssueId::NotRising});
        before = keyframe.step;
        return keyframe;
    });
}

/** Returns by iceberg whether the mean of its velocity follows wind and current. */
std::vector<bool> forcedIcebergs(const RunFile& file)
{
    const std::shared_ptr<const FlightWeather> weather = weatherOf(file.scenario);
    std::vector<bool> forced;
    const auto add = [&](const Iceberg& iceberg) {
        forced.push_back(iceberg.length_m || forcingOf(weather, iceberg));
    };
    for (const Iceberg& iceberg : file.scenario.icebergs)
        add(iceberg);
    for (const Intervention& change : file.interventions)
        if (change.appears)
            add(*change.appears);
    return forced;
}

/** Limits for a run whose scenario, end and interventions have no faults. */
RunContext contextOf(const RunFile& file)
{
    const Scenario& scenario = file.scenario;
    return {.flownUntil_s = file.flownUntil_s,
            .lastStep =
                std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s)),
            .icebergsAtStart = scenario.icebergs.size(),
            .icebergs = icebergCount(file),
            .uavs = scenario.uavs.size(),
            .current_mps = scenario.current_mps,
            .forced = forcedIcebergs(file)};
}

RunFile readRun(ObjectReader& run)
{
    RunFile file;
    if (const Json* value = run.need("scenario")) {
        ObjectReader scenario(*value, run.path("scenario"), run.faults());
        file.scenario = readScenario(scenario);
    }
    if (const Json* value = run.find("options")) {
        ObjectReader options(*value, run.path("options"), run.faults());
        optionMembers(MemberReader{options}, file.options);
    }
    // The last step may end half a step after the duration.
    const double latest_s = file.scenario.duration_s + std::abs(file.scenario.dt_s);
    if (run.need("flown_until_s") != nullptr)
        file.flownUntil_s =
            run.number("flown_until_s", latest_s, Limits{.low = 0, .high = latest_s});
    if (const Json* value = run.need("metrics")) {
        ObjectReader metrics(*value, run.path("metrics"), run.faults());
        metricMembers(MemberReader{metrics}, file.metrics);
    }
    // The members below are checked against those above, which is pointless if those are faulty.
    if (!run.faults().empty())
        return file;
    file.interventions = readInterventions(run, file.flownUntil_s);
    checkSurroundings(file, run.faults());
    checkAppearing(file, run.faults());
    checkReferences(file, run.faults());
    checkRecording(file, run.faults());
    if (!run.faults().empty())
        return file;
    const RunContext context = contextOf(file);
    file.fixes = readFixes(run, context);
    file.plans = readPlans(run, context);
    file.keyframes = readKeyframes(run, context);
    return file;
}

} // namespace

void writeRun(const RunFile& run, const TextSink& put)
{
    JsonObject options;
    optionMembers(MemberWriter{options}, run.options);
    JsonObject metrics;
    metricMembers(MemberWriter{metrics}, run.metrics);
    JsonObject head;
    head.add("format", kFormat);
    head.add("version", 1);
    head.add("program", programName());
    head.addText("scenario", scenarioText(run.scenario, 1));
    head.addText("options", options.inLine());
    head.add("flown_until_s", run.flownUntil_s);
    const std::string members = head.inLines(0);
    put(std::string_view(members).substr(0, members.size() - 2)); // without the end of the object
    put(",\n \"interventions\": ");
    putJsonLines(put, run.interventions, 1, interventionText);
    if (!run.fixes.empty()) {
        put(",\n \"fixes\": ");
        putJsonLines(put, run.fixes, 1, fixText);
    }
    put(",\n \"plans\": ");
    putJsonLines(put, run.plans, 1, planText);
    put(",\n \"metrics\": " + metrics.inLine() + ",\n \"keyframes\": ");
    putJsonLines(put, run.keyframes, 1, keyframeText);
    put("\n}\n");
}

RunFile runFromJson(std::string_view text, const std::string& subject, const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson parsed = parseJson(text, budget);
    requireFormat(parsed, kFormat, subject);
    ObjectReader object(parsed.root, "", parsed.faults);
    RunFile file = readRun(object);
    parsed.faults.throwIfAny(subject);
    return file;
}

std::vector<Issue> validate(const RunFile& run)
{
    std::vector<Issue> issues = validate(run.scenario);
    const auto addHint = [&issues](const std::string& path, const std::string& extraJson) {
        if (std::optional<Issue> hint = unknownMembers(path, extraJson))
            issues.push_back(std::move(*hint));
    };
    for (std::size_t i = 0; i < run.interventions.size(); ++i) {
        const Intervention& change = run.interventions[i];
        const std::string path = entryPath("interventions", i);
        addHint(path, change.extraJson);
        if (change.asset)
            addHint(path + ".asset", change.asset->extraJson);
        if (change.appears) {
            addHint(path + ".appears", change.appears->extraJson);
            addHint(path + ".appears.track", change.appears->trackExtraJson);
        }
    }
    return issues;
}

RunFile loadRun(const std::string& path, const std::stop_token& stop)
{
    return runFromJson(readFile(path, stop), path, stop);
}

void saveRun(const RunFile& run, const std::string& path)
{
    FileSet file;
    StagedFile& staged = file.add(path);
    writeRun(run, [&staged](std::string_view piece) { staged.append(piece); });
    file.write();
}

std::string formatOf(std::string_view text, const std::string& subject, const std::stop_token& stop)
{
    constexpr std::array<std::string_view, 4> kFormats = {"bergwatch-scenario", "bergwatch-problem",
                                                          kFormat, "bergwatch-study"};
    ReadBudget budget(subject, text.size(), stop);
    const std::optional<std::string> format = rootText(text, "format", budget);
    if (format && std::ranges::find(kFormats, *format) != kFormats.end())
        return *format;
    throw Error(ErrorCode::WrongFormat, subject,
                {{Severity::Error, "format", {IssueId::NotOneOf, {joined(kFormats, ", ")}}}});
}

} // namespace berg
