#include "widgets/theme/quantity_text.h"

#include "core/base/angles.h"
#include "core/tracking/position_error.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QChar kNarrowSpace{0x202f};
constexpr double kNauticalMile_m = 1852;
constexpr double kKilometre_m = 1000;
constexpr double kHour_s = 3600;
constexpr double kFoot_m = 0.3048;
constexpr double kNoAngle_deg = 1e-9; // tolerance of lines that belong to no hemisphere

struct QuantityText
{
    Q_DECLARE_TR_FUNCTIONS(QuantityText)
};

/** Feet without unit; heights near a multiple of 100 ft, as on airspace charts, are exact. */
QString feetText(double height_m, const QLocale& locale)
{
    const double height_ft = height_m / kFoot_m;
    const double round_ft = 100 * std::round(height_ft / 100);
    return fixedText(std::abs(height_ft - round_ft) < 1 ? round_ft : height_ft, 0, locale);
}

/** An angle >= 0 in the selected form. */
QString shownAngle(double angle_deg, std::optional<int> decimals, const QLocale& locale)
{
    QString text = QString::fromStdString(angleText(angle_deg, shownUnits().coordinates, decimals));
    return text.replace(u'.', locale.decimalPoint());
}

} // namespace

QString fixedText(double value, int decimals, const QLocale& locale)
{
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = plain.toString(value, 'f', decimals);
    const auto point = text.indexOf(plain.decimalPoint());
    const auto first = text.startsWith(plain.negativeSign()) ? plain.negativeSign().size() : 0;
    for (auto at = (point < 0 ? text.size() : point) - 3; at > first; at -= 3)
        text.insert(at, kNarrowSpace);
    return text;
}

QString significantText(double value, int digits, const QLocale& locale)
{
    if (value == 0 || !std::isfinite(value))
        return fixedText(0, 0, locale);
    const auto magnitude = [](double v) { return static_cast<int>(std::floor(std::log10(v))); };
    const double unit = std::pow(10.0, magnitude(std::abs(value)) - digits + 1);
    const double rounded = std::round(value / unit) * unit;
    const int decimals = std::max(0, digits - 1 - magnitude(std::abs(rounded)));
    return fixedText(rounded, decimals, locale);
}

QString changeText(double share, const QLocale& locale)
{
    const double percent = 100 * share;
    const int decimals = std::abs(percent) < 99.95 ? 1 : 0;
    const double rounded = std::abs(percent) < 0.05 ? 0 : percent;
    const QString sign = rounded == 0 ? QString() : rounded < 0 ? u"−"_s : u"+"_s;
    return sign + QuantityText::tr("%1 %").arg(fixedText(std::abs(rounded), decimals, locale));
}

QString clockText(double time_s)
{
    if (!std::isfinite(time_s))
        return u"∞"_s;
    const auto total = std::max(0LL, std::llround(time_s));
    const auto hours = total / 3600;
    const QString rest =
        u"%1:%2"_s.arg(total / 60 % 60, 2, 10, QChar(u'0')).arg(total % 60, 2, 10, QChar(u'0'));
    return hours > 0 ? u"%1:%2"_s.arg(hours).arg(rest) : rest;
}

QString marginText(double time_s)
{
    if (!std::isfinite(time_s))
        return QuantityText::tr("not home");
    return time_s < 0 ? u"\u2212"_s + clockText(-time_s) : clockText(time_s);
}

QString fieldDurationText(double time_s, int decimals, const QLocale& locale)
{
    constexpr double kMinute_s = 60;
    const auto number = [&](double value, int least) {
        QString text = QLocale::c().toString(value, 'f', decimals);
        if (decimals > 0)
            while (text.endsWith(u'0') || text.endsWith(u'.'))
                if (const bool isPoint = text.endsWith(u'.'); text.chop(1), isPoint)
                    break;
        while (text.indexOf(u'.') < 0 ? text.size() < least : text.indexOf(u'.') < least)
            text.prepend(u'0');
        return text.replace(u'.', locale.decimalPoint());
    };
    const double scale = std::pow(10.0, decimals);
    const double rounded_s = std::round(time_s * scale) / scale;
    if (rounded_s >= kMinute_s && std::fmod(rounded_s, kMinute_s) == 0)
        return QuantityText::tr("%1 min").arg(number(rounded_s / kMinute_s, 1));
    if (rounded_s < kMinute_s)
        return QuantityText::tr("%1 s").arg(number(rounded_s, 1));
    const auto minutes = static_cast<long long>(rounded_s / kMinute_s);
    return u"%1:%2:%3"_s.arg(minutes / 60)
        .arg(minutes % 60, 2, 10, QChar(u'0'))
        .arg(number(rounded_s - kMinute_s * static_cast<double>(minutes), 2));
}

ShownUnit distanceUnit()
{
    if (shownUnits().distance == DistanceUnit::Nautical)
        return {.inSi = kNauticalMile_m, .name = QuantityText::tr("nmi")};
    return {.name = QuantityText::tr("m")};
}

