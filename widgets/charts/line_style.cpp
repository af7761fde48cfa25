#include "widgets/charts/line_style.h"

namespace berg {
namespace {

constexpr double kStrong_px = 3.2;
constexpr double kThin_px = 1;
constexpr qsizetype kSmoothSegments = 2500; // painting more also takes too long

double roleWidth_px(LineRole role)
{
    switch (role) {
    case LineRole::Accumulated:
        return 2.4;
    case LineRole::Momentary:
    case LineRole::Wind:
        return 1.8;
    case LineRole::Weighted:
    case LineRole::Signed:
    case LineRole::Sigma:
    case LineRole::Uav:
    case LineRole::Current:
        return 1.5;
    case LineRole::Bound:
    case LineRole::Gust:
        return 1.2;
    }
    return kThin_px;
}

double width_px(const TimeLine& line)
{
    switch (line.emphasis) {
    case LineEmphasis::None:
        return roleWidth_px(line.role);
    case LineEmphasis::Strong:
        return kStrong_px;
    case LineEmphasis::Faint:
        return kThin_px;
    }
    return kThin_px;
}

} // namespace

Ink sigmaInk(double sigma_m2, double full_m2)
{
    return {.of = InkOf::Sigma, .value = full_m2 > 0 ? sigma_m2 / full_m2 : 0};
}

Ink lineInk(const TimeLine& line, double sigmaFull_m2)
{
    switch (line.role) {
    case LineRole::Accumulated:
    case LineRole::Wind:
    case LineRole::Gust:
        return {.of = InkOf::Accumulated};
    case LineRole::Momentary:
    case LineRole::Weighted:
    case LineRole::Signed:
        return {.of = InkOf::Momentary};
    case LineRole::Current:
        return {.of = InkOf::Plan};
    case LineRole::Sigma:
        return sigmaInk(line.points.empty() ? 0 : line.points.back().y(), sigmaFull_m2);
    case LineRole::Bound:
        return {.of = InkOf::Muted};
    case LineRole::Uav:
        return {.of = InkOf::Uav, .value = static_cast<double>(line.uav)};
    }
    return {};
}

double lineWidth_px(const TimeLine& line, bool crowded)
{
    const bool isThin = crowded && line.emphasis != LineEmphasis::Strong &&
                        line.role != LineRole::Accumulated; // this line is smooth and readable
    return isThin ? kThin_px : width_px(line);
}

bool isDashed(LineRole role)
{
    return role == LineRole::Weighted || role == LineRole::Gust;
}

bool isCrowded(qsizetype segments)
{
    return segments > kSmoothSegments;
}

} // namespace berg
