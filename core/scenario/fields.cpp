#include "core/scenario/fields.h"

#include <limits>

namespace berg {

namespace {

constexpr Limits kFinite{.low = std::numeric_limits<double>::lowest(),
                         .high = std::numeric_limits<double>::max()};
constexpr Limits kSeed{.low = 0, .high = static_cast<double>(kLargestSeed)};

/**
 * Marks English texts for lupdate, which finds them by this function's name
 * (widgets/CMakeLists.txt).
 */
constexpr const char* en(const char* words)
{
    return words;
}

/** Tables of fields; the struct is the context of their translations. */
struct Fields
{
    using enum Quantity;
    using enum Presence;

    // Columns of a row: name in files, location, quantity, limits, unusual traits, label and help
    // of the input; a pair has a label and help text for each number.
    // clang-format off

    template <typename T> // lupdate takes "class T" for the context
    static constexpr Field<T> kId{"id", [](T& o) { return &o.id; }, Text, {},
        {.presence = Always, .note = en("Unique in the file; without it, uav-1, uav-2, ... or berg-1, berg-2, ... in "
                "the order of the file.")}, en("Id")};
    template <typename T> // lupdate takes "class T" for the context
    static constexpr Field<T> kName{
        "name", [](T& o) { return &o.name; }, Text, {}, {}, en("Name"), en("Shown on the map in place of the id.")};
    template <typename T> // lupdate takes "class T" for the context
    static constexpr Field<T> kPosition{
        "position_m", [](T& o) { return &o.position_m; }, Distance, limits::kCoordinate_m,
        {.step = 10, .presence = Needed, .note = en("Position at the start; of an iceberg the estimate, which is "
                "the truth in the simple model.")},
        en("East"), en("Position at the start, east of the scenario's origin."),
        en("North"), en("Position at the start, north of the scenario's origin.")};

