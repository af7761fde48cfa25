#include "core/io/import/import_forecast_file.h"

#include "core/base/error.h"
#include "core/io/import/forecast/grib_forecast.h"
#include "core/io/import/forecast/netcdf_forecast.h"
#include "core/io/import/forecast/reading_bytes.h"
#include "core/io/import/import_forecast.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/isolated_work.h"
#include "core/io/text/read_budget.h"

namespace berg {

namespace {

enum class ForecastFormat
{
    Json,
    Netcdf,
    Grib,
    Other
};

ForecastFormat forecastFormatOf(std::string_view bytes)
{
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89HDF\r\n\x1a\n"sv))
        return ForecastFormat::Netcdf;
    if (bytes.starts_with("CDF") && bytes.size() > 3 &&
        (bytes[3] == '\x01' || bytes[3] == '\x02' || bytes[3] == '\x05'))
        return ForecastFormat::Netcdf;
    if (bytes.starts_with("GRIB"))
        return ForecastFormat::Grib;
    constexpr std::size_t kHead = 4096; // the series follows place and units
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return first != std::string_view::npos && bytes[first] == '{' &&
                   bytes.substr(0, kHead).find("\"timeseries\"") != std::string_view::npos
               ? ForecastFormat::Json
               : ForecastFormat::Other;
}

using GridReader = ForecastReading (*)(std::string_view, const ForecastReadOptions&, ReadBudget&,
                                       const ForecastProgress&, const std::stop_token&);

ForecastReading readIsolated(GridReader read, std::string_view bytes, const std::string& subject,
                             const ForecastReadOptions& options, const ForecastProgress& progress,
                             const std::stop_token& stop)
{
    // Memory beside that of the budget is the library's: its tables, and chunks it unpacks.
    constexpr std::size_t kLibrary = 600'000'000;
    const std::size_t most = readLimit(10 * bytes.size() + kLibrary);
    return readingFrom(runIsolated(
        subject,
        [&](const std::function<void(double)>& report) {
            ReadBudget budget(subject, bytes.size());
            return bytesOf(read(bytes, options, budget, report, {}));
        },
        {.memory = most, .processor_s = 120}, progress, stop));
}

} // namespace

bool looksLikeForecast(std::string_view bytes)
{
    return forecastFormatOf(bytes) != ForecastFormat::Other;
}

ForecastReading forecastFromBytes(std::string_view bytes, const std::string& subject,
                                  const ForecastReadOptions& options,
                                  const ForecastProgress& progress, const std::stop_token& stop)
{
    // Throws if the file is too large, before another process begins.
    const ReadBudget budget(subject, bytes.size(), stop);
    budget.throwIfStopped();
    switch (forecastFormatOf(bytes)) {
    case ForecastFormat::Netcdf:
        if (readsNetcdf())
            return readIsolated(netcdfForecast, bytes, subject, options, progress, stop);
        break;
    case ForecastFormat::Grib:
        if (readsGrib())
            return readIsolated(gribForecast, bytes, subject, options, progress, stop);
        break;
    case ForecastFormat::Json:
    case ForecastFormat::Other:
        return {.format = "MET Norway JSON",
                .field = {.places = {forecastFromJson(bytes, subject, stop)}}};
    }
    ReadBudget unused(subject, bytes.size());
    return forecastFormatOf(bytes) == ForecastFormat::Netcdf
               ? netcdfForecast(bytes, options, unused, progress, stop)
               : gribForecast(bytes, options, unused, progress, stop);
}

ForecastReading loadForecastFile(const std::string& path, const ForecastReadOptions& options,
                                 const ForecastProgress& progress, const std::stop_token& stop)
{
    return forecastFromBytes(readFile(path, stop), path, options, progress, stop);
}

} // namespace berg
