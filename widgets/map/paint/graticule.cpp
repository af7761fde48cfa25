#include "widgets/map/paint/graticule.h"

#include "core/base/angles.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/theme/quantity_text.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace berg {
namespace {

constexpr double kMetresPerDegree =
    111'200;                        // per degree of latitude, precise enough to choose a step
constexpr int kSamples = 12;        // per side of the view
constexpr double kSagitta_px = 0.2; // largest deviation of a line's pieces from its curve
constexpr double kClosest_px = 60;  // smallest distance of meridians that continue poleward
constexpr double kPoleMargin = 0.2; // share of the view: a pole this near counts as visible
constexpr double kToPole_deg = 90;  // meridians at its multiples reach the pole

// Distances of labels to the edge of the map and to each other.
constexpr double kEdge_px = 6;
constexpr double kLeastSlant =
    0.5; // smallest sine of the angle between an edge and a line labelled there
constexpr QMarginsF kApart_px(4, 2, 4, 2);

// Steps in minutes of arc that read well: decimals of minutes, whole minutes, whole degrees.
constexpr std::array<double, 21> kSteps_min = {0.01, 0.02, 0.05, 0.1, 0.2,  0.5,  1,
                                               2,    5,    10,   15,  20,   30,   60,
                                               120,  300,  600,  900, 1200, 1800, 2700};

// Steps for decimal degrees, from 0.0002 degrees on.
constexpr std::array<double, 19> kDecimalSteps_min = {
    0.012, 0.03, 0.06, 0.12, 0.3, 0.6, 1.2, 3, 6, 12, 30, 60, 120, 300, 600, 900, 1200, 1800, 2700};

double stepFor(double wanted_min)
{
    const auto among = [&](const auto& steps) {
        const auto it = std::lower_bound(steps.begin(), steps.end(), wanted_min);
        return it == steps.end() ? steps.back() : *it;
    };
    return shownUnits().coordinates == CoordinateForm::DecimalDegrees ? among(kDecimalSteps_min)
                                                                      : among(kSteps_min);
}

/** Returns the precision for `latitudeText` that keeps multiples of the step distinct. */
std::optional<int> decimalsOf(double step_min)
{
    if (step_min >= 60)
        return std::nullopt;
    switch (shownUnits().coordinates) {
    case CoordinateForm::DecimalDegrees:
        return step_min >= 0.6 ? 0 : step_min >= 0.06 ? 1 : 2;
    case CoordinateForm::DegreesMinutesSeconds:
        return step_min >= 1 ? 0 : step_min >= 0.1 ? 1 : 3;
    case CoordinateForm::DegreesMinutes:
        break;
    }
    return step_min >= 1 ? 0 : step_min >= 0.1 ? 1 : 2;
}

struct GeoBounds
{
    double south_deg = 90;
    double north_deg = -90;
    double west_deg = 0; ///< relative to the reference meridian
    double east_deg = 0;
    double reference_deg = 0;
};

/** Latitudes and longitudes in view; all longitudes if a pole is in view. */
GeoBounds geoBoundsOf(const LocalFrame& frame, const MapViewTransform& view, const QRectF& rect)
{
    GeoBounds bounds;
    bounds.reference_deg = frame.toGeographic(view.toWorld(rect.center())).longitude_deg;
    const double reach_m = mapReach_m(frame);
    for (int i = 0; i <= kSamples; ++i) {
        for (int j = 0; j <= kSamples; ++j) {
            if (i % kSamples != 0 && j % kSamples != 0 && (i != j || 2 * i != kSamples))
                continue; // extremes lie on the edge or in the middle
            const QPointF p_px(rect.left() + rect.width() * i / kSamples,
                               rect.top() + rect.height() * j / kSamples);
            Point p_m = view.toWorld(p_px);
            p_m *= std::min(1.0, reach_m / std::max(1.0, p_m.norm()));
            const LatLon place = frame.toGeographic(p_m);
            const double east_deg =
                std::remainder(place.longitude_deg - bounds.reference_deg, 360.0);
            bounds.south_deg = std::min(bounds.south_deg, place.latitude_deg);
            bounds.north_deg = std::max(bounds.north_deg, place.latitude_deg);
            bounds.west_deg = std::min(bounds.west_deg, east_deg);
            bounds.east_deg = std::max(bounds.east_deg, east_deg);
        }
    }
    const double margin_px = kPoleMargin * std::max(rect.width(), rect.height());
    const QRectF nearby = rect.adjusted(-margin_px, -margin_px, margin_px, margin_px);
    for (const double pole_deg : {90.0, -90.0}) {
        if (!nearby.contains(view.toPixel(frame.toPlane({pole_deg, 0}))))
            continue;
        bounds.west_deg = -180;
        bounds.east_deg = 180;
        (pole_deg > 0 ? bounds.north_deg : bounds.south_deg) = pole_deg;
    }
    return bounds;
}

/** Latitude of the parallel nearest to the equator. */
double widestLatitude_deg(const GeoBounds& bounds)
{
    if (bounds.south_deg <= 0 && bounds.north_deg >= 0)
        return 0;
    return std::min(std::abs(bounds.south_deg), std::abs(bounds.north_deg));
}

struct DegreeRange
{
    double from_deg = 0;
    double to_deg = 0;
};

/** Approximate length of a line and its smallest radius of curvature. */
struct LineForm
{
    double length_px = 0;
    double radius_px = 1;
};

/** Samples a line finely enough to look smooth. */
QPolygonF sampled(const LocalFrame& frame, const MapViewTransform& view, const DegreeRange& span,
                  const LineForm& form, const auto& placeAt)
{
    const double piece_px = std::sqrt(8 * kSagitta_px * form.radius_px);
    const int pieces = static_cast<int>(std::clamp(form.length_px / piece_px, 4.0, 150.0));
    QPolygonF path;
    for (int i = 0; i <= pieces; ++i) {
        const double at_deg = span.from_deg + (span.to_deg - span.from_deg) * i / pieces;
        path << view.toPixel(frame.toPlane(placeAt(at_deg)));
    }
    return path;
}

std::vector<double> multiples(double step_deg, const DegreeRange& span)
{
    std::vector<double> values_deg;
    for (double k = std::ceil(span.from_deg / step_deg); k * step_deg <= span.to_deg; ++k)
        values_deg.push_back(k * step_deg);
    return values_deg;
}

/** Largest step, degrees, of which `longitude_deg` is a multiple. */
double rank_deg(double longitude_deg)
{
    const auto unit = [](double minutes) { return std::llround(minutes / kSteps_min.front()); };
    const long long value = unit(longitude_deg * 60);
    if (value % unit(kToPole_deg * 60) == 0)
        return kToPole_deg;
    double largest_min = kSteps_min.front();
    for (const double step_min : kSteps_min)
        if (value % unit(step_min) == 0)
            largest_min = step_min;
    return largest_min / 60;
}

/**
 * Latitude at which a meridian ends, a parallel or the pole, so that meridians of the same rank
 * keep their distance.
 */
double polewardLimit_deg(double longitude_deg, double scale_pxpm, double latitudeStep_deg)
{
    const double step_deg = rank_deg(longitude_deg);
    if (step_deg >= kToPole_deg)
        return 90;
    const double shrink = kClosest_px / (step_deg * kMetresPerDegree * scale_pxpm);
    const double limit_deg = shrink < 1 ? degFromRad(std::acos(shrink)) : 0;
    return std::floor(limit_deg / latitudeStep_deg) * latitudeStep_deg;
}

/** Intersection of a path with an edge of the map; nullopt if it meets the edge at a flat angle. */
std::optional<QPointF> crossing(const QPolygonF& path, const QLineF& edge)
{
    for (qsizetype i = 0; i + 1 < path.size(); ++i) {
        const QLineF piece(path[i], path[i + 1]);
        QPointF at;
        if (piece.intersects(edge, &at) == QLineF::BoundedIntersection &&
            std::abs(std::sin(radFromDeg(piece.angleTo(edge)))) > kLeastSlant)
            return at;
    }
    return std::nullopt;
}

/** Candidate label places of a line, best first. */
std::vector<QRectF> labelPlaces(const Graticule& graticule, const GraticuleLine& line,
                                const QRectF& rect, const QSizeF& size)
{
    const QSizeF half = size / 2;
    const QRectF middles = rect.adjusted(kEdge_px + half.width(), kEdge_px + half.height(),
                                         -kEdge_px - half.width(), -kEdge_px - half.height());
    const QLineF top(middles.topLeft(), middles.topRight());
    const QLineF right(middles.topRight(), middles.bottomRight());
    const QLineF bottom(middles.bottomLeft(), middles.bottomRight());
    const QLineF left(middles.topLeft(), middles.bottomLeft());
    const std::array<QLineF, 4> edges = line.isMeridian ? std::array{top, bottom, right, left}
                                                        : std::array{right, left, top, bottom};
    std::vector<QRectF> places;
    const auto offer = [&](const QPointF& middle) {
        if (QLineF(middle, graticule.middle_px).length() < graticule.reach_px)
            places.emplace_back(middle - QPointF(half.width(), half.height()), size);
    };
    for (const QLineF& edge : edges)
        if (const std::optional<QPointF> at = crossing(line.path_px, edge))
            offer(*at);
    const qsizetype middle = line.path_px.size() / 2;
    if (places.empty() && middles.contains(line.path_px[middle]))
        offer(line.path_px[middle]); // a circle that is entirely in view
    return places;
}

} // namespace