    static constexpr auto kUav = std::to_array<Field<Uav>>({
        kId<Uav>,
        kName<Uav>,
        kPosition<Uav>,
        {"heading_deg", [](Uav& u) { return &u.heading_deg; }, Degrees, kFinite, {.step = 5, .presence = Always},
         en("Heading"), en("Clockwise from north, at the start.")},
        {"airspeed_mps", [](Uav& u) { return &u.spec.airspeed_mps; }, Speed, limits::kAirspeed_mps, {.mostDecimals = 2},
         en("Airspeed"), en("Must exceed the wind speed.")},
        {"max_bank_deg", [](Uav& u) { return &u.spec.maxBank_deg; }, Degrees, limits::kBank_deg, {},
         en("Maximum bank angle"), en("Bank in a turn; the larger, the tighter the turns.")},
        {"fov_m", [](Uav& u) { return &u.fov_m; }, Metres, limits::kExtent_m,
         {.step = 50, .note = en("Extent of the field of view along and across the heading.")}, en("View along-track"),
         en("Extent of the field of view along the heading."), en("View cross-track"),
         en("Extent of the field of view across the heading.")},
        {"altitude_m", [](Uav& u) { return &u.spec.altitude_m; }, Height, limits::kExtent_m, {.step = 10},
         en("Altitude"), en("Height above sea level. UAVs at least %1 apart in height may pass each other.")},
        {"endurance_s", [](Uav& u) { return &u.spec.endurance_s; }, Seconds, limits::kEndurance_s,
         {.step = 60, .noneText = en("unlimited"), .zeroIsNone = true, .note = en("Longest flight; the UAV is home "
                "before it ends. Without it, the UAV lands only when ordered to return.")}, en("Endurance"),
         en("Longest flight; the UAV is home before it ends. At 0 it lands only when ordered to return.")},
        {"home_m", [](Uav& u) { return &u.home_m; }, Distance, limits::kCoordinate_m,
         {.step = 10, .note = en("Landing place; without it, where the UAV starts.")}, en("Home east"),
         en("Landing place, east of the scenario's origin."), en("Home north"),
         en("Landing place, north of the scenario's origin.")},
        {"turnaround_s", [](Uav& u) { return &u.turnaround_s; }, Seconds, limits::kTime_s, {.step = 60},
         en("Turn-around"), en("Time on the ground between landing and the next take-off.")},
        {"reserve_percent", [](Uav& u) { return &u.spec.reservePercent; }, Percent, limits::kReservePercent,
         {.step = 5}, en("Reserve"), en("Share of the endurance that plans leave unused.")},
        {"reserve_s", [](Uav& u) { return &u.spec.reserve_s; }, Seconds, limits::kTime_s,
         {.noneText = en("by percentage")}, en("Fixed reserve"), en("Reserve as a time, in place of the percentage.")},
        {"climb_s", [](Uav& u) { return &u.spec.climb_s; }, Seconds, limits::kTime_s, {.step = 5}, en("Climb"),
         en("Time from take-off to the flight altitude.")},
        {"landing_s", [](Uav& u) { return &u.spec.landing_s; }, Seconds, limits::kTime_s, {.step = 5}, en("Landing"),
         en("Time from the flight altitude above home to the ground.")},
        {"max_wind_mps", [](Uav& u) { return &u.weather.wind_mps; }, Speed, limits::kWindSpeed_mps,
         {.noneText = en("none")}, en("Wind limit"), en("Strongest wind in which the UAV may fly.")},
        {"max_gust_mps", [](Uav& u) { return &u.weather.gust_mps; }, Speed, limits::kWindSpeed_mps,
         {.noneText = en("none")}, en("Gust limit"), en("Strongest gusts in which the UAV may fly.")},
        {"min_visibility_m", [](Uav& u) { return &u.weather.visibility_m; }, Distance, limits::kLength_m,
         {.step = 100, .noneText = en("none")}, en("Visibility limit"),
         en("Shortest visibility in which the UAV may fly; compared with the forecast.")},
        {"min_ceiling_m", [](Uav& u) { return &u.weather.ceiling_m; }, Height, limits::kLength_m,
         {.step = 10, .noneText = en("none")}, en("Ceiling limit"),
         en("Lowest cloud base, above sea level, in which the UAV may fly; compared with the forecast.")},
        {"icing", [](Uav& u) { return &u.weather.icing; }, Text, {}, {}, en("Icing conditions"),
         en("Whether the UAV may fly below 0 °C in nearly saturated air.")},
        {"autopilot_s", [](Uav& u) { return &u.spec.autopilot_s; }, Seconds, limits::kAutopilot_s,
         {.mostDecimals = 2, .noneText = en("each time step"), .note = en("Time between two commands of the "
                "autopilot; 0 means every time step. After an order to return home, a slower autopilot commands "
                "once a second.")}, en("Autopilot rate"),
         en("Time between two commands of the autopilot; at 0 it commands at each time step.")},
        {"firmware", [](Uav& u) { return &u.aircraft.firmware; }, Text, {}, {}, en("Autopilot"),
         en("Firmware for which missions are exported.")},
        {"airframe", [](Uav& u) { return &u.aircraft.airframe; }, Text, {}, {}, en("Airframe"),
         en("A VTOL and a multirotor fly over icebergs without loiter circles.")},
        {"take_off", [](Uav& u) { return &u.aircraft.takeOff; }, Text, {}, {}, en("Take-off"),
         en("By mission item, or by hand: then the mission is started in the air.")},
        {"take_off_altitude_m", [](Uav& u) { return &u.aircraft.takeOffAltitude_m; }, Height, limits::kExtent_m,
         {.step = 10}, en("Take-off altitude"), en("Height above home at which the first leg begins.")},
        {"take_off_pitch_deg", [](Uav& u) { return &u.aircraft.takeOffPitch_deg; }, Degrees, limits::kPitch_deg, {},
         en("Take-off pitch"), en("Least pitch of a fixed wing in the take-off.")},
        {"mission_end", [](Uav& u) { return &u.aircraft.end; }, Text, {}, {}, en("End of the mission"),
         en("What the last items of an exported mission do, unless it ends over the last iceberg.")},
        {"approach_m", [](Uav& u) { return &u.aircraft.approach_m; }, Metres, limits::kExtent_m, {.step = 50},
         en("Approach leg"), en("Distance from the loiter in which the UAV descends to the landing place.")},
        {"approach_altitude_m", [](Uav& u) { return &u.aircraft.approachAltitude_m; }, Height, limits::kExtent_m,
         {.step = 5}, en("Approach altitude"), en("Height above home to which the UAV descends before the approach.")},
        {"approach_course_deg", [](Uav& u) { return &u.aircraft.approachCourse_deg; }, Degrees, limits::kCourse_deg,
         {.step = 5, .noneText = en("into the wind")}, en("Approach course"),
         en("Course of the approach, clockwise from north; 360 is north.")},
        {"loiter_radius_m", [](Uav& u) { return &u.aircraft.loiterRadius_m; }, Metres, limits::kExtent_m,
         {.step = 10, .noneText = en("tightest turn")}, en("Loiter radius"),
         en("Radius of loiters in missions; never less than the tightest turn in the wind.")},
        {"hover_speed_mps", [](Uav& u) { return &u.aircraft.hoverSpeed_mps; }, Speed, limits::kAirspeed_mps,
         {.mostDecimals = 2}, en("Hover speed"), en("Speed of a VTOL while it flies like a multirotor.")},
        {"speed_items", [](Uav& u) { return &u.aircraft.speedItems; }, Text, {}, {}, en("Speed in the mission"),
         en("Off: the autopilot flies at the speed of its own parameters.")},
        {"camera", [](Uav& u) { return &u.aircraft.camera; }, Text, {}, {}, en("Camera"),
         en("What triggers the camera over an iceberg; it is off between icebergs.")},
        {"trigger_m", [](Uav& u) { return &u.aircraft.trigger_m; }, Metres, limits::kExtent_m, {.step = 10},
         en("Trigger distance"), en("Distance flown between two pictures.")},
        {"trigger_s", [](Uav& u) { return &u.aircraft.trigger_s; }, Seconds, limits::kTrigger_s, {},
         en("Trigger interval"), en("Time between two pictures.")},
        {"gimbal_down", [](Uav& u) { return &u.aircraft.gimbalDown; }, Text, {}, {}, en("Gimbal down"),
         en("An item of the mission points the gimbal straight down.")},
    });

