#include "core/io/import/fields/import_xml.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/map_readers.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

/** Collects the sightings of a GPX file, point by point. */
class GpxReader
{
public:
    explicit GpxReader(const ImportText& source)
        : m_source(source), m_found(source), m_isOwn(isOwnExport(source.text))
    {
    }

    SightingTable take()
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path.back()); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(m_source.text, events, m_source.budget);
        SightingTable table = m_found.take();
        table.idCandidates.clear(); // no columns can be mapped
        return table;
    }

private:
    static bool isPoint(std::string_view name)
    {
        return name == "wpt" || name == "rtept" || name == "trkpt";
    }

    void opened(const XmlElement& element)
    {
        if (element.name == "gpx" && element.attribute("creator") != "Bergwatch")
            m_isOwn = false;
        if (element.name == "trk") {
            m_track.clear();
            m_first = m_found.table().sightings.size();
        }
        if (!isPoint(element.name))
            return;
        m_found.begin(element.line, m_isOwn);
        m_properties = Json::object();
        m_name.clear();
        m_type.clear();
        m_latitude = element.attribute("lat");
        m_longitude = element.attribute("lon");
    }

    void closed(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        if (element.name == "name" && parent == "trk")
            m_track = element.text;
        else if (element.name == "name" && isPoint(parent))
            m_name = element.text;
        else if (element.name == "type" && isPoint(parent))
            m_type = trimmed(element.text);
        else if (element.name == "time" && isPoint(parent))
            m_found.texts().set(SightingField::Time, element.text);
        else if (path.size() > 2 && parent == "extensions" && path[path.size() - 3].name == "wpt")
            extension(element);
        else if (isPoint(element.name))
            finish(element.name);
        else if (element.name == "trk")
            m_found.endTrack(m_first);
    }

    /** Only the extensions of Bergwatch are fields of a sighting. */
    void extension(const XmlElement& element)
    {
        membersOf(m_properties).emplace_back(element.name, element.text);
        constexpr std::array<std::string_view, 4> kFields{"id", "sigma_m2", "q_m2ps", "radius_m"};
        if (std::ranges::find(kFields, element.name) != kFields.end())
            m_found.setProperty(element.name, element.text);
        else
            m_found.setData(element.name, element.text);
    }

    void finish(std::string_view point)
    {
        const bool isTrack = point == "trkpt";
        m_found.setTitle(isTrack ? m_track : m_name);
        if (m_isOwn && point != "wpt")
            return; // routes and tracks show where UAVs fly
        // Only waypoints of an export become a feature, for the scene: GPX has no areas, and each
        // point of a route or track has fields of its own.
        const auto place = [this](std::size_t) {
            return FilePlace{.longitude = m_longitude, .latitude = m_latitude};
        };
        FileFeature feature{.name = m_name, .geometry = [&place] {
                                return FileGeometry{{{.icebergs = {.count = 1, .at = place}}}};
                            }};
        if (m_isOwn)
            feature.kind = featureKind(&m_properties, m_type);
        if (m_found.addToScene(feature))
            return;
        FieldTexts& texts = m_found.texts();
        texts.set(SightingField::Latitude, m_latitude);
        texts.set(SightingField::Longitude, m_longitude);
        if (isTrack) {
            m_found.addTrackPlace(texts, m_found.line(), true);
            return;
        }
        if (point == "rtept") // its time does not say when an iceberg was seen
            texts.drop(SightingField::Time);
        m_found.addPlace(texts);
    }

    const ImportText& m_source;
    FeatureSightings m_found;
    bool m_isOwn;
    Json m_properties;       ///< extensions of the open waypoint
    std::string m_track;     ///< name of the open track
    std::size_t m_first = 0; ///< index of the first sighting of the open track
    std::string m_name;
    std::string m_type;
    std::string m_latitude;
    std::string m_longitude;
};

} // namespace

SightingTable readGpx(const ImportText& source)
{
    return GpxReader(source).take();
}

bool isGpx(std::string_view text)
{
    return rootIs(text, "gpx");
}

} // namespace berg
