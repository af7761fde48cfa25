#include "core/io/import/import_readers.h"
#include "core/io/import/import_xml.h"
#include "core/scenario/operation.h"

#include <utility>

namespace berg {

namespace {

constexpr std::string_view kExterior = "outerBoundaryIs";

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
        readXml(m_source.text, events, m_source.budget);
        m_names.requireMapped(m_source.budget.subject());
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
        m_point.clear();
        m_further = 0;
        m_data.clear();
        m_rings.clear();
        m_holes = 0;
        m_whens.clear();
        m_coordinates.clear();
        m_source.budget.giveBack(std::exchange(m_kept, 0));
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
            m_whens.push_back(kept(element.text));
        else if (element.name == "coord")
            m_coordinates.push_back({.line = element.line, .text = kept(element.text)});
        else if (element.name == "when" || element.name == "begin")
            setTime(path);
        else if (element.name == "coordinates" && parent == "Point")
            addPoint(element.text);
        else if (element.name == "coordinates" && m_isOwn)
            shape(path);
        else if (element.name == "value" && parent == "Data")
            property(path[path.size() - 2].attribute("name"), element.text);
        else if (element.name == "SimpleData")
            property(element.attribute("name"), element.text);
    }

    /** That of the Placemark itself, not of how to look at it. */
    void setTime(XmlPath path)
    {
        const std::string_view parent = parentName(path);
        if ((parent == "TimeStamp" || parent == "TimeSpan") &&
            parentName(path.first(path.size() - 1)) == "Placemark")
            m_texts.set(SightingField::Time, path.back().text);
    }

    void addPoint(const std::string& text)
    {
        if (m_point.empty())
            m_point = text;
        else
            ++m_further;
    }

    /** A text that is kept until the end of the Placemark, in a list that grows. */
    const std::string& kept(const std::string& text)
    {
        const std::size_t memory = 3 * sizeof(Coordinate) + text.capacity();
        m_source.budget.take(memory);
        m_kept += memory;
        return text;
    }

    /** Outlines of an export of our own. */
    void shape(XmlPath path)
    {
        const std::string& text = path.back().text;
        const std::string_view parent = parentName(path);
        if (parent == "LinearRing" && parentName(path.first(path.size() - 1)) == kExterior)
            m_rings.push_back(kept(text));
        else if (parent == "LinearRing")
            ++m_holes;
    }

    void property(const std::string& name, const std::string& text)
    {
        m_data[name] = text;
        if (name == "drift_east_mps" || name == "drift_north_mps")
            return;
        if (const std::optional<FieldUse> use = m_names.of(name))
            m_texts.set(*use, text);
    }

    void finish()
    {
        m_inside = false;
        setName(m_texts, m_name);
        if (m_isOwn && (m_style == "#area" || m_style == "#no-fly" || m_style == "#stand-off" ||
                        m_style == "#asset" || isOfAircraft() || isOfPermit())) {
            readOwn();
        } else if (!m_coordinates.empty()) {
            m_further += m_point.empty() ? std::size_t{0} : std::size_t{1};
            finishTrack();
        } else if (m_point.empty()) {
            addRow(m_table, RejectedRow{.line = m_line, .fault = IssueId::NotAPoint, .detail = {}},
                   m_source.budget);
        } else {
            setPlace(m_texts, m_point, ",");
            addRow(m_table, withData(sightingIn(m_table, m_source, m_texts, m_line, false), m_data),
                   m_source.budget);
        }
        for (; m_further > 0; --m_further)
            addRow(m_table,
                   RejectedRow{.line = m_line,
                               .fault = IssueId::FurtherPlace,
                               .detail = cleanText(m_name, 60)},
                   m_source.budget);
    }

    /** What is made anew of a scenario, and airspace. */
    [[nodiscard]] bool isOfPermit() const
    {
        return m_style == "#airspace" ||
               std::ranges::any_of(kVolumePartIds, [&](std::string_view id) {
                   return m_style == "#" + std::string(id);
               });
    }
    [[nodiscard]] bool isOfAircraft() const { return m_style.starts_with("#uav-"); }

    /** Of an export of our own what is no iceberg; ways and visits say nothing more. */
    void readOwn()
    {
        setPlace(m_texts, m_point, ",");
        const OwnMark mark{.title = m_name,
                           .place = placeOf(m_texts),
                           .time = parseUtc(m_texts.text(SightingField::Time)),
                           .data = m_data};
        if (m_style == "#area" || m_style == "#no-fly")
            readArea();
        else if (m_style == "#asset")
            addOwnAsset(m_table.scene, mark);
        else if (m_data.contains("airspeed_mps"))
            addOwnUav(m_table.scene, mark);
    }

    void readArea()
    {
        SceneArea area = ownArea(m_data, m_style == "#no-fly");
        for (const std::string& text : m_rings) {
            std::optional<std::vector<LatLon>> ring = placesOfTuples(text);
            if (ring)
                area.rings.push_back(std::move(*ring));
        }
        for (std::size_t i = 0; i < m_holes; ++i)
            addFinding(m_table.scene.findings, SceneNote::AreaHoles);
        if (!area.rings.empty() && area.rings.size() == m_rings.size())
            m_table.scene.addArea(std::move(area));
        else
            addFinding(m_table.scene.findings, SceneNote::AreaUnreadable);
    }

    void finishTrack()
    {
        const std::size_t first = m_table.sightings.size();
        for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
            const std::size_t line = m_coordinates[i].line;
            FieldTexts texts = m_texts;
            if (i < m_whens.size())
                texts.set(SightingField::Time, m_whens[i]);
            setPlace(texts, m_coordinates[i].text, " \t\n");
            addRow(m_table, sightingIn(m_table, m_source, texts, line, true), m_source.budget);
        }
        m_tracks.give(m_table, first);
    }

    const ImportText& m_source;
    ColumnNames m_names;
    bool m_isOwn; ///< an export of our own
    SightingTable m_table;
    TrackIds m_tracks;
    bool m_inside = false; ///< of a Placemark
    std::size_t m_line = 0;
    FieldTexts m_texts;
    std::string m_name;
    std::string m_style;
    std::string m_point;
    std::size_t m_further = 0; ///< points after it
    std::vector<std::string> m_rings;
    std::size_t m_holes = 0;
    OwnData m_data;
    std::vector<std::string> m_whens;
    std::vector<Coordinate> m_coordinates;
    std::size_t m_kept = 0; ///< bytes of them
};

} // namespace

SightingTable readKml(const ImportText& source)
{
    return KmlSightings(source).take();
}

bool isKml(std::string_view text)
{
    return rootIs(text, "kml");
}

} // namespace berg
