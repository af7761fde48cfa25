#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QChar kNarrowSpace{0x202f};

struct QuantityText
{
    Q_DECLARE_TR_FUNCTIONS(QuantityText)
};

/** "47° 03.2′" of an angle >= 0. */
QString angleText(double angle_deg, int decimals, const QLocale& locale)
{
    if (decimals < 0)
        return u"%1°"_s.arg(std::lround(angle_deg));
    const double unit = std::pow(10.0, decimals);
    const auto total = std::llround(angle_deg * 60 * unit); // rounded once: never 60.0 minutes
    const auto perDegree = std::llround(60 * unit);
    const double minutes = static_cast<double>(total % perDegree) / unit;
    QString text = locale.toString(minutes, 'f', decimals);
    if (minutes < 10)
        text.prepend(u'0');
    return u"%1° %2′"_s.arg(total / perDegree).arg(text);
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

QString clockText(double time_s)
{
    const auto total = std::max(0LL, std::llround(time_s));
    const auto hours = total / 3600;
    const QString rest =
        u"%1:%2"_s.arg(total / 60 % 60, 2, 10, QChar(u'0')).arg(total % 60, 2, 10, QChar(u'0'));
    return hours > 0 ? u"%1:%2"_s.arg(hours).arg(rest) : rest;
}

std::optional<double> clockValue(const QString& text)
{
    const QStringList parts = text.trimmed().split(u':');
    if (parts.size() > 3)
        return std::nullopt;
    double time_s = 0;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool isNumber = false;
        const double part = QLocale::c().toDouble(QString(parts[i]).replace(u',', u'.'), &isNumber);
        const bool leads = i == 0;
        if (!isNumber || !(part >= 0) || !std::isfinite(part) || (!leads && part >= 60))
            return std::nullopt;
        time_s = 60 * time_s + part;
    }
    return time_s;
}

QString distanceText(double distance_m, const QLocale& locale, int digits)
{
    if (distance_m < 999.5)
        return QuantityText::tr("%1 m").arg(significantText(distance_m, digits, locale));
    return QuantityText::tr("%1 km").arg(significantText(distance_m / 1000, digits, locale));
}

QString sigmaText(double sigma_m2, const QLocale& locale)
{
    return QuantityText::tr("%1 m²").arg(significantText(sigma_m2, 3, locale));
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

QString latitudeText(double latitude_deg, int decimals, const QLocale& locale)
{
    const QString angle = angleText(std::abs(latitude_deg), decimals, locale);
    return latitude_deg < 0 ? QuantityText::tr("%1 S", "latitude").arg(angle)
                            : QuantityText::tr("%1 N", "latitude").arg(angle);
}

QString longitudeText(double longitude_deg, int decimals, const QLocale& locale)
{
    const QString angle = angleText(std::abs(longitude_deg), decimals, locale);
    return longitude_deg < 0 ? QuantityText::tr("%1 W", "longitude").arg(angle)
                             : QuantityText::tr("%1 E", "longitude").arg(angle);
}

} // namespace berg
