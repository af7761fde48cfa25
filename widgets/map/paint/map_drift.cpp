#include "widgets/map/paint/map_drift.h"

#include <algorithm>
#include <array>

namespace berg {
namespace {

constexpr double kLongestArrow_px = 44;
constexpr std::array<double, 11> kDriftTimes_s = {60,   120,  300,   600,   1200, 1800,
                                                  3600, 7200, 21600, 43200, 86400};

} // namespace

double driftTimeFor_s(double speed_mps, double scale_pxpm)
{
    double suitable_s = 0;
    for (const double time_s : kDriftTimes_s)
        if (speed_mps * time_s * scale_pxpm <= kLongestArrow_px)
            suitable_s = time_s;
    return suitable_s;
}

QLineF driftArrow(const MapPicture& picture, const MapLayout& layout, std::size_t iceberg)
{
    if (layout.density.isDense)
        return {};
    const Point path_m = picture.icebergs[iceberg].velocity_mps * layout.symbols.driftTime_s;
    const Point path_px = path_m * layout.view.scale_pxpm();
    const double length_px = path_px.norm();
    if (length_px < 1.5)
        return {};
    const QPointF along(path_px.x() / length_px, -path_px.y() / length_px);
    const LabelDisk& disk = layout.icebergs[iceberg];
    const QPointF start = disk.centre_px + along * disk.radius_px;
    return {start, start + along * std::min(length_px, kCappedArrow_px)};
}

bool isCapped(const QLineF& arrow)
{
    constexpr double kRounding_px = 1e-6;
    return arrow.length() > kCappedArrow_px - kRounding_px;
}

} // namespace berg
