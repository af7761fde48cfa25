#include "core/io/import/scenario/import_scene_merge.h"

#include "core/base/angles.h"
#include "core/base/find_by_id.h"
#include "core/base/number_text.h"
#include "core/checks/validate.h"
#include "core/io/import/fields/area_outline.h"
#include "core/io/import/scenario/import_icebergs.h"
#include "core/io/import/scenario/import_selection.h"
#include "core/scenario/text_checks.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

std::size_t errorCount(const Scenario& scenario)
{
    const std::vector<Issue> issues = validate(scenario);
    return static_cast<std::size_t>(
        std::count_if(issues.begin(), issues.end(),
                      [](const Issue& issue) { return issue.severity == Severity::Error; }));
}

std::optional<SceneNote> areaFault(const std::vector<Point>& corners_m)
{
    if (corners_m.empty())
        return SceneNote::AreaInParts;
    if (corners_m.size() < 3 || corners_m.size() > kMostAreaCorners)
        return SceneNote::AreaCorners;
    if (!std::all_of(corners_m.begin(), corners_m.end(), onPlane))
        return SceneNote::AreaTooFar;
    if (!isSimplePolygon(corners_m))
        return SceneNote::AreaCrossing;
    return std::nullopt;
}

/** Returns why the area of the scenario cannot be a geofence for its UAVs, or nullopt if it can. */
std::optional<SceneNote> fenceFault(const Scenario& scenario)
{
    if (scenario.area_m.size() > kMostFenceCorners)
        return SceneNote::FenceCorners;
    const bool allInside =
        std::all_of(scenario.uavs.begin(), scenario.uavs.end(), [&](const Uav& uav) {
            return insidePolygon(scenario.area_m, uav.position_m) &&
                   insidePolygon(scenario.area_m, uav.home_m.value_or(uav.position_m));
        });
    return allInside ? std::nullopt : std::optional(SceneNote::FenceOutside);
}

/** Applies the parts of one scene. */
class SettingImport
{
public:
    SettingImport(const FileScene& scene, const std::set<std::string, std::less<>>& icebergs,
                  ImportResult& result)
        : m_scene(scene)
        , m_icebergs(icebergs)
        , m_at(result.at)
        , m_scenario(result.scenario)
        , m_findings(result.scene)
        , m_frame(m_scenario.origin)
        , m_errors(errorCount(m_scenario))
    {
    }

    void take()
    {
        for (const SceneUav& uav : m_scene.uavs)
            takeUav(uav);
        if (m_scene.area)
            takeArea(*m_scene.area);
        for (const SceneArea& area : m_scene.noFly)
            takeNoFly(area);
        if (m_scene.asset)
            takeAsset(*m_scene.asset);
        m_findings.insert(m_findings.end(), m_scene.findings.begin(), m_scene.findings.end());
    }

private:
    /**
     * Makes a change if the scenario stays as valid as it was. Returns whether the change was made.
     */
    bool attempt(const std::function<void(Scenario&)>& change)
    {
        Scenario changed = m_scenario;
        change(changed);
        if (errorCount(changed) > m_errors)
            return false;
        m_scenario = std::move(changed);
        return true;
    }

    void attemptNumber(const char* name, const std::optional<double>& value,
                       const std::function<void(Scenario&, double)>& change)
    {
        if (value && !attempt([&](Scenario& scenario) { change(scenario, *value); }))
            addFinding(m_findings, SceneNote::NumberWrong,
                       std::string(name) + ' ' + numberText(*value));
    }

    void takeUav(const SceneUav& taken)
    {
        const std::optional<LatLon> home = taken.home ? taken.home : taken.start;
        const Point start_m =
            taken.start ? toCentimetre(m_frame.toPlane(*taken.start)) : Point(Point::Zero());
        const Point home_m = home ? toCentimetre(m_frame.toPlane(*home)) : start_m;
        if (!onPlane(start_m) || !onPlane(home_m)) {
            addFinding(m_findings, SceneNote::UavsTooFar);
            return;
        }
        const std::size_t row = rowFor(taken);
        if (row == kMostUavs) {
            addFinding(m_findings, SceneNote::UavsTooMany);
            return;
        }
        Uav& uav = m_scenario.uavs[row];
        if (taken.start) {
            uav.position_m = start_m;
            uav.home_m = home_m == start_m ? std::nullopt : std::optional(home_m);
        }
        if (!taken.name.empty() && taken.name != uav.id)
            uav.name = taken.name;
        takeNumbers(taken, row);
        addFinding(m_findings, SceneNote::UavsTaken);
    }

    void takeNumbers(const SceneUav& taken, std::size_t row)
    {
        attemptNumber("heading_deg", taken.heading_deg, [&](Scenario& scenario, double true_deg) {
            Uav& uav = scenario.uavs[row];
            // The heading uses the file's place: near a pole the rounding of the position would
            // turn it.
            const double north_rad =
                m_frame.trueNorth_rad(taken.start.value_or(m_frame.toGeographic(uav.position_m)));
            const double turn = (true_deg - degFromRad(north_rad)) / 360;
            uav.heading_deg = std::round(360e6 * (turn - std::floor(turn))) / 1e6;
        });
        attemptNumber("airspeed_mps", taken.airspeed_mps, [&](Scenario& scenario, double value) {
            scenario.uavs[row].spec.airspeed_mps = value;
        });
        attemptNumber("altitude_m", taken.altitude_m, [&](Scenario& scenario, double value) {
            scenario.uavs[row].spec.altitude_m = value;
        });
    }

