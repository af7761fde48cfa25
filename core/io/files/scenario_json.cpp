#include "core/io/files/scenario_json.h"

#include "core/io/files/scenario_parts.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/validate.h"

#include <functional>
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

LatLon readOrigin(const Json& value, Scenario& scenario, ObjectReader& parent)
{
    ObjectReader object(value, parent.path("origin"), parent.faults());
    LatLon origin = scenario.origin;
    origin.latitude_deg = object.number("latitude_deg", origin.latitude_deg);
    origin.longitude_deg = object.number("longitude_deg", origin.longitude_deg);
    scenario.originExtraJson = object.unknown();
    return origin;
}

void readPlanner(const Json& value, Scenario& scenario, ObjectReader& parent)
{
    ObjectReader object(value, parent.path("planner"), parent.faults());
    PlannerSettings& planner = scenario.planner;
    planner.policy = object.choice("policy", planner.policy, kPolicyNames);
    planner.tau = object.number("tau", planner.tau);
    planner.route = object.choice("route", planner.route, kRouteNames);
    planner.backend = object.choice("backend", planner.backend, kBackendNames);
    planner.formulation = object.choice("formulation", planner.formulation, kFormulationNames);
    const double before_s = object.number("latency_s", scenario.planningTime_s); // in older files
    scenario.planningTime_s = object.number("planning_delay_s", before_s);
    scenario.reachRadius_m = object.optionalNumber("reach_radius_m");
    scenario.fovShape = object.choice("fov_shape", scenario.fovShape, kFovShapeNames);
    scenario.clusters = object.boolean("clusters", scenario.clusters);
    scenario.plannerExtraJson = object.unknown();
}

void readObserver(const Json& value, Scenario& scenario, ObjectReader& parent)
{
    ObjectReader object(value, parent.path("observer"), parent.faults());
    ObserverSpec& observer = scenario.observer;
    observer.model = object.choice("model", observer.model, kObserverNames);
    observer.positionSd_m = object.number("position_sd_m", observer.positionSd_m);
    observer.interval_s = object.number("interval_s", observer.interval_s);
    observer.detection = object.number("detection", observer.detection);
    observer.search = object.choice("search", observer.search, kSearchNames);
    scenario.observerExtraJson = object.unknown();
}

/** Reads a list of at most `most` entries with `readEntry(value, path, faults)`. */
template <class Entry>
std::vector<Entry> readList(ObjectReader& object, const char* member, std::size_t most,
                            Entry (*readEntry)(const Json&, const std::string&, Faults&))
{
    std::vector<Entry> entries;
    if (object.need(member) == nullptr)
        return entries;
    const Json* list = object.array(member);
    if (list == nullptr)
        return entries;
    const std::string path = object.path(member);
    if (list->size() > most) {
        object.faults().add(path, {IssueId::MostEntries, {countOf(most), countOf(list->size())}});
        return entries;
    }
    for (std::size_t i = 0; i < list->size(); ++i)
        entries.push_back(readEntry((*list)[i], entryPath(path, i), object.faults()));
    return entries;
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

std::string originText(const Scenario& scenario)
{
    JsonObject object;
    object.add("latitude_deg", scenario.origin.latitude_deg);
    object.add("longitude_deg", scenario.origin.longitude_deg);
    object.addExtra(scenario.originExtraJson);
    return object.inLine();
}

std::string plannerText(const Scenario& scenario)
{
    const PlannerSettings& planner = scenario.planner;
    const PlannerSettings standard;
    JsonObject object;
    object.add("policy", nameOf(kPolicyNames, planner.policy));
    object.add("tau", planner.tau);
    if (planner.route != standard.route)
        object.add("route", nameOf(kRouteNames, planner.route));
    if (planner.backend != standard.backend)
        object.add("backend", nameOf(kBackendNames, planner.backend));
    if (planner.formulation != standard.formulation)
        object.add("formulation", nameOf(kFormulationNames, planner.formulation));
    object.addUnless("planning_delay_s", scenario.planningTime_s, 0.0);
    object.addOptional("reach_radius_m", scenario.reachRadius_m);
    if (scenario.fovShape != FovShape::Body)
        object.add("fov_shape", nameOf(kFovShapeNames, scenario.fovShape));
    object.addUnless("clusters", scenario.clusters, false);
    object.addExtra(scenario.plannerExtraJson);
    return object.inLine();
}

std::string observerText(const Scenario& scenario)
{
    const ObserverSpec& observer = scenario.observer;
    const ObserverSpec standard;
    JsonObject object;
    object.add("model", nameOf(kObserverNames, observer.model));
    object.addUnless("position_sd_m", observer.positionSd_m, standard.positionSd_m);
    object.addUnless("interval_s", observer.interval_s, standard.interval_s);
    object.addUnless("detection", observer.detection, standard.detection);
    if (observer.search != standard.search)
        object.add("search", nameOf(kSearchNames, observer.search));
    object.addExtra(scenario.observerExtraJson);
    return object.inLine();
}

} // namespace