    static constexpr auto kIceberg = std::to_array<Field<Iceberg>>({
        kId<Iceberg>,
        kName<Iceberg>,
        kPosition<Iceberg>,
        {"velocity_mps", [](Iceberg& i) { return &i.velocity_mps; }, Speed, limits::kVelocity_mps,
         {.step = 0.05, .leastDecimals = 2, .mostDecimals = 3, .presence = Always, .note = en("Drift velocity, "
                "without the current.")}, en("Drift east"),
         en("Known drift to the east, without the current."), en("Drift north"),
         en("Known drift to the north, without the current.")},
        {"velocity_sd_mps", [](Iceberg& i) { return &i.velocitySd_mps; }, Speed, limits::kSpeed_mps,
         {.step = 0.05, .leastDecimals = 2, .mostDecimals = 3, .note = en("Standard deviation of the error of the "
                "drift velocity, along each axis (Kalman observer).")}, en("Drift error"),
         en("Standard deviation of the error of the known drift, along each axis.")},
        {"velocity_spread_mps", [](Iceberg& i) { return &i.velocitySpread_mps; }, Speed, limits::kSpeed_mps,
         {.step = 0.05, .leastDecimals = 2, .mostDecimals = 3, .note = en("Changing drift (Kalman observer): "
                "standard deviation with which the velocity varies about the current. A fit to a beacon gave 0.15 "
                "m/s.")}, en("Drift variation"),
         en("Long-term standard deviation of the drift about the current, along each axis. Example, a beacon off "
                    "Canada: 0.15 m/s.")},
        {"velocity_time_s", [](Iceberg& i) { return &i.velocityTime_s; }, Seconds, limits::kTime_s,
         {.step = 3600, .note = en("Changing drift (Kalman observer): time in which the velocity fades to the "
                "current (to 1/e); 0 means constant drift. A fit to a beacon gave 36000 s.")},
         en("Drift time constant"), en("Time in which a known drift fades to that of the current. At 0 the drift is "
                    "constant. Example, a beacon off Canada: 36,000 s.")},
        {"q_m2ps", [](Iceberg& i) { return &i.q_m2ps; }, Growth, limits::kGrowth_m2ps,
         {.step = 0.005, .leastDecimals = 3, .mostDecimals = 6}, en("Growth q"),
         en("Growth of the uncertainty per second out of view.")},
        {"sigma0_m2", [](Iceberg& i) { return &i.sigma0_m2; }, Variance, limits::kSigma_m2,
         {.mostDecimals = 3, .presence = Always}, en("Uncertainty σ₀"),
         en("Variance of the position when it was last seen.")},
        {"observed_s", [](Iceberg& i) { return &i.observed_s; }, Seconds, limits::kTime_s,
         {.note = en("Age of the last sighting at t = 0: adds q x age and (`velocity_sd_mps` x age)^2 to "
                "`sigma0_m2`; with changing drift the formula is that of the drift process.")}, en("Last seen"),
         en("Time between the last sighting and the start; σ has grown since.")},
        {"appears_s", [](Iceberg& i) { return &i.appears_s; }, Seconds, limits::kTime_s, {.step = 10}, en("Appears at"),
         en("Run time from which the iceberg is known; 0 is the start.")},
        {"radius_m", [](Iceberg& i) { return &i.radius_m; }, Metres, limits::kLength_m, {.step = 5}, en("Radius"),
         en("Half its length. It sets the size on the map and how far outside the area the iceberg is monitored.")},
        {"length_m", [](Iceberg& i) { return &i.length_m; }, Metres, limits::kIcebergLength_m,
         {.step = 10, .noneText = en("not known"), .note = en("Length at the waterline: wind and current then carry "
                "the iceberg by the balance of their drags (below 15 m: the current and 2 % of the wind, turned 20 "
                "degrees), and it stands still where a `forecast` gives a depth below its draft of 1.78 L^0.71. "
                "Without it the current alone carries the iceberg.")}, en("Length"),
         en("Length at the waterline. With it, wind and current carry the iceberg, and it may run aground; without "
                    "it, the current alone.")},
        {"uav", [](Iceberg& i) { return &i.uav; }, Text, {},
         {.note = en("Id of the only UAV that may visit it; empty allows any UAV.")}, en("Visited by"),
         en("The only UAV that may visit it.")},
    });

