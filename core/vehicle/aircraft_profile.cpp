#include "core/vehicle/aircraft_profile.h"

#include <array>

namespace berg {

namespace {

constexpr AutopilotFirmware kPx4Firmware = AutopilotFirmware::Px4;

constexpr std::array kReadyProfiles{
    ReadyProfile{"ardupilot-plane", {}},
    ReadyProfile{"ardupilot-flying-wing",
                 {.takeOff = TakeOffMethod::Hand,
                  .end = MissionEnd::Landing,
                  .camera = CameraTrigger::Distance}},
    ReadyProfile{"ardupilot-vtol",
                 {.airframe = Airframe::Vtol,
                  .takeOffAltitude_m = 40,
                  .end = MissionEnd::Landing,
                  .approach_m = 300}},
    ReadyProfile{"ardupilot-multirotor",
                 {.airframe = Airframe::Multirotor,
                  .takeOffAltitude_m = 30,
                  .camera = CameraTrigger::Time,
                  .gimbalDown = true}},
    ReadyProfile{"px4-plane", {.firmware = kPx4Firmware, .end = MissionEnd::Landing}},
    ReadyProfile{"px4-vtol",
                 {.firmware = kPx4Firmware,
                  .airframe = Airframe::Vtol,
                  .takeOffAltitude_m = 40,
                  .end = MissionEnd::Landing,
                  .approach_m = 300}},
    ReadyProfile{"px4-multirotor",
                 {.firmware = kPx4Firmware,
                  .airframe = Airframe::Multirotor,
                  .takeOffAltitude_m = 30,
                  .camera = CameraTrigger::Time,
                  .gimbalDown = true}}};

} // namespace

std::span<const ReadyProfile> readyProfiles()
{
    return kReadyProfiles;
}

} // namespace berg
