#include "widgets/words/field_names.h"

#include "core/scenario/fields.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <cmath>
#include <functional>
#include <map>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Name of a field that no table of the core lists. Its translation is in `context`. */
struct FieldName
{
    std::string_view field;
    const char* label;
    Quantity quantity = Quantity::Text;
    const char* context = "FieldNames";
};

struct OtherFields
{
    using enum Quantity;
    static constexpr FieldName kAll[]{
        {"uavs.home_m", QT_TRANSLATE_NOOP("InspectorRows", "Home"), Distance, "InspectorRows"},
        {"icebergs.track.time_s", QT_TRANSLATE_NOOP("FieldNames", "Time of the recorded track"),
         Seconds},
        {"icebergs.track.position_m",
         QT_TRANSLATE_NOOP("FieldNames", "Place of the recorded track"), Distance},
        {"ground_station", QT_TRANSLATE_NOOP("InspectorRows", "Ground station"), Text,
         "InspectorRows"},
        // Options of the core, named as in the dialogs for imports, random fields and exports.
        {"import.position error", "Position error", Metres, kFieldContext},
        {"import.drift variation", "Drift variation", Speed, kFieldContext},
        {"import.drift time", "Drift time constant", Seconds, kFieldContext},
        {"import.q", "Growth q", Growth, kFieldContext},
        {"import.area: south", QT_TRANSLATE_NOOP("FieldNames", "South"), Degrees},
        {"import.area: north", QT_TRANSLATE_NOOP("FieldNames", "North"), Degrees},
        {"import.area: west", QT_TRANSLATE_NOOP("FieldNames", "West"), Degrees},
        {"import.area: east", QT_TRANSLATE_NOOP("FieldNames", "East"), Degrees},
        {"import.at", QT_TRANSLATE_NOOP("FieldNames", "Start at")},
        {"import.since", QT_TRANSLATE_NOOP("FieldNames", "Not before")},
        {"import.until", QT_TRANSLATE_NOOP("FieldNames", "Not after")},
        {"import.origin", QT_TRANSLATE_NOOP("FieldNames", "Origin")},
        {"generate.icebergs", QT_TRANSLATE_NOOP("FieldNames", "Number of icebergs")},
        {"generate.area_m", QT_TRANSLATE_NOOP("FieldNames", "Area")},
        {"generate.speedMin_mps", QT_TRANSLATE_NOOP("FieldNames", "Lowest speed"), Speed},
        {"generate.speedMax_mps", QT_TRANSLATE_NOOP("FieldNames", "Highest speed"), Speed},
        {"generate.towards_deg",
         QT_TRANSLATE_NOOP("FieldNames", "Drift direction, clockwise from north"), Degrees},
        {"generate.spread_deg", QT_TRANSLATE_NOOP("FieldNames", "Spread to either side"), Degrees},
        {"generate.sigmaMin_m2", QT_TRANSLATE_NOOP("FieldNames", "Smallest σ at the start"),
         Variance},
        {"generate.sigmaMax_m2", QT_TRANSLATE_NOOP("FieldNames", "Largest σ at the start"),
         Variance},
        {"generate.q_m2ps", QT_TRANSLATE_NOOP("FieldNames", "Growth of σ"), Growth},
        {"generate.spacing_m",
         QT_TRANSLATE_NOOP("FieldNames", "Minimum distance between two icebergs"), Distance},
        {"export.altitude", QT_TRANSLATE_NOOP("ExportText", "Altitude"), Height, "ExportText"},
        {"export.speed", QT_TRANSLATE_NOOP("ExportText", "Airspeed"), Speed, "ExportText"},
        {"export.acceptance", QT_TRANSLATE_NOOP("ExportText", "Acceptance radius"), Metres,
         "ExportText"},
        {"export.loiter", QT_TRANSLATE_NOOP("ExportText", "Loiter turns"), Number, "ExportText"},
        {"export.return-home", QT_TRANSLATE_NOOP("ExportText", "Return home"), Text, "ExportText"},
        {"export.no-return-home", QT_TRANSLATE_NOOP("ExportText", "Return home"), Text,
         "ExportText"},
        {"export.what", QT_TRANSLATE_NOOP("ExportText", "What"), Text, "ExportText"},
    };
};

/** Returns "icebergs.position_m[1]" for "icebergs[3].position_m[1]". */
std::string withoutEntry(const std::string& field)
{
    const std::size_t open = field.find('[');
    const std::size_t close = field.find(']');
    if (!field.starts_with("icebergs[") && !field.starts_with("uavs[") &&
        !field.starts_with("no_fly["))
        return field;
    return close == std::string::npos ? field : field.substr(0, open) + field.substr(close + 1);
}

/** Returns "icebergs.q_m2ps" for "icebergs[3].q_m2ps". */
std::string withoutIndices(const std::string& field)
{
    std::string name;
    bool inside = false;
    for (const char c : field) {
        inside = inside || c == '[';
        if (!inside)
            name += c;
        inside = inside && c != ']';
    }
    return name;
}

/** Returns labels and quantities by path without entries; pairs and lists have those of their
 * parts. */