    static constexpr auto kAsset = std::to_array<Field<Asset>>({
        kName<Asset>,
        kPosition<Asset>,
        {"velocity_mps", [](Asset& a) { return &a.velocity_mps; }, Speed, limits::kAssetVelocity_mps,
         {.step = 0.5, .mostDecimals = 2, .note = en("Speed of a ship; 0 for a platform.")},
         en("Speed east"), en("Speed of a ship to the east; 0 for a platform."),
         en("Speed north"), en("Speed of a ship to the north; 0 for a platform.")},
        {"range_m", [](Asset& a) { return &a.range_m; }, Distance, limits::kExtent_m,
         {.step = 500, .mostDecimals = 2, .presence = Always}, en("Range"), en("Distance within which icebergs matter "
                    "to the asset.")},
        {"gain", [](Asset& a) { return &a.gain; }, Number, limits::kGain, {.mostDecimals = 2, .presence = Always},
         en("Gain"), en("Additional weight of an iceberg at the asset.")},
        {"alarm_m", [](Asset& a) { return &a.alarm_m; }, Distance, limits::kLength_m,
         {.step = 500, .mostDecimals = 2, .noneText = en("half the range"), .zeroIsNone = true}, en("Inner ring"),
         en("An iceberg predicted to enter it within an hour raises an alarm. At 0 it is half the range.")},
        {"standoff_m", [](Asset& a) { return &a.standoff_m; }, Distance, limits::kLength_m,
         {.step = 100, .mostDecimals = 2, .noneText = en("none"), .note = en("UAVs that start clear of the asset "
                "keep this distance, from a ship to its whole track.")}, en("Stand-off ring"),
         en("Least distance of UAVs from the asset; for a ship, from its whole track.")},
        {"standoff_ceiling_m", [](Asset& a) { return &a.standoffCeiling_m; }, Height, limits::kCeiling_m,
         {.step = 10, .noneText = en("none")}, en("Stand-off ceiling"), en("Height above which UAVs may cross the "
                    "ring.")},
    });

    static constexpr auto kNoFlyArea = std::to_array<Field<NoFlyArea>>({
        {"name", [](NoFlyArea& a) { return &a.name; }, Text, {}, {}, en("Name"), en("Shown on the map.")},
        {"area_m", [](NoFlyArea& a) { return &a.corners_m; }, Distance, limits::kCoordinate_m,
         {.presence = Needed, .note = en("Corners of the area.")},
         en("Corner of the no-fly area")},
        {"floor_m", [](NoFlyArea& a) { return &a.floor_m; }, Height, limits::kLength_m, {.step = 10}, en("Floor"),
         en("UAVs below this height may pass under the area.")},
        {"ceiling_m", [](NoFlyArea& a) { return &a.ceiling_m; }, Height, limits::kCeiling_m,
         {.step = 10, .noneText = en("none")}, en("Ceiling"), en("UAVs above this height may pass over the area.")},
    });

    static constexpr auto kAirspaceArea = std::to_array<Field<AirspaceArea>>({
        {"name", [](AirspaceArea& a) { return &a.name; }, Text, {}, {.note = en("Name of the airspace.")}, en("Name")},
        {"kind", [](AirspaceArea& a) { return &a.kind; }, Text, {}, {.note = en("Class or type of the airspace.")}},
        {"area_m", [](AirspaceArea& a) { return &a.corners_m; }, Metres, limits::kCoordinate_m,
         {.presence = Needed, .note = en("Corners of the area.")},
         en("Corner of the airspace")},
        {"floor_m", [](AirspaceArea& a) { return &a.floor_m; }, Height, limits::kLength_m,
         {.note = en("Lower limit, above the sea.")}, en("Floor")},
        {"ceiling_m", [](AirspaceArea& a) { return &a.ceiling_m; }, Height, limits::kCeiling_m,
         {.note = en("Upper limit, above the sea.")}, en("Ceiling")},
        {"from_utc", [](AirspaceArea& a) { return &a.fromUtc; }, Utc, {},
         {.note = en("Time from which the airspace exists; without it, always.")}, en("Start of the airspace")},
        {"until_utc", [](AirspaceArea& a) { return &a.untilUtc; }, Utc, {},
         {.note = en("Time until which the airspace exists, not before `from_utc`; without it, always.")},
         en("End of the airspace")},
    });

    static constexpr auto kIceChart = std::to_array<Field<IceChart>>({
        {"source", [](IceChart& c) { return &c.source; }, Text, {},
         {.note = en("File or service that the chart comes from.")},
         en("Source of the ice chart")},
        {"date_utc", [](IceChart& c) { return &c.dateUtc; }, Utc, {},
         {.note = en("Date of the chart; without it, unknown.")},
         en("Date of the ice chart")},
    });

