#include "core/io/import/forecast/netcdf_axes.h"

#include "core/base/error.h"
#include "core/io/import/forecast/grid_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostCoordinates = 20'000'000;

bool isAnyOf(std::string_view text, std::initializer_list<std::string_view> words)
{
    return std::ranges::find(words, text) != words.end();
}

/** Returns the position of a dimension in a variable's, or nullopt. */
std::optional<std::size_t> axisPositionOf(const NetcdfVariable& variable, std::size_t dimension)
{
    const auto at = std::ranges::find(variable.dimensions, dimension);
    if (at == variable.dimensions.end())
        return std::nullopt;
    return static_cast<std::size_t>(at - variable.dimensions.begin());
}

std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    std::size_t at = 0;
    while ((at = text.find_first_not_of(' ', at)) != std::string::npos) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

} // namespace

std::string NetcdfAxisReader::attribute(const NetcdfVariable& variable, const char* name) const
{
    return m_file.text(&variable, name).value_or(std::string());
}

const NetcdfVariable* NetcdfAxisReader::variableNamed(std::string_view name) const
{
    const auto at = std::ranges::find(m_file.variables(), name, &NetcdfVariable::name);
    return at == m_file.variables().end() || !at->isNumeric ? nullptr : &*at;
}

bool NetcdfAxisReader::isLatitude(const NetcdfVariable& variable) const
{
    if (const std::string name = attribute(variable, "standard_name"); !name.empty())
        return name == "latitude";
    return isAnyOf(attribute(variable, "units"), {"degrees_north", "degree_north", "degree_N",
                                                  "degrees_N", "degreeN", "degreesN"}) ||
           isAnyOf(variable.name, {"lat", "latitude", "nav_lat"});
}

bool NetcdfAxisReader::isLongitude(const NetcdfVariable& variable) const
{
    if (const std::string name = attribute(variable, "standard_name"); !name.empty())
        return name == "longitude";
    return isAnyOf(attribute(variable, "units"), {"degrees_east", "degree_east", "degree_E",
                                                  "degrees_E", "degreeE", "degreesE"}) ||
           isAnyOf(variable.name, {"lon", "longitude", "nav_lon"});
}

bool NetcdfAxisReader::isTime(const NetcdfVariable& variable) const
{
    return variable.dimensions.size() <= 1 &&
           attribute(variable, "units").find(" since ") != std::string::npos &&
           !isAnyOf(attribute(variable, "standard_name"),
                    {"forecast_reference_time", "forecast_period"}) &&
           variable.name != "forecast_reference_time";
}

std::vector<const NetcdfVariable*>
NetcdfAxisReader::coordinatesOf(const NetcdfVariable& variable) const
{
    std::vector<const NetcdfVariable*> found;
    const auto add = [&](std::string_view name) {
        if (const NetcdfVariable* const known = variableNamed(name);
            known != nullptr && known != &variable)
            found.push_back(known);
    };
    for (const std::string& name : wordsOf(attribute(variable, "coordinates")))
        add(name);
    for (const std::size_t dimension : variable.dimensions)
        add(m_file.dimensions()[dimension].name);
    return found;
}

/** Sets row and column from the dimensions of latitude and longitude. */
bool NetcdfAxisReader::placeBy(const NetcdfVariable& variable, NetcdfAxes& axes) const
{
    const std::vector<std::size_t>& lat = axes.latitude->dimensions;
    const std::vector<std::size_t>& lon = axes.longitude->dimensions;
    if (lat.empty() && lon.empty())
        return true; // one place
    if (lat.size() == 2 && lat == lon) {
        axes.row = axisPositionOf(variable, lat[0]);
        axes.column = axisPositionOf(variable, lat[1]);
        return axes.row && axes.column && axes.row != axes.column;
    }
    if (lat.size() != 1 || lon.size() != 1)
        return false;
    axes.row = axisPositionOf(variable, lat[0]);
    axes.column = axisPositionOf(variable, lon[0]);
    return axes.row && axes.column && axes.row != axes.column; // else a list of stations
}

