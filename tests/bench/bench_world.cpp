// Effect of realistic conditions: each is flown with and without, in the same
// scenarios with the same noise, and compared pair by pair.
//
// Use: bench_world PART [scenarios], and of the part observer also [first seed [regime]]
//      bench_world sparse [fields [row or all [first seed [policies or none [bound]]]]]

#include "tests/bench/world_parts.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

using namespace berg;

struct Part
{
    std::string_view name;
    void (*run)(int scenarios);
};

constexpr std::array kParts{Part{"clusters", bench::clusters},
                            Part{"observer", bench::observer},
                            Part{"filter", bench::filter},
                            Part{"lost", bench::lost},
                            Part{"wind", bench::wind},
                            Part{"asset", bench::asset},
                            Part{"area", bench::area},
                            Part{"autopilot", bench::autopilot},
                            Part{"endurance", bench::endurance},
                            Part{"geofence", bench::geofence},
                            Part{"fleet", bench::fleet},
                            Part{"fleet-coverage", bench::fleetCoverage},
                            Part{"separation", bench::separation},
                            Part{"pads", bench::pads},
                            Part{"tau", bench::tau}};

int sparse(int argc, char** argv)
{
    bench::SparseOptions options;
    if (argc > 2)
        options.fields = std::atoi(argv[2]);
    if (argc > 3 && std::string_view(argv[3]) != "all")
        options.row = argv[3];
    if (argc > 4)
        options.firstSeed = std::atoll(argv[4]);
    if (argc > 5)
        options.against = argv[5];
    options.bound = argc > 6 && std::string_view(argv[6]) == "bound";
    return bench::sparse(options) ? 0 : 2;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string_view wanted = argc > 1 ? argv[1] : "";
    const int scenarios = argc > 2 ? std::atoi(argv[2]) : 50;
    if (wanted == "observer" && argc > 3) {
        bench::observerFrom(std::atoll(argv[3]), scenarios, argc > 4 ? argv[4] : "");
        return 0;
    }
    if (wanted == "sparse")
        return sparse(argc, argv);
    for (const Part& part : kParts)
        if (part.name == wanted) {
            part.run(scenarios);
            return 0;
        }
    std::printf(
        "bench_world PART [scenarios [first seed [regime], of observer]]; the parts are sparse");
    for (const Part& part : kParts)
        std::printf(" %.*s", static_cast<int>(part.name.size()), part.name.data());
    std::printf("\n");
    return 2;
}
