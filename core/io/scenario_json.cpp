#include "core/io/scenario_json.h"

#include "core/io/atomic_file.h"
#include "core/io/scenario_parts.h"
#include "core/scenario/validate.h"

#include <algorithm>
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

/** A position may not be left out: a wrong default would be flown without notice. */
Point readPosition(ObjectReader& object)
{
    const Json* value = object.need("position_m");
    return value == nullptr ? Point(Point::Zero()) : object.point("position_m", Point::Zero());
}

Uav readUav(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Uav uav;
    uav.id = object.text("id");
    uav.name = object.text("name");
    uav.position_m = readPosition(object);
    uav.heading_deg = object.number("heading_deg", uav.heading_deg);
    uav.spec.airspeed_mps = object.number("airspeed_mps", uav.spec.airspeed_mps);
    uav.spec.maxBank_deg = object.number("max_bank_deg", uav.spec.maxBank_deg);
    uav.fov_m = object.point("fov_m", uav.fov_m);
    uav.spec.altitude_m = object.number("altitude_m", uav.spec.altitude_m);
    // No member means no limit, which memory writes as 0; a file that says 0 is mistaken.
    uav.spec.endurance_s =
        object.number("endurance_s", 0, Limits{.low = 0, .high = 1e9, .above = true});
    if (object.find("home_m") != nullptr)
        uav.home_m = object.point("home_m", uav.position_m);
    uav.turnaround_s = object.number("turnaround_s", uav.turnaround_s);
    uav.spec.autopilot_s = object.number("autopilot_s", uav.spec.autopilot_s);
    uav.extraJson = object.unknown();
    return uav;
}