ShownUnit longDistanceUnit()
{
    if (shownUnits().distance == DistanceUnit::Nautical)
        return distanceUnit();
    return {.inSi = kKilometre_m, .name = QuantityText::tr("km")};
}

ShownUnit speedUnit()
{
    if (shownUnits().speed == SpeedUnit::Knots)
        return {.inSi = kNauticalMile_m, .per = kHour_s, .name = QuantityText::tr("kn")};
    return {.name = QuantityText::tr("m/s")};
}

ShownUnit areaUnit()
{
    if (shownUnits().distance == DistanceUnit::Nautical)
        return {.inSi = kNauticalMile_m * kNauticalMile_m, .name = QuantityText::tr("nmi²")};
    return {.inSi = kKilometre_m * kKilometre_m, .name = QuantityText::tr("km²")};
}

ShownUnit heightUnit()
{
    if (shownUnits().height == HeightUnit::Feet)
        return {.inSi = kFoot_m, .name = QuantityText::tr("ft")};
    return {.name = QuantityText::tr("m")};
}

QString distanceText(double distance_m, const QLocale& locale, int digits, DistanceUnit unit)
{
    const auto number = [&](double value) { return significantText(value, digits, locale); };
    if (unit == DistanceUnit::Nautical)
        return QuantityText::tr("%1 nmi").arg(number(distance_m / kNauticalMile_m));
    if (distance_m < 999.5)
        return QuantityText::tr("%1 m").arg(number(distance_m));
    return QuantityText::tr("%1 km").arg(number(distance_m / kKilometre_m));
}

QString heightText(double height_m, const QLocale& locale)
{
    if (shownUnits().height == HeightUnit::Feet)
        return QuantityText::tr("%1 ft").arg(feetText(height_m, locale));
    return distanceText(height_m, locale, 3, DistanceUnit::Metric);
}

QString heightsText(double floor_m, const std::optional<double>& ceiling_m, const QLocale& locale)
{
    const bool isInFeet = shownUnits().height == HeightUnit::Feet;
    const auto metres = [&](double height_m) {
        return distanceText(height_m, locale, 3, DistanceUnit::Metric);
    };
    const auto feet = [&](double height_m) { return feetText(height_m, locale); };
    const auto both = [&](const QString& inMetres, const QString& inFeet) {
        return isInFeet ? QuantityText::tr("%1 ft (%2)").arg(inFeet, inMetres)
                        : QuantityText::tr("%1 (%2 ft)").arg(inMetres, inFeet);
    };
    const auto range = [](const QString& low, const QString& high) {
        return QuantityText::tr("%1 to %2").arg(low, high);
    };
    if (ceiling_m)
        return both(range(metres(floor_m), metres(*ceiling_m)),
                    range(feet(floor_m), feet(*ceiling_m)));
    return floor_m > 0 ? QuantityText::tr("from %1").arg(both(metres(floor_m), feet(floor_m)))
                       : QuantityText::tr("at all heights");
}

QString offsetText(double offset_m, const QLocale& locale)
{
    const bool isNautical = shownUnits().distance == DistanceUnit::Nautical;
    const ShownUnit unit = distanceUnit();
    return u"%1 %2"_s.arg(fixedText(unit.fromSi(offset_m), isNautical ? 3 : 0, locale), unit.name);
}

QString speedText(double speed_mps, const QLocale& locale, int digits)
{
    const ShownUnit unit = speedUnit();
    return u"%1 %2"_s.arg(significantText(unit.fromSi(speed_mps), digits, locale), unit.name);
}

QString fixedSpeedText(double speed_mps, int decimals, const QLocale& locale)
{
    const ShownUnit unit = speedUnit();
    return u"%1 %2"_s.arg(fixedText(unit.fromSi(speed_mps), decimals, locale), unit.name);
}

ShownUnit radius95Unit(double largest_m2)
{
    constexpr double kLeast_nmi = 0.1; // smaller radii are in metres: "0.003 nmi" is hard to grasp
    constexpr double kLeast_km = 0.9995;
    const ShownUnit unit = longDistanceUnit();
    const double least = shownUnits().distance == DistanceUnit::Nautical ? kLeast_nmi : kLeast_km;
    return unit.fromSi(radius95_m(largest_m2)) >= least ? unit
                                                        : ShownUnit{.name = QuantityText::tr("m")};
}

QString radius95Text(double sigma_m2, const QLocale& locale)
{
    const ShownUnit unit = radius95Unit(sigma_m2);
    return u"%1 %2"_s.arg(significantText(unit.fromSi(radius95_m(sigma_m2)), 3, locale), unit.name);
}

QString uncertaintyText(double sigma_m2, const QLocale& locale)
{
    const QString sigma = sigmaText(sigma_m2, locale);
    const QString radius = radius95Text(sigma_m2, locale);
    return shownUnits().uncertainty == UncertaintyForm::Sigma
               ? QuantityText::tr("σ %1 (95 % within %2)").arg(sigma, radius)
               : QuantityText::tr("95 % within %2 (σ %1)").arg(sigma, radius);
}

