// Reads and writes UAVs, icebergs, the asset and the surroundings of a scenario file.

#include "core/io/files/members.h"

namespace berg {

namespace {

/** Reads both lists of the recorded track; `validate` checks their values. */
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
        faults.add(object.path("time_s"), {IssueId::LeastEntries, {2}});
    faults.take(times->size() * sizeof(double) + places->size() * sizeof(Point));
    iceberg.track.time_s.reserve(times->size());
    iceberg.track.position_m.reserve(places->size());
    for (std::size_t i = 0; i < times->size(); ++i)
        if (const auto time_s = numberOf((*times)[i], entryPath(object.path("time_s"), i), faults))
            iceberg.track.time_s.push_back(*time_s);
    for (std::size_t i = 0; i < places->size(); ++i)
        if (const auto place_m =
                pointOf((*places)[i], entryPath(object.path("position_m"), i), faults))
            iceberg.track.position_m.push_back(*place_m);
    // If an entry is missing, the lists no longer match; further faults would be misleading.
    if (iceberg.track.time_s.size() != times->size() ||
        iceberg.track.position_m.size() != places->size())
        iceberg.track = {};
}

std::string trackText(const Iceberg& iceberg)
{
    JsonObject object;
    object.addText("time_s", jsonArrayOf(iceberg.track.time_s));
    object.addText("position_m", jsonArrayOf(iceberg.track.position_m));
    object.addExtra(iceberg.trackExtraJson);
    return object.inLine();
}

/** Reads outlines; `validate` checks their corners. */
std::vector<std::vector<Point>> readOutlines(ObjectReader& object)
{
    const Faults& faults = object.faults();
    return readEach(object, "outlines_m", [&](const Json& ring, const std::string& path) {
        std::vector<Point> outline_m;
        if (!ring.is_array()) {
            object.faults().add(path, {IssueId::WrongType, {ValueKind::Array, kindOf(ring)}});
            return outline_m;
        }
        faults.take(ring.size() * sizeof(Point));
        outline_m.reserve(ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i)
            outline_m.push_back(
                pointOf(ring[i], entryPath(path, i), object.faults()).value_or(Point::Zero()));
        return outline_m;
    });
}

/** Reads the areas; their number is limited before their outlines are read. */
std::vector<IceArea> readIceAreas(ObjectReader& object)
{
    const Json* const list = object.neededArray("areas");
    if (list != nullptr && list->size() > kMostIceAreas) {
        object.faults().add(
            object.path("areas"),
            {IssueId::IceAreaCount, {countOf(kMostIceAreas), countOf(list->size())}});
        return {};
    }
    return readEach(object, "areas", [&](const Json& area, const std::string& path) {
        return readObject<IceArea>(area, path, object.faults());
    });
}

std::string outlinesText(const IceArea& area)
{
    return jsonArray(textsOf(area.outlines_m, [](const std::vector<Point>& outline_m) {
        return jsonArrayOf(outline_m);
    }));
}

} // namespace

std::vector<Point> readCorners(ObjectReader& reader, const char* name)
{
    std::vector<Point> corners_m;
    const Json* list = reader.array(name);
    if (list == nullptr)
        return corners_m;
    const std::string path = reader.path(name);
    if (list->size() < 3 || list->size() > kMostAreaCorners) {
        reader.faults().add(
            path, {IssueId::AreaCorners, {countOf(kMostAreaCorners), countOf(list->size())}});
        return corners_m;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::optional<Point> corner =
            pointOf((*list)[i], entryPath(path, i), reader.faults());
        if (!corner)
            return {}; // a shape that lacks a corner is not worth checking
        corners_m.push_back(*corner);
    }
    return corners_m;
}

template <class T>
T readObject(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader reader(value, path, faults);
    T object;
    readFields(reader, fieldsOf<T>(), object);
    if constexpr (std::is_same_v<T, Iceberg>)
        if (const Json* track = reader.find("track"))
            readTrack(*track, reader.path("track"), faults, object);
    if constexpr (std::is_same_v<T, IceArea>)
        object.outlines_m = readOutlines(reader);
    if constexpr (std::is_same_v<T, IceChart>)
        object.areas = readIceAreas(reader);
    object.extraJson = reader.unknown();
    return object;
}

template <class T>
std::string objectText(const T& object)
{
    JsonObject members;
    writeFields(members, fieldsOf<T>(), object);
    if constexpr (std::is_same_v<T, Iceberg>)
        if (!object.track.empty())
            members.addText("track", trackText(object));
    if constexpr (std::is_same_v<T, IceArea>)
        members.addText("outlines_m", outlinesText(object));
    if constexpr (std::is_same_v<T, IceChart>)
        members.addText("areas", jsonArray(textsOf(object.areas, &objectText<IceArea>)));
    members.addExtra(object.extraJson);
    return members.inLine();
}

template Uav readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Uav&);
template Iceberg readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Iceberg&);
template Asset readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Asset&);
template NoFlyArea readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const NoFlyArea&);
template AirspaceArea readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const AirspaceArea&);
template IceArea readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const IceArea&);
template IceChart readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const IceChart&);
template GroundStation readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const GroundStation&);
template Operation readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Operation&);
template Weather readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Weather&);

} // namespace berg