/** Both lists of the recorded track; what they must hold is up to `validate`. */
void readTrack(const Json& value, const std::string& path, Faults& faults, Iceberg& iceberg)
{
    ObjectReader object(value, path, faults);
    const bool whole = object.need("time_s") != nullptr && object.need("position_m") != nullptr;
    const Json* times = object.array("time_s");
    const Json* places = object.array("position_m");
    iceberg.trackExtraJson = object.unknown();
    if (!whole || times == nullptr || places == nullptr)
        return;
    if (times->empty())
        faults.add(object.path("time_s"), "must have at least 2 entries");
    for (std::size_t i = 0; i < times->size(); ++i)
        if (const auto time_s = numberOf((*times)[i], entryPath(object.path("time_s"), i), faults))
            iceberg.track.time_s.push_back(*time_s);
    for (std::size_t i = 0; i < places->size(); ++i)
        if (const auto place_m =
                pointOf((*places)[i], entryPath(object.path("position_m"), i), faults))
            iceberg.track.position_m.push_back(*place_m);
    // With an entry missing the rest does not fit together: nothing more is said about it.
    if (iceberg.track.time_s.size() != times->size() ||
        iceberg.track.position_m.size() != places->size())
        iceberg.track = {};
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
    scenario.planningTime_s = object.number("latency_s", scenario.planningTime_s);
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

std::vector<Point> readArea(ObjectReader& object)
{
    std::vector<Point> area_m;
    const Json* value = object.array("area_m");
    if (value == nullptr)
        return area_m;
    if (value->size() < 3 || value->size() > kMostAreaCorners) {
        object.faults().add(object.path("area_m"),
                            "must have from 3 to " + std::to_string(kMostAreaCorners) +
                                " corners, not " + std::to_string(value->size()));
        return area_m;
    }
    for (std::size_t i = 0; i < value->size(); ++i) {
        const std::string path = entryPath(object.path("area_m"), i);
        const std::optional<Point> corner = pointOf((*value)[i], path, object.faults());
        if (!corner)
            return {}; // a shape with a corner missing is not worth checking
        area_m.push_back(*corner);
    }
    return area_m;
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
        object.faults().add(path, "must hold at most " + std::to_string(most) + " entries, not " +
                                      std::to_string(list->size()));
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

/** Adds what `validate` finds, except about members already known to be unreadable. */
void addFindings(const Scenario& scenario, ObjectReader& object)
{
    if (!object.isObject())
        return;
    for (Issue& issue : validate(scenario)) {
        std::string path = object.path("") + issue.field;
        if (issue.severity == Severity::Error && !object.faults().has(path))
            object.faults().add(std::move(path), std::move(issue.message));
    }
}

std::string uavText(const Uav& uav)
{
    const Uav standard;
    JsonObject object;
    object.add("id", uav.id);
    object.addUnless("name", uav.name, standard.name);
    object.add("position_m", uav.position_m);
    object.add("heading_deg", uav.heading_deg);
    object.addUnless("airspeed_mps", uav.spec.airspeed_mps, standard.spec.airspeed_mps);
    object.addUnless("max_bank_deg", uav.spec.maxBank_deg, standard.spec.maxBank_deg);
    object.addUnless("fov_m", uav.fov_m, standard.fov_m);
    object.addUnless("altitude_m", uav.spec.altitude_m, standard.spec.altitude_m);
    object.addUnless("endurance_s", uav.spec.endurance_s, 0.0);
    if (uav.home_m)
        object.add("home_m", *uav.home_m);
    object.addUnless("turnaround_s", uav.turnaround_s, standard.turnaround_s);
    object.addUnless("autopilot_s", uav.spec.autopilot_s, 0.0);
    object.addExtra(uav.extraJson);
    return object.inLine();
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
    object.addUnless("latency_s", scenario.planningTime_s, 0.0);
    if (scenario.reachRadius_m)
        object.add("reach_radius_m", *scenario.reachRadius_m);
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

std::string trackText(const Iceberg& iceberg)
{
    JsonObject object;
    object.addText("time_s", jsonArrayOf(iceberg.track.time_s));
    object.addText("position_m", jsonArrayOf(iceberg.track.position_m));
    object.addExtra(iceberg.trackExtraJson);
    return object.inLine();
}

/** Text of each entry of a list. */
template <class Entry>
std::vector<std::string> textsOf(const std::vector<Entry>& entries,
                                 std::string (*text)(const Entry&))
{
    std::vector<std::string> texts;
    texts.reserve(entries.size());
    std::transform(entries.begin(), entries.end(), std::back_inserter(texts), text);
    return texts;
}

} // namespace

Asset readAsset(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Asset asset;
    asset.name = object.text("name");
    asset.position_m = readPosition(object);
    asset.velocity_mps = object.point("velocity_mps", asset.velocity_mps);
    asset.range_m = object.number("range_m", asset.range_m);
    asset.gain = object.number("gain", asset.gain);
    asset.alarm_m = object.number("alarm_m", asset.alarm_m);
    asset.extraJson = object.unknown();
    return asset;
}

std::string assetText(const Asset& asset)
{
    JsonObject object;
    object.addUnless("name", asset.name, {});
    object.add("position_m", asset.position_m);
    object.addUnless("velocity_mps", asset.velocity_mps, Point(Point::Zero()));
    object.add("range_m", asset.range_m);
    object.add("gain", asset.gain);
    object.addUnless("alarm_m", asset.alarm_m, 0.0);
    object.addExtra(asset.extraJson);
    return object.inLine();
}

Iceberg readIceberg(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Iceberg iceberg;
    iceberg.id = object.text("id");
    iceberg.name = object.text("name");
    iceberg.position_m = readPosition(object);
    iceberg.velocity_mps = object.point("velocity_mps", iceberg.velocity_mps);
    iceberg.velocitySd_mps = object.number("velocity_sd_mps", iceberg.velocitySd_mps);
    iceberg.q_m2ps = object.number("q_m2ps", iceberg.q_m2ps);
    iceberg.sigma0_m2 = object.number("sigma0_m2", iceberg.sigma0_m2);
    iceberg.observed_s = object.number("observed_s", iceberg.observed_s);
    iceberg.appears_s = object.number("appears_s", iceberg.appears_s);
    iceberg.radius_m = object.number("radius_m", iceberg.radius_m);
    if (const Json* track = object.find("track"))
        readTrack(*track, object.path("track"), faults, iceberg);
    iceberg.extraJson = object.unknown();
    return iceberg;
}

Scenario readScenario(ObjectReader& object)
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
    constexpr WholeLimits kSeedLimits{.low = 0, .high = std::int64_t{1} << 53};
    scenario.seed = object.whole("seed", scenario.seed, kSeedLimits);
    scenario.dt_s = object.number("dt_s", scenario.dt_s);
    scenario.noise = object.boolean("noise", scenario.noise);
    scenario.wind_mps = object.point("wind_mps", scenario.wind_mps);
    scenario.current_mps = object.point("current_mps", scenario.current_mps);
    scenario.area_m = readArea(object);
    scenario.geofence = object.boolean("geofence", scenario.geofence);
    scenario.uavs = readList(object, "uavs", kMostUavs, &readUav);
    scenario.icebergs = readList(object, "icebergs", kMostIcebergs, &readIceberg);
    if (const Json* value = object.find("asset"))
        scenario.asset = readAsset(*value, object.path("asset"), object.faults());
    if (const Json* value = object.find("observer"))
        readObserver(*value, scenario, object);
    if (const Json* value = object.find("planner"))
        readPlanner(*value, scenario, object);
    scenario.extraJson = object.unknown();
    nameUnnamed(scenario, object);
    addFindings(scenario, object);
    return scenario;
}

std::string icebergText(const Iceberg& iceberg)
{
    const Iceberg standard;
    JsonObject object;
    object.add("id", iceberg.id);
    object.addUnless("name", iceberg.name, standard.name);
    object.add("position_m", iceberg.position_m);
    object.add("velocity_mps", iceberg.velocity_mps);
    object.addUnless("velocity_sd_mps", iceberg.velocitySd_mps, standard.velocitySd_mps);
    object.addUnless("q_m2ps", iceberg.q_m2ps, standard.q_m2ps);
    object.add("sigma0_m2", iceberg.sigma0_m2);
    object.addUnless("observed_s", iceberg.observed_s, standard.observed_s);
    object.addUnless("appears_s", iceberg.appears_s, standard.appears_s);
    object.addUnless("radius_m", iceberg.radius_m, standard.radius_m);
    if (!iceberg.track.empty())
        object.addText("track", trackText(iceberg));
    object.addExtra(iceberg.extraJson);
    return object.inLine();
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
    object.addText("uavs", jsonLines(textsOf(scenario.uavs, &uavText), indent + 1));
    object.addText("icebergs", jsonLines(textsOf(scenario.icebergs, &icebergText), indent + 1));
    if (scenario.asset)
        object.addText("asset", assetText(*scenario.asset));
    if (scenario.observer != ObserverSpec{} || !scenario.observerExtraJson.empty())
        object.addText("observer", observerText(scenario));
    object.addText("planner", plannerText(scenario));
    object.addExtra(scenario.extraJson);
    return object.inLines(indent);
}

Scenario scenarioFromJson(std::string_view text, const std::string& subject)
{
    ParsedJson file = parseJson(text, subject);
    requireFormat(file, kFormat, subject);
    ObjectReader object(file.root, "", file.faults);
    Scenario scenario = readScenario(object);
    file.faults.throwIfAny(subject);
    return scenario;
}

std::string scenarioToJson(const Scenario& scenario)
{
    return scenarioText(scenario, 0) + '\n';
}

Scenario loadScenario(const std::string& path)
{
    return scenarioFromJson(readFile(path), path);
}

void saveScenario(const Scenario& scenario, const std::string& path)
{
    writeFileAtomically(path, scenarioToJson(scenario));
}

} // namespace berg
