#include "widgets/charts/chart_labels.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kGap_px = 6; // between a line and its label
constexpr int kPlaces = 60;   // tried along the line

/** Part of the polyline between two abscissas: lowest and highest ordinate. */
std::optional<std::pair<double, double>> ordinates(const QPolygonF& line, double from, double to)
{
    std::optional<std::pair<double, double>> range;
    const auto include = [&](double y) {
        if (!range)
            range = {y, y};
        range->first = std::min(range->first, y);
        range->second = std::max(range->second, y);
    };
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QPointF& a = line[i];
        const QPointF& b = line[i + 1];
        if (b.x() < from || a.x() > to)
            continue;
        const auto at = [&](double x) {
            return b.x() > a.x() ? a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()) : b.y();
        };
        include(at(std::max(from, a.x())));
        include(at(std::min(to, b.x())));
        if (b.x() <= to)
            include(b.y());
    }
    return range;
}

} // namespace

std::optional<QRectF> labelBesideLine(const QPolygonF& own, std::span<const QPolygonF> lines,
                                      std::span<const QRectF> taken, const QSizeF& size,
                                      const QRectF& plot)
{
    if (own.isEmpty() || size.width() > plot.width())
        return std::nullopt;
    const double last = std::min(own.back().x(), plot.right()) - size.width() - 2;
    const auto isFree = [&](const QRectF& rect) {
        const QRectF wide = rect.adjusted(-3, -3, 3, 3);
        if (!plot.contains(rect) || std::any_of(taken.begin(), taken.end(), [&](const QRectF& r) {
                return r.intersects(wide);
            }))
            return false;
        return std::none_of(lines.begin(), lines.end(), [&](const QPolygonF& line) {
            const auto range = ordinates(line, wide.left(), wide.right());
            return range && range->second > wide.top() && range->first < wide.bottom();
        });
    };
    for (int k = 0; k < kPlaces; ++k) {
        const double left = last - (last - plot.left()) * k / kPlaces;
        const auto range = ordinates(own, left, left + size.width());
        if (!range)
            continue;
        const QRectF above(QPointF(left, range->first - kGap_px - size.height()), size);
        const QRectF below(QPointF(left, range->second + kGap_px), size);
        for (const QRectF& rect : {above, below})
            if (isFree(rect))
                return rect;
    }
    return std::nullopt;
}

} // namespace berg
