#include "core/io/export/maps/map_features.h"

#include "core/base/number_text.h"
#include "core/io/text/export_numbers.h"
#include "core/permit/airspace.h"
#include "core/scenario/fields.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace berg {

namespace {

/** Adds the fields of a scenario object with these names; absent optional ones are left out. */
template <class T>
void addFields(MapFeature& feature, const T& object, std::initializer_list<const char*> names)
{
    for (const char* name : names)
        withField(between(fieldsOf<T>(), name, name).front(), object, [&](const auto& value) {
            if constexpr (requires { MapValue(value); })
                feature.properties.push_back({name, value});
            else if constexpr (requires { value.value(); })
                if (value)
                    feature.properties.push_back({name, *value});
        });
}

std::string lineKind(ExportScope what)
{
    return what == ExportScope::FirstLeg || what == ExportScope::Order
               ? "plan"
               : std::string(nameOf(kExportScopeNames, what));
}

std::string titleOr(const std::string& name, const char* title)
{
    return name.empty() ? title : name;
}

/** Collects the features of one content. */
class FeatureList
{
public:
    explicit FeatureList(const ExportContent& content) : m_content(content) {}

    std::vector<MapFeature> take()
    {
        addArea();
        for (std::size_t i = 0; i < m_content.noFly.size(); ++i)
            addClosed("no-fly", std::to_string(i), m_content.noFly[i]);
        if (m_content.standoff)
            addClosed("stand-off", {}, *m_content.standoff);
        for (const AirspaceArea& area : m_content.scenario->airspace)
            addAirspace(area);
        if (m_content.operation)
            addOperation(*m_content.operation);
        for (const ExportIceberg& now : m_content.icebergs)
            if (now.isListed)
                addIceberg(now);
        if (m_content.asset)
            addAsset(*m_content.asset);
        for (const ExportUav& uav : m_content.uavs) {
            addUav(uav);
            addVisits(uav);
            addLine(uav);
        }
        return std::move(m_features);
    }

private:
    MapFeature& add(MapFeature feature) { return m_features.emplace_back(std::move(feature)); }

    void addTime(MapFeature& feature, double time_s) const
    {
        feature.time_s = time_s;
        feature.properties.push_back({"time_s", roundedSeconds(time_s)});
        if (m_content.start)
            feature.properties.push_back({"time", utcText(*m_content.start, time_s)});
    }

    void addArea()
    {
        if (m_content.area_m.empty())
            return;
        MapFeature& area = add({.kind = "area",
                                .title = "Area",
                                .geometry = MapOutline{.corners_m = m_content.area_m}});
        addFields(area, *m_content.scenario, {"geofence"});
    }

    void addClosed(const std::string& kind, const std::string& key, const NoFlyArea& area)
    {
        MapFeature& closed = add({.kind = kind,
                                  .key = key,
                                  .title = kind == "no-fly" ? titleOr(area.name, "No-fly area")
                                                            : "Stand-off " + area.name,
                                  .geometry = MapOutline{.corners_m = area.corners_m,
                                                         .floor_m = area.floor_m,
                                                         .ceiling_m = area.ceiling_m}});
        addFields(closed, area, {"name", "floor_m", "ceiling_m"});
    }

    void addAirspace(const AirspaceArea& area)
    {
        MapFeature& airspace =
            add({.kind = "airspace",
                 .key = std::to_string(&area - m_content.scenario->airspace.data()),
                 .title = titleOr(titleOf(area), "Airspace"),
                 .folder = "Airspace",
                 .geometry = MapOutline{.corners_m = area.corners_m,
                                        .floor_m = area.floor_m,
                                        .ceiling_m = area.ceiling_m}});
        addFields(airspace, area, {"name"});
        airspace.properties.push_back({"class", area.kind}); // "kind" is that of the feature
        addFields(airspace, area, {"floor_m", "ceiling_m"});
        if (!area.fromUtc.empty())
            addFields(airspace, area, {"from_utc"});
        if (!area.untilUtc.empty())
            addFields(airspace, area, {"until_utc"});
    }