Graticule graticuleOf(const LocalFrame& frame, const MapViewTransform& view, const QRectF& rect,
                      double spacing_px)
{
    const GeoBounds bounds = geoBoundsOf(frame, view, rect);
    const double scale_pxpm = view.scale_pxpm();
    const double pxPerDegree = scale_pxpm * kMetresPerDegree;
    const double earthRadius_px = scale_pxpm * kEarthRadius_m;
    const double wanted_min = spacing_px / pxPerDegree * 60;
    const double shrink = std::max(1e-6, std::cos(radFromDeg(widestLatitude_deg(bounds))));
    const double latitudeStep_min = stepFor(wanted_min);
    const double longitudeStep_min = stepFor(wanted_min / shrink);

    Graticule graticule;
    graticule.middle_px = view.toPixel(Point::Zero());
    graticule.reach_px = mapReach_m(frame) * scale_pxpm;
    graticule.latitudeDecimals = decimalsOf(latitudeStep_min);
    graticule.longitudeDecimals = decimalsOf(longitudeStep_min);

    const DegreeRange latitudes{bounds.south_deg, bounds.north_deg};
    const DegreeRange longitudes{bounds.reference_deg + bounds.west_deg,
                                 bounds.reference_deg + bounds.east_deg};
    const bool fullCircle = bounds.east_deg - bounds.west_deg >= 360;
    for (const double lon_deg : multiples(longitudeStep_min / 60, longitudes)) {
        if (fullCircle && lon_deg >= longitudes.from_deg + 360)
            break; // repeats the first meridian
        const double limit_deg = polewardLimit_deg(lon_deg, scale_pxpm, latitudeStep_min / 60);
        const DegreeRange shown{std::max(latitudes.from_deg, -limit_deg),
                                std::min(latitudes.to_deg, limit_deg)};
        if (shown.from_deg >= shown.to_deg)
            continue;
        const double wrapped_deg = std::remainder(lon_deg, 360.0);
        const auto placeAt = [lon_deg](double lat_deg) { return LatLon{lat_deg, lon_deg}; };
        graticule.lines.push_back(
            {.isMeridian = true,
             .value_deg = wrapped_deg <= -180 ? wrapped_deg + 360 : wrapped_deg,
             .path_px = sampled(frame, view, shown,
                                {.length_px = (shown.to_deg - shown.from_deg) * pxPerDegree,
                                 .radius_px = earthRadius_px},
                                placeAt)});
    }
    for (const double lat_deg : multiples(latitudeStep_min / 60, latitudes)) {
        if (std::abs(lat_deg) >= 90 - 1e-9)
            continue; // a parallel at the pole is a point
        const double cosine = std::cos(radFromDeg(lat_deg));
        const LineForm form{.length_px =
                                (longitudes.to_deg - longitudes.from_deg) * pxPerDegree * cosine,
                            .radius_px = earthRadius_px * cosine};
        const auto placeAt = [lat_deg](double lon_deg) { return LatLon{lat_deg, lon_deg}; };
        graticule.lines.push_back({.isMeridian = false,
                                   .value_deg = lat_deg,
                                   .path_px = sampled(frame, view, longitudes, form, placeAt)});
    }
    return graticule;
}

