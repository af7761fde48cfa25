#include "widgets/map/picture/swept_mask.h"

#include "core/base/angles.h"
#include "widgets/map/picture/footprint.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace berg {
namespace {

constexpr double kSlack_px = 0.3;        // tolerance of edges
constexpr double kLargestTurn_rad = 0.5; // of the footprint within one piece
constexpr int kMostPieces = 400;         // limit of pieces between two poses

/** A pose in pixels of the image: y down, angles clockwise on the screen. */
struct PixelPose
{
    Point at = Point::Zero();
    double heading_rad = 0;
};

/** Shorter turn from one angle to another, both in [-pi, pi]. */
double turnBetween(double from_rad, double to_rad)
{
    const double turn_rad = to_rad - from_rad;
    return turn_rad > kPi ? turn_rad - 2 * kPi : turn_rad < -kPi ? turn_rad + 2 * kPi : turn_rad;
}

/** Number of corners for which a disk's polygon stays within the tolerance. */
int diskCornersFor(double radius_px)
{
    constexpr int kFewest = 8;
    constexpr int kMost = 180;
    const double share = std::min(1.0, kSlack_px / std::max(kSlack_px, radius_px));
    return std::clamp(static_cast<int>(std::ceil(kPi / std::acos(1 - share))), kFewest, kMost);
}

/** Directions of straight lines from the origin that stay near all points passed so far. */
struct Cone
{
    std::optional<Point> right; ///< nullopt means any direction
    Point left = Point::Zero();
    double reach_px = 0; ///< distance of the farthest point

    /** Narrows the cone to lines near `point_px` as well; returns false if there are none. */
    bool admit(const Point& point_px)
    {
        const double length_px = point_px.norm();
        if (length_px <= kSlack_px)
            return true;
        if (length_px < reach_px - kSlack_px) // the path turns back
            return false;
        if (right && (cross(*right, point_px) < 0 || cross(point_px, left) < 0))
            return false;
        const Point aside = Point(-point_px.y(), point_px.x()) * (kSlack_px / length_px);
        const bool isFirst = !right;
        if (isFirst || cross(*right, point_px - aside) > 0)
            right = point_px - aside;
        if (isFirst || cross(point_px + aside, left) > 0)
            left = point_px + aside;
        reach_px = std::max(reach_px, length_px);
        return true;
    }
};

} // namespace

/** Paints the footprint along a path, merged into pieces as long as the tolerance allows. */
class SweptMask::Brush
{
public:
    Brush(QImage& image, std::vector<PaintedRun>& rows, const SweptStyle& style,
          const SensorSpec& sensor)
        : m_rows(rows)
        , m_pixels(reinterpret_cast<QRgb*>(image.bits()))
        , m_stride(image.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb)))
        , m_width(image.width())
        , m_height(image.height())
        , m_sensor(sensor)
        , m_scale_pxpm(style.view.scale_pxpm() * style.ratio)
        , m_origin_px(
              pointOf((style.view.toPixel(Point::Zero()) - style.rect.topLeft()) * style.ratio))
        , m_tint(qPremultiply(style.tint.rgba()))
        , m_left(rows.size(), kNowhere)
        , m_right(rows.size(), -kNowhere)
    {
        m_corners_px =
            footprintCorners(sensor, diskCornersFor(sensor.fov_m.x() / 2 * m_scale_pxpm));
        for (Point& corner : m_corners_px) {
            corner = Point(corner.x(), -corner.y()) * m_scale_pxpm;
            m_reach_px = std::max(m_reach_px, corner.norm());
        }
        // The edge between two rotated footprints is straight: it misses the arc by r turn^2 / 8.
        m_largestTurn_rad =
            std::min(kLargestTurn_rad, std::sqrt(8 * kSlack_px / std::max(1.0, m_reach_px)));
    }

    /** Paints poses within the budget; returns their number, at least two if there are two. */
    std::size_t paint(std::span<const MapPose> poses, double budget_ms)
    {
        constexpr std::size_t kPosesPerClockCheck = 64;
        QElapsedTimer clock;
        clock.start();
        start(pixelPose(poses.front()));
        std::size_t count = 1;
        while (count < poses.size()) {
            flyTo(pixelPose(poses[count]));
            ++count;
            if (count % kPosesPerClockCheck == 0 &&
                static_cast<double>(clock.nsecsElapsed()) > budget_ms * 1e6)
                break;
        }
        finish();
        return count;
    }

