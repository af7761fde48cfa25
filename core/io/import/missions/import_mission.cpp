#include "core/io/import/missions/import_mission.h"

#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

// Numbers of the MAVLink common message set.

/** NAV commands to fly to a place, and waypoints that users may define. */
constexpr std::array<std::int64_t, 11> kPlaceCommands{16 /* WAYPOINT */,
                                                      17 /* LOITER_UNLIM */,
                                                      18 /* LOITER_TURNS */,
                                                      19 /* LOITER_TIME */,
                                                      31 /* LOITER_TO_ALT */,
                                                      82 /* SPLINE_WAYPOINT */,
                                                      31000 /* USER_1 ... */,
                                                      31001,
                                                      31002,
                                                      31003,
                                                      31004};
/** Frames with latitude and longitude, whatever their altitude reference and number type. */
constexpr std::array<std::int64_t, 6> kGlobalFrames{0, 3, 5, 6, 10, 11};
/** Frames whose altitudes are above mean sea level, not above home or ground. */
constexpr std::array<std::int64_t, 2> kSeaLevelFrames{0, 5};
constexpr std::int64_t kChangeSpeed = 178;
/**
 * Types of speed in a speed change: through the air, or over ground, which is equal without wind.
 */
constexpr std::array<double, 2> kFlightSpeeds{0, 1};

template <class Value, std::size_t Size>
bool isOneOf(const std::array<Value, Size>& values, Value value)
{
    return std::find(values.begin(), values.end(), value) != values.end();
}

std::variant<Sighting, RejectedRow> rowOf(const MissionItem& item)
{
    FieldTexts texts;
    texts.set(SightingField::Latitude, item.latitude);
    texts.set(SightingField::Longitude, item.longitude);
    texts.set(SightingField::Name, item.name);
    return sightingOf(texts, {}, item.line);
}

bool isNowhere(const LatLon& place)
{
    return place.latitude_deg == 0 && place.longitude_deg == 0;
}

} // namespace

bool MissionPlaces::isNew(const LatLon& place)
{
    const auto grid = [](double angle_deg) { return std::llround(angle_deg * 1e7); };
    return m_known.emplace(grid(place.latitude_deg), grid(place.longitude_deg)).second;
}

void MissionPlaces::setHome(const MissionItem& home)
{
    std::variant<Sighting, RejectedRow> row = rowOf(home);
    const auto* const sighting = std::get_if<Sighting>(&row);
    if (sighting == nullptr) {
        addRow(m_table, std::move(row), m_budget);
    } else if (!isNowhere(sighting->place)) {
        (void)isNew(sighting->place);
        m_uav.start = m_uav.home = sighting->place;
        m_homeAltitude_m = decimalOf(home.altitude).value_or(0);
    }
}

void MissionPlaces::setRally(const LatLon& place)
{
    (void)isNew(place);
    m_uav.home = place;
    if (!m_uav.start)
        m_uav.start = place;
}

void MissionPlaces::setCruise(double airspeed_mps)
{
    if (!m_uav.airspeed_mps)
        m_uav.airspeed_mps = airspeed_mps;
}

void MissionPlaces::setSpeed(const MissionItem& item)
{
    const std::optional<double> kind = decimalOf(item.param1);
    const std::optional<double> speed_mps = decimalOf(item.param2);
    if (!m_uav.airspeed_mps && kind && isOneOf(kFlightSpeeds, *kind) && speed_mps && *speed_mps > 0)
        m_uav.airspeed_mps = speed_mps;
}

void MissionPlaces::setAltitude(const MissionItem& item)
{
    const std::optional<double> altitude_m = decimalOf(item.altitude);
    if (m_uav.altitude_m || !altitude_m)
        return;
    const double above_m =
        *altitude_m - (isOneOf(kSeaLevelFrames, item.frame) ? m_homeAltitude_m : 0);
    if (above_m > 0)
        m_uav.altitude_m = above_m;
}

SightingTable MissionPlaces::take()
{
    if (m_uav.start || m_uav.airspeed_mps || m_uav.altitude_m)
        m_table.scene.uavs.push_back(std::move(m_uav));
    return std::move(m_table);
}

void MissionPlaces::add(const MissionItem& item)
{
    if (item.command == kChangeSpeed)
        setSpeed(item);
    if (!isOneOf(kPlaceCommands, item.command))
        return;
    std::variant<Sighting, RejectedRow> row = rowOf(item);
    const auto* const sighting = std::get_if<Sighting>(&row);
    if (!isOneOf(kGlobalFrames, item.frame))
        row = RejectedRow{.line = item.line,
                          .fault = IssueId::NoPosition,
                          .detail = "frame " + std::to_string(item.frame)};
    else if (sighting != nullptr && isNowhere(sighting->place))
        row = RejectedRow{.line = item.line, .fault = IssueId::NoPosition, .detail = {}};
    else if (sighting != nullptr) {
        setAltitude(item);
        if (!isNew(sighting->place))
            return;
    }
    addRow(m_table, std::move(row), m_budget);
}

void MissionPlaces::reject(std::size_t line, const std::string& what)
{
    addRow(m_table,
           RejectedRow{.line = line, .fault = IssueId::NotAPoint, .detail = cleanText(what, 60)},
           m_budget);
}

} // namespace berg