    /**
     * Returns the index of the scenario's UAV for one of the file and gives it its id; `kMostUavs`
     * if there is no room.
     */
    std::size_t rowFor(const SceneUav& taken)
    {
        std::vector<Uav>& uavs = m_scenario.uavs;
        const auto isFree = [&](std::size_t row) { return !m_taken.contains(row); };
        std::size_t row = 0;
        while (row < uavs.size() && !(isFree(row) && uavs[row].id == taken.id))
            ++row;
        if (row == uavs.size())
            for (row = 0; row < uavs.size() && !isFree(row);)
                ++row;
        if (row == kMostUavs)
            return row;
        if (row == uavs.size()) {
            uavs.push_back(uavs.empty() ? Uav{} : Uav(uavs.front()));
            uavs.back().id = newId();
            uavs.back().name.clear();
            uavs.back().home_m.reset();
        }
        m_taken.insert(row);
        if (!taken.id.empty() && !isUavId(taken.id))
            uavs[row].id = taken.id;
        return row;
    }

    [[nodiscard]] bool isUavId(const std::string& id) const
    {
        return findById(m_scenario.uavs, id) != nullptr;
    }

    [[nodiscard]] std::string newId() const
    {
        for (std::size_t n = 1;; ++n)
            if (std::string id = "uav-" + std::to_string(n);
                !isUavId(id) && !m_icebergs.contains(id))
                return id;
    }

    /** Returns the corners of an area, or nullopt after adding a finding. */
    std::optional<std::vector<Point>> cornersOf(const SceneArea& area)
    {
        std::vector<Point> corners_m = areaOutline(area.rings, m_frame);
        for (Point& corner_m : corners_m)
            corner_m = toCentimetre(corner_m);
        if (const std::optional<SceneNote> fault = areaFault(corners_m)) {
            addFinding(m_findings, *fault);
            return std::nullopt;
        }
        return corners_m;
    }

    void takeNoFly(const SceneArea& area)
    {
        std::optional<std::vector<Point>> corners_m = cornersOf(area);
        if (!corners_m)
            return;
        const bool isTaken = attempt([&](Scenario& scenario) {
            scenario.noFly.push_back({.name = area.name,
                                      .corners_m = std::move(*corners_m),
                                      .floor_m = area.floor_m.value_or(0),
                                      .ceiling_m = area.ceiling_m});
        });
        addFinding(m_findings, isTaken ? SceneNote::NoFlyTaken : SceneNote::NoFlyUnfit);
    }

    void takeArea(const SceneArea& area)
    {
        std::optional<std::vector<Point>> corners_m = cornersOf(area);
        if (!corners_m)
            return;
        m_scenario.area_m = std::move(*corners_m);
        const std::optional<SceneNote> fault =
            area.geofence ? fenceFault(m_scenario) : std::nullopt;
        m_scenario.geofence = area.geofence && !fault;
        addFinding(m_findings, m_scenario.geofence ? SceneNote::FenceTaken : SceneNote::AreaTaken);
        if (fault)
            addFinding(m_findings, *fault);
    }

    void takeAsset(const SceneAsset& taken)
    {
        const Point place_m = m_frame.toPlane(taken.place);
        if (!attempt([&](Scenario& scenario) {
                scenario.asset = Asset{.name = taken.name, .position_m = toCentimetre(place_m)};
            })) {
            addFinding(m_findings, SceneNote::AssetTooFar);
            return;
        }
        addFinding(m_findings, SceneNote::AssetTaken);
        attemptNumber("range_m", taken.range_m,
                      [](Scenario& scenario, double value) { scenario.asset->range_m = value; });
        attemptNumber(
            "standoff_ceiling_m", taken.standoffCeiling_m,
            [](Scenario& scenario, double value) { scenario.asset->standoffCeiling_m = value; });
        attemptNumber("standoff_m", taken.standoff_m,
                      [](Scenario& scenario, double value) { scenario.asset->standoff_m = value; });
        if (!taken.velocity_mps)
            return;
        const Point exact_mps = turned(*taken.velocity_mps, m_frame.trueNorth_rad(taken.place));
        const Point velocity_mps = (exact_mps * 1e7).array().round() / 1e7;
        const double until_s = m_at && taken.time ? secondsBetween(*taken.time, *m_at) : 0;
        if (!attempt([&](Scenario& scenario) {
                scenario.asset->velocity_mps = velocity_mps;
                scenario.asset->position_m = toCentimetre(place_m + velocity_mps * until_s);
            }))
            addFinding(m_findings, SceneNote::NumberWrong,
                       "velocity_mps " + numberText(taken.velocity_mps->x()) + ' ' +
                           numberText(taken.velocity_mps->y()));
    }

    const FileScene& m_scene;
    const std::set<std::string, std::less<>>& m_icebergs;
    const std::optional<UtcTime> m_at;
    Scenario& m_scenario;
    std::vector<SceneFinding>& m_findings;
    const LocalFrame m_frame;
    const std::size_t m_errors;
    std::set<std::size_t> m_taken; ///< indices of UAVs that come from the file
};

} // namespace

void applyScene(const FileScene& scene, const std::set<std::string, std::less<>>& icebergs,
                ImportResult& result)
{
    SettingImport(scene, icebergs, result).take();
}

} // namespace berg