    static constexpr auto kIceArea = std::to_array<Field<IceArea>>({
        {"label", [](IceArea& a) { return &a.label; }, Text, {},
         {.note = en("Words or codes of the chart for the area; may be empty.")},
         en("Label of the ice")},
        {"concentration_tenths", [](IceArea& a) { return &a.concentration_tenths; }, Number, limits::kTenths,
         {.note = en("Part of the area that ice covers, in tenths; without it, unknown.")},
         en("Ice concentration")},
        {"fast", [](IceArea& a) { return &a.isFast; }, Text, {},
         {.note = en("Whether the ice is fast to a shore and does not drift.")},
         en("Fast ice")},
    });

    static constexpr auto kGroundStation = std::to_array<Field<GroundStation>>({
        {"position_m", [](GroundStation& g) { return &g.position_m; }, Distance, limits::kCoordinate_m,
         {.step = 10, .presence = Needed, .note = en("Position of the antenna.")},
         en("Station east"), en("East of the scenario's origin."),
         en("Station north"), en("North of the scenario's origin.")},
        {"antenna_m", [](GroundStation& g) { return &g.antenna_m; }, Height, limits::kLength_m, {.presence = Always},
         en("Antenna height"), en("Height above the sea.")},
        {"range_m", [](GroundStation& g) { return &g.range_m; }, Distance, limits::kExtent_m,
         {.step = 1000, .noneText = en("radio horizon"), .note = en("Range of the link; without it, the radio horizon "
                "of the antenna and the UAV's altitude.")}, en("Link range"),
         en("Range of the link; the lowest value means the radio horizon of the antenna and the UAV's altitude.")},
    });

    static constexpr auto kOperation = std::to_array<Field<Operation>>({
        {"margin_m", [](Operation& o) { return &o.margin_m; }, Metres, limits::kExtent_m, {.mostDecimals = 3},
         en("Margin"), en("Distance around all places of the plan, for turns and replanning. Not used with a "
                    "geofence.")},
        {"span_m", [](Operation& o) { return &o.span_m; }, Metres, limits::kSmallError_m, {.mostDecimals = 3},
         en("UAV size"), en("Largest dimension of a UAV; half of it is added to the ground-risk buffer.")},
        {"position_error_m", [](Operation& o) { return &o.positionError_m; }, Metres, limits::kSmallError_m,
         {.mostDecimals = 3}, en("Satellite position error"), en("Part of the width of the contingency volume. Source: "
                    "Digisky 3.3.0, after the guide of the Swiss FOCA: 3 m.")},
        {"path_error_m", [](Operation& o) { return &o.pathError_m; }, Metres, limits::kSmallError_m,
         {.mostDecimals = 3}, en("Path-keeping error"), en("Error of the autopilot, part of the width of the "
                    "contingency volume. Same source: 3 m.")},
        {"map_error_m", [](Operation& o) { return &o.mapError_m; }, Metres, limits::kSmallError_m, {.mostDecimals = 3},
         en("Map error"), en("Part of the width of the contingency volume. Same source: 1 m.")},
        {"reaction_s", [](Operation& o) { return &o.reaction_s; }, Seconds, limits::kReaction_s, {.mostDecimals = 3},
         en("Reaction time"), en("Time at full speed before the crew reacts. Same source: 1 s.")},
        {"turn_bank_deg", [](Operation& o) { return &o.turnBank_deg; }, Degrees, limits::kBank_deg, {.mostDecimals = 3},
         en("Bank of the turn back"), en("Sets the turn radius v²/(g tan bank). Same source: 30°.")},
        {"height_error_m", [](Operation& o) { return &o.heightError_m; }, Metres, limits::kSmallError_m,
         {.mostDecimals = 3}, en("Height error"),
         en("Part of the height of the contingency volume. Same source: 4 m.")},
        {"climb_part", [](Operation& o) { return &o.climbPart; }, Number, limits::kPart, {.mostDecimals = 3},
         en("Climb part"),
         en("Share of the speed that is climb during the reaction time. Same source: 0.707, a climb of 45°.")},
        {"pull_up_part", [](Operation& o) { return &o.pullUpPart; }, Number, limits::kPart, {.mostDecimals = 3},
         en("Pull-up part"), en("Height needed to level out, as a share of v²/g. Same source: 0.3.")},
        {"buffer_ratio", [](Operation& o) { return &o.bufferRatio; }, Number, limits::kPart, {.mostDecimals = 3},
         en("Buffer ratio"),
         en("Width of the ground-risk buffer divided by the height of the contingency volume. Same source: 1, the 1:1 "
                    "rule.")},
        {"adjacent_s", [](Operation& o) { return &o.adjacent_s; }, Seconds, limits::kTime_s, {.mostDecimals = 3},
         en("Adjacent area, time"), en("Flight time at full speed. Same source: 180 s.")},
        {"adjacent_least_m", [](Operation& o) { return &o.adjacentLeast_m; }, Metres, limits::kLength_m,
         {.mostDecimals = 3}, en("Adjacent area, minimum"), en("Minimum width. Same source: 5 km.")},
        {"adjacent_most_m", [](Operation& o) { return &o.adjacentMost_m; }, Metres, limits::kLength_m,
         {.mostDecimals = 3}, en("Adjacent area, maximum"), en("Maximum width. Same source: 35 km.")},
        {"crew", [](Operation& o) { return &o.crew; }, Text, {}, {.isLong = true}, en("Crew"),
         en("Names printed in the flight brief. If empty, the brief has a blank line.")},
        {"call_sign", [](Operation& o) { return &o.callSign; }, Text, {}, {}, en("Call sign"),
         en("Printed in the flight brief. If empty, the brief has a blank line.")},
        {"contacts", [](Operation& o) { return &o.contacts; }, Text, {}, {.isLong = true}, en("Contacts"),
         en("Ship, air traffic service, rescue: names, numbers, frequencies.")},
        {"link", [](Operation& o) { return &o.link; }, Text, {}, {.isLong = true}, en("Command link"),
         en("How the UAVs are commanded, and what they do if the link is lost.")},
        {"checklist", [](Operation& o) { return &o.checklist; }, Text, {}, {.isLong = true}, en("Checklist"),
         en("One item per line, printed with a box to tick.")},
    });