    void addOperation(const OperationVolume& volume)
    {
        constexpr std::array<const char*, kVolumeParts> kTitles{
            "Flight geography", "Contingency volume", "Ground-risk buffer", "Adjacent area"};
        for (std::size_t i = 0; i < kVolumeParts; ++i) {
            const std::optional<double> top_m = volume.top_m(static_cast<VolumePart>(i));
            MapFeature& part = add(
                {.kind = std::string(kVolumePartIds[i]),
                 .title = kTitles[i],
                 .folder = kVolumeTitle,
                 .geometry = MapOutline{.corners_m = volume.outlines_m[i], .ceiling_m = top_m}});
            part.properties.push_back({"name", kVolumeTitle});
            if (top_m)
                part.properties.push_back({"ceiling_m", std::round(*top_m * 10) / 10});
        }
    }

    void addIceberg(const ExportIceberg& now)
    {
        Iceberg iceberg = now.iceberg; // with its velocity in true directions
        iceberg.velocity_mps = eastNorth_mps(m_content, iceberg.velocity_mps, now.position_m);
        const Point drift_mps = eastNorth_mps(m_content, now.drift_mps, now.position_m);
        const std::string state(nameOf(kIcebergStateNames, now.state));
        MapFeature& feature =
            add({.kind = "iceberg",
                 .key = iceberg.id,
                 .title = titleOf(iceberg),
                 .about = iceberg.id + ": " + state + ", sigma " + fixedText(now.sigma_m2, 1) +
                          " m2, radius " + fixedText(iceberg.radius_m, 0) + " m, drift east " +
                          fixedText(drift_mps.x(), 2) + " m/s, north " +
                          fixedText(drift_mps.y(), 2) + " m/s",
                 .folder = "Icebergs",
                 .geometry = now.position_m});
        addFields(feature, iceberg, {"id", "name"});
        addTime(feature, m_content.now_s);
        feature.properties.push_back({"sigma_m2", now.sigma_m2});
        addFields(feature, iceberg, {"q_m2ps", "velocity_mps"});
        feature.properties.push_back({"drift_mps", drift_mps});
        for (const auto& [name, value] : driftData(m_content, now))
            feature.properties.push_back({std::string(name), value});
        addFields(feature, iceberg, {"radius_m", "appears_s"});
        feature.properties.push_back({"state", state});
    }

    void addAsset(Asset asset)
    {
        const Point place_m = assetPlace_m(m_content);
        asset.velocity_mps = eastNorth_mps(m_content, asset.velocity_mps, place_m);
        MapFeature& feature =
            add({.kind = "asset", .title = titleOr(asset.name, "Asset"), .geometry = place_m});
        addFields(feature, asset, {"name"});
        addTime(feature, m_content.now_s);
        addFields(feature, asset, {"velocity_mps", "range_m"});
        if (asset.standoff_m > 0)
            addFields(feature, asset, {"standoff_m", "standoff_ceiling_m"});
    }

    void addUav(const ExportUav& exported)
    {
        Uav uav = exported.uav;
        uav.heading_deg = trueHeading_deg(m_content, uav.heading_deg, uav.position_m);
        MapFeature start{.kind = "uav",
                         .key = uav.id,
                         .title = titleOf(uav),
                         .folder = titleOf(uav),
                         .geometry = uav.position_m,
                         .uav = exported.row};
        MapFeature home = start;
        addFields(start, uav, {"id", "name"});
        addTime(start, exported.start_s);
        addFields(start, uav, {"heading_deg", "airspeed_mps", "altitude_m"});
        home.kind = "home";
        home.title = "Home of " + start.title;
        home.geometry = exported.home_m;
        home.isAtStart = exported.home_m == uav.position_m;
        home.properties.push_back({"uav", uav.id});
        addFields(home, uav, {"id", "name"});
        const LatLon place = roundedPlace(m_content.frame.toGeographic(uav.position_m));
        home.properties.push_back({"start_latitude_deg", place.latitude_deg});
        home.properties.push_back({"start_longitude_deg", place.longitude_deg});
        addFields(home, uav, {"heading_deg", "airspeed_mps", "altitude_m"});
        add(std::move(start));
        add(std::move(home));
    }

