#pragma once

#include "core/io/text/json_writer.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace berg {

// What the texts of `--json` share.

using ResultJson = nlohmann::ordered_json;

template <class T>
ResultJson orNull(const std::optional<T>& value)
{
    return value ? ResultJson(*value) : ResultJson(nullptr);
}

inline std::string resultText(const ResultJson& json)
{
    return jsonText(json, 1) + '\n';
}

} // namespace berg
