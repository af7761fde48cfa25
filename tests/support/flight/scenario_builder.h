#pragma once

#include "core/scenario/scenario.h"

namespace berg::test {

/** Returns a scenario without noise and icebergs: one UAV at the origin, flying east. */
inline Scenario emptySea(double duration_s = 1000)
{
    Scenario scenario;
    scenario.name = "test";
    scenario.duration_s = duration_s;
    scenario.noise = false;
    Uav uav;
    uav.id = "uav-1";
    uav.heading_deg = 90;
    scenario.uavs.push_back(uav);
    return scenario;
}

/** Adds a stationary iceberg and returns it for changes. */
inline Iceberg& addIceberg(Scenario& scenario, double east_m, double north_m, double sigma0_m2 = 5)
{
    Iceberg iceberg;
    iceberg.id = "berg-" + std::to_string(scenario.icebergs.size() + 1);
    iceberg.position_m = {east_m, north_m};
    iceberg.sigma0_m2 = sigma0_m2;
    scenario.icebergs.push_back(iceberg);
    return scenario.icebergs.back();
}

/** Makes icebergs measured, with velocities that change within the hour. */
inline void letVelocitiesChange(Scenario& scenario)
{
    scenario.observer.model = ObserverModel::Kalman;
    for (Iceberg& iceberg : scenario.icebergs) {
        iceberg.velocitySpread_mps = 0.05;
        iceberg.velocityTime_s = 3600;
    }
}

} // namespace berg::test
