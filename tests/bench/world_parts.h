#pragma once

#include "core/mission/mission.h"
#include "core/scenario/limits.h"
#include "core/study/statistics.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

// One function per realistic condition: it flies scenarios 1 ... `scenarios` with and
// without the condition and prints the results.

namespace berg::bench {

void observer(int scenarios);
/** Runs the regime named `only`, or all of them if it is empty. */
void observerFrom(std::int64_t firstSeed, int scenarios, std::string_view only);
void filter(int scenarios);
void lost(int scenarios);
void wind(int scenarios);
void asset(int scenarios);
void area(int scenarios);
void autopilot(int scenarios);
void clusters(int scenarios);
void endurance(int scenarios);
void geofence(int scenarios);
void fleet(int scenarios);
void fleetCoverage(int scenarios);
void separation(int scenarios);
void pads(int scenarios);
void tau(int scenarios);

/** Selects a part of the table of sparse fields and long runs. */
struct SparseOptions
{
    int fields = 12; ///< number of fields per row
    std::string row; ///< name of the row, or empty for all rows
    std::int64_t firstSeed = 501;
    std::string against = "latency,visitation"; ///< policies flown besides coverage
    bool bound = false;                         ///< lower bound of each field
};
/** Flies the table; returns false if no row has that name. */
bool sparse(const SparseOptions& options);

/** UAVs along the western edge, evenly, heading as the first; each in an altitude layer. */
inline Scenario withUavs(Scenario scenario, int uavs)
{
    const Uav first = scenario.uavs.front();
    scenario.uavs.clear();
    for (int i = 0; i < uavs; ++i) {
        Uav uav = first;
        uav.id = "uav-" + std::to_string(i + 1);
        uav.position_m.y() += 1000.0 * i;
        uav.spec.altitude_m += kLayerHeight_m * i;
        scenario.uavs.push_back(uav);
    }
    return scenario;
}

inline int countOf(const Mission& mission, EventKind kind)
{
    return static_cast<int>(
        std::count_if(mission.events().begin(), mission.events().end(),
                      [kind](const MissionEvent& e) { return e.kind == kind; }));
}

/** Measured values of one flight, by column. */
using Row = std::vector<double>;

/** Prints a line with the mean of each column. */
inline void printMeans(const char* name, const std::vector<Row>& flights)
{
    std::printf("%-24s", name);
    for (std::size_t column = 0; column < flights.front().size(); ++column) {
        double sum = 0;
        for (const Row& row : flights)
            sum += row[column];
        std::printf(" %11.3f", sum / static_cast<double>(flights.size()));
    }
    std::printf("\n");
    std::fflush(stdout);
}

/** Prints the paired difference of `with` from `without` in one column, in % of the mean without.
 */
inline void printDifference(const char* name, const std::vector<Row>& without,
                            const std::vector<Row>& with, std::size_t column = 0)
{
    std::vector<double> share;
    double base = 0;
    for (const Row& row : without)
        base += row[column] / static_cast<double>(without.size());
    for (std::size_t i = 0; i < with.size(); ++i)
        share.push_back(100 * (with[i][column] - without[i][column]) / base);
    const MeanInterval mean = meanInterval(share);
    std::printf("%-24s %+.2f %% [%+.2f, %+.2f]\n", name, mean.mean, mean.low, mean.high);
    std::fflush(stdout);
}

} // namespace berg::bench