ShownUnit zetaUnit(double largest_m2s)
{
    constexpr double kSquareKilometre_m2 = kKilometre_m * kKilometre_m;
    if (std::abs(largest_m2s) < kSquareKilometre_m2)
        return {.name = QuantityText::tr("m² s")};
    return {.inSi = kSquareKilometre_m2, .name = QuantityText::tr("km² s")};
}

QString zetaText(double zeta_m2s, const QLocale& locale, int digits)
{
    const ShownUnit unit = zetaUnit(zeta_m2s);
    return u"%1 %2"_s.arg(significantText(unit.fromSi(zeta_m2s), digits, locale), unit.name);
}

QString sigmaText(double sigma_m2, const QLocale& locale)
{
    return QuantityText::tr("%1 m²").arg(significantText(sigma_m2, 3, locale));
}

QString widestSigmaText(double full_m2, const QLocale& locale)
{
    constexpr double kFourDigits = 999.5;
    QString text = significantText(full_m2 < kFourDigits ? 88.8 : full_m2, 3, locale);
    for (QChar& c : text)
        if (c.isDigit())
            c = u'8';
    return text;
}

QString durationText(double time_s, const QLocale& locale)
{
    const auto whole = [&](double unit_s) { return fixedText(time_s / unit_s, 0, locale); };
    if (std::fmod(time_s, 3600) == 0)
        return QuantityText::tr("%1 h").arg(whole(3600));
    if (std::fmod(time_s, 60) == 0)
        return QuantityText::tr("%1 min").arg(whole(60));
    return QuantityText::tr("%1 s").arg(whole(1));
}

QString latitudeText(double latitude_deg, std::optional<int> decimals, const QLocale& locale)
{
    QString angle = shownAngle(std::abs(latitude_deg), decimals, locale);
    if (std::abs(latitude_deg) < kNoAngle_deg)
        return angle;
    return latitude_deg < 0 ? QuantityText::tr("%1 S", "latitude").arg(angle)
                            : QuantityText::tr("%1 N", "latitude").arg(angle);
}

QString longitudeText(double longitude_deg, std::optional<int> decimals, const QLocale& locale)
{
    QString angle = shownAngle(std::abs(longitude_deg), decimals, locale);
    if (std::abs(std::remainder(longitude_deg, 180.0)) < kNoAngle_deg)
        return angle;
    return longitude_deg < 0 ? QuantityText::tr("%1 W", "longitude").arg(angle)
                             : QuantityText::tr("%1 E", "longitude").arg(angle);
}

QString withPlainHemispheres(const QString& text)
{
    const std::array<std::pair<QString, QChar>, 4> letters{
        {{QuantityText::tr("%1 N", "latitude"), u'N'},
         {QuantityText::tr("%1 S", "latitude"), u'S'},
         {QuantityText::tr("%1 E", "longitude"), u'E'},
         {QuantityText::tr("%1 W", "longitude"), u'W'}}};
    QString plain = text;
    for (const auto& [shown, english] : letters) {
        const QString own = QString(shown).remove(u"%1"_s).trimmed();
        if (own.size() == 1 && own != english)
            plain.replace(QRegularExpression(u"(?<!\\p{L})%1(?!\\p{L})"_s.arg(own),
                                             QRegularExpression::CaseInsensitiveOption |
                                                 QRegularExpression::UseUnicodePropertiesOption),
                          english);
    }
    return plain;
}

QString placeText(const LatLon& place, std::optional<int> decimals, const QLocale& locale)
{
    return latitudeText(place.latitude_deg, decimals, locale) + u"  "_s +
           longitudeText(place.longitude_deg, decimals, locale);
}

QString directionText(double heading_deg)
{
    const int whole_deg = static_cast<int>(std::lround(heading_deg)) % 360;
    return u"%1°"_s.arg(whole_deg < 0 ? whole_deg + 360 : whole_deg, 3, 10, QChar(u'0'));
}

QString bearingText(const Point& path_m)
{
    return directionText(headingFromPsi(std::atan2(path_m.y(), path_m.x())));
}

QString declinationText(double declination_deg, const QLocale& locale)
{
    const QString angle = fixedText(std::abs(declination_deg), 1, locale) + u'°';
    return declination_deg < 0 ? QuantityText::tr("%1 W", "longitude").arg(angle)
                               : QuantityText::tr("%1 E", "longitude").arg(angle);
}

QString courseText(double true_deg, const std::optional<double>& declination_deg)
{
    if (!declination_deg)
        return directionText(true_deg);
    return QuantityText::tr("%1 T / %2 M", "course by true and by magnetic north")
        .arg(directionText(true_deg), directionText(true_deg - *declination_deg));
}

} // namespace berg