    void addVisits(const ExportUav& uav)
    {
        std::int64_t sequence = 0;
        for (const Visit& visit : uav.visits) {
            if (!visit.iceberg)
                continue;
            ++sequence;
            const Iceberg& iceberg = m_content.icebergs.at(toIndex(*visit.iceberg)).iceberg;
            MapFeature& feature = add({.kind = "visit",
                                       .key = uav.uav.id + '/' + std::to_string(sequence),
                                       .title = titleOf(m_content, visit),
                                       .folder = titleOf(uav.uav),
                                       .geometry = visit.position_m,
                                       .altitude_m = uav.uav.spec.altitude_m,
                                       .uav = uav.row});
            feature.properties = {{"sequence", sequence}, {"iceberg", iceberg.id}};
            addFields(feature, iceberg, {"name"});
            if (!visit.members.empty())
                feature.properties.push_back({"cluster", idsOf(m_content, visit)});
            feature.properties.push_back({"uav", uav.uav.id});
            if (const auto chance = chanceInView(m_content, uav, visit, *visit.iceberg))
                feature.properties.push_back({"chance_in_view", *chance});
            addTime(feature, visit.time_s);
        }
    }

    void addLine(const ExportUav& uav)
    {
        std::vector<std::string> order;
        for (const Visit& visit : uav.visits)
            std::ranges::move(idsOf(m_content, visit), std::back_inserter(order));
        MapFeature& line = add({.kind = lineKind(m_content.what),
                                .key = uav.uav.id,
                                .title = titleOf(uav.uav),
                                .folder = titleOf(uav.uav),
                                .geometry = &uav,
                                .uav = uav.row});
        line.properties = {{"uav", uav.uav.id}, {"order", std::move(order)}};
        if (m_content.what == ExportScope::Track) {
            line.properties.push_back({"flown_m", uav.flown_m});
            line.properties.push_back({"zeta_m2s", *m_content.zeta_m2s}); // of all UAVs
        } else {
            line.properties.push_back(
                {"policy", std::string(nameOf(kPolicyNames, m_content.planner.policy))});
            line.properties.push_back({"tau", m_content.planner.tau});
        }
    }

    const ExportContent& m_content;
    std::vector<MapFeature> m_features;
};

} // namespace

std::vector<MapFeature> mapFeatures(const ExportContent& content)
{
    return FeatureList(content).take();
}

std::vector<MapProperty> flatProperties(const MapFeature& feature)
{
    std::vector<MapProperty> flat{{"kind", feature.kind}};
    for (const MapProperty& property : feature.properties) {
        if (const auto* list = std::get_if<std::vector<std::string>>(&property.value)) {
            flat.push_back({property.name, joined(*list, ", ")});
        } else if (const auto* vector_mps = std::get_if<Point>(&property.value)) {
            const std::string stem = property.name.substr(0, property.name.rfind('_'));
            const std::string unit = property.name.substr(stem.size());
            flat.push_back({std::string(stem).append("_east").append(unit), vector_mps->x()});
            flat.push_back({std::string(stem).append("_north").append(unit), vector_mps->y()});
        } else {
            flat.push_back(property);
        }
    }
    return flat;
}

Rgb uavColour(std::size_t row)
{
    constexpr std::array<Rgb, 6> kColours{{{0, 114, 178},
                                           {213, 94, 0},
                                           {0, 158, 115},
                                           {204, 121, 167},
                                           {230, 159, 0},
                                           {86, 180, 233}}};
    return kColours[row % kColours.size()];
}

FeatureKind styleOf(const MapFeature& feature)
{
    const FeatureKind* const kind = findKind(feature.kind);
    require(kind != nullptr, "a kind with a style");
    FeatureKind style = *kind;
    if (feature.uav)
        style.colour = uavColour(*feature.uav);
    return style;
}

} // namespace berg
