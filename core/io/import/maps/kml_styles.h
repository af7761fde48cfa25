#pragma once

// Private to core/io: colours of the styles of a KML document.

#include "core/io/import/fields/import_xml.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace berg {

/** Colours of a style, 0xAARRGGBB; nullopt where it has none. */
struct KmlStyle
{
    std::optional<std::uint32_t> fill;
    std::optional<std::uint32_t> stroke;
};

/**
 * Collects the styles of a document from the events of `readXml` and charges the budget for them.
 */
class KmlStyles
{
public:
    void opened(const XmlElement& element, ReadBudget& budget);
    void closed(XmlPath path);

    /** Returns the style that was read last. */
    [[nodiscard]] const KmlStyle& last() const { return m_style; }
    /** Returns the style with this key, or the normal one of a style map. */
    [[nodiscard]] KmlStyle of(const std::string& key) const;
    /** Returns the key of a `styleUrl`, shortened because many features store one. */
    [[nodiscard]] static std::string keyOf(std::string_view url);

private:
    std::map<std::string, KmlStyle> m_styles;
    std::map<std::string, std::string> m_aliases; ///< normal styles of style maps
    KmlStyle m_style;
    std::string m_mapKey;
    std::string m_pairKey;
    std::string m_pairUrl;
};

} // namespace berg
