#include "core/io/import/import_xml.h"

#include <algorithm>

namespace berg {

namespace {

const std::string& textOf(const OwnData& data, std::string_view name)
{
    static const std::string kNone;
    const auto it = data.find(name);
    return it == data.end() ? kNone : it->second;
}

std::optional<double> numberOf(const OwnData& data, std::string_view name)
{
    return decimalOf(trimmed(textOf(data, name)));
}

} // namespace

std::string_view parentName(XmlPath path)
{
    return path.size() < 2 ? std::string_view() : path[path.size() - 2].name;
}

void setName(FieldTexts& texts, const std::string& name)
{
    texts.set({.field = SightingField::Id, .rank = 1000}, name);
    if (texts.text(SightingField::Id) != trimmed(name))
        texts.set({.field = SightingField::Name, .rank = 1000}, name);
}

std::optional<LatLon> placeOf(const FieldTexts& texts)
{
    FieldTexts place;
    place.set(SightingField::Latitude, texts.text(SightingField::Latitude));
    place.set(SightingField::Longitude, texts.text(SightingField::Longitude));
    const std::variant<Sighting, RejectedRow> row = sightingOf(place, {}, 0);
    const auto* const sighting = std::get_if<Sighting>(&row);
    return sighting == nullptr ? std::nullopt : std::optional(sighting->place);
}

std::optional<std::vector<LatLon>> placesOfTuples(std::string_view tuples)
{
    std::vector<LatLon> places;
    for (std::string_view rest = trimmed(tuples); !rest.empty(); rest = trimmed(rest)) {
        const std::string_view tuple = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const std::size_t comma = std::min(tuple.find(','), tuple.size() - 1);
        const std::string_view second = tuple.substr(comma + 1);
        const std::optional<double> longitude_deg = decimalOf(tuple.substr(0, comma));
        const std::optional<double> latitude_deg = decimalOf(second.substr(0, second.find(',')));
        const std::optional<LatLon> place = longitude_deg && latitude_deg
                                                ? scenePlace(*latitude_deg, *longitude_deg)
                                                : std::nullopt;
        if (!place)
            return std::nullopt;
        places.push_back(*place);
        rest.remove_prefix(tuple.size());
    }
    return places;
}

std::variant<Sighting, RejectedRow> withData(std::variant<Sighting, RejectedRow> row,
                                             const OwnData& data)
{
    row = withDrift(std::move(row), {.east = textOf(data, "drift_east_mps"),
                                     .north = textOf(data, "drift_north_mps")});
    if (auto* const sighting = std::get_if<Sighting>(&row)) {
        sighting->appearsIn_s = numberOf(data, "appears_in_s");
        sighting->change = changeOf([&](const char* name) { return numberOf(data, name); });
    }
    return row;
}

void addOwnUav(FileScene& scene, const OwnMark& home)
{
    SceneUav* uav = scene.addUav();
    if (uav == nullptr)
        return;
    const std::optional<double> latitude_deg = numberOf(home.data, "start_latitude_deg");
    const std::optional<double> longitude_deg = numberOf(home.data, "start_longitude_deg");
    if (latitude_deg && longitude_deg)
        uav->start = scenePlace(*latitude_deg, *longitude_deg);
    if (!uav->start)
        uav->start = home.place;
    uav->id = cleanText(textOf(home.data, "id"), kLongestId);
    uav->name = cleanText(textOf(home.data, "name"), kLongestName);
    uav->home = home.place;
    uav->heading_deg = numberOf(home.data, "heading_deg");
    uav->airspeed_mps = numberOf(home.data, "airspeed_mps");
    uav->altitude_m = numberOf(home.data, "altitude_m");
}

void addOwnAsset(FileScene& scene, const OwnMark& asset)
{
    if (!asset.place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    // Without data it has been drawn by hand; ours may have a title and no name.
    const std::string& name =
        asset.data.contains("range_m") ? textOf(asset.data, "name") : asset.title;
    SceneAsset added{.name = cleanText(name, kLongestName),
                     .place = *asset.place,
                     .time = asset.time,
                     .range_m = numberOf(asset.data, "range_m"),
                     .standoff_m = numberOf(asset.data, "standoff_m"),
                     .standoffCeiling_m = numberOf(asset.data, "standoff_ceiling_m")};
    const std::optional<double> east_mps = numberOf(asset.data, "velocity_east_mps");
    const std::optional<double> north_mps = numberOf(asset.data, "velocity_north_mps");
    if (east_mps && north_mps)
        added.velocity_mps = Point(*east_mps, *north_mps);
    scene.addAsset(std::move(added));
}

SceneArea ownArea(const OwnData& data, bool isNoFly)
{
    return {.rings = {},
            .geofence = trimmed(textOf(data, "geofence")) == "true",
            .isNoFly = isNoFly,
            .name = isNoFly ? cleanText(textOf(data, "name"), kLongestName) : std::string(),
            .floor_m = numberOf(data, "floor_m"),
            .ceiling_m = numberOf(data, "ceiling_m")};
}

bool rootIs(std::string_view text, std::string_view name)
{
    constexpr std::size_t kHead = 4096;
    const std::string_view head = text.substr(0, kHead);
    const std::size_t at = head.find('<' + std::string(name));
    return trimmed(head).substr(0, 4).find('<') != std::string_view::npos &&
           at != std::string_view::npos;
}

} // namespace berg