    static constexpr auto kWeather = std::to_array<Field<Weather>>({
        {"gust_mps", [](Weather& w) { return &w.gust_mps; }, Speed, limits::kWindSpeed_mps,
         {.noneText = en("not known")}, en("Gusts"), en("Speed of the gusts, compared with the limits of the UAVs.")},
        {"temperature_degc", [](Weather& w) { return &w.temperature_degC; }, Celsius, limits::kTemperature_degC,
         {.noneText = en("not known")}, en("Temperature"), en("Air temperature at sea level.")},
        {"dew_point_degc", [](Weather& w) { return &w.dewPoint_degC; }, Celsius, limits::kTemperature_degC,
         {.noneText = en("not known")}, en("Dew point"), en("Dew point at sea level. With the temperature it shows "
                    "whether ice may form.")},
    });

    static constexpr auto kForecastEntry = std::to_array<Field<ForecastEntry>>({
        {"wind_mps", [](ForecastEntry& e) { return &e.wind_mps; }, Speed, limits::kWindVelocity_mps,
         {.note = en("Velocity of the wind at 10 m, towards true east and north.")},
         en("Wind east"), "", en("Wind north")},
        {"gust_mps", [](ForecastEntry& e) { return &e.gust_mps; }, Speed, limits::kWindSpeed_mps,
         {.note = en("Speed of gusts.")}, en("Gusts")},
        {"air_temperature_degc", [](ForecastEntry& e) { return &e.airTemperature_degC; }, Celsius,
         limits::kTemperature_degC, {.note = en("Temperature of the air at 2 m.")}, en("Temperature")},
        {"dew_point_degc", [](ForecastEntry& e) { return &e.dewPoint_degC; }, Celsius, limits::kTemperature_degC,
         {.note = en("Dew point of the air at 2 m.")},
         en("Dew point")},
        {"fog_percent", [](ForecastEntry& e) { return &e.fog_percent; }, Percent, limits::kPercent,
         {.note = en("Part of the area with fog.")}, en("Fog")},
        {"visibility_m", [](ForecastEntry& e) { return &e.visibility_m; }, Distance, limits::kLength_m,
         {.note = en("Visibility.")},
         en("Visibility")},
        {"ceiling_m", [](ForecastEntry& e) { return &e.ceiling_m; }, Height, limits::kLength_m,
         {.note = en("Height of the cloud base above the sea.")}, en("Cloud base")},
        {"current_mps", [](ForecastEntry& e) { return &e.current_mps; }, Speed, limits::kVelocity_mps,
         {.note = en("Velocity of the current, towards true east and north.")},
         en("Current east"), "", en("Current north")},
    });

    static constexpr auto kForecast = std::to_array<Field<Forecast>>({
        {"latitude_deg", [](Forecast& f) { return &f.place.latitude_deg; }, Degrees, limits::kLatitude_deg,
         {.presence = Needed, .note = en("Latitude of a place of the grid.")}, en("Latitude")},
        {"longitude_deg", [](Forecast& f) { return &f.place.longitude_deg; }, Degrees, limits::kLongitude_deg,
         {.presence = Needed, .note = en("Longitude of a place of the grid.")}, en("Longitude")},
        {"depth_m", [](Forecast& f) { return &f.depth_m; }, Metres, limits::kLength_m,
         {.note = en("Depth of the sea at the place.")}, en("Depth of the sea")},
    });

