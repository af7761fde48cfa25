#include "core/io/import_xml.h"

#include "core/io/import_fields.h"
#include "core/io/xml_reader.h"

#include <algorithm>

namespace berg {

namespace {

/** Name of the element's parent, empty for the root. */
std::string_view parentName(XmlPath path)
{
    return path.size() < 2 ? std::string_view() : path[path.size() - 2].name;
}

/** Longitude, latitude and perhaps a height, set apart by any of `separators`. */
void setPlace(FieldTexts& texts, std::string_view tuple, std::string_view separators)
{
    const std::string_view whole = trimmed(tuple);
    const std::size_t first = whole.find_first_of(separators);
    if (first == std::string_view::npos)
        return;
    const std::string_view rest = whole.substr(first + 1);
    texts.set(SightingField::Longitude, whole.substr(0, first));
    texts.set(SightingField::Latitude, rest.substr(0, rest.find_first_of(separators)));
}

/** An id or, where something else is the id, the name. */
void setName(FieldTexts& texts, const std::string& name)
{
    texts.set({.field = SightingField::Id, .rank = 1000}, name);
    if (texts.text(SightingField::Id) != trimmed(name))
        texts.set({.field = SightingField::Name, .rank = 1000}, name);
}

/** How exports of our own name a home; then comes the aircraft. */
constexpr std::string_view kOwnHome = "Home of ";

/** Where an aircraft starts and lands; none when the texts are no place. */
std::optional<AircraftPlaces> homeOf(const FieldTexts& texts, std::size_t line)
{
    const std::variant<Sighting, RejectedRow> row = sightingOf(texts, {}, line);
    const auto* const sighting = std::get_if<Sighting>(&row);
    if (sighting == nullptr)
        return std::nullopt;
    return AircraftPlaces{.line = line, .start = sighting->place, .home = sighting->place};
}

bool isOwnKml(std::string_view text)
{
    return text.find("<Style id=\"iceberg\">") != std::string_view::npos &&
           text.find("<Style id=\"uav-") != std::string_view::npos;
}

/** Gathers the sightings of a KML file, Placemark by Placemark. */
class KmlSightings
{
public:
    explicit KmlSightings(const ImportText& source)
        : m_source(source), m_names(source.mapping), m_isOwn(isOwnKml(source.text))
    {
    }

    SightingTable take()
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path.back()); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(m_source.text, m_source.subject, events);
        return std::move(m_table);
    }

private:
    /** A gx:coord, and the line it stands on. */
    struct Coordinate
    {
        std::size_t line = 0;
        std::string text;
    };

    void opened(const XmlElement& element)
    {
        if (element.name != "Placemark")
            return;
        m_inside = true;
        m_line = element.line;
        m_texts.clear();
        m_name.clear();
        m_style.clear();
        m_drift = {};
        m_point.clear();
        m_whens.clear();
        m_coordinates.clear();
        // A name or an id of the data is a better name for the iceberg.
        m_texts.set({.field = SightingField::Id, .rank = 1001}, element.attribute("id"));
    }

    void closed(XmlPath path)
    {
        if (!m_inside)
            return;
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        if (element.name == "Placemark")
            finish();
        else if (element.name == "name" && parent == "Placemark")
            m_name = element.text;
        else if (element.name == "styleUrl" && parent == "Placemark")
            m_style = trimmed(element.text);
        else if (element.name == "when" && parent == "Track")
            m_whens.push_back(element.text);
        else if (element.name == "coord")
            m_coordinates.push_back({.line = element.line, .text = element.text});
        else if (element.name == "when" || (element.name == "begin" && parent == "TimeSpan"))
            m_texts.set(SightingField::Time, element.text);
        else if (element.name == "coordinates" && parent == "Point" && m_point.empty())
            m_point = element.text;
        else if (element.name == "value" && parent == "Data")
            property(path[path.size() - 2].attribute("name"), element.text);
        else if (element.name == "SimpleData")
            property(element.attribute("name"), element.text);
    }

    void property(const std::string& name, const std::string& text)
    {
        if (name == "drift_east_mps")
            m_drift.east = text;
        else if (name == "drift_north_mps")
            m_drift.north = text;
        else if (const std::optional<FieldUse> use = m_names.of(name))
            m_texts.set(*use, text);
    }

    void finish()
    {
        m_inside = false;
        setName(m_texts, m_name);
        if (m_isOwn && (m_style == "#area" || m_style == "#asset" || isOfAircraft())) {
            readOwn();
        } else if (!m_coordinates.empty()) {
            finishTrack();
        } else if (m_point.empty()) {
            addRow(m_table, RejectedRow{.line = m_line, .fault = RowFault::NotAPoint, .detail = {}},
                   m_source.subject);
        } else {
            setPlace(m_texts, m_point, ",");
            addRow(m_table, withDrift(sightingOf(m_texts, {}, m_line), m_drift), m_source.subject);
        }
    }

