#include "widgets/theme/typed_quantity.h"

#include "core/base/unit_names.h"

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

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/** Name of a unit in the window's language; empty if that has no name of its own. */
QString shownName(const NamedUnit& unit)
{
    static constexpr std::array kShown{"nmi", "kn", "%1 s", "%1 min", "%1 h"};
    const QString own = textOf(unit.names.begin()[0]);
    for (const char* pattern : kShown)
        if (QString::fromLatin1(pattern).remove(u"%1"_s).trimmed() == own)
            return QCoreApplication::translate("QuantityText", pattern)
                .remove(u"%1"_s)
                .trimmed()
                .toLower();
    return {};
}

/** Finds the unit of a field by its first name, or its name in the window's language. Returns null
 * for areas and variances, which accept numbers only. */
const NamedUnit* unitOfField(const QString& name)
{
    const QString small = name.trimmed().toLower();
    for (const NamedUnit& unit : namedUnits())
        if (unit.dimension != Dimension::Area && unit.dimension != Dimension::Growth &&
            (small == textOf(unit.names.begin()[0]) ||
             (!small.isEmpty() && small == shownName(unit))))
            return &unit;
    return nullptr;
}

std::optional<double> inSi(Dimension dimension, const QString& name)
{
    if (const std::optional<double> known = unitInSi(dimension, name.toStdString()))
        return known;
    for (const NamedUnit& unit : namedUnits())
        if (unit.dimension == dimension && name.toLower() == shownName(unit) && !name.isEmpty())
            return unit.inSi;
    return std::nullopt;
}

/** C locale without group separators, so that a comma never separates thousands. */
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

/** A number with its unit. */
struct QuantityPart
{
    QString number;
    QString unit;
};

std::vector<QuantityPart> partsOf(QString text)
{
    for (QChar& c : text)
        if (c.isSpace()) // includes no-break spaces between thousands
            c = u' ';
    static const QRegularExpression kPart(
        u"\\G\\s*([+−-]?[.,]?\\d(?:[.,\\d]|\\s(?=\\d{3}(?!\\d)))*)\\s*([^\\d\\s:+−.,-][^\\d:+]*)?"_s);
    std::vector<QuantityPart> parts;
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

/** Time in seconds of parts separated by colons, the last of which counts `last_s` seconds each. */
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

/** Sum of numbers with units in SI; several numbers are allowed for times only. */
std::optional<double> sumOf(const std::vector<QuantityPart>& parts, Dimension dimension,
                            double plain, const QLocale& locale)
{
    if (parts.empty() || (parts.size() > 1 && dimension != Dimension::Time))
        return std::nullopt;
    double sum = 0;
    for (const QuantityPart& part : parts) {
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
    return unitOfField(unit) != nullptr;
}

std::optional<double> typedNumber(const QString& text, const QString& unit, const QLocale& locale)
{
    const QString trimmed = text.trimmed();
    const NamedUnit* own = unitOfField(unit);
    if (!own)
        return numberOf(trimmed, locale);
    if (own->dimension == Dimension::Time && trimmed.contains(u':')) {
        const std::optional<double> time_s = durationValue(trimmed, 1, locale);
        return time_s ? std::optional(*time_s / own->inSi) : std::nullopt;
    }
    const std::vector<QuantityPart> parts = partsOf(trimmed);
    if (parts.size() == 1 && parts.front().unit.isEmpty())
        return numberOf(parts.front().number, locale); // conversion via SI would round it
    const std::optional<double> value = sumOf(parts, own->dimension, own->inSi, locale);
    return value ? std::optional(*value / own->inSi) : std::nullopt;
}

} // namespace berg
