#include "core/io/import/forecast/cf_names.h"

#include <algorithm>
#include <cctype>
#include <span>

namespace berg {

namespace {

using enum GridNumber;

struct NumberName
{
    std::string_view name;
    GridNumber number;
};

constexpr NumberName kStandardNames[] = {
    {"eastward_wind", WindEast},
    {"northward_wind", WindNorth},
    {"x_wind", WindAlongX},
    {"y_wind", WindAlongY},
    {"grid_eastward_wind", WindAlongX},
    {"grid_northward_wind", WindAlongY},
    {"wind_speed_of_gust", Gust},
    {"air_temperature", AirTemperature},
    {"dew_point_temperature", DewPoint},
    {"fog_area_fraction", Fog},
    {"visibility_in_air", Visibility},
    {"cloud_base_altitude", Ceiling},
    {"height_at_cloud_base", Ceiling},
    {"eastward_sea_water_velocity", CurrentEast},
    {"northward_sea_water_velocity", CurrentNorth},
    {"surface_eastward_sea_water_velocity", CurrentEast},
    {"surface_northward_sea_water_velocity", CurrentNorth},
    {"x_sea_water_velocity", CurrentAlongX},
    {"y_sea_water_velocity", CurrentAlongY},
    {"sea_water_x_velocity", CurrentAlongX},
    {"sea_water_y_velocity", CurrentAlongY},
    {"sea_floor_depth", Depth},
    {"sea_floor_depth_below_geoid", Depth},
    {"sea_floor_depth_below_sea_level", Depth},
    {"sea_floor_depth_below_sea_surface", Depth},
    {"sea_floor_depth_below_mean_sea_level", Depth},
    {"model_sea_floor_depth_below_geoid", Depth},
    {"angle_of_rotation_from_east_to_x", AngleOfX},
};

constexpr NumberName kVariableNames[] = {
    {"u10", WindEast},
    {"v10", WindNorth},
    {"u10m", WindEast},
    {"v10m", WindNorth},
    {"eastward_wind", WindEast},
    {"northward_wind", WindNorth},
    {"eastward_wind_10m", WindEast},
    {"northward_wind_10m", WindNorth},
    {"uwind_eastward", WindEast},
    {"vwind_northward", WindNorth},
    {"x_wind", WindAlongX},
    {"y_wind", WindAlongY},
    {"x_wind_10m", WindAlongX},
    {"y_wind_10m", WindAlongY},
    {"uwind", WindAlongX},
    {"vwind", WindAlongY},
    {"wind_speed_of_gust", Gust},
    {"wind_gust", Gust},
    {"gust", Gust},
    {"fg10", Gust},
    {"i10fg", Gust},
    {"air_temperature", AirTemperature},
    {"air_temperature_2m", AirTemperature},
    {"t2m", AirTemperature},
    {"tair", AirTemperature},
    {"dew_point_temperature", DewPoint},
    {"dew_point_temperature_2m", DewPoint},
    {"d2m", DewPoint},
    {"fog_area_fraction", Fog},
    {"visibility", Visibility},
    {"vis", Visibility},
    {"cloud_base", Ceiling},
    {"cloud_base_altitude", Ceiling},
    {"cloud_base_height", Ceiling},
    {"ceiling", Ceiling},
    {"ceil", Ceiling},
    {"cbh", Ceiling},
    {"uo", CurrentEast},
    {"vo", CurrentNorth},
    {"water_u", CurrentEast},
    {"water_v", CurrentNorth},
    {"u_eastward", CurrentEast},
    {"v_northward", CurrentNorth},
    {"eastward_sea_water_velocity", CurrentEast},
    {"northward_sea_water_velocity", CurrentNorth},
    {"x_sea_water_velocity", CurrentAlongX},
    {"y_sea_water_velocity", CurrentAlongY},
    {"vozocrtx", CurrentAlongX},
    {"vomecrty", CurrentAlongY},
    {"h", Depth},
    {"deptho", Depth},
    {"bathymetry", Depth},
    {"sea_floor_depth", Depth},
    {"model_depth", Depth},
    {"angle", AngleOfX},
};

std::optional<GridNumber> numberNamed(std::span<const NumberName> names, std::string_view name)
{
    for (const NumberName& known : names)
        if (known.name == name)
            return known.number;
    return std::nullopt;
}

struct UnitName
{
    std::string_view name;
    UnitScale scale;
};

constexpr UnitName kSpeeds[] = {
    {"m s-1", {}},
    {"m/s", {}},
    {"m.s-1", {}},
    {"ms-1", {}},
    {"m s^-1", {}},
    {"m s**-1", {}},
    {"meter second-1", {}},
    {"metre second-1", {}},
    {"meters/second", {}},
    {"meter/sec", {}},
    {"m/sec", {}},
    {"", {}},
    {"cm s-1", {0.01}},
    {"cm/s", {0.01}},
    {"km/h", {1 / 3.6}},
    {"km h-1", {1 / 3.6}},
    {"knots", {1852.0 / 3600}},
    {"knot", {1852.0 / 3600}},
    {"kt", {1852.0 / 3600}},
    {"kn", {1852.0 / 3600}},
};
constexpr UnitName kTemperatures[] = {
    {"K", {1, -273.15}},
    {"kelvin", {1, -273.15}},
    {"Kelvin", {1, -273.15}},
    {"degK", {1, -273.15}},
    {"deg_K", {1, -273.15}},
    {"", {1, -273.15}},
    {"degC", {}},
    {"deg_C", {}},
    {"celsius", {}},
    {"Celsius", {}},
    {"C", {}},
    {"degree_Celsius", {}},
    {"degrees_Celsius", {}},
    {"degree_C", {}},
    {"degrees_C", {}},
    {"degrees C", {}},
    {"degree_celsius", {}},
};
constexpr UnitName kLengths[] = {
    {"m", {}}, {"meter", {}},  {"meters", {}},   {"metre", {}},      {"metres", {}},
    {"", {}},  {"km", {1000}}, {"ft", {0.3048}}, {"feet", {0.3048}},
};
constexpr UnitName kShares[] = {
    {"1", {100}}, {"", {100}}, {"0-1", {100}}, {"%", {}}, {"percent", {}},
};
constexpr double kDegree_rad = 3.14159265358979323846 / 180;
constexpr UnitName kAngles[] = {
    {"radians", {}},           {"radian", {}}, {"rad", {}}, {"", {}}, {"degrees", {kDegree_rad}},
    {"degree", {kDegree_rad}},
};

std::span<const UnitName> unitsOf(GridNumber number)
{
    switch (number) {
    case AirTemperature:
    case DewPoint:
        return kTemperatures;
    case Visibility:
    case Ceiling:
    case Depth:
        return kLengths;
    case Fog:
        return kShares;
    case AngleOfX:
        return kAngles;
    case WindEast:
    case WindNorth:
    case WindAlongX:
    case WindAlongY:
    case Gust:
    case CurrentEast:
    case CurrentNorth:
    case CurrentAlongX:
    case CurrentAlongY:
        break;
    }
    return kSpeeds;
}

} // namespace

std::optional<GridNumber> numberOfStandardName(std::string_view name)
{
    return numberNamed(kStandardNames, name.substr(0, name.find(' '))); // a modifier may follow
}

std::optional<GridNumber> numberOfVariableName(std::string_view name)
{
    std::string lower(name);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return numberNamed(kVariableNames, lower);
}

std::optional<UnitScale> unitScale(GridNumber number, std::string_view unit)
{
    for (const UnitName& known : unitsOf(number))
        if (known.name == unit)
            return known.scale;
    return std::nullopt;
}

std::string unitNames(GridNumber number)
{
    std::string names;
    for (const UnitName& known : unitsOf(number))
        if (!known.name.empty())
            names.append(names.empty() ? "" : ", ").append(known.name);
    return names;
}

double wantedLevel_m(GridNumber number)
{
    switch (number) {
    case WindEast:
    case WindNorth:
    case WindAlongX:
    case WindAlongY:
    case Gust:
        return 10;
    case AirTemperature:
    case DewPoint:
    case Visibility:
        return 2;
    case Fog:
    case Ceiling:
    case CurrentEast:
    case CurrentNorth:
    case CurrentAlongX:
    case CurrentAlongY:
    case Depth:
    case AngleOfX:
        break;
    }
    return 0;
}

} // namespace berg
