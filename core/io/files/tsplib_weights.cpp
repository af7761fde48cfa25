#include "core/io/files/tsplib_weights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace berg {

namespace {

double nearestWhole(double x)
{
    return std::floor(x + 0.5);
}

/**
 * Converts DDD.MM (degrees and minutes) to radians. TSPLIB defines the rounded pi and the
 * truncation of degrees.
 */
Point radiansOf(const Point& degreesAndMinutes)
{
    constexpr double kPi = 3.141592;
    Point radians;
    for (const Eigen::Index axis : {0, 1}) {
        const double degrees = std::trunc(degreesAndMinutes[axis]);
        const double minutes = degreesAndMinutes[axis] - degrees;
        radians[axis] = kPi * (degrees + 5.0 * minutes / 3.0) / 180.0;
    }
    return radians;
}

/** Kilometres between two places given as latitude and longitude in radians, on TSPLIB's Earth. */
double geographicDistance(const Point& a, const Point& b)
{
    constexpr double kRadius = 6378.388;
    const double q1 = std::cos(a[1] - b[1]);
    const double q2 = std::cos(a[0] - b[0]);
    const double q3 = std::cos(a[0] + b[0]);
    const double cosine = std::clamp(0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3), -1.0, 1.0);
    return std::trunc(kRadius * std::acos(cosine) + 1.0);
}

} // namespace

double tsplibWeight(const Point& a, const Point& b, TsplibWeight type)
{
    const Point d = a - b;
    const double square = d[0] * d[0] + d[1] * d[1]; // hypot would round differently
    switch (type) {
    case TsplibWeight::Euclidean:
        return nearestWhole(std::sqrt(square));
    case TsplibWeight::Ceiling:
        return std::ceil(std::sqrt(square));
    case TsplibWeight::Pseudo: {
        const double length = std::sqrt(square / 10.0);
        const double whole = nearestWhole(length);
        return whole < length ? whole + 1 : whole;
    }
    case TsplibWeight::Geographic:
        return geographicDistance(radiansOf(a), radiansOf(b));
    case TsplibWeight::Explicit:
        break;
    }
    throw std::logic_error("tsplibWeight: explicit weights have no places");
}

} // namespace berg