    static constexpr auto kOrigin = std::to_array<Field<LatLon>>({
        {"latitude_deg", [](LatLon& o) { return &o.latitude_deg; }, Degrees, limits::kLatitude_deg,
         {.presence = Always, .note = en("Latitude of the local plane's origin.")}, en("Latitude"),
         en("Coordinate of the origin, in any format; a full coordinate or a place name sets both. Everything moves "
                    "with it.")},
        {"longitude_deg", [](LatLon& o) { return &o.longitude_deg; }, Degrees, limits::kLongitude_deg,
         {.presence = Always, .note = en("Longitude of the local plane's origin.")}, en("Longitude"),
         en("Coordinate of the origin, in any format; a full coordinate or a place name sets both. Everything moves "
                    "with it.")},
    });

    static constexpr auto kObserver = std::to_array<Field<ObserverSpec>>({
        {"model", [](ObserverSpec& o) { return &o.model; }, Text, {},
         {.presence = Always, .note = en("With `simple`, the estimate of an iceberg in view is the truth; with "
                "`kalman`, a filter uses noisy measurements.")}, en("Observer"),
         en("Exact: a sighting gives the true position. Filter: position and velocity are estimated from noisy "
                    "measurements, and icebergs can get lost.")},
        {"position_sd_m", [](ObserverSpec& o) { return &o.positionSd_m; }, Metres, limits::kLength_m, {},
         en("Position error"), en("Standard deviation of a measured position, along each axis.")},
        {"interval_s", [](ObserverSpec& o) { return &o.interval_s; }, Seconds, limits::kSensorInterval_s,
         {.mostDecimals = 3}, en("Sensor interval"),
         en("Time between two samples of the sensor, each of which measures what is in view.")},
        {"detection", [](ObserverSpec& o) { return &o.detection; }, Number, limits::kDetection, {.step = 5},
         en("Detection probability"), en("Probability that one sample shows an iceberg in view.")},
        {"search", [](ObserverSpec& o) { return &o.search; }, Text, {}, {}, en("Search"),
         en("Search pattern for an iceberg that is not at its estimated position.")},
    });

    static constexpr auto kPlanner = std::to_array<Field<Scenario>>({
        {"policy", [](Scenario& s) { return &s.planner.policy; }, Text, {},
         {.presence = Always, .note = en("Policy that chooses the orders.")}},
        {"tau", [](Scenario& s) { return &s.planner.tau; }, Number, limits::kTau,
         {.presence = Always, .note = en("0 visits the most uncertain iceberg first; a large value gives the "
                "shortest path.")},
         en("Trade-off τ")},
        {"route", [](Scenario& s) { return &s.planner.route; }, Text, {},
         {.note = en("Whether the path ends over the last iceberg or returns to its start.")}},
        {"backend", [](Scenario& s) { return &s.planner.backend; }, Text, {}, {.note = en("Solver of the orders.")}},
        {"formulation", [](Scenario& s) { return &s.planner.formulation; }, Text, {}, {}, en("Formulation"),
         en("Integer program that COIN-OR CBC solves when it is the solver.")},
        {"planning_delay_s", [](Scenario& s) { return &s.planningTime_s; }, Seconds, limits::kPlanningDelay_s,
         {.olderName = "latency_s"},
         en("Planning time"),
         en("Time to make a plan in flight; until it is ready the UAV continues with the previous plan.")},
        {"reach_radius_m", [](Scenario& s) { return &s.reachRadius_m; }, Distance, limits::kExtent_m,
         {.step = 10, .noneText = en("in view"), .note = en("An iceberg is reached within this distance. Without "
                "it, an iceberg is reached when it is in view; with measurements, when its estimate is in view "
                "after a sighting.")}, en("Acceptance radius"),
         en("Distance at which an iceberg counts as reached; at 0 it is reached when it is in view.")},
        {"fov_shape", [](Scenario& s) { return &s.fovShape; }, Text, {},
         {.note = en("Shape of the field of view. The diameter of a disk is `fov_m[0]`; the second number has no "
                "effect.")}, en("Field of view"),
         en("Shape of the area that the camera covers.")},
        {"clusters", [](Scenario& s) { return &s.clusters; }, Text, {}, {}, en("Group nearby icebergs"),
         en("Icebergs that fit into one field of view are planned as one point, from which all are seen.")},
    });

