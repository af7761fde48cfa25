#pragma once

#include "core/base/geodesy.h"
#include "widgets/theme/unit_settings.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// How quantities are written on screen: decimal sign of the locale, narrow no-break spaces between
// thousands (ISO 80000-1), digits that mean something, always a unit, the one of `shownUnits`.
// Files never use these.

/** A unit that numbers are shown and typed in. */
struct ShownUnit
{
    double inSi = 1; ///< times this,
    double per = 1;  ///< by this: 1852 m / 3600 s, so that what is typed is converted exactly
    QString name;

    [[nodiscard]] double toSi(double value) const { return value * inSi / per; }
    [[nodiscard]] double fromSi(double value) const { return value * per / inSi; }
};

[[nodiscard]] ShownUnit distanceUnit();     ///< m or nmi
[[nodiscard]] ShownUnit longDistanceUnit(); ///< km or nmi
[[nodiscard]] ShownUnit speedUnit();        ///< m/s or kn
[[nodiscard]] ShownUnit areaUnit();         ///< km² or nmi²
[[nodiscard]] ShownUnit heightUnit();       ///< m or ft

/** Fixed number of decimals, e.g. "84 420" or "0.25". */
[[nodiscard]] QString fixedText(double value, int decimals, const QLocale& locale);

/** `digits` significant digits without an exponent: 84 423 with four is "84 420". */
[[nodiscard]] QString significantText(double value, int digits, const QLocale& locale);

/** "+8.0 %", "−0.4 %", "0.0 %" for 0.08, -0.004 and 0: a change as a share of what it was. */
[[nodiscard]] QString changeText(double share, const QLocale& locale);

/** mm:ss, from one hour on h:mm:ss; rounded to whole seconds, negative times as zero; "∞". */
[[nodiscard]] QString clockText(double time_s);
/** A time above the reserve, with a sign where it is below: "−02:44"; "not home" if infinite. */
[[nodiscard]] QString marginText(double time_s);

/** "45 s", "45 min" or "0:16:40": a duration in a field, exact to `decimals` of a second. */
[[nodiscard]] QString fieldDurationText(double time_s, int decimals, const QLocale& locale);

/** "850 m", "1.85 km" or "0.999 nmi" with so many significant digits. */
[[nodiscard]] QString distanceText(double distance_m, const QLocale& locale, int digits = 3,
                                   DistanceUnit unit = shownUnits().distance);

/** "100 m" or "328 ft": a height above the sea. */
[[nodiscard]] QString heightText(double height_m, const QLocale& locale);

/** "0 m to 150 m (0 to 492 ft)", "from 100 m (328 ft)", "at all heights"; the unit of heights
 * first.
 */
[[nodiscard]] QString heightsText(double floor_m, const std::optional<double>& ceiling_m,
                                  const QLocale& locale);

/** "-1 234 m" or "-0.666 nmi": a coordinate of the plane, to the metre. */
[[nodiscard]] QString offsetText(double offset_m, const QLocale& locale);

/** "0.32 m/s" or "0.62 kn" with so many significant digits. */
[[nodiscard]] QString speedText(double speed_mps, const QLocale& locale, int digits = 2);

/** The same with so many decimals. */
[[nodiscard]] QString fixedSpeedText(double speed_mps, int decimals, const QLocale& locale);

/** Of radii of 95 % up to that of this sigma: m, km or, from 0.1 nmi on in nautical units, nmi. */
[[nodiscard]] ShownUnit radius95Unit(double largest_m2);
/** "367 m", "1.22 km" or "0.198 nmi": the radius of 95 % in its own unit, three digits. */
[[nodiscard]] QString radius95Text(double sigma_m2, const QLocale& locale);

/**
 * Both ways of saying how uncertain a position is, the chosen one first: "σ 8.12 m² (95 % within
 * 6.97 m)" or "95 % within 6.97 m (σ 8.12 m²)".
 */
[[nodiscard]] QString uncertaintyText(double sigma_m2, const QLocale& locale);

/** m² s, or km² s from a million on, for numbers up to this. */
[[nodiscard]] ShownUnit zetaUnit(double largest_m2s);
/** "84 420 m² s", "16 000 km² s", with so many significant digits. */
[[nodiscard]] QString zetaText(double zeta_m2s, const QLocale& locale, int digits = 4);

/** "8.12 m²": three digits. */
[[nodiscard]] QString sigmaText(double sigma_m2, const QLocale& locale);

/** As wide as any sigma of up to this much is with three digits; of small ones "88.8". */
[[nodiscard]] QString widestSigmaText(double full_m2, const QLocale& locale);

/** "30 s", "10 min", "2 h": a whole number of the largest unit that fits. */
[[nodiscard]] QString durationText(double time_s, const QLocale& locale);

/** Decimals of the minutes of a place that is looked at closely: about 2 m. */
inline constexpr int kPlaceDecimals = 3;

/**
 * An angle with the hemisphere in the form chosen: 47° 03.2′ N, 47.053° N or 47° 03′ 12″ N. The
 * equator and the meridians of 0 and 180 degrees belong to none.
 * `decimals` of the minutes, 0..4, give the precision in every form; -1: whole degrees only.
 */
[[nodiscard]] QString latitudeText(double latitude_deg, int decimals, const QLocale& locale);
[[nodiscard]] QString longitudeText(double longitude_deg, int decimals, const QLocale& locale);
/**
 * A place as it is typed, with the letters of hemispheres of the window's language, such as O for
 * west, made N, S, E and W, which every reader knows.
 */
[[nodiscard]] QString withPlainHemispheres(const QString& text);
/** Both, as far apart as they are read. */
[[nodiscard]] QString placeText(const LatLon& place, int decimals, const QLocale& locale);

/** As navigators write it: "045°", clockwise from north, within one turn. */
[[nodiscard]] QString directionText(double heading_deg);
/** The direction of a way. */
[[nodiscard]] QString bearingText(const Point& path_m);
/** "16.7° W", positive east. */
[[nodiscard]] QString declinationText(double declination_deg, const QLocale& locale);
/** "045° T / 063° M": by true and magnetic north; "045°" without a declination. */
[[nodiscard]] QString courseText(double true_deg, const std::optional<double>& declination_deg);

} // namespace berg