private:
    static constexpr double kNowhere = std::numeric_limits<double>::infinity();

    static Point pointOf(const QPointF& p) { return {p.x(), p.y()}; }

    [[nodiscard]] PixelPose pixelPose(const MapPose& pose) const
    {
        return {.at = m_origin_px + Point(pose.position_m.x(), -pose.position_m.y()) * m_scale_pxpm,
                .heading_rad = -pose.psi_rad};
    }
    [[nodiscard]] double turnOf(const PixelPose& pose) const
    {
        return -footprintTurn_rad(m_sensor, -pose.heading_rad);
    }

    void start(const PixelPose& pose)
    {
        m_from = m_end = pose;
        m_startTurn_rad = turnOf(pose);
        m_cone = {};
        m_least_rad = m_most_rad = 0;
    }
    void finish() { sweep(m_from, m_end); }

    /** Continues along an arc to `next` in pieces that are nearly straight. */
    void flyTo(const PixelPose& next)
    {
        const PixelPose from = m_end;
        const double bend_rad = turnBetween(from.heading_rad, next.heading_rad);
        const Point path = next.at - from.at;
        const Point sagitta =
            Point(path.y(), -path.x()) * (bend_rad / 8); // approximate sagitta of the arc
        if (isOutOfSight(from.at, next.at, m_reach_px + sagitta.norm())) {
            finish();
            start(next);
            return;
        }
        const bool turns = m_sensor.shape == FovShape::Body;
        const double wanted = std::max(turns ? std::abs(bend_rad) / m_largestTurn_rad : 0.0,
                                       std::sqrt(sagitta.norm() / kSlack_px));
        const int pieces = std::clamp(static_cast<int>(std::ceil(wanted)), 1, kMostPieces);
        for (int k = 1; k < pieces; ++k) {
            const double share = static_cast<double>(k) / pieces;
            join({.at = from.at + path * share + sagitta * (4 * share * (1 - share)),
                  .heading_rad = wrapPi(from.heading_rad + bend_rad * share)});
        }
        join(next);
    }

    [[nodiscard]] bool isOutOfSight(const Point& a, const Point& b, double margin_px) const
    {
        return std::max(a.x(), b.x()) < -margin_px ||
               std::min(a.x(), b.x()) > m_width + margin_px ||
               std::max(a.y(), b.y()) < -margin_px || std::min(a.y(), b.y()) > m_height + margin_px;
    }

    void join(const PixelPose& next)
    {
        if (!lengthen(next)) {
            finish();
            start(m_end);
            lengthen(next);
        }
        m_end = next;
    }

    /** Extends the current piece to `next` if it stays straight and turns in one direction. */
    bool lengthen(const PixelPose& next)
    {
        const double turn_rad = turnBetween(m_startTurn_rad, turnOf(next));
        const double least_rad = std::min(m_least_rad, turn_rad);
        const double most_rad = std::max(m_most_rad, turn_rad);
        const double range_rad = most_rad - least_rad;
        if (range_rad > m_largestTurn_rad * 1.001 ||
            (range_rad - std::abs(turn_rad)) * m_reach_px > kSlack_px)
            return false;
        if (!m_cone.admit(next.at - m_from.at))
            return false;
        m_least_rad = least_rad;
        m_most_rad = most_rad;
        return true;
    }

    /** Paints both footprints and the area between them. */
    void sweep(const PixelPose& from, const PixelPose& to)
    {
        placeCorners(from, m_fromCorners);
        placeCorners(to, m_toCorners);
        m_top = m_height;
        m_bottom = -1;
        const std::size_t count = m_corners_px.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = i + 1 == count ? 0 : i + 1;
            widen(m_fromCorners[i], m_fromCorners[next]);
            widen(m_toCorners[i], m_toCorners[next]);
            widen(m_fromCorners[i], m_toCorners[i]);
        }
        for (int y = m_top; y <= m_bottom; ++y)
            fillRow(static_cast<std::size_t>(y));
    }

    void placeCorners(const PixelPose& pose, std::vector<Point>& corners) const
    {
        const double turn_rad = turnOf(pose);
        const Point along(std::cos(turn_rad), std::sin(turn_rad));
        corners.clear();
        for (const Point& corner : m_corners_px)
            corners.emplace_back(pose.at.x() + along.x() * corner.x() - along.y() * corner.y(),
                                 pose.at.y() + along.y() * corner.x() + along.x() * corner.y());
    }

    /** Extends the rows that the line crosses to reach it. */
    void widen(Point upper, Point lower)
    {
        if (upper.y() > lower.y())
            std::swap(upper, lower);
        if (lower.y() < 0.5 || upper.y() > m_height - 0.5)
            return;
        const int first = static_cast<int>(std::ceil(std::max(upper.y() - 0.5, 0.0)));
        const int last = static_cast<int>(std::floor(std::min(lower.y() - 0.5, m_height - 1.0)));
        if (first > last)
            return;
        const double slope = (lower.x() - upper.x()) / (lower.y() - upper.y());
        for (int y = first; y <= last; ++y) {
            const auto row = static_cast<std::size_t>(y);
            const double x = upper.x() + (y + 0.5 - upper.y()) * slope;
            m_left[row] = std::min(m_left[row], x);
            m_right[row] = std::max(m_right[row], x);
        }
        m_top = std::min(m_top, first);
        m_bottom = std::max(m_bottom, last);
    }

    /** Paints the pixels of a row with their centres inside, except those known to be painted. */
    void fillRow(std::size_t row)
    {
        const double left = std::exchange(m_left[row], kNowhere);
        const double right = std::exchange(m_right[row], -kNowhere);
        if (right < 0.5 || left > m_width - 0.5)
            return;
        const int first = static_cast<int>(std::ceil(std::max(left - 0.5, 0.0)));
        const int last = static_cast<int>(std::floor(std::min(right - 0.5, m_width - 1.0)));
        if (first > last)
            return;
        PaintedRun& painted = m_rows[row];
        if (last < painted.first - 1 || first > painted.last + 1) {
            fill(row, first, last);
            if (last - first > painted.last - painted.first)
                painted = {.first = first, .last = last};
            return;
        }
        fill(row, first, painted.first - 1);
        fill(row, painted.last + 1, last);
        painted = {.first = std::min(first, painted.first), .last = std::max(last, painted.last)};
    }

    void fill(std::size_t row, int first, int last)
    {
        if (first <= last)
            std::fill_n(m_pixels + static_cast<qsizetype>(row) * m_stride + first, last - first + 1,
                        m_tint);
    }

    std::vector<PaintedRun>& m_rows;
    QRgb* m_pixels;
    qsizetype m_stride;
    int m_width;
    int m_height;
    const SensorSpec& m_sensor;
    double m_scale_pxpm;
    Point m_origin_px;
    QRgb m_tint;
    std::vector<Point> m_corners_px; ///< of the footprint before rotation
    double m_reach_px = 0;           ///< distance of the farthest corner from the centre
    double m_largestTurn_rad = kLargestTurn_rad;

    PixelPose m_from; ///< start of the current piece
    PixelPose m_end;
    Cone m_cone;
    double m_startTurn_rad = 0;
    double m_least_rad = 0; ///< turn within it, relative to its start
    double m_most_rad = 0;

    std::vector<Point> m_fromCorners;
    std::vector<Point> m_toCorners;
    std::vector<double> m_left; ///< extent of the current footprint, by row
    std::vector<double> m_right;
    int m_top = 0;
    int m_bottom = -1;
};

