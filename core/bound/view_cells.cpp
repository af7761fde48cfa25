#include "core/bound/view_cells.h"

#include "core/base/angles.h"
#include "core/vehicle/dubins.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** This exceeds the share that rounding to `float` may add. */
constexpr double kRoundingShare = 1e-6;

} // namespace

bool ViewRegion::contains(const Point& p_m) const
{
    const Point off_m = p_m - centre_m;
    return disk ? off_m.squaredNorm() <= half_m.x() * half_m.x()
                : std::abs(off_m.x()) <= half_m.x() && std::abs(off_m.y()) <= half_m.y();
}

ViewCells::ViewCells(std::span<const ViewRegion> regions, int perRegion, const Travel& travel,
                     const std::stop_token& stop)
    : m_regions(static_cast<int>(regions.size())), m_perRegion(perRegion), m_travel(travel)
{
    for (const ViewRegion& region : regions)
        cut(region);
    for (const Cell& cell : m_cells) {
        std::uint32_t touching = 0;
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (meets(cell, regions[i]))
                touching |= std::uint32_t{1} << i;
        m_touching.push_back(touching);
    }
    m_legs_s.reserve(m_cells.size() * m_cells.size());
    for (const Cell& from : m_cells) {
        if (stop.stop_requested())
            return;
        for (const Cell& to : m_cells)
            m_legs_s.push_back(leg_s(from, to));
    }
}

void ViewCells::cut(const ViewRegion& region)
{
    if (region.disk) {
        const double halfAngle_rad = kPi / m_perRegion;
        for (int c = 0; c < m_perRegion; ++c) {
            const double angle_rad = 2 * halfAngle_rad * c;
            const Point outward(std::cos(angle_rad), std::sin(angle_rad));
            m_cells.push_back({.middle_m = region.centre_m + region.half_m.x() * outward,
                               .along = Point(-outward.y(), outward.x()),
                               .outward = outward,
                               .half_m = region.half_m.x() * std::sin(halfAngle_rad),
                               .sag_m = region.half_m.x() * (1 - std::cos(halfAngle_rad))});
        }
        return;
    }
    const int perSide = m_perRegion / 4;
    for (const Point& outward : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
        const Point along(-outward.y(), outward.x());
        const double halfSide_m = std::abs(along.dot(region.half_m));
        const Point side_m = region.centre_m + std::abs(outward.dot(region.half_m)) * outward;
        for (int c = 0; c < perSide; ++c)
            m_cells.push_back(
                {.middle_m = side_m + halfSide_m * ((2.0 * c + 1) / perSide - 1) * along,
                 .along = along,
                 .outward = outward,
                 .half_m = halfSide_m / perSide});
    }
}

bool ViewCells::meets(const Cell& cell, const ViewRegion& region)
{
    const Point toCentre_m = region.centre_m - cell.middle_m;
    const double s_m = std::clamp(cell.along.dot(toCentre_m), -cell.half_m, cell.half_m);
    if (region.disk) // `sag` covers the arc and 1 mm the rounding; a cell too many does no harm.
        return (toCentre_m - s_m * cell.along).norm() <= region.half_m.x() + cell.sag_m + 1e-3;
    const Point halves_m = cell.half_m * cell.along.cwiseAbs() + region.half_m;
    return std::abs(toCentre_m.x()) <= halves_m.x() + 1e-3 &&
           std::abs(toCentre_m.y()) <= halves_m.y() + 1e-3;
}

float ViewCells::leg_s(const Cell& from, const Cell& to) const
{
    const Point leg_m = to.middle_m - from.middle_m;
    const double middle_s = flightTime_s(leg_m, m_travel.airspeed_mps, m_travel.wind_mps);
    if (!(middle_s > 0))
        return 0;
    // The time of flight is convex in the displacement, so it is nowhere below its tangent plane;
    // the gradient is a / (U + a.W), a the unit vector flown along through the air.
    const Point air = (leg_m / middle_s - m_travel.wind_mps) / m_travel.airspeed_mps;
    const Point slope_spm = air / (m_travel.airspeed_mps + air.dot(m_travel.wind_mps));
    const double least_s = middle_s - from.half_m * std::abs(slope_spm.dot(from.along)) -
                           to.half_m * std::abs(slope_spm.dot(to.along)) -
                           from.sag_m * std::max(0.0, -slope_spm.dot(from.outward)) -
                           to.sag_m * std::max(0.0, slope_spm.dot(to.outward));
    return static_cast<float>(std::max(0.0, least_s) * (1 - kRoundingShare));
}

std::vector<float> ViewCells::legsFrom_s(const Point& start_m) const
{
    const Cell start{.middle_m = start_m};
    std::vector<float> legs_s;
    for (const Cell& cell : m_cells)
        legs_s.push_back(leg_s(start, cell));
    return legs_s;
}

} // namespace berg
