#include "core/earth/sun.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

using std::chrono::hours;

constexpr hours kHalfDay{12};
constexpr double kDay_s = 86400;
constexpr double kMinutesPerDegree = 4; ///< time in which the Earth turns by one degree

double sinDeg(double angle_deg)
{
    return std::sin(radFromDeg(angle_deg));
}
double cosDeg(double angle_deg)
{
    return std::cos(radFromDeg(angle_deg));
}

struct Sun
{
    double declination_deg = 0;
    double equation_min = 0; ///< equation of time: apparent less mean solar time
};

/** Position of the sun: Meeus, chapters 21, 24 and 27, low accuracy, as in NOAA's spreadsheet. */
Sun sunAt(SunTime time)
{
    using namespace std::chrono;
    constexpr double kCentury_d = 36525;
    constexpr sys_days kEpoch{year(2000) / January / 1}; // J2000.0 is noon of this day
    const double days_d = duration<double>(time - kEpoch).count() / kDay_s - 0.5;
    const double t = days_d / kCentury_d;
    const double meanLongitude_deg = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly_deg = 357.52911 + t * (35999.05029 - 0.0001537 * t);
    const double eccentricity = 0.016708634 - t * (0.000042037 + 0.0000001267 * t);
    const double centre_deg = sinDeg(anomaly_deg) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
                              sinDeg(2 * anomaly_deg) * (0.019993 - 0.000101 * t) +
                              sinDeg(3 * anomaly_deg) * 0.000289;
    const double node_deg = 125.04 - 1934.136 * t;
    const double longitude_deg =
        meanLongitude_deg + centre_deg - 0.00569 - 0.00478 * sinDeg(node_deg);
    const double meanObliquity_deg =
        23 + (26 + (21.448 - t * (46.815 + t * (0.00059 - t * 0.001813))) / 60) / 60;
    const double obliquity_deg = meanObliquity_deg + 0.00256 * cosDeg(node_deg);
    const double half = std::tan(radFromDeg(obliquity_deg / 2));
    const double y = half * half;
    const double e = eccentricity;
    const double equation_rad = y * sinDeg(2 * meanLongitude_deg) - 2 * e * sinDeg(anomaly_deg) +
                                4 * e * y * sinDeg(anomaly_deg) * cosDeg(2 * meanLongitude_deg) -
                                y * y / 2 * sinDeg(4 * meanLongitude_deg) -
                                5 * e * e / 4 * sinDeg(2 * anomaly_deg);
    return {.declination_deg = degFromRad(std::asin(sinDeg(obliquity_deg) * sinDeg(longitude_deg))),
            .equation_min = kMinutesPerDegree * degFromRad(equation_rad)};
}

/** Hour angle of the sun, degrees in [-180, 180], 0 at solar noon and positive after it. */
double hourAngle_deg(SunTime time, const Sun& sun, double longitude_deg)
{
    using namespace std::chrono;
    const double minutes_min = duration<double>(time - floor<days>(time)).count() / 60;
    const double solar_deg = (minutes_min + sun.equation_min) / kMinutesPerDegree + longitude_deg;
    return std::remainder(solar_deg - 180, 360);
}

SunTime nearestNoon(SunTime time, LatLon place)
{
    using namespace std::chrono;
    const double after_min =
        kMinutesPerDegree * hourAngle_deg(time, sunAt(time), place.longitude_deg);
    return time - milliseconds(std::llround(60'000 * after_min));
}

/** Returns when the sun passes the elevation between two times on either side of it. */
SunTime crossing(SunTime below, SunTime above, LatLon place, double elevation_deg)
{
    using std::chrono::abs;
    while (abs(above - below) > SunTime::duration(1)) {
        const SunTime middle = below + (above - below) / 2;
        (sunElevation_deg(middle, place) < elevation_deg ? below : above) = middle;
    }
    return above;
}

} // namespace

double sunElevation_deg(SunTime time, LatLon place)
{
    const Sun sun = sunAt(time);
    const double sine = sinDeg(place.latitude_deg) * sinDeg(sun.declination_deg) +
                        cosDeg(place.latitude_deg) * cosDeg(sun.declination_deg) *
                            cosDeg(hourAngle_deg(time, sun, place.longitude_deg));
    return degFromRad(std::asin(std::clamp(sine, -1.0, 1.0)));
}

SunSpan sunSpan(SunTime time, LatLon place, double elevation_deg)
{
    const SunTime noon = nearestNoon(time, place);
    const auto isAbove = [&](SunTime at) { return sunElevation_deg(at, place) >= elevation_deg; };
    SunSpan span{.begin = {}, .end = {}, .isAboveAtNoon = isAbove(noon)};
    if (!span.isAboveAtNoon)
        return span;
    if (!isAbove(noon - kHalfDay))
        span.begin = crossing(noon - kHalfDay, noon, place, elevation_deg);
    if (!isAbove(noon + kHalfDay))
        span.end = crossing(noon + kHalfDay, noon, place, elevation_deg);
    return span;
}

std::optional<SunTime> nextRise(SunTime time, LatLon place, double elevation_deg)
{
    constexpr int kYear_d = 367;
    for (int day = 0; day < kYear_d; ++day) {
        const SunSpan span = sunSpan(time + day * 2 * kHalfDay, place, elevation_deg);
        if (span.begin && *span.begin > time)
            return span.begin;
    }
    return std::nullopt;
}

std::optional<SunTime> lastSet(SunTime time, LatLon place, double elevation_deg)
{
    constexpr int kYear_d = 367;
    for (int day = 0; day < kYear_d; ++day) {
        const SunSpan span = sunSpan(time - day * 2 * kHalfDay, place, elevation_deg);
        if (span.end && *span.end < time)
            return span.end;
    }
    return std::nullopt;
}

} // namespace berg
