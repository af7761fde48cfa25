#include "widgets/map/graticule.h"

#include "core/base/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {
namespace {

constexpr double kMetresPerDegree = 111'200; // of latitude; enough to choose a step
constexpr int kSamples = 12;                 // of each side of the view

// Steps in minutes of arc that read well: decimals of minutes, whole minutes, whole degrees.
constexpr std::array<double, 21> kSteps_min = {0.01, 0.02, 0.05, 0.1, 0.2,  0.5,  1,
                                               2,    5,    10,   15,  20,   30,   60,
                                               120,  300,  600,  900, 1200, 1800, 2700};

double stepFor(double wanted_min)
{
    const auto it = std::lower_bound(kSteps_min.begin(), kSteps_min.end(), wanted_min);
    return it == kSteps_min.end() ? kSteps_min.back() : *it;
}

int decimalsOf(double step_min)
{
    if (step_min >= 60)
        return -1;
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

/** Latitudes and longitudes in view; all longitudes when a pole is. */
GeoBounds geoBoundsOf(const LocalFrame& frame, const MapViewTransform& view, const QRectF& rect)
{
    GeoBounds bounds;
    bounds.reference_deg = frame.toGeographic(view.toWorld(rect.center())).longitude_deg;
    for (int i = 0; i <= kSamples; ++i) {
        for (int j = 0; j <= kSamples; ++j) {
            const QPointF p_px(rect.left() + rect.width() * i / kSamples,
                               rect.top() + rect.height() * j / kSamples);
            const LatLon place = frame.toGeographic(view.toWorld(p_px));
            const double east_deg =
                std::remainder(place.longitude_deg - bounds.reference_deg, 360.0);
            bounds.south_deg = std::min(bounds.south_deg, place.latitude_deg);
            bounds.north_deg = std::max(bounds.north_deg, place.latitude_deg);
            bounds.west_deg = std::min(bounds.west_deg, east_deg);
            bounds.east_deg = std::max(bounds.east_deg, east_deg);
        }
    }
    for (const double pole_deg : {90.0, -90.0}) {
        if (!rect.contains(view.toPixel(frame.toPlane({pole_deg, 0}))))
            continue;
        bounds.west_deg = -180;
        bounds.east_deg = 180;
        (pole_deg > 0 ? bounds.north_deg : bounds.south_deg) = pole_deg;
    }
    return bounds;
}

struct Span
{
    double from_deg = 0;
    double to_deg = 0;
};

QPolygonF sampled(const LocalFrame& frame, const MapViewTransform& view, const Span& span,
                  const auto& placeAt)
{
    constexpr int kPieces = 24;
    QPolygonF path;
    for (int i = 0; i <= kPieces; ++i) {
        const double at_deg = span.from_deg + (span.to_deg - span.from_deg) * i / kPieces;
        path << view.toPixel(frame.toPlane(placeAt(at_deg)));
    }
    return path;
}

std::vector<double> multiples(double step_deg, const Span& span)
{
    std::vector<double> values_deg;
    for (double k = std::ceil(span.from_deg / step_deg); k * step_deg <= span.to_deg; ++k)
        values_deg.push_back(k * step_deg);
    return values_deg;
}

} // namespace

Graticule graticuleOf(const LocalFrame& frame, const MapViewTransform& view, const QRectF& rect,
                      double spacing_px)
{
    const GeoBounds bounds = geoBoundsOf(frame, view, rect);
    const double middle_deg = 0.5 * (bounds.south_deg + bounds.north_deg);
    const double wanted_min = spacing_px / view.scale_pxpm() / kMetresPerDegree * 60;
    const double shrink = std::max(0.02, std::cos(radFromDeg(middle_deg)));
    const double latitudeStep_min = stepFor(wanted_min);
    const double longitudeStep_min = stepFor(wanted_min / shrink);

    Graticule graticule;
    graticule.latitudeDecimals = decimalsOf(latitudeStep_min);
    graticule.longitudeDecimals = decimalsOf(longitudeStep_min);

    const Span latitudes{bounds.south_deg, bounds.north_deg};
    const Span longitudes{bounds.reference_deg + bounds.west_deg,
                          bounds.reference_deg + bounds.east_deg};
    const bool fullCircle = bounds.east_deg - bounds.west_deg >= 360;
    for (const double lon_deg : multiples(longitudeStep_min / 60, longitudes)) {
        if (fullCircle && lon_deg >= longitudes.from_deg + 360)
            break; // the first meridian again
        const auto placeAt = [lon_deg](double lat_deg) { return LatLon{lat_deg, lon_deg}; };
        graticule.lines.push_back({.isMeridian = true,
                                   .value_deg = std::remainder(lon_deg, 360.0),
                                   .path_px = sampled(frame, view, latitudes, placeAt)});
    }
    for (const double lat_deg : multiples(latitudeStep_min / 60, latitudes)) {
        const auto placeAt = [lat_deg](double lon_deg) { return LatLon{lat_deg, lon_deg}; };
        graticule.lines.push_back({.isMeridian = false,
                                   .value_deg = lat_deg,
                                   .path_px = sampled(frame, view, longitudes, placeAt)});
    }
    return graticule;
}

double northAngle_rad(const LocalFrame& frame, const Point& position_m)
{
    LatLon place = frame.toGeographic(position_m);
    constexpr double kStep_deg = 1e-3;
    // At the pole itself there is no north; straight up is as good as any.
    if (place.latitude_deg + kStep_deg >= 90)
        return 0;
    place.latitude_deg += kStep_deg;
    const Point north_m = frame.toPlane(place) - position_m;
    return std::atan2(north_m.x(), north_m.y());
}

} // namespace berg