std::map<std::string, FieldName, std::less<>> allNames()
{
    std::map<std::string, FieldName, std::less<>> names;
    for (const FieldName& name : OtherFields::kAll)
        names.emplace(name.field, name);
    forEachObject([&](const std::string& object, const auto& fields) {
        for (const auto& field : fields) {
            const std::string path = withoutIndices(object) + field.name;
            const auto add = [&](const std::string& place, const char* label) {
                if (*label != 0)
                    names.emplace(path + place, FieldName{.field = {},
                                                          .label = label,
                                                          .quantity = field.quantity,
                                                          .context = kFieldContext});
            };
            if (isPair(field))
                add("[1]", field.label2);
            add(isPair(field) ? "[0]" : isList(field) ? "[]" : "", field.label);
        }
    });
    return names;
}

const FieldName* findField(const std::string& field)
{
    static const std::map<std::string, FieldName, std::less<>> kNames = allNames();
    const std::string bare = withoutIndices(field);
    for (const std::string& path :
         {withoutEntry(field), field.ends_with(']') ? bare + "[]" : bare, bare})
        if (const auto it = kNames.find(path); it != kNames.end())
            return &it->second;
    return nullptr;
}

/** Returns a number with as many decimals as it has, six at most. */
QString valueDigits(double value, const QLocale& locale)
{
    constexpr double kSmallest = 1e-6;
    constexpr double kPlain = 1e9;
    constexpr int kMostDecimals = 6;
    if (value != 0 && (std::abs(value) < kSmallest || std::abs(value) >= kPlain))
        return locale.toString(value, 'g', kMostDecimals);
    const auto isRough = [value](int decimals) {
        const double shifted = value * std::pow(10.0, decimals);
        return std::abs(std::round(shifted) - shifted) > kSmallest * std::abs(shifted);
    };
    int decimals = 0;
    while (decimals < kMostDecimals && isRough(decimals))
        ++decimals;
    return fixedText(value, decimals, locale);
}

QString withUnit(double value, const ShownUnit& unit, const QLocale& locale)
{
    return u"%1 %2"_s.arg(valueDigits(unit.fromSi(value), locale), unit.name);
}

/** Returns a height; feet have one decimal, as in the fields. */
QString heightFieldText(double height_m, const QLocale& locale)
{
    const ShownUnit unit = heightUnit();
    const bool isExact = shownUnits().height == HeightUnit::Metres;
    const double shown = unit.fromSi(height_m);
    return u"%1 %2"_s.arg(valueDigits(isExact ? shown : std::round(10 * shown) / 10, locale),
                          unit.name);
}

QString quantityText(Quantity quantity, double value, const QLocale& locale)
{
    switch (quantity) {
    case Quantity::Text:
    case Quantity::Utc:
    case Quantity::Number:
    case Quantity::Percent:
    case Quantity::Celsius:
        break;
    case Quantity::Metres:
        return withUnit(value, {.name = u"m"_s}, locale);
    case Quantity::Distance:
        return withUnit(value, distanceUnit(), locale);
    case Quantity::Height:
        return heightFieldText(value, locale);
    case Quantity::Speed:
        return withUnit(value, speedUnit(), locale);
    case Quantity::Seconds:
        return withUnit(value, {.name = u"s"_s}, locale);
    case Quantity::Degrees:
        return valueDigits(value, locale) + u'°';
    case Quantity::Variance:
        return withUnit(value, {.name = u"m²"_s}, locale);
    case Quantity::Growth:
        return withUnit(value, {.name = u"m²/s"_s}, locale);
    }
    return valueDigits(value, locale);
}

/** Rounded, as computed values are. */
QString computedText(const Amount& amount, const QLocale& locale)
{
    if (amount.quantity == Quantity::Seconds)
        return clockText(amount.value);
    if (amount.quantity == Quantity::Distance)
        return distanceText(amount.value, locale, 2);
    if (amount.quantity == Quantity::Speed)
        return u"%1 %2"_s.arg(
            valueDigits(std::round(100 * speedUnit().fromSi(amount.value)) / 100, locale),
            speedUnit().name);
    return quantityText(amount.quantity, amount.value, locale);
}

} // namespace

QString fieldWords(const char* english)
{
    return *english == 0 ? QString() : QCoreApplication::translate(kFieldContext, english);
}

QString fieldName(const std::string& field)
{
    const FieldName* const name = findField(field);
    return name == nullptr ? QString() : QCoreApplication::translate(name->context, name->label);
}

QString fieldValue(const std::string& field, const IssueArgument& value, const QLocale& locale)
{
    if (const auto* const count = std::get_if<std::int64_t>(&value))
        return locale.toString(static_cast<qlonglong>(*count));
    if (const auto* const text = std::get_if<std::string>(&value))
        return QString::fromStdString(*text);
    if (const auto* const amount = std::get_if<Amount>(&value))
        return computedText(*amount, locale);
    const FieldName* const name = findField(field);
    return quantityText(name == nullptr ? Quantity::Number : name->quantity,
                        std::get<double>(value), locale);
}

} // namespace berg
