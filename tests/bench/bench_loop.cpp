// Random fleets with losses, endurance, wind, fences and changes in flight: how many show a fault
// that the closed loop must not have, and which.
//
// Use: bench_loop [fleets] [first seed]

#include "tests/support/flight/fleet_watch.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    using namespace berg::test;
    const int fleets = argc > 1 ? std::atoi(argv[1]) : 2000;
    const int first = argc > 2 ? std::atoi(argv[2]) : 1;
    std::array<int, kFaultNames.size()> flights{};
    int losses = 0;
    int sorties = 0;
    int landings = 0;
    int reserves = 0;
    for (int seed = first; seed < first + fleets; ++seed) {
        const FleetFaults faults = faultsOf(static_cast<std::uint64_t>(seed));
        losses += faults.losses;
        sorties += faults.sorties;
        landings += faults.landings;
        reserves += faults.reserves;
        for (std::size_t i = 0; i < flights.size(); ++i)
            flights[i] += faults.seconds[i] > 0 ? 1 : 0;
        if (!faults.any())
            continue;
        std::printf("seed %d: %s;", seed, faults.first.c_str());
        for (std::size_t i = 0; i < flights.size(); ++i)
            if (faults.seconds[i] > 0)
                std::printf(" %s %d", kFaultNames[i], faults.seconds[i]);
        std::printf("\n");
        std::fflush(stdout);
    }
    std::printf("%d fleets, %d losses, %d take-offs, %d landings, %d of them with part of the "
                "reserve as others were in the way; flights with\n",
                fleets, losses, sorties, landings, reserves);
    for (std::size_t i = 0; i < flights.size(); ++i)
        std::printf("  %-10s %d\n", kFaultNames[i], flights[i]);
    return 0;
}
