// UAVs, icebergs, the asset and the surroundings of a scenario file.

#include "core/io/files/scenario_parts.h"
#include "core/scenario/operation.h"

namespace berg {

namespace {

/** A position may not be left out: a wrong default would be flown without notice. */
Point readPosition(ObjectReader& object)
{
    const Json* value = object.need("position_m");
    return value == nullptr ? Point(Point::Zero()) : object.point("position_m", Point::Zero());
}

/** Both lists of the recorded track; what they must hold is up to `validate`. */
void readTrack(const Json& value, const std::string& path, Faults& faults, Iceberg& iceberg)
{
    ObjectReader object(value, path, faults);
    const bool whole = object.need("time_s") != nullptr && object.need("position_m") != nullptr;
    const Json* times = object.array("time_s");
    const Json* places = object.array("position_m");
    iceberg.trackExtraJson = object.unknown();
    if (!whole || times == nullptr || places == nullptr)
        return;
    if (times->empty())
        faults.add(object.path("time_s"), {IssueId::LeastEntries, {2}});
    faults.take(times->size() * sizeof(double) + places->size() * sizeof(Point));
    iceberg.track.time_s.reserve(times->size());
    iceberg.track.position_m.reserve(places->size());
    for (std::size_t i = 0; i < times->size(); ++i)
        if (const auto time_s = numberOf((*times)[i], entryPath(object.path("time_s"), i), faults))
            iceberg.track.time_s.push_back(*time_s);
    for (std::size_t i = 0; i < places->size(); ++i)
        if (const auto place_m =
                pointOf((*places)[i], entryPath(object.path("position_m"), i), faults))
            iceberg.track.position_m.push_back(*place_m);
    // With an entry missing the rest does not fit together: nothing more is said about it.
    if (iceberg.track.time_s.size() != times->size() ||
        iceberg.track.position_m.size() != places->size())
        iceberg.track = {};
}

std::string trackText(const Iceberg& iceberg)
{
    JsonObject object;
    object.addText("time_s", jsonArrayOf(iceberg.track.time_s));
    object.addText("position_m", jsonArrayOf(iceberg.track.position_m));
    object.addExtra(iceberg.trackExtraJson);
    return object.inLine();
}

} // namespace

std::vector<Point> readCorners(ObjectReader& object, const char* member)
{
    std::vector<Point> corners_m;
    const Json* value = object.array(member);
    if (value == nullptr)
        return corners_m;
    if (value->size() < 3 || value->size() > kMostAreaCorners) {
        object.faults().add(
            object.path(member),
            {IssueId::AreaCorners, {countOf(kMostAreaCorners), countOf(value->size())}});
        return corners_m;
    }
    for (std::size_t i = 0; i < value->size(); ++i) {
        const std::string path = entryPath(object.path(member), i);
        const std::optional<Point> corner = pointOf((*value)[i], path, object.faults());
        if (!corner)
            return {}; // a shape with a corner missing is not worth checking
        corners_m.push_back(*corner);
    }
    return corners_m;
}

Uav readUav(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Uav uav;
    uav.id = object.text("id");
    uav.name = object.text("name");
    uav.position_m = readPosition(object);
    uav.heading_deg = object.number("heading_deg", uav.heading_deg);
    uav.spec.airspeed_mps = object.number("airspeed_mps", uav.spec.airspeed_mps);
    uav.spec.maxBank_deg = object.number("max_bank_deg", uav.spec.maxBank_deg);
    uav.fov_m = object.point("fov_m", uav.fov_m);
    uav.spec.altitude_m = object.number("altitude_m", uav.spec.altitude_m);
    // No member means no limit, which memory writes as 0; a file that says 0 is mistaken.
    uav.spec.endurance_s = object.number(
        "endurance_s", 0, Limits{.low = 0, .high = limits::kEndurance_s.high, .above = true});
    if (object.find("home_m") != nullptr)
        uav.home_m = object.point("home_m", uav.position_m);
    uav.turnaround_s = object.number("turnaround_s", uav.turnaround_s);
    uav.spec.reservePercent = object.number("reserve_percent", uav.spec.reservePercent);
    uav.spec.reserve_s = object.optionalNumber("reserve_s");
    uav.spec.climb_s = object.number("climb_s", uav.spec.climb_s);
    uav.spec.landing_s = object.number("landing_s", uav.spec.landing_s);
    uav.weather.wind_mps = object.optionalNumber("max_wind_mps");
    uav.weather.gust_mps = object.optionalNumber("max_gust_mps");
    uav.weather.icing = object.boolean("icing", uav.weather.icing);
    uav.spec.autopilot_s = object.number("autopilot_s", uav.spec.autopilot_s);
    uav.extraJson = object.unknown();
    return uav;
}

std::string uavText(const Uav& uav)
{
    const Uav standard;
    JsonObject object;
    object.add("id", uav.id);
    object.addUnless("name", uav.name, standard.name);
    object.add("position_m", uav.position_m);
    object.add("heading_deg", uav.heading_deg);
    object.addUnless("airspeed_mps", uav.spec.airspeed_mps, standard.spec.airspeed_mps);
    object.addUnless("max_bank_deg", uav.spec.maxBank_deg, standard.spec.maxBank_deg);
    object.addUnless("fov_m", uav.fov_m, standard.fov_m);
    object.addUnless("altitude_m", uav.spec.altitude_m, standard.spec.altitude_m);
    object.addUnless("endurance_s", uav.spec.endurance_s, 0.0);
    object.addOptional("home_m", uav.home_m);
    object.addUnless("turnaround_s", uav.turnaround_s, standard.turnaround_s);
    object.addUnless("reserve_percent", uav.spec.reservePercent, standard.spec.reservePercent);
    object.addOptional("reserve_s", uav.spec.reserve_s);
    object.addUnless("climb_s", uav.spec.climb_s, 0.0);
    object.addUnless("landing_s", uav.spec.landing_s, 0.0);
    object.addOptional("max_wind_mps", uav.weather.wind_mps);
    object.addOptional("max_gust_mps", uav.weather.gust_mps);
    object.addUnless("icing", uav.weather.icing, false);
    object.addUnless("autopilot_s", uav.spec.autopilot_s, 0.0);
    object.addExtra(uav.extraJson);
    return object.inLine();
}

Iceberg readIceberg(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Iceberg iceberg;
    iceberg.id = object.text("id");
    iceberg.name = object.text("name");
    iceberg.position_m = readPosition(object);
    iceberg.velocity_mps = object.point("velocity_mps", iceberg.velocity_mps);
    iceberg.velocitySd_mps = object.number("velocity_sd_mps", iceberg.velocitySd_mps);
    iceberg.velocitySpread_mps = object.number("velocity_spread_mps", iceberg.velocitySpread_mps);
    iceberg.velocityTime_s = object.number("velocity_time_s", iceberg.velocityTime_s);
    iceberg.q_m2ps = object.number("q_m2ps", iceberg.q_m2ps);
    iceberg.sigma0_m2 = object.number("sigma0_m2", iceberg.sigma0_m2);
    iceberg.observed_s = object.number("observed_s", iceberg.observed_s);
    iceberg.appears_s = object.number("appears_s", iceberg.appears_s);
    iceberg.radius_m = object.number("radius_m", iceberg.radius_m);
    iceberg.uav = object.text("uav");
    if (const Json* track = object.find("track"))
        readTrack(*track, object.path("track"), faults, iceberg);
    iceberg.extraJson = object.unknown();
    return iceberg;
}

std::string icebergText(const Iceberg& iceberg)
{
    const Iceberg standard;
    JsonObject object;
    object.add("id", iceberg.id);
    object.addUnless("name", iceberg.name, standard.name);
    object.add("position_m", iceberg.position_m);
    object.add("velocity_mps", iceberg.velocity_mps);
    object.addUnless("velocity_sd_mps", iceberg.velocitySd_mps, standard.velocitySd_mps);
    object.addUnless("velocity_spread_mps", iceberg.velocitySpread_mps,
                     standard.velocitySpread_mps);
    object.addUnless("velocity_time_s", iceberg.velocityTime_s, standard.velocityTime_s);
    object.addUnless("q_m2ps", iceberg.q_m2ps, standard.q_m2ps);
    object.add("sigma0_m2", iceberg.sigma0_m2);
    object.addUnless("observed_s", iceberg.observed_s, standard.observed_s);
    object.addUnless("appears_s", iceberg.appears_s, standard.appears_s);
    object.addUnless("radius_m", iceberg.radius_m, standard.radius_m);
    object.addUnless("uav", iceberg.uav, standard.uav);
    if (!iceberg.track.empty())
        object.addText("track", trackText(iceberg));
    object.addExtra(iceberg.extraJson);
    return object.inLine();
}

Asset readAsset(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Asset asset;
    asset.name = object.text("name");
    asset.position_m = readPosition(object);
    asset.velocity_mps = object.point("velocity_mps", asset.velocity_mps);
    asset.range_m = object.number("range_m", asset.range_m);
    asset.gain = object.number("gain", asset.gain);
    asset.alarm_m = object.number("alarm_m", asset.alarm_m);
    asset.standoff_m = object.number("standoff_m", asset.standoff_m);
    asset.standoffCeiling_m = object.optionalNumber("standoff_ceiling_m");
    asset.extraJson = object.unknown();
    return asset;
}

std::string assetText(const Asset& asset)
{
    JsonObject object;
    object.addUnless("name", asset.name, {});
    object.add("position_m", asset.position_m);
    object.addUnless("velocity_mps", asset.velocity_mps, Point(Point::Zero()));
    object.add("range_m", asset.range_m);
    object.add("gain", asset.gain);
    object.addUnless("alarm_m", asset.alarm_m, 0.0);
    object.addUnless("standoff_m", asset.standoff_m, 0.0);
    object.addOptional("standoff_ceiling_m", asset.standoffCeiling_m);
    object.addExtra(asset.extraJson);
    return object.inLine();
}

NoFlyArea readNoFlyArea(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    NoFlyArea area;
    area.name = object.text("name");
    if (object.need("area_m") != nullptr)
        area.corners_m = readCorners(object, "area_m");
    area.floor_m = object.number("floor_m", area.floor_m);
    area.ceiling_m = object.optionalNumber("ceiling_m");
    area.extraJson = object.unknown();
    return area;
}

std::string noFlyAreaText(const NoFlyArea& area)
{
    JsonObject object;
    object.addUnless("name", area.name, {});
    object.addText("area_m", jsonArrayOf(area.corners_m));
    object.addUnless("floor_m", area.floor_m, 0.0);
    object.addOptional("ceiling_m", area.ceiling_m);
    object.addExtra(area.extraJson);
    return object.inLine();
}

GroundStation readGroundStation(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    GroundStation station;
    station.position_m = readPosition(object);
    station.antenna_m = object.number("antenna_m", station.antenna_m);
    station.range_m = object.optionalNumber("range_m");
    station.extraJson = object.unknown();
    return station;
}

std::string groundStationText(const GroundStation& station)
{
    JsonObject object;
    object.add("position_m", station.position_m);
    object.add("antenna_m", station.antenna_m);
    object.addOptional("range_m", station.range_m);
    object.addExtra(station.extraJson);
    return object.inLine();
}

Operation readOperation(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Operation operation;
    for (const OperationNumber& number : kOperationNumbers)
        operation.*number.member = object.number(number.name.data(), operation.*number.member);
    for (const OperationText& text : kOperationTexts)
        operation.*text.member = object.text(text.name.data());
    operation.extraJson = object.unknown();
    return operation;
}

std::string operationText(const Operation& operation)
{
    const Operation standard;
    JsonObject object;
    for (const OperationNumber& number : kOperationNumbers)
        object.addUnless(number.name, operation.*number.member, standard.*number.member);
    for (const OperationText& text : kOperationTexts)
        object.addUnless(text.name, operation.*text.member, {});
    object.addExtra(operation.extraJson);
    return object.inLine();
}

AirspaceArea readAirspaceArea(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    AirspaceArea area;
    area.name = object.text("name");
    area.kind = object.text("kind");
    if (object.need("area_m") != nullptr)
        area.corners_m = readCorners(object, "area_m");
    area.floor_m = object.number("floor_m", area.floor_m);
    area.ceiling_m = object.optionalNumber("ceiling_m");
    area.fromUtc = object.text("from_utc");
    area.untilUtc = object.text("until_utc");
    area.extraJson = object.unknown();
    return area;
}

std::string airspaceAreaText(const AirspaceArea& area)
{
    JsonObject object;
    object.addUnless("name", area.name, {});
    object.addUnless("kind", area.kind, {});
    object.addText("area_m", jsonArrayOf(area.corners_m));
    object.addUnless("floor_m", area.floor_m, 0.0);
    object.addOptional("ceiling_m", area.ceiling_m);
    object.addUnless("from_utc", area.fromUtc, {});
    object.addUnless("until_utc", area.untilUtc, {});
    object.addExtra(area.extraJson);
    return object.inLine();
}

Weather readWeather(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    Weather weather;
    weather.gust_mps = object.optionalNumber("gust_mps");
    weather.temperature_degC = object.optionalNumber("temperature_degc");
    weather.dewPoint_degC = object.optionalNumber("dew_point_degc");
    weather.extraJson = object.unknown();
    return weather;
}

std::string weatherText(const Weather& weather)
{
    JsonObject object;
    object.addOptional("gust_mps", weather.gust_mps);
    object.addOptional("temperature_degc", weather.temperature_degC);
    object.addOptional("dew_point_degc", weather.dewPoint_degC);
    object.addExtra(weather.extraJson);
    return object.inLine();
}

} // namespace berg
