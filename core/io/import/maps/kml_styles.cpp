#include "core/io/import/maps/kml_styles.h"

#include "core/io/import/fields/import_fields.h"

#include <charconv>

namespace berg {

namespace {

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

} // namespace

void KmlStyles::opened(const XmlElement& element, ReadBudget& budget)
{
    constexpr std::size_t kStyle = 128 + 2 * kLongestName; // a style with its keys in a map
    if (element.name == "Style" || element.name == "Pair")
        budget.take(kStyle);
    if (element.name == "Style") {
        m_style = {};
    } else if (element.name == "StyleMap") {
        m_mapKey = keyOf('#' + element.attribute("id"));
    } else if (element.name == "Pair") {
        m_pairKey.clear();
        m_pairUrl.clear();
    }
}

void KmlStyles::closed(XmlPath path)
{
    const XmlElement& element = path.back();
    const std::string_view parent = parentName(path);
    const bool isOff = trimmed(element.text) == "0";
    if (element.name == "styleUrl" && parent == "Pair")
        m_pairUrl = keyOf(element.text);
    else if (element.name == "key" && parent == "Pair")
        m_pairKey = trimmed(element.text);
    else if (element.name == "Pair" && m_pairKey == "normal")
        m_aliases[m_mapKey] = m_pairUrl;
    else if (element.name == "color" && parent == "PolyStyle")
        m_style.fill = kmlColour(element.text);
    else if (element.name == "color" && parent == "LineStyle")
        m_style.stroke = kmlColour(element.text);
    else if (element.name == "fill" && parent == "PolyStyle" && isOff)
        m_style.fill = 0;
    else if (element.name == "outline" && parent == "PolyStyle" && isOff)
        m_style.stroke = 0;
    else if (element.name == "Style" && parent != "Placemark")
        m_styles[keyOf('#' + element.attribute("id"))] = m_style;
}

KmlStyle KmlStyles::of(const std::string& key) const
{
    const auto alias = m_aliases.find(key);
    const auto found = m_styles.find(alias == m_aliases.end() ? key : alias->second);
    return found == m_styles.end() ? KmlStyle() : found->second;
}

std::string KmlStyles::keyOf(std::string_view url)
{
    return std::string(trimmed(url).substr(0, kLongestName));
}

} // namespace berg
