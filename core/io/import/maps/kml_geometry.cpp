#include "core/io/import/maps/kml_geometry.h"

#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

/** Removes the first tuple and returns its values; blanks around a comma do not separate tuples. */
std::vector<std::string_view> takeTuple(std::string_view& rest)
{
    std::vector<std::string_view> values;
    for (bool continues = true; continues;) {
        const std::size_t end = std::min(rest.find_first_of(" \t\r\n\v\f,"), rest.size());
        values.push_back(rest.substr(0, end));
        rest.remove_prefix(end);
        rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
        continues = rest.starts_with(',');
        if (continues) {
            rest.remove_prefix(1);
            rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
        }
    }
    if (values.size() > 1 && values.back().empty()) // a comma at the end
        values.pop_back();
    return values;
}

bool isWhole(std::string_view value)
{
    return value.find_first_not_of("+-0123456789") == std::string_view::npos;
}

std::optional<KmlTuple> tupleOf(const std::vector<std::string_view>& values)
{
    if (values.size() < 2 || values.size() > 3)
        return std::nullopt;
    return KmlTuple{.longitude = std::string(values[0]),
                    .latitude = std::string(values[1]),
                    .mayHaveCommas = values.size() == 3 && std::ranges::all_of(values, isWhole)};
}

} // namespace

std::optional<std::vector<KmlTuple>> kmlTuples(std::string_view text)
{
    std::vector<KmlTuple> tuples;
    for (std::string_view rest = trimmed(text); !rest.empty();) {
        std::optional<KmlTuple> tuple = tupleOf(takeTuple(rest));
        if (!tuple)
            return std::nullopt;
        tuples.push_back(std::move(*tuple));
    }
    return tuples;
}

std::optional<KmlTuple> kmlCoord(std::string_view text)
{
    std::vector<std::string_view> values;
    for (std::string_view rest = trimmed(text); !rest.empty(); rest = trimmed(rest)) {
        const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
        values.push_back(rest.substr(0, end));
        rest.remove_prefix(end);
    }
    const bool hasCommaEnds =
        std::ranges::any_of(values, [](std::string_view value) { return value.ends_with(','); });
    if (values.size() > 1 && !hasCommaEnds)
        return tupleOf(values);
    const std::optional<std::vector<KmlTuple>> tuples = kmlTuples(text);
    return tuples && tuples->size() == 1 ? std::optional(tuples->front()) : std::nullopt;
}

void KmlGeometry::clear()
{
    m_budget.release(std::exchange(m_memory, 0));
    m_shapes.clear();
    m_area.reset();
    m_longitude.clear();
    m_latitude.clear();
}

bool KmlGeometry::has(KmlShape::Kind kind) const
{
    return std::ranges::find(m_shapes, kind, &KmlShape::kind) != m_shapes.end();
}

KmlText KmlGeometry::stored(std::size_t line, std::string text)
{
    const std::size_t memory = 3 * sizeof(KmlText) + text.capacity(); // of a growing list
    m_budget.take(memory);
    m_memory += memory;
    return {.line = line, .text = std::move(text)};
}

void KmlGeometry::addShape(KmlShape::Kind kind, KmlText text)
{
    m_shapes.push_back({.kind = kind, .texts = {}, .whens = {}});
    if (kind != KmlShape::Kind::Track)
        m_shapes.back().texts.push_back(std::move(text));
}

void KmlGeometry::opened(XmlPath path)
{
    const XmlElement& element = path.back();
    if (element.name == "Track") {
        m_track = m_shapes.size();
        addShape(KmlShape::Kind::Track, stored(element.line, {}));
    } else if (element.name == "Polygon") {
        m_area = m_shapes.size();
        addShape(KmlShape::Kind::Area, stored(element.line, {}));
    }
}

void KmlGeometry::closed(XmlPath path)
{
    const XmlElement& element = path.back();
    const std::string_view parent = parentName(path);
    if (element.name == "when" && parent == "Track")
        m_shapes[m_track].whens.push_back(stored(element.line, element.text).text);
    else if (element.name == "coord" && parent == "Track")
        m_shapes[m_track].texts.push_back(stored(element.line, element.text));
    else if (element.name == "coordinates")
        addCoordinates(path);
    else if (element.name == "longitude" && parent == "Location")
        m_longitude = element.text;
    else if (element.name == "latitude" && parent == "Location")
        m_latitude = element.text;
    else if (element.name == "Location" && parent == "Model")
        addShape(KmlShape::Kind::Point,
                 stored(element.line, std::string(trimmed(m_longitude)) + ',' +
                                          std::string(trimmed(m_latitude))));
}

void KmlGeometry::addCoordinates(XmlPath path)
{
    KmlText text = stored(path.back().line, path.back().text);
    const std::string_view parent = parentName(path);
    const std::string_view grandparent = parentName(path.first(path.size() - 1));
    const bool isRing = parent == "LinearRing" && m_area.has_value();
    if (isRing && grandparent == "outerBoundaryIs")
        m_shapes[*m_area].texts.front() = std::move(text);
    else if (isRing && grandparent == "innerBoundaryIs")
        m_shapes[*m_area].texts.push_back(std::move(text));
    else
        addShape(parent == "Point" ? KmlShape::Kind::Point : KmlShape::Kind::Line, std::move(text));
}

} // namespace berg
