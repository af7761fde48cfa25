#pragma once

#include "core/io/text/json_writer.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace berg {

// Helpers for the documents of `--json`.

using ResultJson = nlohmann::ordered_json;

/** JSON value, or null for nullopt. */
template <class T>
ResultJson orNull(const std::optional<T>& value)
{
    return value ? ResultJson(*value) : ResultJson(nullptr);
}

/** Returns the text of a document: indented, with a final newline. */
inline std::string resultText(const ResultJson& json)
{
    return jsonText(json, 1) + '\n';
}

} // namespace berg
