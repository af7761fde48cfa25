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

/** Names from files may hold broken UTF-8. */
inline std::string resultText(const ResultJson& json)
{
    return escapedJson(json.dump(1, ' ', false, ResultJson::error_handler_t::replace)) + '\n';
}

} // namespace berg
