#pragma once

#include <functional>
#include <string>
#include <vector>

namespace berg {

/** One row of the page of scenario fields; the texts may contain `code` of Markdown. */
struct FieldRow
{
    std::string field;    ///< "uavs[].airspeed_mps"
    std::string standard; ///< default as JSON, or a word if it is not a value
    std::string values;   ///< limits of a number, or names of a choice; empty if there are none
    std::string meaning;
    bool operator==(const FieldRow&) const = default;
};

/** Returns the translation of an English text of the tables (context `kFieldContext`). */
using FieldWords = std::function<std::string(const char* english)>;

/**
 * Returns a row for each field of a scenario file, in the order of `forEachObject`, with the
 * defaults of default-constructed objects. A part of `objectParts` stands before its fields or
 * after those of its object.
 */
[[nodiscard]] std::vector<FieldRow> fieldRows(const FieldWords& said);

/** Returns the English rows as a table in Markdown. */
[[nodiscard]] std::string fieldTable();

} // namespace berg
