#pragma once

#include "core/io/text/utc_time.h"

#include <QString>

#include <optional>
#include <variant>

namespace berg {

/**
 * The UTC time that a user types, in every form the imports read, or a sentence why it is none. A
 * time of day alone ("1200Z") is of the day of `day`, where there is one.
 */
[[nodiscard]] std::variant<UtcTime, QString> readTime(const QString& text,
                                                      std::optional<UtcTime> day);

} // namespace berg
