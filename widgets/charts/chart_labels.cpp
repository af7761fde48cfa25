#include "widgets/charts/chart_labels.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {
namespace {

constexpr double kGap_px = 6; // between a line and its label
constexpr int kPlaces = 60;   // tried along the line

/** Labels pushed together: they move as one block. */
struct Block
{
    double offsetSum = 0; ///< of the wanted middles, each less its offset within the block
    std::size_t first = 0;
    std::size_t count = 0;
    [[nodiscard]] double start(const LabelColumn& column) const
    {
        const double n = static_cast<double>(count);
        const double lowest = column.top + column.spacing / 2;
        const double highest = column.bottom - column.spacing * (n - 0.5);
        return std::clamp(offsetSum / n, lowest, std::max(lowest, highest));
    }
};

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

std::vector<double> spreadLabels(std::span<const double> wanted, const LabelColumn& column)
{
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    // Pool adjacent violators: a block that would touch the one before joins it.
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < order.size(); ++k) {
        blocks.push_back({.offsetSum = wanted[order[k]], .first = k, .count = 1});
        while (blocks.size() > 1) {
            const Block last = blocks.back();
            Block& before = blocks[blocks.size() - 2];
            const double n = static_cast<double>(before.count);
            if (before.start(column) + column.spacing * n <= last.start(column))
                break;
            before.offsetSum +=
                last.offsetSum - column.spacing * n * static_cast<double>(last.count);
            before.count += last.count;
            blocks.pop_back();
        }
    }
    std::vector<double> middles(wanted.size());
    for (const Block& block : blocks)
        for (std::size_t k = 0; k < block.count; ++k)
            middles[order[block.first + k]] =
                block.start(column) + column.spacing * static_cast<double>(k);
    return middles;
}

std::vector<std::optional<double>> nameableLabels(std::span<const double> wanted,
                                                  const LabelColumn& column, double farthest)
{
    const auto room = static_cast<std::size_t>((column.bottom - column.top) / column.spacing);
    std::vector<std::size_t> taken;
    std::vector<double> takenWanted;
    std::vector<double> middles;
    for (std::size_t i = 0; i < wanted.size() && taken.size() < room; ++i) {
        takenWanted.push_back(wanted[i]);
        std::vector<double> spread = spreadLabels(takenWanted, column);
        const bool near = std::equal(
            spread.begin(), spread.end(), takenWanted.begin(),
            [farthest](double at, double want) { return std::abs(at - want) <= farthest; });
        if (!near) {
            takenWanted.pop_back();
            continue;
        }
        middles = std::move(spread);
        taken.push_back(i);
    }
    std::vector<std::optional<double>> result(wanted.size());
    for (std::size_t k = 0; k < taken.size(); ++k)
        result[taken[k]] = middles[k];
    return result;
}

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