    static constexpr auto kScenario = std::to_array<Field<Scenario>>({
        {"name", [](Scenario& s) { return &s.name; }, Text, {}, {.presence = Always}, en("Name"),
         en("Title of the scenario, shown on the map.")},
        {"notes", [](Scenario& s) { return &s.notes; }, Text, {}, {.isLong = true}, en("Notes"),
         en("Any text, stored in the file.")},
        {"start_utc", [](Scenario& s) { return &s.startUtc; }, Utc, {},
         {.note = en("Start time, ISO 8601 with Z; without it, times are relative.")}, en("Start (UTC)"),
         en("Date and time of the start, such as 2026-11-29 12:00 or 29 Nov 2026 12:00; 1200Z keeps the date. Empty: "
                    "times are relative.")},
        {"duration_s", [](Scenario& s) { return &s.duration_s; }, Seconds, limits::kDuration_s,
         {.step = 60, .mostDecimals = 2, .presence = Always}, en("Duration"),
         en("Length of the run, at most seven days.")},
        {"seed", [](Scenario& s) { return &s.seed; }, Number, kSeed, {.mostDecimals = 0, .presence = Always},
         en("Seed"),
         en("Seed of the random drift: the same seed repeats the run.")},
        {"dt_s", [](Scenario& s) { return &s.dt_s; }, Seconds, limits::kTimeStep_s,
         {.step = 0.05, .leastDecimals = 2, .mostDecimals = 3, .presence = Always}, en("Time step"),
         en("Step of the simulation; a smaller step is more exact and slower.")},
        {"noise", [](Scenario& s) { return &s.noise; }, Text, {},
         {.presence = Always, .note = en("If false, nothing is random: icebergs drift at their given velocities, "
                "and measurements detect every iceberg in view.")}, en("Random drift"),
         en("Off: icebergs drift exactly as known.")},
        {"wind_mps", [](Scenario& s) { return &s.wind_mps; }, Speed, {},
         {.step = 0.5, .mostDecimals = 2, .note = en("Velocity over ground; the wind must be slower than the "
                "airspeed.")},
         en("Wind east"), en("Towards the east; must be below the UAV's airspeed."), en("Wind north"),
         en("Towards the north; must be below the UAV's airspeed.")},
        {"current_mps", [](Scenario& s) { return &s.current_mps; }, Speed, limits::kVelocity_mps,
         {.step = 0.05, .leastDecimals = 2, .mostDecimals = 3, .note = en("Velocity over ground; the current "
                "carries every iceberg.")}, en("Current east"),
         en("Carries every iceberg towards the east."), en("Current north"),
         en("Carries every iceberg towards the north.")},
        {"area_m", [](Scenario& s) { return &s.area_m; }, Distance, limits::kCoordinate_m,
         {.note = en("Corners of the monitored area; an iceberg that is farther outside than its radius is no "
                "longer monitored.")},
         en("Corner of the area")},
        {"geofence", [](Scenario& s) { return &s.geofence; }, Text, {},
         {.note = en("UAVs that start clear of the edge of `area_m` stay inside it; `validate` warns if a start "
                "leaves no safe turn or path home, but the flight is allowed.")}, en("Geofence"),
         en("UAVs stay inside the area if they start clear of its edge.")},
        {"separation_m", [](Scenario& s) { return &s.separation_m; }, Distance, limits::kLength_m,
         {.step = 50, .mostDecimals = 2, .noneText = en("no separation"), .note = en("Least distance between UAVs "
                "whose altitudes differ by less than %1, after they have reached it (`validate` gives a hint if "
                "they start nearer); 0 turns separation off.")}, en("Separation"),
         en("Least distance between UAVs whose altitudes differ by less than %1.")},
    });
};

} // namespace

template <> std::span<const Field<Uav>> fieldsOf() { return Fields::kUav; }
template <> std::span<const Field<Iceberg>> fieldsOf() { return Fields::kIceberg; }
template <> std::span<const Field<Asset>> fieldsOf() { return Fields::kAsset; }
template <> std::span<const Field<NoFlyArea>> fieldsOf() { return Fields::kNoFlyArea; }
template <> std::span<const Field<AirspaceArea>> fieldsOf() { return Fields::kAirspaceArea; }
template <> std::span<const Field<IceChart>> fieldsOf() { return Fields::kIceChart; }
template <> std::span<const Field<IceArea>> fieldsOf() { return Fields::kIceArea; }
template <> std::span<const Field<GroundStation>> fieldsOf() { return Fields::kGroundStation; }
template <> std::span<const Field<Operation>> fieldsOf() { return Fields::kOperation; }
template <> std::span<const Field<Weather>> fieldsOf() { return Fields::kWeather; }
template <> std::span<const Field<Forecast>> fieldsOf() { return Fields::kForecast; }
template <> std::span<const Field<ForecastEntry>> fieldsOf() { return Fields::kForecastEntry; }
template <> std::span<const Field<LatLon>> fieldsOf() { return Fields::kOrigin; }
template <> std::span<const Field<ObserverSpec>> fieldsOf() { return Fields::kObserver; }
template <> std::span<const Field<Scenario>> fieldsOf() { return Fields::kScenario; }
std::span<const Field<Scenario>> plannerFields() { return Fields::kPlanner; }
// clang-format on

} // namespace berg
