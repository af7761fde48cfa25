#include "widgets/map/picture/route_colours.h"

#include "widgets/theme/palette.h"
#include "widgets/words/object_names.h"

namespace berg {

RouteColours routeColours(const MapPicture& picture, const Theme& theme,
                          std::optional<std::size_t> uav)
{
    if (!areDistinguished(picture.uavs))
        return {.uav = theme.uav,
                .plan = theme.plan,
                .former = theme.formerPlan,
                .track = theme.track,
                .home = theme.ink};
    // Beside the plan of the same colour the flown track is fainter.
    constexpr double kTrackShare = 0.7;
    constexpr double kFormerShare = 0.65;
    const QColor colour = uav ? uavColour(theme, picture.uavs[*uav].place) : theme.ink;
    return {.uav = colour,
            .plan = colour,
            .former = mixed(theme.sea, colour, kFormerShare),
            .track = mixed(theme.sea, colour, kTrackShare),
            .home = colour};
}

} // namespace berg
