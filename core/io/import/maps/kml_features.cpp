#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_scene.h"
#include "core/io/import/maps/feature_parsers.h"

#include <charconv>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace berg {

namespace {

/** Returns the place of a Point, whose text must be one tuple without decimal commas. */
FilePlace placeOfPoint(const std::string& text)
{
    std::optional<std::vector<KmlTuple>> tuples = kmlTuples(text);
    if (tuples && tuples->size() == 1)
        return {.longitude = std::move(tuples->front().longitude),
                .latitude = std::move(tuples->front().latitude),
                .mayHaveCommas = tuples->front().mayHaveCommas};
    if (text.find_first_of("0123456789") == std::string::npos)
        return {.fault = IssueId::NoPosition, .mayHaveCommas = text.find(',') != text.npos};
    return {.fault = IssueId::PlaceAmbiguous,
            .detail = cleanText(text, 60),
            .mayHaveCommas = text.find(',') != text.npos};
}

/** Returns a place of a track, whose time counts even if it is missing. */
FilePlace placeOfTrack(const KmlShape& track, std::size_t i)
{
    const KmlText& given = track.texts[i];
    FilePlace place{.line = given.line,
                    .time = i < track.whens.size() ? track.whens[i] : std::string()};
    if (std::optional<KmlTuple> tuple = kmlCoord(given.text)) {
        place.longitude = std::move(tuple->longitude);
        place.latitude = std::move(tuple->latitude);
    } else if (!trimmed(given.text).empty()) {
        place.fault = IssueId::PlaceAmbiguous;
        place.detail = cleanText(given.text, 60);
    }
    return place;
}

FileShape shapeOfKml(const KmlShape& shape)
{
    const std::size_t texts = shape.texts.size();
    if (shape.kind == KmlShape::Kind::Point)
        return {.icebergs = {.count = 1, .at = [&shape](std::size_t) {
                                 return placeOfPoint(shape.texts[0].text);
                             }}};
    if (shape.kind == KmlShape::Kind::Track)
        return {.kind = ShapeKind::Track,
                .icebergs = {.count = texts,
                             .at = [&shape](std::size_t i) { return placeOfTrack(shape, i); },
                             .timesLeft = shape.whens.size() > texts}};
    return {
        .kind = shape.kind == KmlShape::Kind::Area ? ShapeKind::Area : ShapeKind::Line,
        .parts = texts,
        .readPart = [&shape](std::size_t part) { return placesOfTuples(shape.texts[part].text); }};
}

/** Reads a colour of KML (aabbggrr), or returns nullopt. */
std::optional<std::uint32_t> kmlColour(std::string_view text)
{
    const std::string_view digits = trimmed(text);
    std::uint32_t abgr = 0;
    const char* const end = digits.data() + digits.size();
    const auto [read, fault] = std::from_chars(digits.data(), end, abgr, 16);
    if (digits.size() != 8 || fault != std::errc() || read != end)
        return std::nullopt;
    return (abgr & 0xFF00FF00U) | ((abgr & 0xFFU) << 16U) | ((abgr >> 16U) & 0xFFU);
}

/** Returns the key of a `styleUrl`, shortened because many features store one. */
std::string keyOfStyle(std::string_view url)
{
    return std::string(trimmed(url).substr(0, kLongestName));
}

/** Collects the styles of a document from the events of `readXml`. */
class KmlStyleReader
{
public:
    void opened(const XmlElement& element, ReadBudget& budget)
    {
        constexpr std::size_t kStyle = 128 + 2 * kLongestName; // a style with its keys in a map
        if (element.name == "Style" || element.name == "Pair")
            budget.take(kStyle);
        if (element.name == "Style") {
            m_style = {};
        } else if (element.name == "StyleMap") {
            m_mapKey = keyOfStyle('#' + element.attribute("id"));
        } else if (element.name == "Pair") {
            m_pairKey.clear();
            m_pairUrl.clear();
        }
    }

    void closed(XmlPath path)
    {
        const XmlElement& element = path.back();
        const std::string_view parent = parentName(path);
        const bool isOff = trimmed(element.text) == "0";
        if (element.name == "styleUrl" && parent == "Pair")
            m_pairUrl = keyOfStyle(element.text);
        else if (element.name == "key" && parent == "Pair")
            m_pairKey = trimmed(element.text);
        else if (element.name == "Pair" && m_pairKey == "normal")
            m_normal[m_mapKey] = m_pairUrl;
        else if (element.name == "color" && parent == "PolyStyle")
            m_style.fill = kmlColour(element.text);
        else if (element.name == "color" && parent == "LineStyle")
            m_style.stroke = kmlColour(element.text);
        else if (element.name == "fill" && parent == "PolyStyle" && isOff)
            m_style.fill = 0;
        else if (element.name == "outline" && parent == "PolyStyle" && isOff)
            m_style.stroke = 0;
        else if (element.name == "Style" && parent != "Placemark")
            m_styles[keyOfStyle('#' + element.attribute("id"))] = m_style;
    }

    /** Returns the style that was read last. */
    [[nodiscard]] const KmlStyle& last() const { return m_style; }

    /** Returns the styles by their keys; a style map has the normal one of its styles. */
    KmlStyles take()
    {
        for (const auto& [map, style] : m_normal)
            if (const auto found = m_styles.find(style); found != m_styles.end())
                m_resolved[map] = found->second;
        m_resolved.merge(m_styles);
        return std::move(m_resolved);
    }

private:
    KmlStyles m_styles;
    KmlStyles m_resolved;
    std::map<std::string, std::string> m_normal; ///< normal styles of style maps
    KmlStyle m_style;
    std::string m_mapKey;
    std::string m_pairKey;
    std::string m_pairUrl;
};

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
        return m_styles.take();
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
        m_feature.geometry = [this] {
            // In a Bergwatch export, an area of another program is somebody's note.
            FileGeometry geometry{.hasIcebergAreas = !m_isOwn};
            for (const KmlShape& shape : m_geometry.shapes())
                geometry.shapes.push_back(shapeOfKml(shape));
            return geometry;
        };
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
        m_feature.style = keyOfStyle(m_feature.style);
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
    FileFeature m_feature;
    Json m_properties;
    KmlGeometry m_geometry;
    KmlStyleReader m_styles;
    std::vector<FolderTime> m_folderTimes;
};

} // namespace

KmlStyles readKmlFeatures(std::string_view text, ReadBudget& budget, const KmlSink& sink)
{
    return KmlDocument(text, budget, sink).read(text);
}

} // namespace berg
