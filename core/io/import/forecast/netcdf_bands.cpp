#include "core/io/import/forecast/netcdf_bands.h"

#include "core/base/error.h"
#include "core/io/import/forecast/cf_names.h"
#include "core/io/import/forecast/cf_time.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace berg {

namespace {

constexpr const char* kElement = "GRIB_ELEMENT";
constexpr const char* kLevel = "GRIB_SHORT_NAME"; // such as "10-HTGL"
constexpr const char* kValidTime = "GRIB_VALID_TIME";

struct BandElement
{
    std::string_view name;
    std::string_view levels; ///< codes of the surfaces at which it is wanted
    bool isExact;            ///< whether another level is useless
    GridNumber number;
};
constexpr std::array kBandElements{
    BandElement{"UGRD", "HTGL", true, GridNumber::WindEast},
    BandElement{"VGRD", "HTGL", true, GridNumber::WindNorth},
    BandElement{"GUST", "HTGL SFC", false, GridNumber::Gust},
    BandElement{"TMP", "HTGL", true, GridNumber::AirTemperature},
    BandElement{"DPT", "HTGL", true, GridNumber::DewPoint},
    BandElement{"VIS", "HTGL SFC", false, GridNumber::Visibility},
    BandElement{"CEIL", "CEIL SFC CBL HTGL", false, GridNumber::Ceiling},
    BandElement{"UOGRD", "SFC MSL DBSL", false, GridNumber::CurrentEast},
    BandElement{"VOGRD", "SFC MSL DBSL", false, GridNumber::CurrentNorth},
};

/** Returns the number at the begin of a text, as in "10-HTGL" or "1777615200 sec UTC". */
std::optional<double> leadingNumber(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    double number = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failed == std::errc{} ? std::optional(number) : std::nullopt;
}

/** Returns the time of an attribute that counts seconds since 1970. */
std::optional<ForecastTime> bandTime(const NetcdfFile& file, const NetcdfVariable& variable,
                                     const char* name)
{
    const std::vector<double> numbers = file.numbers(variable, name);
    const std::optional<double> seconds =
        numbers.empty() ? leadingNumber(file.text(&variable, name).value_or(""))
                        : std::optional(numbers.front());
    return seconds ? cfTime(*cfTimeUnit("seconds since 1970-01-01", ""), *seconds) : std::nullopt;
}

[[noreturn]] void failBand(const NetcdfFile& file, const NetcdfVariable& variable,
                           const char* attribute)
{
    throw Error(ErrorCode::InvalidInput, file.subject(),
                {{Severity::Error, variable.name + ':' + attribute, {IssueId::Missing}}});
}

} // namespace

bool isBand(const NetcdfFile& file, const NetcdfVariable& variable)
{
    const bool isUnnamed =
        variable.name.starts_with("Band") && !file.text(&variable, "standard_name") &&
        file.text(&variable, "long_name").value_or("").starts_with("GDAL Band Number");
    return isUnnamed || file.text(&variable, kElement);
}

std::optional<GribBand> gribBandOf(const NetcdfFile& file, const NetcdfVariable& variable)
{
    const std::optional<std::string> element = file.text(&variable, kElement);
    if (!element)
        failBand(file, variable, kElement);
    const auto known = std::ranges::find(kBandElements, *element, &BandElement::name);
    if (known == kBandElements.end())
        return std::nullopt;
    const std::string level = file.text(&variable, kLevel).value_or("");
    const std::optional<double> height_m = leadingNumber(level);
    if (!height_m)
        failBand(file, variable, kLevel);
    const std::string surface = level.substr(level.rfind('-') + 1);
    const double offset_m = std::abs(*height_m - wantedLevel_m(known->number));
    if (surface.empty() || known->levels.find(surface) == std::string_view::npos ||
        (known->isExact && offset_m > 0))
        return std::nullopt;
    const std::optional<ForecastTime> time = bandTime(file, variable, kValidTime);
    if (!time)
        failBand(file, variable, kValidTime);
    std::string unit = file.text(&variable, "GRIB_UNIT").value_or("");
    std::erase_if(unit, [](char c) { return c == '[' || c == ']'; });
    return GribBand{.number = known->number,
                    .levelOffset_m = offset_m,
                    .time = *time,
                    .issued = bandTime(file, variable, "GRIB_REF_TIME"),
                    .unit = unit};
}

} // namespace berg
