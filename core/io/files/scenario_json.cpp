#include "core/io/files/scenario_json.h"

#include "core/io/files/scenario_parts.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/validate.h"

#include <set>

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-scenario";

constexpr std::array<Named<FovShape>, 3> kFovShapeNames{{
    {FovShape::Body, "body"},
    {FovShape::North, "north"},
    {FovShape::Disk, "disk"},
}};

constexpr std::array<Named<ObserverModel>, 2> kObserverNames{{
    {ObserverModel::Simple, "simple"},
    {ObserverModel::Kalman, "kalman"},
}};

constexpr std::array<Named<SearchPattern>, 3> kSearchNames{{
    {SearchPattern::None, "none"},
    {SearchPattern::Square, "square"},
    {SearchPattern::Sector, "sector"},
}};

template <class Io>
void addPlanner(Io& io, Held<Io, Scenario>& scenario)
{
    const PlannerSettings standard;
    auto& planner = scenario.planner;
    io.addChoice("policy", planner.policy, kPolicyNames);
    io.add("tau", planner.tau);
    io.addChoice("route", planner.route, kRouteNames, standard.route);
    io.addChoice("backend", planner.backend, kBackendNames, standard.backend);
    io.addChoice("formulation", planner.formulation, kFormulationNames, standard.formulation);
    io.addOlder("latency_s", scenario.planningTime_s);
    io.addUnless("planning_delay_s", scenario.planningTime_s, 0.0);
    io.addOptional("reach_radius_m", scenario.reachRadius_m);
    io.addChoice("fov_shape", scenario.fovShape, kFovShapeNames, FovShape::Body);
    io.addUnless("clusters", scenario.clusters, false);
}

template <class Io>
void addObserver(Io& io, Held<Io, ObserverSpec>& observer)
{
    const ObserverSpec standard;
    io.addChoice("model", observer.model, kObserverNames);
    io.addUnless("position_sd_m", observer.positionSd_m, standard.positionSd_m);
    io.addUnless("interval_s", observer.interval_s, standard.interval_s);
    io.addUnless("detection", observer.detection, standard.detection);
    io.addChoice("search", observer.search, kSearchNames, standard.search);
}

template <class Io>
void addMembers(Io& io, Held<Io, Scenario>& scenario)
{
    const Point still = Point::Zero();
    io.add("name", scenario.name);
    io.addUnless("notes", scenario.notes, {});
    io.addPart("origin", scenario.originExtraJson, false, [&scenario](auto& part) {
        part.add("latitude_deg", scenario.origin.latitude_deg);
        part.add("longitude_deg", scenario.origin.longitude_deg);
    });
    io.addUnless("start_utc", scenario.startUtc, {});
    io.add("duration_s", scenario.duration_s);
    io.addSeed(scenario.seed);
    io.add("dt_s", scenario.dt_s);
    io.add("noise", scenario.noise);
    io.addUnless("wind_mps", scenario.wind_mps, still);
    io.addUnless("current_mps", scenario.current_mps, still);
    io.addCorners(scenario.area_m, false);
    io.addUnless("geofence", scenario.geofence, false);
    io.addList("no_fly", scenario.noFly, kMostNoFlyAreas, false);
    io.addList("airspace", scenario.airspace, kMostAirspaceAreas, false);
    io.addObject("operation", scenario.operation);
    io.addUnless("separation_m", scenario.separation_m, Scenario().separation_m);
    io.addList("uavs", scenario.uavs, kMostUavs, true);
    io.addList("icebergs", scenario.icebergs, kMostIcebergs, true);
    io.addObject("asset", scenario.asset);
    io.addObject("weather", scenario.weather);
    io.addObject("ground_station", scenario.groundStation);
    io.addPart("observer", scenario.observerExtraJson, scenario.observer == ObserverSpec{},
               [&scenario](auto& part) { addObserver(part, scenario.observer); });
    io.addPart("planner", scenario.plannerExtraJson, false,
               [&scenario](auto& part) { addPlanner(part, scenario); });
}

/** Gives entries without id the name of their row, or the next free one when that is taken. */
template <class Entry>
void nameByRow(std::vector<Entry>& entries, const Json* list, const std::string& prefix,
               std::set<std::string>& taken)
{
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Json& value = (*list)[i];
        if (value.is_object() && value.contains("id"))
            continue;
        std::string id = prefix + std::to_string(i + 1);
        for (std::size_t n = entries.size() + 1; taken.contains(id); ++n)
            id = prefix + std::to_string(n);
        taken.insert(id);
        entries[i].id = std::move(id);
    }
}

void nameUnnamed(Scenario& scenario, ObjectReader& object)
{
    std::set<std::string> taken;
    for (const Uav& uav : scenario.uavs)
        taken.insert(uav.id);
    for (const Iceberg& iceberg : scenario.icebergs)
        taken.insert(iceberg.id);
    nameByRow(scenario.uavs, object.find("uavs"), "uav-", taken);
    nameByRow(scenario.icebergs, object.find("icebergs"), "berg-", taken);
}

/** Adds what is wrong for this use, except about members already known to be unreadable. */
void addFindings(const Scenario& scenario, ObjectReader& object, ScenarioUse use)
{
    if (!object.isObject())
        return;
    for (Issue& issue : use == ScenarioUse::Flying ? validate(scenario) : unreadable(scenario)) {
        std::string path = object.path("") + issue.field;
        if (issue.severity == Severity::Error && !object.faults().has(path))
            object.faults().add(std::move(path), std::move(issue.reason));
    }
}

} // namespace

Scenario readScenario(ObjectReader& object, ScenarioUse use)
{
    Scenario scenario;
    checkFormat(object, kFormat);
    MemberReader io(object);
    addMembers(io, scenario);
    scenario.extraJson = object.unknown();
    nameUnnamed(scenario, object);
    addFindings(scenario, object, use);
    return scenario;
}

std::string scenarioText(const Scenario& scenario, int indent)
{
    MemberWriter io(indent);
    io.add("format", kFormat);
    io.add("version", 1);
    addMembers(io, scenario);
    io.addExtra(scenario.extraJson);
    return io.inLines(indent);
}

Scenario scenarioFromJson(std::string_view text, const std::string& subject, ScenarioUse use,
                          const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson file = parseJson(text, budget);
    requireFormat(file, kFormat, subject);
    ObjectReader object(file.root, "", file.faults);
    Scenario scenario = readScenario(object, use);
    file.faults.throwIfAny(subject);
    return scenario;
}

std::string scenarioToJson(const Scenario& scenario)
{
    return scenarioText(scenario, 0) + '\n';
}

Scenario loadScenario(const std::string& path, ScenarioUse use)
{
    return scenarioFromJson(readFile(path), path, use);
}

} // namespace berg
