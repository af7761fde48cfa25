#pragma once

#include "core/base/random.h"
#include "widgets/map/picture/map_picture.h"

#include <algorithm>

namespace berg::test {

/**
 * Returns a map picture of `icebergs` in 5 km x 4 km with a flown track and a plan over all of
 * them.
 */
inline MapPicture randomPicture(int icebergs, std::uint64_t seed = 1)
{
    using namespace Qt::StringLiterals;
    Random random(seed);
    MapPicture picture;
    picture.title = u"Grand Banks, %1 icebergs"_s.arg(icebergs);
    picture.subtitle = u"Nearest iceberg first"_s;
    picture.readouts = {{.caption = u"Time"_s, .value = u"16:40"_s, .unit = {}},
                        {.caption = u"Zeta"_s, .value = u"84 420"_s, .unit = u"m² s"_s}};
    MapRoute& route = picture.routes.emplace_back();
    for (int i = 0; i < icebergs; ++i) {
        picture.icebergs.push_back(
            {.id = u"B%1"_s.arg(i + 1, 2, 10, QChar(u'0')),
             .position_m = {random.uniform(0, 5000), random.uniform(0, 4000)},
             .velocity_mps = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)},
             .sigma_m2 = random.uniform(0, 20),
             .radius_m = random.uniform(3, 150),
             .inView = i == 2});
        route.plan.push_back(MapPlace::of(i));
    }
    picture.uavs = {MapUav{.position_m = {2500, 2000}, .psi_rad = 0.6, .sensor = {}}};
    for (int k = 0; k <= 200; ++k)
        route.track.push_back({.position_m = {15.0 * k - 500, 500 + 7.5 * k}, .time_s = 5.0 * k});
    picture.sigmaFull_m2 = 20;
    picture.emptyTitle = u"No icebergs yet"_s;
    picture.emptyHint = u"Add some to the scenario."_s;
    return picture;
}

} // namespace berg::test
