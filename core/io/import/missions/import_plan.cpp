#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/io/import/fields/json_members.h"
#include "core/io/import/missions/import_mission.h"
#include "core/io/import/missions/mission_readers.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

constexpr WholeLimits kMavNumbers{.low = 0, .high = 65535};
constexpr std::size_t kParams = 7;
constexpr std::size_t kLatitude = 4; ///< index among the params; longitude and altitude follow
constexpr std::int64_t kVtolTakeOff = 84;
constexpr std::int64_t kVtolTransition = 3000;
constexpr std::string_view kToFixedWing = "4"; ///< first param of such a transition

/** Returns a number as its text; empty for null, which means none. */
std::string memberText(const Json& value, const std::string& path, Faults& faults)
{
    if (value.is_null())
        return {};
    return numberOf(value, path, faults) ? jsonText(value) : std::string();
}

/** Whether the shape is an inclusion, which is the default. */
bool isInclusion(const Json& shape)
{
    const Json* inclusion = memberOf(&shape, "inclusion");
    return inclusion == nullptr || *inclusion != false;
}

/** Whether MAV_TYPE `type` is a type that only hovers. */
bool isMultirotor(double type)
{
    constexpr std::array<double, 8> kTypes{
        2 /* QUADROTOR */,  3 /* COAXIAL */,    4 /* HELICOPTER */,   13 /* HEXAROTOR */,
        14 /* OCTOROTOR */, 15 /* TRICOPTER */, 29 /* DODECAROTOR */, 35 /* DECAROTOR */};
    return std::ranges::find(kTypes, type) != kTypes.end();
}

/** Whether MAV_TYPE `type` takes off as a multirotor and may continue as an aircraft. */
bool isVtol(double type)
{
    return type >= 19 && type <= 25;
}

/**
 * Returns a polygon for a circle of the fence: inside an inclusion, outside an exclusion. Returns
 * nullopt for a faulty circle.
 */
std::optional<std::vector<LatLon>> circleOf(const Json* circle, bool isInside)
{
    constexpr int kCorners = 36;
    const std::optional<LatLon> centre =
        placeOf(memberOf(circle, "center"), AxisOrder::LatitudeFirst);
    const std::optional<double> radius_m = numberAt(circle, "radius");
    if (!centre || !radius_m || outOfLimits(*radius_m, limits::kLength_m) || *radius_m <= 0)
        return std::nullopt;
    const LocalFrame frame(*centre);
    std::vector<LatLon> corners;
    for (int i = 0; i < kCorners; ++i)
        corners.push_back(frame.toGeographic(turned(
            {*radius_m / (isInside ? 1 : std::cos(kPi / kCorners)), 0}, 2 * kPi * i / kCorners)));
    return corners;
}

/** Adds an inclusion or exclusion; it becomes a finding if it has no corners. */
void addFenceArea(FileScene& scene, std::optional<std::vector<LatLon>> corners, bool isInside)
{
    if (corners && !corners->empty())
        scene.addArea({.rings = {std::move(*corners)}, .geofence = isInside, .isNoFly = !isInside});
    else
        addFinding(scene.findings, SceneNote::AreaUnreadable);
}

/**
 * Reads the parts of the fence that a scenario can hold: one inclusion, and exclusions. A fence of
 * version 1 is a single polygon.
 */
void readFence(const Json* fence, FileScene& scene)
{
    if (const Json* polygon = arrayOf(fence, "polygon"); polygon && !polygon->empty())
        addFenceArea(scene, placesOf(polygon, AxisOrder::LatitudeFirst), true);
    if (const Json* polygons = arrayOf(fence, "polygons"))
        for (const Json& polygon : *polygons)
            addFenceArea(scene, placesOf(memberOf(&polygon, "polygon"), AxisOrder::LatitudeFirst),
                         isInclusion(polygon));
    if (const Json* circles = arrayOf(fence, "circles"))
        for (const Json& circle : *circles)
            addFenceArea(scene, circleOf(memberOf(&circle, "circle"), isInclusion(circle)),
                         isInclusion(circle));
}

