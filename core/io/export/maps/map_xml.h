#pragma once

// Private to core/io: pieces of the XML of KML and GPX. Texts are escaped by `htmlText`, so any
// name is allowed in them.

#include "core/base/number_text.h"
#include "core/io/export/maps/map_features.h"
#include "core/io/text/html_text.h"

#include <string>
#include <string_view>

namespace berg {

/** Returns `<name>text</name>` with the text escaped. */
[[nodiscard]] inline std::string xmlElement(std::string_view name, std::string_view text)
{
    const std::string tag(name);
    return "<" + tag + ">" + htmlText(text) + "</" + tag + ">";
}

/** Returns the ISO 8601 text of an instant of the content; empty if it has no start time. */
[[nodiscard]] inline std::string timeText(const ExportContent& content, double time_s)
{
    return content.start ? utcText(*content.start, time_s) : std::string();
}

/** Returns the value of a property of `flatProperties`. */
[[nodiscard]] inline std::string valueText(const MapValue& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return decimalText(*number);
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return std::to_string(*whole);
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? "true" : "false";
    return std::get<std::string>(value);
}

} // namespace berg
