#pragma once

#include "core/io/text/read_budget.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg {

/** An open element of an XML text. */
struct XmlElement
{
    std::string name; ///< without its prefix
    std::size_t line = 0;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string text; ///< text of the element itself without its children; complete when the
                      ///< element is closed

    /** Returns the value of an attribute, or an empty text if the element has no such attribute. */
    [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/** The open elements, from the root to the current one. */
using XmlPath = std::span<const XmlElement>;

/** Callbacks of `readXml`: at the start of an element and at its end. */
struct XmlEvents
{
    std::function<void(XmlPath)> opened;
    std::function<void(XmlPath)> closed;
};

/**
 * Reads well-formed XML and calls `events` for each element. Text that is valid UTF-8 is read as
 * UTF-8 whatever it declares, other text (UTF-16, ISO 8859-1) as it declares. Prefixes of names are
 * dropped, with or without a declared namespace. Throws `Error` SyntaxError with line and reason,
 * also for nesting deeper than 64 and for a document type declaration, so that only the five
 * entities of XML exist. Exceptions of the callbacks and the budget pass through.
 */
void readXml(std::string_view text, const XmlEvents& events, ReadBudget& budget);

} // namespace berg
