#pragma once

#include "core/earth/geodesy.h"
#include "widgets/theme/unit_settings.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// Formats of quantities on screen: decimal sign of the locale, narrow no-break spaces between
// thousands (ISO 80000-1), significant digits only, always with the unit selected by `shownUnits`.
// Files never use these.

/** A unit in which numbers are shown and typed. */
struct ShownUnit
{
    double inSi = 1; ///< the unit in SI is `inSi` / `per`,
    double per = 1;  ///< e.g. 1852 m / 3600 s, so that typed numbers are converted exactly
    QString name;

    [[nodiscard]] double toSi(double value) const { return value * inSi / per; }
    [[nodiscard]] double fromSi(double value) const { return value * per / inSi; }
};

[[nodiscard]] ShownUnit distanceUnit();     ///< m or nmi
[[nodiscard]] ShownUnit longDistanceUnit(); ///< km or nmi
[[nodiscard]] ShownUnit speedUnit();        ///< m/s or kn
[[nodiscard]] ShownUnit areaUnit();         ///< km² or nmi²
[[nodiscard]] ShownUnit heightUnit();       ///< m or ft

/** Number with fixed decimals, e.g. "84 420" or "0.25". */
[[nodiscard]] QString fixedText(double value, int decimals, const QLocale& locale);

/** Number with `digits` significant digits, without exponent: 84 423 with four is "84 420". */
[[nodiscard]] QString significantText(double value, int digits, const QLocale& locale);

/** Relative change: "+8.0 %", "−0.4 %", "0.0 %" for 0.08, -0.004 and 0. */
[[nodiscard]] QString changeText(double share, const QLocale& locale);

/** Duration as mm:ss, from one hour as h:mm:ss; whole seconds, negative as zero, "∞". */
[[nodiscard]] QString clockText(double time_s);
/** Margin above the reserve, with a sign if below: "−02:44"; "not home" if infinite. */
[[nodiscard]] QString marginText(double time_s);

/** Duration in an input field, exact to `decimals` of a second: "45 s", "45 min", "0:16:40". */
[[nodiscard]] QString fieldDurationText(double time_s, int decimals, const QLocale& locale);

/** Distance with `digits` significant digits: "850 m", "1.85 km" or "0.999 nmi". */
[[nodiscard]] QString distanceText(double distance_m, const QLocale& locale, int digits = 3,
                                   DistanceUnit unit = shownUnits().distance);

/** Height above the sea: "100 m" or "328 ft". */
[[nodiscard]] QString heightText(double height_m, const QLocale& locale);

/** Height range, selected unit first: "0 m to 150 m (0 to 492 ft)", "from 100 m (328 ft)", "at all
 * heights". A ceiling of nullopt means unlimited. */
[[nodiscard]] QString heightsText(double floor_m, const std::optional<double>& ceiling_m,
                                  const QLocale& locale);

/** Coordinate in the local plane, to the metre: "-1 234 m" or "-0.666 nmi". */
[[nodiscard]] QString offsetText(double offset_m, const QLocale& locale);

/** Speed with `digits` significant digits: "0.32 m/s" or "0.62 kn". */
[[nodiscard]] QString speedText(double speed_mps, const QLocale& locale, int digits = 2);

/** Speed with fixed decimals. */
[[nodiscard]] QString fixedSpeedText(double speed_mps, int decimals, const QLocale& locale);

/** Unit of 95 % radii up to that of this sigma: m, km or, in nautical units from 0.1 nmi on, nmi.
 */
[[nodiscard]] ShownUnit radius95Unit(double largest_m2);
/** 95 % radius of a sigma with three digits: "367 m", "1.22 km" or "0.198 nmi". */
[[nodiscard]] QString radius95Text(double sigma_m2, const QLocale& locale);

/**
 * Uncertainty of a position in both forms, the selected one first: "σ 8.12 m² (95 % within 6.97 m)"
 * or "95 % within 6.97 m (σ 8.12 m²)".
 */
[[nodiscard]] QString uncertaintyText(double sigma_m2, const QLocale& locale);

/** Unit of zeta up to this value: m² s, or km² s from a million on. */
[[nodiscard]] ShownUnit zetaUnit(double largest_m2s);
/** Zeta with `digits` significant digits: "84 420 m² s", "16 000 km² s". */
[[nodiscard]] QString zetaText(double zeta_m2s, const QLocale& locale, int digits = 4);

/** Sigma with three digits: "8.12 m²". */
[[nodiscard]] QString sigmaText(double sigma_m2, const QLocale& locale);

/** Placeholder as wide as any sigma up to this value with three digits; at least "88.8". */
[[nodiscard]] QString widestSigmaText(double full_m2, const QLocale& locale);

/** Duration in words, whole in the largest suitable unit: "30 s", "10 min", "2 h". */
[[nodiscard]] QString durationText(double time_s, const QLocale& locale);

/** Decimals of minutes for a precise place: about 2 m. */
inline constexpr int kPlaceDecimals = 3;

/**
 * Latitude with hemisphere in the selected form: 47° 03.2′ N, 47.053° N or 47° 03′ 12″ N; the
 * equator has no hemisphere. `decimals` of the minutes (0 to 4) set the precision in every form;
 * nullopt means whole degrees.
 */
[[nodiscard]] QString latitudeText(double latitude_deg, std::optional<int> decimals,
                                   const QLocale& locale);
/** Longitude in the same form; the meridians of 0 and 180 degrees have no hemisphere. */
[[nodiscard]] QString longitudeText(double longitude_deg, std::optional<int> decimals,
                                    const QLocale& locale);
/**
 * Replaces the hemisphere letters of the window's language in a typed place (such as O for west) by
 * N, S, E and W, which all readers accept.
 */
[[nodiscard]] QString withPlainHemispheres(const QString& text);
/** Latitude and longitude in the same form, separated by two spaces. */
[[nodiscard]] QString placeText(const LatLon& place, std::optional<int> decimals,
                                const QLocale& locale);

/** Direction as navigators write it: "045°", clockwise from north, in [0, 360). */
[[nodiscard]] QString directionText(double heading_deg);
/** Direction of a vector (east, north). */
[[nodiscard]] QString bearingText(const Point& path_m);
/** Declination with hemisphere: "16.7° W". */
[[nodiscard]] QString declinationText(double declination_deg, const QLocale& locale);
/** Course by true and magnetic north: "045° T / 063° M"; "045°" without a declination. */
[[nodiscard]] QString courseText(double true_deg, const std::optional<double>& declination_deg);

} // namespace berg
