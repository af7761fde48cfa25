#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/maps/feature_parsers.h"

#include <optional>
#include <utility>
#include <vector>

namespace berg {

namespace {

using Kind = KmlShape::Kind;

/** Returns the places of a track, or nullopt if one of them is not a place. */
std::optional<std::vector<LatLon>> placesOfTrack(const KmlShape& track)
{
    std::vector<LatLon> places;
    for (const KmlText& coord : track.texts) {
        const std::optional<KmlTuple> tuple = kmlCoord(coord.text);
        const auto place =
            tuple ? placesOfTuples(tuple->longitude + ',' + tuple->latitude) : std::nullopt;
        if (!place || place->size() != 1)
            return std::nullopt;
        places.push_back(place->front());
    }
    return places;
}

std::vector<FileShape> shapesOfKml(const KmlGeometry& geometry)
{
    std::vector<FileShape> shapes;
    for (const KmlShape& shape : geometry.shapes()) {
        const bool isTrack = shape.kind == Kind::Track;
        shapes.push_back({.kind = shape.kind == Kind::Point  ? FileShape::Kind::Places
                                  : shape.kind == Kind::Area ? FileShape::Kind::Area
                                                             : FileShape::Kind::Line,
                          .parts = isTrack ? 1 : shape.texts.size(),
                          .placesOf = [&shape, isTrack](std::size_t part) {
                              return isTrack ? placesOfTrack(shape)
                                             : placesOfTuples(shape.texts[part].text);
                          }});
    }
    return shapes;
}

/** Collects the features of a document from the events of `readXml`. */
class KmlDocument
{
public:
    KmlDocument(std::string_view text, ReadBudget& budget, const KmlSink& sink)
        : m_budget(budget), m_sink(sink), m_isOwn(isOwnExport(text)), m_geometry(budget)
    {
    }

    KmlStyles read(std::string_view text)
    {
        const XmlEvents events{.opened = [this](XmlPath path) { opened(path); },
                               .closed = [this](XmlPath path) { closed(path); }};
        readXml(text, events, m_budget);
        m_geometry.clear();
        return std::move(m_styles);
    }

private:
    void opened(XmlPath path)
    {
        const XmlElement& element = path.back();
        m_styles.opened(element, m_budget);
        if (m_inside)
            m_geometry.opened(path);
        if (element.name != "Placemark")
            return;
        m_inside = true;
        m_feature = {};
        m_feature.line = element.line;
        m_feature.isOwn = m_isOwn;
        m_feature.id = element.attribute("id");
        m_feature.geometry = &m_geometry;
        m_feature.shapes = [this] { return shapesOfKml(m_geometry); };
        m_properties = Json::object();
        m_feature.properties = &m_properties;
        m_geometry.clear();
        if (!m_folderTimes.empty())
            offerTime(m_folderTimes.back().text, kFeatureIdRank);
    }

    void closed(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        while (!m_folderTimes.empty() && m_folderTimes.back().depth >= path.size())
            m_folderTimes.pop_back();
        m_styles.closed(path);
        if (element.name == "href" && (parent == "Link" || parent == "Url"))
            addLink(path);
        else if (element.name == "when" || element.name == "begin" || element.name == "end")
            setTime(path);
        if (!m_inside)
            return;
        m_geometry.closed(path);
        if (element.name == "Placemark")
            finish();
        else if (element.name == "name" && parent == "Placemark")
            m_feature.name = element.text;
        else if (element.name == "styleUrl" && parent == "Placemark")
            m_feature.style = trimmed(element.text);
        else if (element.name == "Style" && parent == "Placemark")
            setColours();
        else if (element.name == "value" && parent == "Data")
            membersOf(m_properties)
                .emplace_back(path[path.size() - 2].attribute("name"), element.text);
        else if (element.name == "SimpleData")
            membersOf(m_properties).emplace_back(element.attribute("name"), element.text);
    }

    void setColours()
    {
        m_feature.fill = m_styles.last().fill;
        m_feature.stroke = m_styles.last().stroke;
    }

    void addLink(XmlPath path)
    {
        if (!m_sink.link || parentName(path.first(path.size() - 1)) != "NetworkLink")
            return; // link of a model or an image
        m_budget.take(2 * sizeof(KmlText) + path.back().text.capacity());
        m_sink.link({.line = path.back().line, .text = std::string(trimmed(path.back().text))});
    }

    /** Sets the time unless there is a better one. */
    void offerTime(std::string_view text, std::size_t rank)
    {
        if (text.empty() || (!m_feature.time.empty() && m_feature.timeRank <= rank))
            return;
        m_feature.time = text;
        m_feature.timeRank = rank;
    }

    /**
     * Sets the time of a Placemark, or of the folder or document around it, but not that of a view
     * of it. A span gives its begin, else its end.
     */
    void setTime(XmlPath path)
    {
        const std::string_view parent = parentName(path);
        if (parent != "TimeStamp" && parent != "TimeSpan")
            return;
        const std::string_view of = parentName(path.first(path.size() - 1));
        const std::string_view text = trimmed(path.back().text);
        if (of == "Placemark" && m_inside) {
            offerTime(text, path.back().name == "end" ? 1 : 0);
        } else if ((of == "Folder" || of == "Document") && !text.empty()) {
            const std::size_t depth = path.size() - 2;
            if (m_folderTimes.empty() || m_folderTimes.back().depth < depth)
                m_folderTimes.push_back({.depth = depth, .text = std::string(text.substr(0, 200))});
        }
    }

    void finish()
    {
        m_inside = false;
        if (m_isOwn)
            m_feature.kind = featureKind(&m_properties, m_feature.style);
        m_feature.style = KmlStyles::keyOf(m_feature.style);
        m_sink.feature(m_feature);
    }

    /** Time of a folder, which applies to its content. */
    struct FolderTime
    {
        std::size_t depth = 0;
        std::string text;
    };

    ReadBudget& m_budget;
    const KmlSink& m_sink;
    bool m_isOwn;
    bool m_inside = false; ///< whether a Placemark is open
    KmlFeature m_feature;
    Json m_properties;
    KmlGeometry m_geometry;
    KmlStyles m_styles;
    std::vector<FolderTime> m_folderTimes;
};

} // namespace

KmlStyles readKmlFeatures(std::string_view text, ReadBudget& budget, const KmlSink& sink)
{
    return KmlDocument(text, budget, sink).read(text);
}

} // namespace berg
