#include "core/io/figure/wind_barb.h"

#include "core/base/knots.h"

#include <cmath>

namespace berg {

namespace {

constexpr int kFinestBarb_kn = 5;
constexpr int kBarb_kn = 10;
constexpr int kPennant_kn = 50;
constexpr double kBarbLength = 0.42; // of the shaft, across it
constexpr double kBarbLean = 0.16;   // of the shaft, towards where the wind comes from
constexpr double kBarbGap = 0.17;    // of the shaft
constexpr double kCalm = 0.18;       // of the shaft

/** Places along and across the shaft of a barb, as shares of its length. */
class BarbAxes
{
public:
    BarbAxes(const Point& wind_mps, double shaft_px, bool isSouthern)
        : m_shaft_px(shaft_px), m_from(-wind_mps.normalized())
    {
        m_from.y() = -m_from.y(); // pixels go down
        const double side = isSouthern ? -1 : 1;
        m_across = side * Point(-m_from.y(), m_from.x());
    }

    [[nodiscard]] Pixel at(double along, double across) const
    {
        const Point place = m_shaft_px * (along * m_from + across * m_across);
        return {place.x(), place.y()};
    }

private:
    double m_shaft_px;
    Point m_from;   ///< towards where the wind comes from
    Point m_across; ///< to the side of the barbs
};

} // namespace

int barbSpeed_kn(const Point& wind_mps)
{
    return kFinestBarb_kn *
           static_cast<int>(std::lround(wind_mps.norm() / kKnot_mps / kFinestBarb_kn));
}

WindBarb windBarb(const Point& wind_mps, double shaft_px, bool isSouthern)
{
    WindBarb barb;
    int left_kn = barbSpeed_kn(wind_mps);
    if (left_kn == 0) {
        barb.calm_px = kCalm * shaft_px;
        return barb;
    }
    const BarbAxes axes(wind_mps, shaft_px, isSouthern);
    // A hurricane's barbs lengthen the shaft in place of running past the station.
    const int places = left_kn / kPennant_kn * 2 + left_kn % kPennant_kn / kBarb_kn + 1;
    const double tip = std::max(1.0, (places - 1) * kBarbGap + 0.3);
    barb.lines.push_back({axes.at(0, 0), axes.at(tip, 0)});
    double along = tip;
    for (; left_kn >= kPennant_kn; left_kn -= kPennant_kn) {
        barb.pennants.push_back(
            {axes.at(along, 0), axes.at(along, kBarbLength), axes.at(along - 1.3 * kBarbGap, 0)});
        along -= 2 * kBarbGap;
    }
    for (; left_kn >= kBarb_kn; left_kn -= kBarb_kn) {
        barb.lines.push_back({axes.at(along, 0), axes.at(along + kBarbLean, kBarbLength)});
        along -= kBarbGap;
    }
    if (left_kn == 0)
        return barb;
    if (along == tip) // alone it would look like a corner of the shaft
        along -= kBarbGap;
    barb.lines.push_back({axes.at(along, 0), axes.at(along + kBarbLean / 2, kBarbLength / 2)});
    return barb;
}

std::vector<std::vector<Pixel>> velocityArrow(const Point& velocity_mps, double length_px)
{
    constexpr double kHead = 0.36; // of the length, at most
    constexpr double kMostHead_px = 6;
    const Point along = velocity_mps.normalized();
    const Point across(-along.y(), along.x());
    const double head_px = std::min(kMostHead_px, kHead * length_px);
    const auto at = [&](double alongPlace_px, double acrossPlace_px) {
        const Point place = alongPlace_px * along + acrossPlace_px * across;
        return Pixel{place.x(), -place.y()};
    };
    const double tip_px = length_px / 2;
    return {
        {at(-tip_px, 0), at(tip_px, 0)},
        {at(tip_px - head_px, 0.6 * head_px), at(tip_px, 0), at(tip_px - head_px, -0.6 * head_px)}};
}

} // namespace berg
