#include "widgets/theme/typed_quantity.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kMinute_s = 60;

/** A name as the texts that are shown have it in the language of the window. */
QString shownName(const char* pattern)
{
    return QCoreApplication::translate("QuantityText", pattern).remove(u"%1"_s).trimmed().toLower();
}

enum class Dimension
{
    Length,
    Speed,
    Time,
    Angle,
    Share,
    Temperature
};

/** A unit by the names that people write, the one of our fields first; small letters. */
struct NamedUnit
{
    Dimension dimension;
    double inSi;
    QStringList names;
};

std::array<NamedUnit, 15> namedUnits()
{
    constexpr double kNauticalMile_m = 1852;
    constexpr double kFoot_m = 0.3048;
    constexpr double kHour_s = 3600;
    return {{
        {Dimension::Length, 1, {u"m"_s, u"metres"_s, u"meters"_s}},
        {Dimension::Length, 1000, {u"km"_s}},
        {Dimension::Length, kNauticalMile_m, {u"nmi"_s, shownName("nmi"), u"nm"_s, u"sm"_s}},
        {Dimension::Length, kFoot_m, {u"ft"_s, u"feet"_s, u"'"_s, u"′"_s}},
        {Dimension::Speed, 1, {u"m/s"_s, u"mps"_s}},
        {Dimension::Speed, 1000 / kHour_s, {u"km/h"_s, u"kmh"_s, u"kph"_s}},
        {Dimension::Speed,
         kNauticalMile_m / kHour_s,
         {u"kn"_s, shownName("kn"), u"kt"_s, u"kts"_s, u"knots"_s, u"nd"_s}},
        {Dimension::Time, 1, {u"s"_s, shownName("%1 s"), u"sec"_s, u"seconds"_s, u"sek"_s}},
        {Dimension::Time,
         kMinute_s,
         {u"min"_s, shownName("%1 min"), u"m"_s, u"mins"_s, u"minutes"_s, u"′"_s}},
        {Dimension::Time,
         kHour_s,
         {u"h"_s, shownName("%1 h"), u"hr"_s, u"hrs"_s, u"hours"_s, u"t"_s}},
        {Dimension::Time, 24 * kHour_s, {u"d"_s, u"days"_s}},
        {Dimension::Angle, 1, {u"°"_s, u"deg"_s, u"degrees"_s}},
        {Dimension::Share, 1, {u"%"_s, u"percent"_s}},
        {Dimension::Temperature, 1, {u"°c"_s, u"c"_s, u"°"_s}},
        {Dimension::Angle, 180 / M_PI, {u"rad"_s}},
    }};
}

/** The unit of a field: its name is the first of its names, or that in the window's language. */
std::optional<NamedUnit> unitOfField(const QString& name)
{
    const QString small = name.trimmed().toLower();
    for (NamedUnit& unit : namedUnits())
        if (unit.names.mid(0, 2).contains(small))
            return std::move(unit);
    return std::nullopt;
}

std::optional<double> inSi(Dimension dimension, const QString& name)
{
    for (const NamedUnit& unit : namedUnits())
        if (unit.dimension == dimension && unit.names.contains(name.toLower()))
            return unit.inSi;
    return std::nullopt;
}

/** In which a comma is never between thousands. */
QLocale plainLocale()
{
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    return plain;
}

std::optional<double> numberOf(QString text, const QLocale& locale)
{
    constexpr int kLongest = 20;
    text.remove(QRegularExpression(u"\\s"_s));
    bool isNumber = false;
    const bool isPlain = locale == QLocale::c();
    double number = (isPlain ? plainLocale() : locale).toDouble(text, &isNumber);
    if (!isNumber)
        number = plainLocale().toDouble(text.replace(u',', u'.').replace(u'−', u'-'), &isNumber);
    const bool isGood = isNumber && std::isfinite(number) && text.size() <= kLongest;
    return isGood ? std::optional(number) : std::nullopt;
}

