#include "widgets/map/picture/route_colours.h"

#include "widgets/theme/palette.h"

namespace berg {
namespace {

RouteColours colourOnly(const QColor& colour, const Theme& theme)
{
    // Beside the plan of the same colour the flown track is fainter.
    constexpr double kTrackShare = 0.7;
    constexpr double kFormerShare = 0.65;
    return {.uav = colour,
            .plan = colour,
            .former = mixed(theme.sea, colour, kFormerShare),
            .track = mixed(theme.sea, colour, kTrackShare)};
}

RouteColours coloursOfOne(const Theme& theme)
{
    return {.uav = theme.uav, .plan = theme.plan, .former = theme.formerPlan, .track = theme.track};
}

} // namespace

RouteColours routeColours(const MapPicture& picture, const Theme& theme, std::size_t uav)
{
    return picture.isFleet() ? colourOnly(uavColour(theme, picture.uavs[uav].place), theme)
                             : coloursOfOne(theme);
}

QColor bracketColour(const MapPicture& picture, const Theme& theme)
{
    return picture.isFleet() ? theme.ink : theme.uav;
}

RouteColours legendColours(const MapPicture& picture, const Theme& theme)
{
    return picture.isFleet() ? colourOnly(theme.ink, theme) : coloursOfOne(theme);
}

} // namespace berg