std::vector<GraticuleLabel> graticuleLabels(const Graticule& graticule, const QRectF& rect,
                                            const QFontMetricsF& metrics, const QLocale& locale,
                                            std::vector<QRectF> taken)
{
    std::vector<GraticuleLabel> labels;
    for (const GraticuleLine& line : graticule.lines) {
        const QString text =
            line.isMeridian ? longitudeText(line.value_deg, graticule.longitudeDecimals, locale)
                            : latitudeText(line.value_deg, graticule.latitudeDecimals, locale);
        const QSizeF size(metrics.horizontalAdvance(text) + 2, metrics.height());
        for (const QRectF& place : labelPlaces(graticule, line, rect, size)) {
            const QRectF wide = place.marginsAdded(kApart_px);
            if (std::any_of(taken.begin(), taken.end(),
                            [&](const QRectF& other) { return other.intersects(wide); }))
                continue;
            taken.push_back(wide);
            labels.push_back({.text = text, .rect = place});
            break;
        }
    }
    return labels;
}

double northAngle_rad(const LocalFrame& frame, const Point& position_m)
{
    const LatLon place = frame.toGeographic(position_m);
    if (std::abs(place.latitude_deg) >= 90)
        return 0; // at the pole any direction will do
    constexpr double kStep_deg = 1e-3;
    const double span_deg = std::min(kStep_deg, 0.5 * (90 - std::abs(place.latitude_deg)));
    const Point north_m = frame.toPlane({place.latitude_deg + span_deg, place.longitude_deg}) -
                          frame.toPlane({place.latitude_deg - span_deg, place.longitude_deg});
    return std::atan2(north_m.x(), north_m.y());
}

} // namespace berg