bool NetcdfAxisReader::place(const NetcdfVariable& variable, NetcdfAxes& axes) const
{
    for (const NetcdfVariable* const coordinate : coordinatesOf(variable)) {
        if (axes.latitude == nullptr && isLatitude(*coordinate))
            axes.latitude = coordinate;
        if (axes.longitude == nullptr && isLongitude(*coordinate))
            axes.longitude = coordinate;
    }
    if (axes.latitude != nullptr && axes.longitude != nullptr)
        return placeBy(variable, axes);
    // A variable need not name its coordinates: those that share two of its dimensions.
    for (const NetcdfVariable& latitude : m_file.variables())
        for (const NetcdfVariable& longitude : m_file.variables()) {
            if (!latitude.isNumeric || latitude.dimensions.size() != 2 ||
                latitude.dimensions != longitude.dimensions || !isLatitude(latitude) ||
                !isLongitude(longitude))
                continue;
            axes.latitude = &latitude;
            axes.longitude = &longitude;
            if (placeBy(variable, axes))
                return true;
        }
    return false;
}

bool NetcdfAxisReader::chooseLevels(const NetcdfVariable& variable, double wanted_m,
                                    NetcdfAxes& axes) const
{
    for (std::size_t i = 0; i < variable.dimensions.size(); ++i) {
        if (i == axes.row || i == axes.column || i == axes.instant)
            continue;
        const NetcdfDimension& dimension = m_file.dimensions()[variable.dimensions[i]];
        if (dimension.size == 0)
            return false;
        NetcdfLevel level{.dimension = i};
        const NetcdfVariable* const axis = variableNamed(dimension.name);
        if (axis == nullptr || axis->dimensions.size() != 1) {
            // Levels of ROMS rise from the bottom to the surface.
            if (dimension.name.starts_with("s_"))
                level.index = dimension.size - 1;
            axes.levels.push_back(level);
            continue;
        }
        const std::string unit = attribute(*axis, "units");
        const std::string name = attribute(*axis, "standard_name");
        if (isAnyOf(unit, {"Pa", "hPa", "mb", "mbar", "millibar", "K"}) || name == "air_pressure" ||
            name.starts_with("atmosphere_"))
            return false;
        if (name != "realization" && !isAnyOf(unit, {"1", ""})) {
            double best = std::numeric_limits<double>::infinity();
            const std::vector<double> heights = valuesOf(*axis);
            for (std::size_t k = 0; k < heights.size(); ++k)
                if (const double offset = std::abs(std::abs(heights[k]) - wanted_m);
                    offset < best) {
                    best = offset;
                    level.index = k;
                }
            axes.levelOffset_m = best;
        } else if (name.starts_with("ocean_s") || dimension.name.starts_with("s_")) {
            level.index = dimension.size - 1;
        }
        axes.levels.push_back(level);
    }
    return true;
}

std::optional<NetcdfAxes> NetcdfAxisReader::axesOf(const NetcdfVariable& variable,
                                                   double wanted_m) const
{
    NetcdfAxes axes;
    if (!variable.isNumeric || !place(variable, axes))
        return std::nullopt;
    for (const NetcdfVariable* const coordinate : coordinatesOf(variable)) {
        if (axes.time != nullptr || !isTime(*coordinate))
            continue;
        if (coordinate->dimensions.empty()) {
            axes.time = coordinate;
        } else if (const auto at = axisPositionOf(variable, coordinate->dimensions[0]);
                   at && at != axes.row && at != axes.column) {
            axes.time = coordinate;
            axes.instant = at;
        }
    }
    for (const NetcdfVariable& time : m_file.variables()) {
        if (axes.time != nullptr || !time.isNumeric || time.dimensions.size() != 1 || !isTime(time))
            continue;
        if (const auto at = axisPositionOf(variable, time.dimensions[0]);
            at && at != axes.row && at != axes.column) {
            axes.time = &time;
            axes.instant = at;
        }
    }
    if (!chooseLevels(variable, wanted_m, axes))
        return std::nullopt;
    return axes;
}