/** Reads the mission of one file. */
class PlanReading
{
public:
    explicit PlanReading(const ImportText& source)
        : m_subject(source.budget.subject())
        , m_file(parseJson(source.text, source.budget))
        , m_places(source)
    {
    }

    SightingTable take()
    {
        ObjectReader root(m_file.root, {}, m_file.faults);
        if (isBareMission(root)) {
            readMission(m_file.root, {});
        } else {
            requirePlan(root);
            readFence(root.find("geoFence"), m_places.scene());
            m_rally = arrayOf(root.find("rallyPoints"), "points");
            if (const Json* mission = root.need("mission"))
                readMission(*mission, "mission");
        }
        m_file.faults.throwIfAny(m_subject);
        return m_places.take();
    }

private:
    /** Whether the file dates from before plans, when a mission was a file of its own. */
    static bool isBareMission(ObjectReader& root)
    {
        const Json* type = root.find("fileType");
        return type == nullptr ? root.find("MAV_AUTOPILOT") != nullptr : *type == "Mission";
    }

    void requirePlan(ObjectReader& root)
    {
        const Json* type = root.find("fileType");
        if (type == nullptr || *type != "Plan")
            throw Error(ErrorCode::WrongFormat, m_subject,
                        {{Severity::Error, "fileType", {IssueId::NotFormat, {"Plan"}}}});
        const double version = root.number("version", 1);
        if (version != 1)
            throw Error(ErrorCode::UnsupportedVersion, m_subject,
                        {{Severity::Error, "version", {IssueId::UnknownVersion, {version, 1}}}});
    }

    void readMission(const Json& value, const std::string& path)
    {
        ObjectReader mission(value, path, m_file.faults);
        if (mission.find("plannedHomePosition") != nullptr)
            readHome(mission);
        readRally();
        const Json* items = mission.neededArray("items");
        if (items == nullptr)
            return;
        for (std::size_t i = 0; i < items->size(); ++i)
            readItem((*items)[i], memberPath(path, "items[" + std::to_string(i) + ']'), i + 1);
        if (const std::optional<double> speed_mps = numberAt(&value, speedName(value)))
            m_places.setCruise(*speed_mps);
    }

    /** Returns the member with the speed that QGroundControl plans with. */
    [[nodiscard]] const char* speedName(const Json& mission) const
    {
        const double type = numberAt(&mission, "vehicleType").value_or(0);
        const bool hovers = isMultirotor(type) || (isVtol(type) && !m_hasTransition);
        return hovers && memberOf(&mission, "hoverSpeed") != nullptr ? "hoverSpeed" : "cruiseSpeed";
    }

    /**
     * Sets the landing place to a single rally point; of several, it would depend on where the UAV
     * is.
     */
    void readRally()
    {
        const std::size_t count = m_rally == nullptr ? 0 : m_rally->size();
        const std::optional<LatLon> place =
            count == 1 ? placeOf(&m_rally->front(), AxisOrder::LatitudeFirst) : std::nullopt;
        if (place)
            m_places.setRally(*place);
        else
            for (std::size_t i = 0; i < count; ++i)
                addFinding(m_places.scene().findings, SceneNote::RallyPoints);
    }

    void readHome(ObjectReader& mission)
    {
        const Json* given = mission.find("plannedHomePosition");
        const Json* item = memberOf(given, "coordinate"); // form of version 1
        const Json* home = item != nullptr ? item : mission.array("plannedHomePosition");
        if (home == nullptr)
            return;
        const std::string path = mission.path("plannedHomePosition");
        if (home->size() < 2)
            m_file.faults.add(path, {IssueId::LeastEntries, {2}});
        else
            m_places.setHome({.latitude = memberText((*home)[0], path + "[0]", m_file.faults),
                              .longitude = memberText((*home)[1], path + "[1]", m_file.faults),
                              .altitude = home->size() > 2 && (*home)[2].is_number()
                                              ? jsonText((*home)[2])
                                              : std::string()});
    }

