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
    m_points.clear();
    m_tracks.clear();
    m_areas.clear();
    m_longitude.clear();
    m_latitude.clear();
    m_hasLines = false;
}

std::string KmlGeometry::stored(std::string text)
{
    const std::size_t memory = 3 * sizeof(KmlText) + text.capacity(); // of a growing list
    m_budget.take(memory);
    m_memory += memory;
    return text;
}

void KmlGeometry::opened(XmlPath path)
{
    const std::string& name = path.back().name;
    if (name == "Track") {
        stored({});
        m_tracks.emplace_back();
    } else if (name == "Polygon") {
        stored({});
        m_areas.emplace_back();
    }
}

void KmlGeometry::closed(XmlPath path)
{
    const XmlElement& element = path.back();
    const std::string_view parent = parentName(path);
    if (element.name == "when" && parent == "Track")
        m_tracks.back().whens.push_back(stored(element.text));
    else if (element.name == "coord" && parent == "Track")
        m_tracks.back().coordinates.push_back({.line = element.line, .text = stored(element.text)});
    else if (element.name == "coordinates")
        addCoordinates(path);
    else if (element.name == "longitude" && parent == "Location")
        m_longitude = element.text;
    else if (element.name == "latitude" && parent == "Location")
        m_latitude = element.text;
    else if (element.name == "Location" && parent == "Model")
        m_points.push_back(
            stored(std::string(trimmed(m_longitude)) + ',' + std::string(trimmed(m_latitude))));
}

void KmlGeometry::addCoordinates(XmlPath path)
{
    const std::string& text = path.back().text;
    const std::string_view parent = parentName(path);
    const std::string_view grandparent = parentName(path.first(path.size() - 1));
    if (parent == "Point")
        m_points.push_back(stored(text));
    else if (parent == "LinearRing" && grandparent == "outerBoundaryIs" && !m_areas.empty())
        m_areas.back().outline = stored(text);
    else if (parent == "LinearRing" && grandparent == "innerBoundaryIs" && !m_areas.empty())
        m_areas.back().holes.push_back(stored(text));
    else
        m_hasLines = true;
}

} // namespace berg