/** A number and what stands behind it. */
struct Part
{
    QString number;
    QString unit;
};

std::vector<Part> partsOf(QString text)
{
    for (QChar& c : text)
        if (c.isSpace()) // also those between thousands that do not break
            c = u' ';
    static const QRegularExpression kPart(
        u"\\G\\s*([+−-]?[.,]?\\d(?:[.,\\d]|\\s(?=\\d{3}(?!\\d)))*)\\s*([^\\d\\s:+−.,-][^\\d:+]*)?"_s);
    std::vector<Part> parts;
    qsizetype at = 0;
    while (at < text.size()) {
        const QRegularExpressionMatch match = kPart.match(text, at);
        if (!match.hasMatch())
            return {};
        parts.push_back({.number = match.captured(1), .unit = match.captured(2).trimmed()});
        at = match.capturedEnd();
    }
    return parts;
}

/** Seconds of parts from the largest to the one that counts `last_s`. */
std::optional<double> colonTime(const QStringList& parts, double last_s)
{
    if (parts.size() > 3)
        return std::nullopt;
    double time_s = 0;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        const std::optional<double> part = numberOf(parts[i], plainLocale());
        const bool leads = i == 0;
        if (!part || !(*part >= 0) || (!leads && *part >= 60))
            return std::nullopt;
        time_s = 60 * time_s + *part;
    }
    return time_s * last_s;
}

/** Of numbers with units, the largest first; their sum. */
std::optional<double> sumOf(const std::vector<Part>& parts, Dimension dimension, double plain,
                            const QLocale& locale)
{
    if (parts.empty() || (parts.size() > 1 && dimension != Dimension::Time))
        return std::nullopt;
    double sum = 0;
    for (const Part& part : parts) {
        const std::optional<double> number = numberOf(part.number, locale);
        const std::optional<double> unit = part.unit.isEmpty() && parts.size() == 1
                                               ? std::optional(plain)
                                               : inSi(dimension, part.unit);
        if (!number || !unit || (parts.size() > 1 && *number < 0))
            return std::nullopt;
        sum += *number * *unit;
    }
    return sum;
}

} // namespace

std::optional<double> clockValue(const QString& text)
{
    const QStringList parts = text.trimmed().split(u':');
    return parts.size() > 1 ? colonTime(parts, 1) : durationValue(text, 1, QLocale::c());
}

std::optional<double> durationValue(const QString& text, double plain_s, const QLocale& locale)
{
    const QString trimmed = text.trimmed();
    const QStringList parts = trimmed.split(u':');
    const std::optional<double> time_s =
        parts.size() > 1 ? colonTime(parts, parts.size() == 2 ? kMinute_s : 1)
                         : sumOf(partsOf(trimmed), Dimension::Time, plain_s, locale);
    return time_s && *time_s >= 0 ? time_s : std::nullopt;
}

bool hasOtherUnits(const QString& unit)
{
    return unitOfField(unit).has_value();
}

std::optional<double> typedNumber(const QString& text, const QString& unit, const QLocale& locale)
{
    const QString trimmed = text.trimmed();
    const std::optional<NamedUnit> own = unitOfField(unit);
    if (!own)
        return numberOf(trimmed, locale);
    if (own->dimension == Dimension::Time && trimmed.contains(u':')) {
        const std::optional<double> time_s = durationValue(trimmed, 1, locale);
        return time_s ? std::optional(*time_s / own->inSi) : std::nullopt;
    }
    const std::vector<Part> parts = partsOf(trimmed);
    if (parts.size() == 1 && parts.front().unit.isEmpty())
        return numberOf(parts.front().number, locale); // not by way of SI, which would round it
    const std::optional<double> value = sumOf(parts, own->dimension, own->inSi, locale);
    return value ? std::optional(*value / own->inSi) : std::nullopt;
}

} // namespace berg