std::size_t NetcdfAxisReader::sizeOf(const NetcdfVariable& variable) const
{
    std::size_t size = 1;
    for (const std::size_t dimension : variable.dimensions) {
        const std::size_t length = m_file.dimensions()[dimension].size;
        if (length == 0)
            return 0;
        if (size > readLimit(kMostCoordinates) / length)
            throw Error(ErrorCode::FileTooLarge, m_file.subject(),
                        {{Severity::Error,
                          variable.name,
                          {IssueId::TooManyValues,
                           {countOf(readLimit(kMostCoordinates)), doubledLimits()}}}});
        size *= length;
    }
    return size;
}

std::vector<double> NetcdfAxisReader::valuesOf(const NetcdfVariable& variable) const
{
    m_budget.take(sizeOf(variable) * sizeof(double));
    std::vector<std::size_t> start(variable.dimensions.size());
    std::vector<std::size_t> count;
    for (const std::size_t dimension : variable.dimensions)
        count.push_back(m_file.dimensions()[dimension].size);
    std::vector<double> values = m_file.read(variable, start, count);
    const std::vector<double> scale = m_file.numbers(variable, "scale_factor");
    const std::vector<double> offset = m_file.numbers(variable, "add_offset");
    const std::vector<double> fill = m_file.numbers(variable, "_FillValue");
    for (double& value : values) {
        if ((!fill.empty() && value == fill[0]) || std::abs(value) > 1e30)
            value = std::numeric_limits<double>::quiet_NaN();
        else if (!scale.empty() || !offset.empty())
            value = value * (scale.empty() ? 1 : scale[0]) + (offset.empty() ? 0 : offset[0]);
    }
    return values;
}

SourceGrid NetcdfAxisReader::gridOf(const NetcdfVariable& variable, const NetcdfAxes& axes) const
{
    const auto length = [&](const std::optional<std::size_t>& at) {
        return at ? m_file.dimensions()[variable.dimensions[*at]].size : 1;
    };
    SourceGrid grid{.rows = length(axes.row),
                    .columns = length(axes.column),
                    .latitude_deg = valuesOf(*axes.latitude),
                    .longitude_deg = valuesOf(*axes.longitude)};
    makeRectilinear(grid);
    if (axes.column)
        if (const NetcdfVariable* const x =
                variableNamed(m_file.dimensions()[variable.dimensions[*axes.column]].name);
            x != nullptr && x->dimensions.size() == 1)
            if (const std::vector<double> values = valuesOf(*x); values.size() > 1)
                grid.againstX = values.back() < values.front();
    return grid;
}

std::vector<ForecastTime> NetcdfAxisReader::timesOf(const NetcdfVariable& time) const
{
    const auto fail = [&](IssueReason reason) {
        return Error(ErrorCode::InvalidInput, m_file.subject(),
                     {{Severity::Error, time.name, std::move(reason)}});
    };
    const std::string text = attribute(time, "units");
    const std::string calendar = attribute(time, "calendar");
    const std::optional<CfTimeUnit> unit = cfTimeUnit(text, calendar);
    if (!unit)
        throw fail({IssueId::TimeUnitUnknown, {text, calendar}});
    std::vector<ForecastTime> times;
    for (const double value : valuesOf(time)) {
        const std::optional<ForecastTime> instant = cfTime(*unit, value);
        if (!instant)
            throw fail({IssueId::NotUtcTime});
        if (!times.empty() && *instant <= times.back())
            throw fail({IssueId::NotRising});
        times.push_back(*instant);
    }
    return times;
}

} // namespace berg
