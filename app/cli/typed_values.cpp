#include "app/cli/typed_values.h"

#include "app/cli/console.h"
#include "core/earth/coordinates.h"
#include "core/io/import/fields/import_time.h"

#include <variant>

namespace berg::cli {

std::optional<UtcTime> timeOf(const std::string& option, const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    const std::optional<UtcTime> time = parseTypedTime(text);
    if (!time)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine",
                                           "%1: %2 is not a UTC time such as 2026-05-01T12:00:00Z"),
                         {option, text});
    return time;
}

std::optional<LatLon> placeOf(const std::string& option, const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    const std::variant<LatLon, CoordinateFault> place = parsePlace(text);
    if (!std::holds_alternative<LatLon>(place))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1: %2 is not a position such as "
                                                          "64.51N,59.80W"),
                         {option, text});
    return std::get<LatLon>(place);
}

} // namespace berg::cli
