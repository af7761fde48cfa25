#include "widgets/charts/line_look.h"

#include "widgets/theme/palette.h"

namespace berg {
namespace {

constexpr double kStrong_px = 3.2;
constexpr double kThin_px = 1;
constexpr qsizetype kSmoothSegments = 2500; // painting more than that takes too long, too

double roleWidth_px(LineRole role)
{
    switch (role) {
    case LineRole::Accumulated:
        return 2.4;
    case LineRole::Momentary:
        return 1.8;
    case LineRole::Weighted:
    case LineRole::Signed:
    case LineRole::Sigma:
    case LineRole::Uav:
        return 1.5;
    case LineRole::Bound:
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

QColor lineColour(const TimeLine& line, const Theme& theme, double sigmaFull_m2)
{
    switch (line.role) {
    case LineRole::Accumulated:
        return theme.accumulated;
    case LineRole::Momentary:
    case LineRole::Weighted:
    case LineRole::Signed:
        return theme.momentary;
    case LineRole::Sigma:
        return theme.sigma.colour(line.points.empty() ? 0 : line.points.back().y(), sigmaFull_m2);
    case LineRole::Bound:
        return theme.mutedText;
    case LineRole::Uav:
        return uavColour(theme, line.uav);
    }
    return {};
}

QPen linePen(const TimeLine& line, const QBrush& ink, bool crowded, Qt::PenCapStyle cap)
{
    const bool isThin = crowded && line.emphasis != LineEmphasis::Strong &&
                        line.role != LineRole::Accumulated; // which is smooth anyway
    return {ink, isThin ? kThin_px : width_px(line),
            line.role == LineRole::Weighted ? Qt::DashLine : Qt::SolidLine, cap, Qt::RoundJoin};
}

bool isCrowded(qsizetype segments)
{
    return segments > kSmoothSegments;
}

} // namespace berg
