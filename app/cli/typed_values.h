#pragma once

#include "core/earth/geodesy.h"
#include "core/scenario/utc_time.h"

#include <optional>
#include <string>

namespace berg::cli {

/**
 * Returns the UTC time of an option's text, or nullopt if the text is empty. Throws `UsageError`
 * with the option's name if it is not a time.
 */
[[nodiscard]] std::optional<UtcTime> timeOf(const std::string& option, const std::string& text);

/** Returns the position of an option's text in the same way. */
[[nodiscard]] std::optional<LatLon> placeOf(const std::string& option, const std::string& text);

} // namespace berg::cli
