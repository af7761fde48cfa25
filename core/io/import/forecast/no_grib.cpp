// The reader of GRIB in a build without ecCodes.
#include "core/base/error.h"
#include "core/io/import/forecast/grib_forecast.h"

namespace berg {

bool readsGrib()
{
    return false;
}

ForecastReading gribForecast(std::string_view /*bytes*/, const ForecastReadOptions& /*options*/,
                             ReadBudget& budget, const ForecastProgress& /*progress*/,
                             const std::stop_token& /*stop*/)
{
    throw Error(ErrorCode::Unsupported, budget.subject(),
                {IssueId::BuildLacks, {std::string("GRIB"), std::string("libeccodes-dev")}});
}

} // namespace berg
