#include "core/io/files/field_rows.h"

#include "core/base/number_text.h"
#include "core/base/translate_noop.h"
#include "core/io/files/members.h"
#include "core/scenario/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace berg {

namespace {

constexpr const char* kNoDefault = QT_TRANSLATE_NOOP("berg::Fields", "none");
constexpr const char* kRequired = QT_TRANSLATE_NOOP("berg::Fields", "required");
constexpr const char* kOlderName = QT_TRANSLATE_NOOP("berg::Fields", "`%1` in older files.");

std::string withArgument(std::string text, const std::string& argument)
{
    if (const std::size_t place = text.find("%1"); place != std::string::npos)
        text.replace(place, 2, argument);
    return text;
}

/** Returns an exact number, with an exponent if that is clearly shorter: 1000, 1e6. */
std::string shortNumber(double number)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                   std::chars_format::scientific);
    std::string power(buffer.data(), end.ptr);
    for (const std::string_view filler : {"e+0", "e+"})
        if (const std::size_t place = power.find(filler); place != std::string::npos)
            power.replace(place, filler.size(), "e");
    const std::string digits = decimalText(number);
    return power.size() + 1 < digits.size() ? power : digits;
}

template <class T>
const T& standardObject()
{
    static const T standard;
    return standard;
}
template <>
const LatLon& standardObject()
{
    return standardObject<Scenario>().origin;
}

template <class T, class Value>
std::string standardText(const Field<T>& field, const Value& value, const FieldWords& said)
{
    if (field.traits.presence == Presence::Needed)
        return said(kRequired);
    const std::string_view noneText = field.traits.noneText;
    const char* const none = noneText.empty() ? kNoDefault : noneText.data();
    if constexpr (requires { value.has_value(); }) {
        if (!value)
            return said(none);
    } else if constexpr (std::is_same_v<Value, std::vector<Point>>) {
        return said(none);
    } else if constexpr (std::is_same_v<Value, double>) {
        if (field.traits.zeroIsNone && value == 0)
            return said(none);
    }
    return memberText(value);
}

template <class T, class Value>
std::string valuesText(const Field<T>& field, const Value& /*value*/)
{
    if constexpr (std::is_enum_v<Value>)
        return allowedNames(namesOf(Value{}));
    if (!field.limits || field.limits->high == std::numeric_limits<double>::max())
        return {};
    return (field.limits->above ? "> " : "") + shortNumber(field.limits->low) + " … " +
           shortNumber(field.limits->high);
}

template <class T>
std::string meaningText(const Field<T>& field, const FieldWords& said)
{
    const auto text = [&said](std::string_view english) {
        return english.empty() ? std::string() : said(english.data());
    };
    std::string meaning = text(field.traits.note != nullptr ? field.traits.note : field.help);
    if (field.traits.note == nullptr && *field.help2 != 0)
        meaning += ' ' + text(field.help2);
    meaning = withArgument(std::move(meaning), numberText(kLayerHeight_m) + " m");
    if (field.traits.olderName != nullptr)
        meaning += ' ' + withArgument(said(kOlderName), field.traits.olderName);
    return meaning;
}

} // namespace

std::vector<FieldRow> fieldRows(const FieldWords& said)
{
    std::vector<FieldRow> rows;
    const auto addParts = [&](std::string_view object) {
        for (const ObjectPart& part : objectParts())
            if (object.starts_with(std::string(part.path) + '.') &&
                std::ranges::find(rows, part.path, &FieldRow::field) == rows.end())
                rows.push_back({.field = std::string(part.path),
                                .standard = said(kNoDefault),
                                .values = {},
                                .meaning = said(part.meaning)});
    };
    forEachObject([&]<class T>(const std::string& object, std::span<const Field<T>> fields) {
        addParts(object);
        for (const Field<T>& field : fields)
            withField(field, standardObject<T>(), [&](const auto& value) {
                rows.push_back({.field = object + field.name,
                                .standard = standardText(field, value, said),
                                .values = valuesText(field, value),
                                .meaning = meaningText(field, said)});
            });
        addParts(object + "track.");
    });
    return rows;
}

std::string fieldTable()
{
    std::string table = "| field | default | values | meaning |\n|---|---|---|---|\n";
    for (const FieldRow& row : fieldRows([](const char* english) { return english; }))
        table += "| " + row.field + " | " + row.standard + " | " + row.values + " | " +
                 row.meaning + " |\n";
    return table;
}

} // namespace berg
