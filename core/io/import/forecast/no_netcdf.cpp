// The reader of NetCDF in a build without libnetcdf.
#include "core/base/error.h"
#include "core/io/import/forecast/netcdf_forecast.h"

namespace berg {

bool readsNetcdf()
{
    return false;
}

ForecastReading netcdfForecast(std::string_view /*bytes*/, const ForecastReadOptions& /*options*/,
                               ReadBudget& budget, const ForecastProgress& /*progress*/,
                               const std::stop_token& /*stop*/)
{
    throw Error(ErrorCode::Unsupported, budget.subject(),
                {IssueId::BuildLacks, {std::string("NetCDF"), std::string("libnetcdf-dev")}});
}

} // namespace berg
