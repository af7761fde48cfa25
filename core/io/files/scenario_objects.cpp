// UAVs, icebergs, the asset and the surroundings of a scenario file.

#include "core/io/files/scenario_parts.h"
#include "core/scenario/operation.h"

namespace berg {

namespace {

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

void addTrack(MemberReader& io, Iceberg& iceberg)
{
    if (const Json* track = io.object().find("track"))
        readTrack(*track, io.object().path("track"), io.object().faults(), iceberg);
}

void addTrack(MemberWriter& io, const Iceberg& iceberg)
{
    if (!iceberg.track.empty())
        io.addText("track", trackText(iceberg));
}

/** No member means no limit, which memory writes as 0; a file that says 0 is mistaken. */
void addEndurance(MemberReader& io, double& endurance_s)
{
    endurance_s = io.object().number(
        "endurance_s", 0, Limits{.low = 0, .high = limits::kEndurance_s.high, .above = true});
}

void addEndurance(MemberWriter& io, double endurance_s)
{
    io.addUnless("endurance_s", endurance_s, 0.0);
}

void addHome(MemberReader& io, Uav& uav)
{
    if (io.object().find("home_m") != nullptr)
        uav.home_m = io.object().point("home_m", uav.position_m);
}

void addHome(MemberWriter& io, const Uav& uav)
{
    io.addOptional("home_m", uav.home_m);
}

template <class Io>
void addMembers(Io& io, Held<Io, Uav>& uav)
{
    const Uav standard;
    io.add("id", uav.id);
    io.addUnless("name", uav.name, standard.name);
    io.addPosition(uav.position_m);
    io.add("heading_deg", uav.heading_deg);
    io.addUnless("airspeed_mps", uav.spec.airspeed_mps, standard.spec.airspeed_mps);
    io.addUnless("max_bank_deg", uav.spec.maxBank_deg, standard.spec.maxBank_deg);
    io.addUnless("fov_m", uav.fov_m, standard.fov_m);
    io.addUnless("altitude_m", uav.spec.altitude_m, standard.spec.altitude_m);
    addEndurance(io, uav.spec.endurance_s);
    addHome(io, uav);
    io.addUnless("turnaround_s", uav.turnaround_s, standard.turnaround_s);
    io.addUnless("reserve_percent", uav.spec.reservePercent, standard.spec.reservePercent);
    io.addOptional("reserve_s", uav.spec.reserve_s);
    io.addUnless("climb_s", uav.spec.climb_s, 0.0);
    io.addUnless("landing_s", uav.spec.landing_s, 0.0);
    io.addOptional("max_wind_mps", uav.weather.wind_mps);
    io.addOptional("max_gust_mps", uav.weather.gust_mps);
    io.addUnless("icing", uav.weather.icing, false);
    io.addUnless("autopilot_s", uav.spec.autopilot_s, 0.0);
}

template <class Io>
void addMembers(Io& io, Held<Io, Iceberg>& iceberg)
{
    const Iceberg standard;
    io.add("id", iceberg.id);
    io.addUnless("name", iceberg.name, standard.name);
    io.addPosition(iceberg.position_m);
    io.add("velocity_mps", iceberg.velocity_mps);
    io.addUnless("velocity_sd_mps", iceberg.velocitySd_mps, standard.velocitySd_mps);
    io.addUnless("velocity_spread_mps", iceberg.velocitySpread_mps, standard.velocitySpread_mps);
    io.addUnless("velocity_time_s", iceberg.velocityTime_s, standard.velocityTime_s);
    io.addUnless("q_m2ps", iceberg.q_m2ps, standard.q_m2ps);
    io.add("sigma0_m2", iceberg.sigma0_m2);
    io.addUnless("observed_s", iceberg.observed_s, standard.observed_s);
    io.addUnless("appears_s", iceberg.appears_s, standard.appears_s);
    io.addUnless("radius_m", iceberg.radius_m, standard.radius_m);
    io.addUnless("uav", iceberg.uav, standard.uav);
    addTrack(io, iceberg);
}

template <class Io>
void addMembers(Io& io, Held<Io, Asset>& asset)
{
    io.addUnless("name", asset.name, {});
    io.addPosition(asset.position_m);
    io.addUnless("velocity_mps", asset.velocity_mps, Point(Point::Zero()));
    io.add("range_m", asset.range_m);
    io.add("gain", asset.gain);
    io.addUnless("alarm_m", asset.alarm_m, 0.0);
    io.addUnless("standoff_m", asset.standoff_m, 0.0);
    io.addOptional("standoff_ceiling_m", asset.standoffCeiling_m);
}

template <class Io>
void addMembers(Io& io, Held<Io, NoFlyArea>& area)
{
    io.addUnless("name", area.name, {});
    io.addCorners(area.corners_m, true);
    io.addUnless("floor_m", area.floor_m, 0.0);
    io.addOptional("ceiling_m", area.ceiling_m);
}

template <class Io>
void addMembers(Io& io, Held<Io, GroundStation>& station)
{
    io.addPosition(station.position_m);
    io.add("antenna_m", station.antenna_m);
    io.addOptional("range_m", station.range_m);
}

template <class Io>
void addMembers(Io& io, Held<Io, Operation>& operation)
{
    const Operation standard;
    for (const OperationNumber& number : kOperationNumbers)
        io.addUnless(number.name.data(), operation.*number.member, standard.*number.member);
    for (const OperationText& text : kOperationTexts)
        io.addUnless(text.name.data(), operation.*text.member, {});
}

template <class Io>
void addMembers(Io& io, Held<Io, AirspaceArea>& area)
{
    io.addUnless("name", area.name, {});
    io.addUnless("kind", area.kind, {});
    io.addCorners(area.corners_m, true);
    io.addUnless("floor_m", area.floor_m, 0.0);
    io.addOptional("ceiling_m", area.ceiling_m);
    io.addUnless("from_utc", area.fromUtc, {});
    io.addUnless("until_utc", area.untilUtc, {});
}

template <class Io>
void addMembers(Io& io, Held<Io, Weather>& weather)
{
    io.addOptional("gust_mps", weather.gust_mps);
    io.addOptional("temperature_degc", weather.temperature_degC);
    io.addOptional("dew_point_degc", weather.dewPoint_degC);
}

} // namespace

void MemberReader::addSeed(std::int64_t& seed)
{
    seed = m_object.whole("seed", seed, {.low = 0, .high = kLargestSeed});
}

void MemberReader::addPosition(Point& position_m)
{
    if (m_object.need("position_m") != nullptr)
        add("position_m", position_m);
}

void MemberReader::addCorners(std::vector<Point>& corners_m, bool isNeeded)
{
    const Json* list = isNeeded ? m_object.neededArray("area_m") : m_object.array("area_m");
    if (list == nullptr)
        return;
    const std::string path = m_object.path("area_m");
    if (list->size() < 3 || list->size() > kMostAreaCorners) {
        m_object.faults().add(
            path, {IssueId::AreaCorners, {countOf(kMostAreaCorners), countOf(list->size())}});
        return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::optional<Point> corner =
            pointOf((*list)[i], entryPath(path, i), m_object.faults());
        if (!corner) {
            corners_m.clear(); // a shape with a corner missing is not worth checking
            return;
        }
        corners_m.push_back(*corner);
    }
}

template <class T>
T readObject(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader reader(value, path, faults);
    MemberReader io(reader);
    T object;
    addMembers(io, object);
    object.extraJson = reader.unknown();
    return object;
}

template <class T>
std::string objectText(const T& object)
{
    MemberWriter io;
    addMembers(io, object);
    io.addExtra(object.extraJson);
    return io.inLine();
}

template Uav readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Uav&);
template Iceberg readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Iceberg&);
template Asset readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Asset&);
template NoFlyArea readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const NoFlyArea&);
template AirspaceArea readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const AirspaceArea&);
template GroundStation readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const GroundStation&);
template Operation readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Operation&);
template Weather readObject(const Json&, const std::string&, Faults&);
template std::string objectText(const Weather&);

} // namespace berg
