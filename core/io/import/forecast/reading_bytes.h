#pragma once

#include "core/io/import/forecast/forecast_reading.h"

#include <string>
#include <string_view>

namespace berg {

/** Returns a reading as bytes that `readingFrom` of the same program turns back. */
[[nodiscard]] std::string bytesOf(const ForecastReading& reading);
/** Throws `std::logic_error` for other bytes. */
[[nodiscard]] ForecastReading readingFrom(std::string_view bytes);

} // namespace berg