Scenario readScenario(ObjectReader& object, ScenarioUse use)
{
    Scenario scenario;
    (void)object.find("format");
    (void)object.find("version");
    scenario.name = object.text("name");
    scenario.notes = object.text("notes");
    if (const Json* value = object.find("origin"))
        scenario.origin = readOrigin(*value, scenario, object);
    scenario.startUtc = object.text("start_utc");
    scenario.duration_s = object.number("duration_s", scenario.duration_s);
    constexpr WholeLimits kSeedLimits{.low = 0, .high = kLargestSeed};
    scenario.seed = object.whole("seed", scenario.seed, kSeedLimits);
    scenario.dt_s = object.number("dt_s", scenario.dt_s);
    scenario.noise = object.boolean("noise", scenario.noise);
    scenario.wind_mps = object.point("wind_mps", scenario.wind_mps);
    scenario.current_mps = object.point("current_mps", scenario.current_mps);
    scenario.area_m = readCorners(object, "area_m");
    scenario.geofence = object.boolean("geofence", scenario.geofence);
    if (object.find("no_fly") != nullptr)
        scenario.noFly = readList(object, "no_fly", kMostNoFlyAreas, &readNoFlyArea);
    if (object.find("airspace") != nullptr)
        scenario.airspace = readList(object, "airspace", kMostAirspaceAreas, &readAirspaceArea);
    if (const Json* value = object.find("operation"))
        scenario.operation = readOperation(*value, object.path("operation"), object.faults());
    scenario.separation_m = object.number("separation_m", scenario.separation_m);
    scenario.uavs = readList(object, "uavs", kMostUavs, &readUav);
    scenario.icebergs = readList(object, "icebergs", kMostIcebergs, &readIceberg);
    if (const Json* value = object.find("asset"))
        scenario.asset = readAsset(*value, object.path("asset"), object.faults());
    if (const Json* value = object.find("weather"))
        scenario.weather = readWeather(*value, object.path("weather"), object.faults());
    if (const Json* value = object.find("ground_station"))
        scenario.groundStation =
            readGroundStation(*value, object.path("ground_station"), object.faults());
    if (const Json* value = object.find("observer"))
        readObserver(*value, scenario, object);
    if (const Json* value = object.find("planner"))
        readPlanner(*value, scenario, object);
    scenario.extraJson = object.unknown();
    nameUnnamed(scenario, object);
    addFindings(scenario, object, use);
    return scenario;
}

std::string scenarioText(const Scenario& scenario, int indent)
{
    const Point still = Point::Zero();
    JsonObject object;
    object.add("format", kFormat);
    object.add("version", 1);
    object.add("name", scenario.name);
    object.addUnless("notes", scenario.notes, {});
    object.addText("origin", originText(scenario));
    object.addUnless("start_utc", scenario.startUtc, {});
    object.add("duration_s", scenario.duration_s);
    object.add("seed", scenario.seed);
    object.add("dt_s", scenario.dt_s);
    object.add("noise", scenario.noise);
    object.addUnless("wind_mps", scenario.wind_mps, still);
    object.addUnless("current_mps", scenario.current_mps, still);
    if (!scenario.area_m.empty())
        object.addText("area_m", jsonArrayOf(scenario.area_m));
    object.addUnless("geofence", scenario.geofence, false);
    if (!scenario.noFly.empty())
        object.addText("no_fly", jsonLines(textsOf(scenario.noFly, &noFlyAreaText), indent + 1));
    if (!scenario.airspace.empty())
        object.addText("airspace",
                       jsonLines(textsOf(scenario.airspace, &airspaceAreaText), indent + 1));
    if (scenario.operation)
        object.addText("operation", operationText(*scenario.operation));
    object.addUnless("separation_m", scenario.separation_m, Scenario().separation_m);
    object.addText("uavs", jsonLines(textsOf(scenario.uavs, &uavText), indent + 1));
    object.addText("icebergs", jsonLines(textsOf(scenario.icebergs, &icebergText), indent + 1));
    if (scenario.asset)
        object.addText("asset", assetText(*scenario.asset));
    if (scenario.weather != Weather{})
        object.addText("weather", weatherText(scenario.weather));
    if (scenario.groundStation)
        object.addText("ground_station", groundStationText(*scenario.groundStation));
    if (scenario.observer != ObserverSpec{} || !scenario.observerExtraJson.empty())
        object.addText("observer", observerText(scenario));
    object.addText("planner", plannerText(scenario));
    object.addExtra(scenario.extraJson);
    return object.inLines(indent);
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
