#include "core/scenario/sortie.h"

namespace berg {

std::optional<SortieSpec> sortieOf(const Uav& uav)
{
    if (uav.spec.endurance_s == 0)
        return std::nullopt;
    return SortieSpec{.endurance_s = usableEndurance_s(uav.spec),
                      .turnaround_s = uav.spec.landing_s + uav.turnaround_s + uav.spec.climb_s,
                      .home_m = uav.home_m.value_or(uav.position_m)};
}

} // namespace berg
