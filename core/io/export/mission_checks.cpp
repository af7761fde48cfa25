#include "core/io/export/mission_checks.h"

#include "core/io/export/missions/mission_ends.h"
#include "core/land/land_data.h"
#include "core/permit/airspace.h"
#include "core/scenario/fence.h"
#include "core/vehicle/dubins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berg {

namespace {

/** Number of items that usual boards hold. */
constexpr double kMostArduPilotItems = 700;
constexpr double kMostPx4Items = 500;
/** Distance of the first waypoint that PX4 accepts in all versions, by MIS_DIST_1WP. */
constexpr double kPx4FirstLeg_m = 900;
/** Slope of a landing that PX4 accepts as it is delivered, by FW_LND_ANG. */
constexpr double kUsualSlope_deg = 5;
constexpr double kSlopeTolerance_deg = 0.1;

constexpr double kStandstill_m = 0.01; ///< above the rounding of places in items

/** A straight line of the mission; it is flown at all heights up to the upper one. */
struct MissionLeg
{
    Point from_m = Point::Zero();
    Point to_m = Point::Zero();
    double lowest_m = 0;
    double highest_m = 0;
    bool isPlanned = false; ///< a leg between icebergs, which the plan led round closed areas
};

/** Findings with the worst value of each kind. */
class CheckList
{
public:
    void add(ExportNoteKind kind, double value, double limit, std::string_view tool = {})
    {
        const auto it = std::ranges::find(m_notes, kind, &ExportNote::kind);
        if (it == m_notes.end())
            m_notes.push_back(exportNote(kind, tool, value, limit));
        else if (value > it->value)
            *it = exportNote(kind, tool, value, limit);
    }

    std::vector<ExportNote> take() { return std::move(m_notes); }

private:
    std::vector<ExportNote> m_notes;
};

/** Checks the mission of one UAV, which visits an iceberg. */
class MissionCheck
{
public:
    MissionCheck(const ExportContent& content, const ExportUav& uav, CheckList& list)
        : m_content(content), m_uav(uav), m_list(list), m_mission(mavMission(content, uav))
    {
        placeLegs();
    }

    void run()
    {
        checkFirstLeg();
        checkCrossings();
        checkApproach();
        checkItems();
        checkAirspace();
        checkEndurance();
    }

private:
    [[nodiscard]] const AircraftProfile& aircraft() const { return m_uav.uav.aircraft; }
    [[nodiscard]] bool isPx4() const { return aircraft().firmware == AutopilotFirmware::Px4; }

    void addLeg(const Point& to_m, double altitude_m, bool isPlanned)
    {
        m_legs.push_back({.from_m = m_at_m,
                          .to_m = to_m,
                          .lowest_m = std::min(m_altitude_m, altitude_m),
                          .highest_m = std::max(m_altitude_m, altitude_m),
                          .isPlanned = isPlanned});
        m_at_m = to_m;
        m_altitude_m = altitude_m;
    }

    void placeLegs()
    {
        m_at_m = m_uav.uav.position_m;
        m_altitude_m = m_uav.isAloft ? m_mission.altitude_m : 0;
        const std::size_t first = takeOffItems(m_content, m_uav).size();
        const std::size_t end = m_mission.items.size() - endItems(m_content, m_uav).size();
        bool isFirst = !m_uav.isAloft;
        for (std::size_t i = 0; i < m_mission.items.size(); ++i) {
            const MavItem& item = m_mission.items[i];
            if (!hasPlace(item))
                continue;
            addLeg(m_content.frame.toPlane(item.place), item.altitude_m,
                   i >= first && !isFirst && i < end);
            isFirst = isFirst && i < first;
        }
        if (m_mission.items.back().command == LinkCommandId::kReturnToLaunch) {
            addLeg(m_uav.home_m, m_altitude_m, false);
            addLeg(m_uav.home_m, 0, false);
        }
    }

    void checkFirstLeg()
    {
        if (m_uav.isAloft)
            return;
        const auto first = std::ranges::find_if(
            m_uav.visits, [](const Visit& visit) { return visit.iceberg.has_value(); });
        const UavSpec& spec = m_uav.uav.spec;
        const double length_m = (first->position_m - m_uav.uav.position_m).norm();
        const double climb_m = spec.climb_s > 0 ? spec.climb_s * spec.airspeed_mps
                                                : climbDistance_m(aircraft(), spec.altitude_m);
        if (aircraft().airframe == Airframe::FixedWing && length_m < climb_m)
            m_list.add(ExportNoteKind::ClimbTooShort, climb_m, length_m);
        if (isPx4() && length_m > kPx4FirstLeg_m)
            m_list.add(ExportNoteKind::FirstLegFar, length_m, kPx4FirstLeg_m, "PX4");
    }

    /** Counts the legs that no plan led round closed areas; `legsThatCross` counts the others. */
    void checkCrossings()
    {
        const UavSpec& spec = m_uav.uav.spec;
        const auto fence = fenceOf(*m_content.scenario, spec.altitude_m,
                                   {.airspeed_mps = spec.airspeed_mps,
                                    .limit_radps = maxTurnRate_radps(spec),
                                    .wind_mps = m_content.wind_mps});
        if (!fence)
            return;
        const auto crosses = [&](const MissionLeg& leg) {
            return !leg.isPlanned && (leg.to_m - leg.from_m).norm() > kStandstill_m &&
                   (!fence->contains(leg.to_m) || fence->clearance_m(leg.from_m, leg.to_m) == 0);
        };
        if (const auto count = std::ranges::count_if(m_legs, crosses); count > 0)
            m_list.add(ExportNoteKind::EndsCross, static_cast<double>(count), 0);
    }

