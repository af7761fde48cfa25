#include "widgets/charts/decimate.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace berg {
namespace {

/** Appends a point unless it equals the last one. */
void append(QList<QPointF>& out, const QPointF& p)
{
    if (out.isEmpty() || out.back() != p)
        out.push_back(p);
}

void append(QList<QPointF>& out, const Extremes& extremes)
{
    const bool rising = extremes.lowest.x() <= extremes.highest.x();
    append(out, rising ? extremes.lowest : extremes.highest);
    append(out, rising ? extremes.highest : extremes.lowest);
}

} // namespace

QList<QPointF> decimate(std::span<const QPointF> points, const DecimationWindow& window)
{
    require(window.to > window.from && window.columns > 0, "decimation window is empty");
    const double perColumn = (window.to - window.from) / window.columns;
    QList<QPointF> out;
    std::optional<QPointF> before;
    std::optional<QPointF> last;
    std::optional<Extremes> column;
    std::optional<int> columnIndex;
    for (const QPointF& p : points) {
        if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
            continue;
        if (p.x() < window.from) {
            before = p;
            continue;
        }
        if (p.x() > window.to) {
            if (column)
                append(out, *std::exchange(column, std::nullopt));
            if (last)
                append(out, *last);
            if (!last && before)
                append(out, *before);
            append(out, p);
            return out;
        }
        if (!last) {
            if (before)
                append(out, *before);
            append(out, p);
        }
        last = p;
        const int index =
            std::min(window.columns - 1, static_cast<int>((p.x() - window.from) / perColumn));
        if (index == columnIndex) {
            column->include(p);
            continue;
        }
        if (column)
            append(out, *column);
        column = Extremes{.lowest = p, .highest = p};
        columnIndex = index;
    }
    if (column)
        append(out, *column);
    if (last)
        append(out, *last);
    return out;
}

QList<QPointF> simplified(const QList<QPointF>& points, double tolerance)
{
    if (points.size() < 3)
        return points;
    // Range of slopes from the last kept point that pass all later points within the tolerance.
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    QList<QPointF> out{points.front()};
    double lowest = -kInfinity;
    double highest = kInfinity;
    for (qsizetype i = 1; i < points.size(); ++i) {
        QPointF step = points[i] - out.back();
        const bool reachable =
            step.x() > 0 && step.y() >= lowest * step.x() && step.y() <= highest * step.x();
        if (!reachable && points[i - 1] != out.back()) {
            out.push_back(points[i - 1]);
            step = points[i] - out.back();
            lowest = -kInfinity;
            highest = kInfinity;
        }
        if (step.x() > 0) {
            lowest = std::max(lowest, (step.y() - tolerance) / step.x());
            highest = std::min(highest, (step.y() + tolerance) / step.x());
        }
    }
    out.push_back(points.back());
    return out;
}

std::optional<QPointF> pointAt(const QList<QPointF>& points, double x)
{
    const auto next = std::lower_bound(points.begin(), points.end(), x,
                                       [](const QPointF& p, double time) { return p.x() < time; });
    if (next == points.end() || (next == points.begin() && next->x() > x))
        return std::nullopt;
    if (next == points.begin() || next->x() == x)
        return QPointF(x, next->y());
    const QPointF before = *(next - 1);
    const double part = (x - before.x()) / (next->x() - before.x());
    return QPointF(x, before.y() + part * (next->y() - before.y()));
}

} // namespace berg
