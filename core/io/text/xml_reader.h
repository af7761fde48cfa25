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

/** An element of an XML text that is being read. */
struct XmlElement
{
    std::string name; ///< without its namespace
    std::size_t line = 0;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string text; ///< its own, not that of its children; whole when it is closed

    /** Value of an attribute, empty without it. */
    [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/** The elements that are open, the root first and the one in question last. */
using XmlPath = std::span<const XmlElement>;

struct XmlEvents
{
    std::function<void(XmlPath)> opened;
    std::function<void(XmlPath)> closed;
};

/**
 * Reads well-formed XML (UTF-8, UTF-16 or ISO 8859-1) and tells of each element in turn. Throws
 * `Error` SyntaxError with line and reason; also for a document type declaration, so that there are
 * no entities but the five of XML, and for nesting deeper than 64. What the callbacks and the
 * budget throw passes.
 */
void readXml(std::string_view text, const XmlEvents& events, ReadBudget& budget);

} // namespace berg