    void checkApproach()
    {
        const std::optional<LandingPattern> pattern = landingPattern(m_content, m_uav);
        if (!pattern || aircraft().airframe == Airframe::Multirotor)
            return;
        constexpr int kSamples = 10; // the landing place itself may be on land
        for (int i = 0; i < kSamples; ++i) {
            const Point at_m = pattern->from_m + static_cast<double>(i) / kSamples *
                                                     (pattern->home_m - pattern->from_m);
            if (isOnLand(m_content.frame.toGeographic(at_m))) {
                m_list.add(ExportNoteKind::ApproachOverLand, 0, 0);
                break;
            }
        }
        if (aircraft().airframe == Airframe::FixedWing &&
            pattern->slope_deg > kUsualSlope_deg + kSlopeTolerance_deg)
            m_list.add(ExportNoteKind::ApproachSteep, pattern->slope_deg, kUsualSlope_deg);
    }

    /** Counts waypoints that are reached as soon as those before them are. */
    void checkItems()
    {
        int close = 0;
        std::optional<Point> before_m;
        for (const MavItem& item : m_mission.items) {
            if (!hasPlace(item))
                continue;
            const Point at_m = m_content.frame.toPlane(item.place);
            close += item.command == LinkCommandId::kWaypoint && before_m &&
                             (at_m - *before_m).norm() < item.params[1]
                         ? 1
                         : 0;
            before_m = at_m;
        }
        if (close > 0)
            m_list.add(ExportNoteKind::WaypointsClose, close, 0);
        const double most = isPx4() ? kMostPx4Items : kMostArduPilotItems;
        if (const auto count = static_cast<double>(m_mission.items.size()); count > most)
            m_list.add(ExportNoteKind::TooManyItems, count, most, isPx4() ? "PX4" : "ArduPilot");
    }

    void checkAirspace()
    {
        const auto enters = [&](const MissionLeg& leg, const AirspaceArea& area) {
            return area.floor_m <= leg.highest_m &&
                   (!area.ceiling_m || *area.ceiling_m >= leg.lowest_m) &&
                   (insidePolygon(area.corners_m, leg.to_m) ||
                    distanceToEdges(area.corners_m, leg.from_m, leg.to_m) == 0);
        };
        const auto isEntered = [&](const AirspaceArea& area) {
            return isActive(area, *m_content.scenario) &&
                   std::ranges::any_of(m_legs,
                                       [&](const MissionLeg& leg) { return enters(leg, area); });
        };
        if (const auto count = std::ranges::count_if(m_content.scenario->airspace, isEntered);
            count > 0)
            m_list.add(ExportNoteKind::AirspaceOnTheWay, static_cast<double>(count), 0);
    }

    /** Returns the flight time, with climb and landing; a mission that ends aloft comes home. */
    [[nodiscard]] double flight_s() const
    {
        const UavSpec& spec = m_uav.uav.spec;
        const TimedPoint end = endOf(m_uav);
        const auto legTime_s = [&](const Point& from_m, const Point& to_m) {
            return flightTime_s(to_m - from_m, spec.airspeed_mps, m_content.wind_mps);
        };
        const double circle_s = 2 * std::numbers::pi * loiterRadius_m(m_uav) / spec.airspeed_mps;
        double time_s = end.time_s - m_uav.start_s + spec.landing_s;
        if (!m_uav.isAloft)
            time_s += spec.climb_s;
        if (aircraft().airframe == Airframe::FixedWing && m_content.what != ExportScope::Path)
            time_s +=
                circle_s * m_content.options.loiterTurns *
                static_cast<double>(std::ranges::count_if(
                    m_uav.visits, [](const Visit& visit) { return visit.iceberg.has_value(); }));
        const std::optional<LandingPattern> pattern = landingPattern(m_content, m_uav);
        if (!pattern)
            return time_s + legTime_s(end.position_m, m_uav.home_m);
        return time_s + legTime_s(end.position_m, pattern->from_m) +
               (aircraft().airframe == Airframe::FixedWing ? circle_s : 0) +
               legTime_s(pattern->from_m, pattern->home_m);
    }

    void checkEndurance()
    {
        const UavSpec& spec = m_uav.uav.spec;
        if (spec.endurance_s == 0)
            return;
        const double usable_s = spec.endurance_s - reserve_s(spec);
        constexpr double kTolerance_s = 1;
        if (const double needed_s = flight_s(); needed_s > usable_s + kTolerance_s)
            m_list.add(ExportNoteKind::EnduranceShort, needed_s, usable_s);
    }

    const ExportContent& m_content;
    const ExportUav& m_uav;
    CheckList& m_list;
    MavMission m_mission;
    std::vector<MissionLeg> m_legs;
    Point m_at_m = Point::Zero();
    double m_altitude_m = 0;
};

bool visitsAnything(const ExportUav& uav)
{
    return std::ranges::any_of(uav.visits,
                               [](const Visit& visit) { return visit.iceberg.has_value(); });
}

} // namespace

std::vector<ExportNote> missionChecks(const ExportContent& content)
{
    CheckList list;
    if (content.what != ExportScope::Track)
        for (const ExportUav& uav : content.uavs)
            if (visitsAnything(uav))
                MissionCheck(content, uav, list).run();
    return list.take();
}

} // namespace berg