    void readItem(const Json& value, const std::string& path, std::size_t line)
    {
        ObjectReader item(value, path, m_file.faults);
        if (!item.isObject())
            return;
        const std::string type = item.text("type");
        if (type == "SimpleItem" || type == "missionItem")
            readSimple(item, line);
        else if (type == "ComplexItem" || type == "complexItem")
            readComplex(item, line);
        else
            m_file.faults.add(item.path("type"), {IssueId::NotOneOf, {"SimpleItem, ComplexItem"}});
    }

    /**
     * Returns the seven numbers of an item. Items of older versions have four, or each by its name,
     * and a place.
     */
    std::optional<std::array<std::string, kParams>> paramsOf(ObjectReader& item)
    {
        std::array<std::string, kParams> texts;
        const Json* place = item.find("coordinate");
        const std::size_t ownParams = place == nullptr ? kParams : kLatitude;
        const auto take = [&](const Json* list, const char* name, std::size_t first,
                              std::size_t count) {
            const std::string path = item.path(name);
            if (!list->is_array() || list->size() != count) {
                m_file.faults.add(path, {IssueId::EntryCount, {countOf(count), entriesOf(*list)}});
                return false;
            }
            for (std::size_t i = 0; i < count; ++i)
                texts[first + i] =
                    memberText((*list)[i], path + '[' + std::to_string(i) + ']', m_file.faults);
            return true;
        };
        if (place != nullptr && !take(place, "coordinate", kLatitude, kParams - kLatitude))
            return std::nullopt;
        if (place != nullptr && item.find("params") == nullptr) {
            for (std::size_t i = 0; i < ownParams; ++i) {
                const std::string name = "param" + std::to_string(i + 1);
                if (const Json* param = item.find(name.c_str()))
                    texts[i] = memberText(*param, item.path(name), m_file.faults);
            }
            return texts;
        }
        const Json* params = item.need("params");
        return params != nullptr && take(params, "params", 0, ownParams) ? std::optional(texts)
                                                                         : std::nullopt;
    }

    void readSimple(ObjectReader& item, std::size_t line)
    {
        const Json* number = item.need("command");
        const Json* frame = item.need("frame");
        const std::optional<std::array<std::string, kParams>> params = paramsOf(item);
        if (number == nullptr || frame == nullptr || !params)
            return;
        const std::array<std::string, kParams>& texts = *params;
        const std::int64_t command = item.whole("command", 0, kMavNumbers);
        m_hasTransition = m_hasTransition || command == kVtolTakeOff ||
                          (command == kVtolTransition && texts[0] == kToFixedWing);
        m_places.add({.line = line,
                      .command = command,
                      .frame = item.whole("frame", 0, kMavNumbers),
                      .param1 = texts[0],
                      .param2 = texts[1],
                      .latitude = texts[kLatitude],
                      .longitude = texts[kLatitude + 1],
                      .altitude = texts[kLatitude + 2]});
    }

    /**
     * Rejects patterns over an area or a line, which are not places; landing patterns are ignored.
     */
    void readComplex(ObjectReader& item, std::size_t line)
    {
        const std::string kind = item.text("complexItemType");
        if (kind != "fwLandingPattern" && kind != "vtolLandingPattern")
            m_places.reject(line, kind.empty() ? "ComplexItem" : kind);
    }

    const std::string& m_subject;
    ParsedJson m_file;
    const Json* m_rally = nullptr; ///< null if there are no rally points
    bool m_hasTransition = false;  ///< whether a VTOL flies as an aircraft
    MissionPlaces m_places;
};

} // namespace

SightingTable readPlan(const ImportText& source)
{
    return PlanReading(source).take();
}

bool isPlan(std::string_view text)
{
    const auto holds = [&](std::string_view name) {
        return text.find(name) != std::string_view::npos;
    };
    return firstOfJson(text) == '{' && holds("\"groundStation\"") &&
           (holds("\"fileType\"") || (holds("\"MAV_AUTOPILOT\"") && holds("\"items\"")));
}

} // namespace berg