    [[nodiscard]] bool isOfAircraft() const { return m_style.starts_with("#uav-"); }

    /** Of an export of our own where the first aircraft lands; the rest is no iceberg. */
    void readOwn()
    {
        if (!isOfAircraft() || !m_name.starts_with(kOwnHome) || m_table.aircraft)
            return;
        setPlace(m_texts, m_point, ",");
        m_table.aircraft = homeOf(m_texts, m_line);
    }

    void finishTrack()
    {
        for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
            const std::size_t line = m_coordinates[i].line;
            FieldTexts texts = m_texts;
            if (i < m_whens.size())
                texts.set(SightingField::Time, m_whens[i]);
            setPlace(texts, m_coordinates[i].text, " \t\n");
            addRow(m_table, sightingOf(texts, {.timeNeeded = true}, line), m_source.subject);
        }
    }

    const ImportText& m_source;
    FieldNames m_names;
    bool m_isOwn; ///< an export of our own
    SightingTable m_table;
    bool m_inside = false; ///< of a Placemark
    std::size_t m_line = 0;
    FieldTexts m_texts;
    std::string m_name;
    std::string m_style;
    DriftTexts m_drift;
    std::string m_point;
    std::vector<std::string> m_whens;
    std::vector<Coordinate> m_coordinates;
};

/** Gathers the sightings of a GPX file, point by point. */
class GpxSightings
{
public:
    explicit GpxSightings(const ImportText& source) : m_source(source) {}

    SightingTable take()
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path.back()); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(m_source.text, m_source.subject, events);
        if (m_table.aircraft && m_start)
            m_table.aircraft->start = *m_start;
        decideOneIceberg(m_table);
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
        if (element.name == "trk")
            m_track.clear();
        if (!isPoint(element.name))
            return;
        m_texts.clear();
        m_name.clear();
        m_type.clear();
        m_drift = {};
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
    }

    void extension(const XmlElement& element)
    {
        if (element.name == "id")
            m_texts.set(SightingField::Id, element.text);
        else if (element.name == "sigma_m2")
            m_texts.set(SightingField::Sigma, element.text);
        else if (element.name == "radius_m")
            m_texts.set(SightingField::Radius, element.text);
        else if (element.name == "drift_east_mps")
            m_drift.east = element.text;
        else if (element.name == "drift_north_mps")
            m_drift.north = element.text;
    }

    void finish(const XmlElement& point)
    {
        const bool isTrack = point.name == "trkpt";
        if (m_isOwn && (point.name != "wpt" || m_type == "home" || m_type == "asset")) {
            readOwn(point);
            return;
        }
        // The time of a place to go to says nothing of when it was seen.
        if (point.name == "rtept")
            m_texts.drop(SightingField::Time);
        setName(m_texts, isTrack ? m_track : m_name);
        addRow(m_table,
               withDrift(sightingOf(m_texts, {.timeNeeded = isTrack}, point.line), m_drift),
               m_source.subject);
    }

    /** Of an export of our own where the first aircraft starts and lands; the rest is no iceberg.
     */
    void readOwn(const XmlElement& point)
    {
        if (m_type == "home" && point.name == "wpt" && !m_table.aircraft)
            m_table.aircraft = homeOf(m_texts, point.line);
        else if (m_type == "start" && point.name == "rtept" && !m_start)
            if (const std::optional<AircraftPlaces> places = homeOf(m_texts, point.line))
                m_start = places->start;
    }

    const ImportText& m_source;
    bool m_isOwn = false; ///< an export of our own
    SightingTable m_table;
    std::string m_track; ///< name of the one that is open
    FieldTexts m_texts;
    std::string m_name;
    std::string m_type;
    DriftTexts m_drift;
    std::optional<LatLon> m_start; ///< of the first aircraft
};

/** Whether `name` is the first element of the text. */
bool rootIs(std::string_view text, std::string_view name)
{
    constexpr std::size_t kHead = 4096;
    const std::string_view head = text.substr(0, kHead);
    const std::size_t at = head.find('<' + std::string(name));
    return trimmed(head).substr(0, 4).find('<') != std::string_view::npos &&
           at != std::string_view::npos;
}

} // namespace

SightingTable readKml(const ImportText& source)
{
    return KmlSightings(source).take();
}

bool isKml(std::string_view text)
{
    return rootIs(text, "kml");
}

SightingTable readGpx(const ImportText& source)
{
    return GpxSightings(source).take();
}

bool isGpx(std::string_view text)
{
    return rootIs(text, "gpx");
}

} // namespace berg
