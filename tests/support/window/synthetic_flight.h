#pragma once

#include "widgets/flight/flight_record.h"

#include <cmath>
#include <string>

namespace berg::test {

/** Parameters of an artificial flight for charts. */
struct SyntheticFlight
{
    int icebergs = 12;
    double duration_s = 1000;
    double interval_s = 1; ///< between samples
    int uavs = 1;          ///< each has the course of the one before, a quarter of a minute later
};

inline std::vector<UavSample> syntheticUavs(const SyntheticFlight& flight, double time_s)
{
    constexpr double kLag_s = 15;
    std::vector<UavSample> uavs;
    for (int i = 0; i < flight.uavs; ++i) {
        const double own_s = time_s - kLag_s * i;
        uavs.push_back({.u_radps = 0.2 * std::sin(0.05 * own_s),
                        .crossTrack_m = 40 * std::sin(0.013 * own_s),
                        .flown_m = (22 - i) * time_s});
    }
    return uavs;
}

/**
 * Adds the samples in (from, until]: sigma of each iceberg grows and is 0 for 25 s once in a round
 * of all of them, as with visits one after the other.
 */
inline void extend(FlightRecord& record, const SyntheticFlight& flight, double until_s)
{
    constexpr double kGrowth_m2ps = 0.025;
    constexpr double kInView_s = 25;
    constexpr double kLeg_s = 60;
    const double round_s = kLeg_s * flight.icebergs;
    MissionHistory& history = record.history;
    double zeta_m2s = history.samples.empty() ? 0 : history.samples.back().zeta_m2s;
    const auto first = static_cast<int>(history.samples.size());
    for (int k = first; k * flight.interval_s <= until_s + 1e-9; ++k) {
        const double time_s = k * flight.interval_s;
        std::vector<IcebergSample> row(static_cast<std::size_t>(flight.icebergs));
        double sum_m2 = 0;
        for (int i = 0; i < flight.icebergs; ++i) {
            const double since_s = std::fmod(time_s + round_s - kLeg_s * i, round_s);
            IcebergSample& iceberg = row[static_cast<std::size_t>(i)];
            iceberg.inView = since_s < kInView_s;
            iceberg.sigma_m2 = iceberg.inView ? 0 : kGrowth_m2ps * (since_s - kInView_s);
            sum_m2 += iceberg.sigma_m2;
        }
        zeta_m2s += k == 0 ? 0 : sum_m2 * flight.interval_s;
        history.rows.push_back(std::move(row));
        Sample sample{.time_s = time_s,
                      .uavs = syntheticUavs(flight, time_s),
                      .sigmaSum_m2 = sum_m2,
                      .zeta_m2s = zeta_m2s};
        for (const UavSample& uav : sample.uavs)
            sample.flown_m += uav.flown_m;
        history.samples.push_back(std::move(sample));
        record.now.time_s = time_s;
        record.now.metrics.zeta_m2s = zeta_m2s;
    }
}

/** Returns the record of such a flight until `until_s`. */
inline FlightRecord syntheticRecord(const SyntheticFlight& flight, double until_s)
{
    FlightRecord record;
    for (int i = 1; i <= flight.uavs; ++i)
        record.scenario.uavs.emplace_back().id = "uav-" + std::to_string(i);
    record.now.phase = RunPhase::Flying;
    for (int i = 0; i < flight.icebergs; ++i) {
        Iceberg iceberg;
        iceberg.id = "B" + std::to_string(i + 1);
        record.now.icebergs.push_back(iceberg);
        record.now.active.push_back(true);
    }
    record.now.world.tracks.resize(record.now.icebergs.size());
    extend(record, flight, until_s);
    return record;
}

} // namespace berg::test
