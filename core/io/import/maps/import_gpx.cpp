#include "core/io/import/fields/import_xml.h"
#include "core/io/import/maps/map_readers.h"

namespace berg {

namespace {

/** Collects the sightings of a GPX file, point by point. */
class GpxSightings
{
public:
    explicit GpxSightings(const ImportText& source) : m_source(source) {}

    SightingTable take()
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path.back()); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(m_source.text, events, m_source.budget);
        return std::move(m_table);
    }

private:
    static bool isPoint(std::string_view name)
    {
        return name == "wpt" || name == "rtept" || name == "trkpt";
    }

    void opened(const XmlElement& element)
    {
        if (element.name == "gpx")
            m_isOwn = element.attribute("creator") == "Bergwatch";
        if (element.name == "trk") {
            m_track.clear();
            m_first = m_table.sightings.size();
        }
        if (!isPoint(element.name))
            return;
        m_texts.clear();
        m_name.clear();
        m_type.clear();
        m_data.clear();
        m_texts.set(SightingField::Latitude, element.attribute("lat"));
        m_texts.set(SightingField::Longitude, element.attribute("lon"));
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
            m_texts.set(SightingField::Time, element.text);
        else if (path.size() > 2 && parent == "extensions" && path[path.size() - 3].name == "wpt")
            extension(element);
        else if (isPoint(element.name))
            finish(element);
        else if (element.name == "trk")
            m_tracks.give(m_table, m_first);
    }

    void extension(const XmlElement& element)
    {
        m_data[element.name] = element.text;
        if (element.name == "id")
            m_texts.set(SightingField::Id, element.text);
        else if (element.name == "sigma_m2")
            m_texts.set(SightingField::Sigma, element.text);
        else if (element.name == "q_m2ps")
            m_texts.set(SightingField::Growth, element.text);
        else if (element.name == "radius_m")
            m_texts.set(SightingField::Radius, element.text);
    }

    void finish(const XmlElement& point)
    {
        const bool isTrack = point.name == "trkpt";
        if (m_isOwn && (point.name != "wpt" || m_type == "home" || m_type == "asset")) {
            readOwn(point);
            return;
        }
        // The time of a route point does not say when an iceberg was seen.
        if (point.name == "rtept")
            m_texts.drop(SightingField::Time);
        setName(m_texts, isTrack ? m_track : m_name);
        const RowRules rules{.timeNeeded = isTrack, .noted = &m_table.noted};
        addRow(m_table, withData(m_table, sightingOf(m_texts, rules, point.line), m_data),
               m_source.budget);
    }

    /**
     * Reads an object of a Bergwatch export other than an iceberg; routes and tracks add nothing.
     */
    void readOwn(const XmlElement& point)
    {
        if (point.name == "wpt" && m_type == "home")
            addOwnUav(m_table.scene, {.title = m_name, .place = placeOf(m_texts), .data = m_data});
        else if (point.name == "wpt")
            addOwnAsset(m_table.scene, {.title = m_name,
                                        .place = placeOf(m_texts),
                                        .time = parseUtc(m_texts.text(SightingField::Time)),
                                        .data = m_data});
    }

    const ImportText& m_source;
    bool m_isOwn = false; ///< the file is a Bergwatch export
    SightingTable m_table;
    TrackIds m_tracks;
    std::string m_track;     ///< name of the open track
    std::size_t m_first = 0; ///< index of the first sighting of the open track
    FieldTexts m_texts;
    std::string m_name;
    std::string m_type;
    OwnData m_data;
};

} // namespace

SightingTable readGpx(const ImportText& source)
{
    return GpxSightings(source).take();
}

bool isGpx(std::string_view text)
{
    return rootIs(text, "gpx");
}

} // namespace berg
