#include "core/io/import/fields/import_xml.h"

#include "core/io/text/byte_order_mark.h"

#include <algorithm>
#include <array>
#include <utility>

namespace berg {

namespace {

const std::string& valueOf(const OwnData& data, std::string_view name)
{
    static const std::string kNone;
    const auto it = data.find(name);
    return it == data.end() ? kNone : it->second;
}

std::optional<double> numberOf(const OwnData& data, std::string_view name)
{
    return decimalOf(trimmed(valueOf(data, name)));
}

/** Returns the end of the declaration, comment or instruction with which a text begins. */
std::size_t prologEnd(std::string_view text)
{
    std::string_view mark = ">";
    if (text.starts_with("<?"))
        mark = "?>";
    else if (text.starts_with("<!--"))
        mark = "-->";
    else if (text.substr(0, text.find('>')).find('[') != std::string_view::npos)
        mark = "]>"; // document type with entities
    const std::size_t end = text.find(mark);
    return end == std::string_view::npos ? text.size() : end + mark.size();
}

/** Whether the bytes declare an encoding that is neither UTF-8 nor Latin. */
bool declaresOther(std::string_view bytes)
{
    constexpr std::string_view kWord = "encoding";
    const std::string_view head = bytes.substr(0, std::min(bytes.find("?>"), bytes.size()));
    const std::size_t at = head.find(kWord);
    if (!trimmed(withoutByteOrderMark(head)).starts_with("<?xml") || at == std::string_view::npos)
        return false;
    const std::size_t open = std::min(head.find_first_of("'\"", at), head.size() - 1);
    const std::size_t end = std::min(head.find_first_of("'\"", open + 1), head.size());
    const std::string name = plainName(head.substr(open + 1, end - open - 1));
    constexpr std::array<std::string_view, 9> kRead = {
        "utf8", "usascii", "ascii", "iso88591", "latin1", "windows1252", "cp1252", "iso885915", ""};
    return std::ranges::find(kRead, name) == kRead.end();
}

} // namespace

std::string_view parentName(XmlPath path)
{
    return path.size() < 2 ? std::string_view() : path[path.size() - 2].name;
}

void setName(FieldTexts& texts, const std::string& name)
{
    texts.set({.field = SightingField::Id, .rank = kNameRank}, name);
    if (texts.text(SightingField::Id) != trimmed(name))
        texts.set({.field = SightingField::Name, .rank = kNameRank}, name);
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

bool isVectorPart(std::string_view name)
{
    return name.ends_with("_east_mps") || name.ends_with("_north_mps");
}

std::variant<Sighting, RejectedRow>
withData(SightingTable& table, std::variant<Sighting, RejectedRow> row, const OwnData& data)
{
    row = withDrift(
        table, std::move(row),
        {.east = valueOf(data, "drift_east_mps"), .north = valueOf(data, "drift_north_mps")});
    if (auto* const sighting = std::get_if<Sighting>(&row)) {
        const std::optional<double> appears_s = numberOf(data, "appears_s");
        const std::optional<double> time_s = numberOf(data, "time_s");
        sighting->appearsIn_s = appears_s && time_s ? std::optional(*appears_s - *time_s)
                                                    : numberOf(data, "appears_in_s");
        sighting->change = changeOf([&](const char* name) { return numberOf(data, name); });
    }
    return row;
}

void addOwnUav(FileScene& scene, const OwnPlacemark& home)
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
    uav->id = cleanText(valueOf(home.data, "id"), kLongestId);
    uav->name = cleanText(valueOf(home.data, "name"), kLongestName);
    uav->home = home.place;
    uav->heading_deg = numberOf(home.data, "heading_deg");
    uav->airspeed_mps = numberOf(home.data, "airspeed_mps");
    uav->altitude_m = numberOf(home.data, "altitude_m");
}

void addOwnAsset(FileScene& scene, const OwnPlacemark& asset)
{
    if (!asset.place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    // An asset without data was drawn by a user; one of Bergwatch may have a title and no name.
    const std::string& name =
        asset.data.contains("range_m") ? valueOf(asset.data, "name") : asset.title;
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
            .geofence = trimmed(valueOf(data, "geofence")) == "true",
            .isNoFly = isNoFly,
            .name = isNoFly ? cleanText(valueOf(data, "name"), kLongestName) : std::string(),
            .floor_m = numberOf(data, "floor_m"),
            .ceiling_m = numberOf(data, "ceiling_m")};
}

bool rootIs(std::string_view text, std::string_view name)
{
    std::string_view rest = trimmed(withoutByteOrderMark(text));
    while (rest.starts_with("<?") || rest.starts_with("<!"))
        rest = trimmed(rest.substr(prologEnd(rest)));
    if (!rest.starts_with('<'))
        return false;
    const std::string_view whole = rest.substr(1, rest.find_first_of(" \t\r\n/>", 1) - 1);
    return whole.substr(whole.rfind(':') + 1) == name; // npos + 1 is 0
}

std::string textOfXml(std::string_view bytes, const std::string& subject)
{
    std::string decoded = textOfBytes(bytes, subject);
    const bool isXml = rootIs(bytes, "kml") || rootIs(bytes, "gpx");
    if (isXml && !decoded.empty() && declaresOther(bytes))
        decoded.clear();
    return decoded;
}

} // namespace berg
