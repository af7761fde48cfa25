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

/** Gathers the sightings of a KML file, Placemark by Placemark. */
class KmlSightings
{
public:
    explicit KmlSightings(const ImportText& source) : m_source(source), m_names(source.mapping) {}

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
            m_texts.set({.field = SightingField::Id, .rank = 1000}, element.text);
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
        if (const std::optional<FieldUse> use = m_names.of(name))
            m_texts.set(*use, text);
    }

    void finish()
    {
        m_inside = false;
        if (!m_coordinates.empty()) {
            finishTrack();
        } else if (m_point.empty()) {
            addRow(m_table, RejectedRow{.line = m_line, .fault = RowFault::NotAPoint, .detail = {}},
                   m_source.subject);
        } else {
            setPlace(m_texts, m_point, ",");
            addRow(m_table, sightingOf(m_texts, {}, m_line), m_source.subject);
        }
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
    SightingTable m_table;
    bool m_inside = false; ///< of a Placemark
    std::size_t m_line = 0;
    FieldTexts m_texts;
    std::string m_point;
    std::vector<std::string> m_whens;
    std::vector<Coordinate> m_coordinates;
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
    SightingTable table;
    std::string track;
    FieldTexts texts;
    const auto isPoint = [](std::string_view name) { return name == "wpt" || name == "trkpt"; };
    const XmlEvents events{
        .opened =
            [&](XmlPath path) {
                const XmlElement& element = path.back();
                if (element.name == "trk")
                    track.clear();
                if (!isPoint(element.name))
                    return;
                texts.clear();
                texts.set(SightingField::Latitude, element.attribute("lat"));
                texts.set(SightingField::Longitude, element.attribute("lon"));
            },
        .closed =
            [&](XmlPath path) {
                const XmlElement& element = path.back();
                const std::string_view parent = parentName(path);
                if (element.name == "name" && parent == "trk")
                    track = element.text;
                else if (element.name == "name" && parent == "wpt")
                    texts.set(SightingField::Id, element.text);
                else if (element.name == "time" && isPoint(parent))
                    texts.set(SightingField::Time, element.text);
                if (!isPoint(element.name))
                    return;
                if (element.name == "trkpt")
                    texts.set(SightingField::Id, track);
                addRow(table,
                       sightingOf(texts, {.timeNeeded = element.name == "trkpt"}, element.line),
                       source.subject);
            }};
    readXml(source.text, source.subject, events);
    decideOneIceberg(table);
    return table;
}

bool isGpx(std::string_view text)
{
    return rootIs(text, "gpx");
}

} // namespace berg
