// The aircraft profile of a UAV: how its exported missions begin, end and take pictures.

#include "widgets/panels/inspector/field_inputs.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr const char* kUavs = "uavs.";

/** Returns a test of the profile of a UAV for the rows that depend on it. */
template <class Test>
auto profileIs(const Test& test)
{
    return [test](const Scenario& scenario, const std::string& id) {
        const Uav* uav = findById(scenario.uavs, id);
        return uav != nullptr && test(uav->aircraft);
    };
}

QString readyName(std::string_view id)
{
    if (id == "ardupilot-plane")
        return InspectorRows::tr("ArduPilot, fixed wing");
    if (id == "ardupilot-flying-wing")
        return InspectorRows::tr("ArduPilot, flying wing launched by hand");
    if (id == "ardupilot-vtol")
        return InspectorRows::tr("ArduPilot, VTOL");
    if (id == "ardupilot-multirotor")
        return InspectorRows::tr("ArduPilot, multirotor");
    if (id == "px4-plane")
        return InspectorRows::tr("PX4, fixed wing");
    if (id == "px4-vtol")
        return InspectorRows::tr("PX4, VTOL");
    return InspectorRows::tr("PX4, multirotor");
}

/** The profile that all rows below agree with; no value if they are set one by one. */
PickRow readyRow()
{
    std::vector<PickRow::Option> options{{.value = {}, .text = InspectorRows::tr("as set below")}};
    for (const ReadyProfile& ready : readyProfiles())
        options.push_back({.value = std::string(ready.id), .text = readyName(ready.id)});
    return {.words = {.key = u"uavAircraftProfile"_s,
                      .label = InspectorRows::tr("Aircraft profile"),
                      .toolTip = InspectorRows::tr("Sets all values of this group at once."),
                      .undoText = InspectorRows::tr("Choose aircraft profile")},
            .options = [options](const Scenario&) { return options; },
            .read =
                [](const Scenario& scenario, const std::string& id) {
                    const Uav* uav = findById(scenario.uavs, id);
                    for (const ReadyProfile& ready : readyProfiles())
                        if (uav != nullptr && ready.profile == uav->aircraft)
                            return std::string(ready.id);
                    return std::string();
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& chosen) {
                    Uav* uav = findById(scenario.uavs, id);
                    for (const ReadyProfile& ready : readyProfiles())
                        if (uav != nullptr && ready.id == chosen)
                            uav->aircraft = ready.profile;
                }};
}

std::vector<InspectorRow> takeOffRows()
{
    const auto hasItem = [](const AircraftProfile& a) { return a.takeOff == TakeOffMethod::Item; };
    const auto isPitched = [hasItem](const AircraftProfile& a) {
        return hasItem(a) && a.airframe == Airframe::FixedWing;
    };
    return {FieldInputs<Uav>(kUavs).choice(
                "take_off", {InspectorRows::tr("by mission item"), InspectorRows::tr("by hand")}),
            FieldInputs<Uav>(kUavs, profileIs(hasItem)).number("take_off_altitude_m"),
            FieldInputs<Uav>(kUavs, profileIs(isPitched)).number("take_off_pitch_deg")};
}

std::vector<InspectorRow> missionEndRows()
{
    const auto isApproached = [](const AircraftProfile& a) {
        return a.end == MissionEnd::Landing && a.airframe != Airframe::Multirotor;
    };
    const auto lands = [](const AircraftProfile& a) { return a.end == MissionEnd::Landing; };
    const FieldInputs<Uav> approach(kUavs, profileIs(isApproached));
    return {FieldInputs<Uav>(kUavs).choice("mission_end", {InspectorRows::tr("return to launch"),
                                                           InspectorRows::tr("landing pattern"),
                                                           InspectorRows::tr("loiter and wait")}),
            approach.number("approach_m"),
            FieldInputs<Uav>(kUavs, profileIs(lands)).number("approach_altitude_m"),
            approach.number("approach_course_deg")};
}

std::vector<InspectorRow> cameraRows()
{
    const auto triggersBy = [](CameraTrigger trigger) {
        return profileIs([trigger](const AircraftProfile& a) { return a.camera == trigger; });
    };
    return {FieldInputs<Uav>(kUavs).choice("camera", {InspectorRows::tr("not in the mission"),
                                                      InspectorRows::tr("by distance"),
                                                      InspectorRows::tr("by time")}),
            FieldInputs<Uav>(kUavs, triggersBy(CameraTrigger::Distance)).number("trigger_m"),
            FieldInputs<Uav>(kUavs, triggersBy(CameraTrigger::Time)).number("trigger_s"),
            FieldInputs<Uav>(kUavs).flag("gimbal_down")};
}

} // namespace

std::vector<InspectorRow> aircraftRows()
{
    const FieldInputs<Uav> uav(kUavs);
    const auto circles = [](const AircraftProfile& a) {
        return a.airframe != Airframe::Multirotor;
    };
    const auto isVtol = [](const AircraftProfile& a) { return a.airframe == Airframe::Vtol; };
    std::vector<InspectorRow> rows{
        readyRow(), uav.choice("firmware", {u"ArduPilot"_s, u"PX4"_s}),
        uav.choice("airframe", {InspectorRows::tr("fixed wing"), InspectorRows::tr("VTOL"),
                                InspectorRows::tr("multirotor")})};
    append(rows, takeOffRows());
    append(rows, missionEndRows());
    rows.emplace_back(FieldInputs<Uav>(kUavs, profileIs(circles)).number("loiter_radius_m"));
    rows.emplace_back(FieldInputs<Uav>(kUavs, profileIs(isVtol)).number("hover_speed_mps"));
    rows.emplace_back(uav.flag("speed_items"));
    append(rows, cameraRows());
    return rows;
}

} // namespace berg
