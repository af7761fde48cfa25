#pragma once

#include "core/link/aircraft_state.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

/** The battery of an aircraft against the way home and the endurance of its UAV. */
struct BatteryReadout
{
    AircraftBattery battery;
    std::optional<double> left_s;      ///< until it is empty
    bool isComputed = false;           ///< `left_s` follows from the charge, not from a report
    std::optional<double> wayHome_s;   ///< straight, at cruise airspeed in the wind
    std::optional<double> endurance_s; ///< endurance left of the simulated UAV
};

/** Returns true if the battery ends before the way home does. */
[[nodiscard]] bool isBatteryShort(const BatteryReadout& readout);

/** Returns charge, voltage, time left, way home and endurance in one line. */
[[nodiscard]] QString batteryText(const BatteryReadout& readout, const QLocale& locale);

/** Returns the warning for a battery that is too short. */
[[nodiscard]] QString batteryWarning(const BatteryReadout& readout);

} // namespace berg
