#include "core/base/error.h"
#include "core/io/import/import_mission.h"
#include "core/io/import/import_readers.h"
#include "core/io/import/json_members.h"
#include "core/io/text/json_writer.h"

#include <array>

namespace berg {

namespace {

constexpr WholeLimits kMavNumbers{.low = 0, .high = 65535};
constexpr std::size_t kParams = 7;
constexpr std::size_t kLatitude = 4; ///< of the params; longitude and altitude follow

/** A number as its text; empty for null, which stands for none. */
std::string memberText(const Json& value, const std::string& path, Faults& faults)
{
    if (value.is_null())
        return {};
    return numberOf(value, path, faults) ? jsonText(value) : std::string();
}

/** Whether what is inside is where to fly; that is so unless the file says otherwise. */
bool isInclusion(const Json& shape)
{
    const Json* inclusion = memberOf(&shape, "inclusion");
    return inclusion == nullptr || *inclusion != false;
}

/** What of the fence a scenario can hold, one polygon to stay inside of and those to stay out of,
 * and what it cannot. */
void readFence(const Json* fence, FileScene& scene)
{
    if (const Json* polygons = arrayOf(fence, "polygons"))
        for (const Json& polygon : *polygons) {
            std::optional<std::vector<LatLon>> corners =
                placesOf(memberOf(&polygon, "polygon"), AxisOrder::LatitudeFirst);
            const bool isInside = isInclusion(polygon);
            if (corners && !corners->empty())
                scene.addArea(
                    {.rings = {std::move(*corners)}, .geofence = isInside, .isNoFly = !isInside});
            else
                addFinding(scene.findings, SceneNote::AreaUnreadable);
        }
    if (const Json* circles = arrayOf(fence, "circles"))
        for (std::size_t i = 0; i < circles->size(); ++i)
            addFinding(scene.findings, SceneNote::FenceCircles);
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
        requirePlan(root);
        readFence(root.find("geoFence"), m_places.scene());
        m_rally = arrayOf(root.find("rallyPoints"), "points");
        if (const Json* mission = root.need("mission"))
            readMission(*mission);
        m_file.faults.throwIfAny(m_subject);
        return m_places.take();
    }

private:
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

    void readMission(const Json& value)
    {
        ObjectReader mission(value, "mission", m_file.faults);
        if (mission.find("plannedHomePosition") != nullptr)
            readHome(mission);
        readRally();
        const Json* items = mission.neededArray("items");
        if (items == nullptr)
            return;
        for (std::size_t i = 0; i < items->size(); ++i)
            readItem((*items)[i], i);
        if (const Json* cruise = mission.find("cruiseSpeed"); cruise && cruise->is_number())
            m_places.setCruise(cruise->get<double>());
    }

    /** A single rally point is where to land; of several it depends on where the UAV is. */
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
        const Json* home = mission.array("plannedHomePosition");
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

    void readItem(const Json& value, std::size_t index)
    {
        ObjectReader item(value, "mission.items[" + std::to_string(index) + "]", m_file.faults);
        if (!item.isObject())
            return;
        const std::string type = item.text("type");
        if (type == "SimpleItem")
            readSimple(item, index + 1);
        else if (type == "ComplexItem")
            readComplex(item, index + 1);
        else
            m_file.faults.add(item.path("type"), {IssueId::NotOneOf, {"SimpleItem, ComplexItem"}});
    }

    void readSimple(ObjectReader& item, std::size_t line)
    {
        const Json* command = item.need("command");
        const Json* frame = item.need("frame");
        const Json* params = item.need("params");
        if (command == nullptr || frame == nullptr || params == nullptr)
            return;
        const std::string path = item.path("params");
        if (!params->is_array() || params->size() != kParams) {
            m_file.faults.add(path, {IssueId::EntryCount, {countOf(kParams), entriesOf(*params)}});
            return;
        }
        std::array<std::string, kParams> texts;
        for (std::size_t i = 0; i < kParams; ++i)
            texts[i] =
                memberText((*params)[i], path + '[' + std::to_string(i) + ']', m_file.faults);
        m_places.add({.line = line,
                      .command = item.whole("command", 0, kMavNumbers),
                      .frame = item.whole("frame", 0, kMavNumbers),
                      .param1 = texts[0],
                      .param2 = texts[1],
                      .latitude = texts[kLatitude],
                      .longitude = texts[kLatitude + 1],
                      .altitude = texts[kLatitude + 2]});
    }

    /** A pattern over an area or a line is no place; where to land is none of an iceberg. */
    void readComplex(ObjectReader& item, std::size_t line)
    {
        const std::string kind = item.text("complexItemType");
        if (kind != "fwLandingPattern" && kind != "vtolLandingPattern")
            m_places.reject(line, kind.empty() ? "ComplexItem" : kind);
    }

    const std::string& m_subject;
    ParsedJson m_file;
    const Json* m_rally = nullptr; ///< null: no rally points
    MissionPlaces m_places;
};

} // namespace

SightingTable readPlan(const ImportText& source)
{
    return PlanReading(source).take();
}

bool isPlan(std::string_view text)
{
    return isJsonObject(text) && text.find("\"fileType\"") != std::string_view::npos &&
           text.find("\"groundStation\"") != std::string_view::npos;
}

} // namespace berg