const QImage& SweptMask::updated(const std::vector<SweptTrail>& trails, const SweptStyle& style)
{
    advance(trails, style, std::numeric_limits<double>::infinity());
    return m_image;
}

bool SweptMask::advance(const std::vector<SweptTrail>& trails, const SweptStyle& style,
                        double budget_ms)
{
    if (!(style == m_style) || !isOf(trails))
        restart(trails, style);
    QElapsedTimer clock;
    clock.start();
    bool isAll = true;
    for (std::size_t k = 0; k < trails.size() && isAll; ++k)
        isAll = advance(trails[k], m_progress[k],
                        budget_ms - static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    return isAll;
}

bool SweptMask::advance(const SweptTrail& trail, Progress& progress, double budget_ms)
{
    const std::span<const MapPose> poses = trail.poses;
    if (poses.empty())
        return true;
    const std::size_t known = progress.count > 0 ? progress.count - 1 : 0;
    const std::size_t painted =
        known +
        Brush(m_image, m_rows, m_style, trail.sensor).paint(poses.subspan(known), budget_ms);
    progress.until_s = poses[painted - 1].time_s;
    // The last pose may be an instant between two samples, which later lists do not contain.
    const bool isAll = painted == poses.size();
    progress.count = isAll ? painted - 1 : painted;
    if (progress.count > 0)
        progress.anchor = poses[progress.count - 1];
    return isAll;
}

void SweptMask::restart(const std::vector<SweptTrail>& trails, const SweptStyle& style)
{
    m_style = style;
    m_progress.clear();
    for (const SweptTrail& trail : trails)
        m_progress.push_back({.sensor = trail.sensor, .anchor = {}});
    const QSizeF size = style.rect.size() * style.ratio;
    const QSize size_px(std::max(1, static_cast<int>(std::ceil(size.width()))),
                        std::max(1, static_cast<int>(std::ceil(size.height()))));
    if (m_image.size() != size_px)
        m_image = QImage(size_px, QImage::Format_ARGB32_Premultiplied);
    m_image.setDevicePixelRatio(style.ratio);
    m_image.fill(Qt::transparent);
    m_rows.assign(static_cast<std::size_t>(size_px.height()), {});
}

bool SweptMask::isOf(const std::vector<SweptTrail>& trails) const
{
    const auto isBegun = [](const Progress& progress) { return progress.count > 0; };
    return std::any_of(m_progress.begin(), m_progress.end(), isBegun) &&
           std::equal(m_progress.begin(), m_progress.end(), trails.begin(), trails.end(),
                      [](const Progress& progress, const SweptTrail& trail) {
                          return progress.isOf(trail);
                      });
}

bool SweptMask::Progress::isOf(const SweptTrail& trail) const
{
    if (!(sensor == trail.sensor))
        return false;
    return count == 0 || (trail.poses.size() >= count && trail.poses[count - 1] == anchor &&
                          trail.poses.back().time_s >= until_s);
}

} // namespace berg
