#pragma once

#include "core/scenario/fields.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/words/field_names.h"

#include <cmath>

namespace berg {

/**
 * Returns the value of a field as a number: itself, a component of a pair, or the index of an
 * enumerator; `none` for a missing optional.
 */
template <class Value>
[[nodiscard]] double shownNumber(const Value& held, [[maybe_unused]] int axis,
                                 [[maybe_unused]] double none)
{
    if constexpr (std::is_same_v<Value, Point>)
        return held[axis];
    else if constexpr (std::is_same_v<Value, std::optional<double>>)
        return held.value_or(none);
    else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
        return static_cast<double>(held);
    else
        return 0; // holds no number
}

/**
 * Sets a field from a number. `none` clears an optional; other values of it are raised to `least`.
 */
template <class Value>
void setNumber(Value& held, double number, [[maybe_unused]] int axis, [[maybe_unused]] double none,
               [[maybe_unused]] double least)
{
    if constexpr (std::is_same_v<Value, Point>)
        held[axis] = number;
    else if constexpr (std::is_same_v<Value, std::optional<double>>)
        held = number > none ? std::optional(std::max(number, least)) : std::nullopt;
    else if constexpr (std::is_same_v<Value, double>)
        held = number;
    else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
        held = static_cast<Value>(std::llround(number));
}

/** Makes inputs from the fields of the edited T; their keys are the paths of the fields. */
template <class T>
class FieldInputs
{
public:
    using IsShown = decltype(RowWords::isShown);

    /**
     * `path` is the prefix of the keys, as in "uavs."; the inputs are shown where `isShown` is
     * true, or always.
     */
    explicit FieldInputs(const char* path, IsShown isShown = {},
                         std::span<const Field<T>> fields = fieldsOf<T>())
        : m_path(QString::fromLatin1(path)), m_isShown(std::move(isShown)), m_fields(fields)
    {
    }

    /**
     * Returns the input of a number, or of a component of a pair, in SI; it has no unit text if the
     * user chooses the unit.
     */
    [[nodiscard]] NumberRow inSi(std::string_view name, int axis = 0) const
    {
        const Field<T>& field = fieldNamed(name);
        const Limits limits = field.limits.value_or(Limits{});
        const double lowest = lowestOf(field);
        return {
            .words = words(field, axis),
            .unit = siUnitText(field.quantity),
            .decimals = {.least = field.traits.leastDecimals, .most = field.traits.mostDecimals},
            .step = field.traits.step,
            .read =
                [&field, axis, lowest](const Scenario& scenario, const std::string& id) {
                    double number = 0;
                    if (const T* object = objectIn<T>(scenario, id))
                        withField(field, *object, [&](const auto& held) {
                            number = shownNumber(held, axis, lowest);
                        });
                    return number;
                },
            .write =
                [&field, axis, lowest, least = limits.low](Scenario& scenario,
                                                           const std::string& id, double number) {
                    if (T* object = objectIn<T>(scenario, id))
                        withField(field, *object, [&](auto& held) {
                            setNumber(held, number, axis, lowest, least);
                        });
                },
            .range = always({.low = lowest, .high = limits.high}),
            .lowestText = fieldWords(field.traits.noneText)};
    }
    /** Returns the input of a number, or of a component of a pair, in the user's unit. */
    [[nodiscard]] NumberRow number(std::string_view name, int axis = 0) const
    {
        return inUserUnit(inSi(name, axis), fieldNamed(name).quantity);
    }

    [[nodiscard]] TextRow text(std::string_view name) const
    {
        const Field<T>& field = fieldNamed(name);
        const auto place = std::get<std::string* (*)(T&)>(field.place);
        return {.words = words(field),
                .multiLine = field.traits.isLong,
                .read =
                    [&field](const Scenario& scenario, const std::string& id) {
                        std::string text;
                        if (const T* object = objectIn<T>(scenario, id))
                            withField(field, *object, [&](const auto& held) {
                                if constexpr (std::is_same_v<decltype(held), const std::string&>)
                                    text = held;
                            });
                        return text;
                    },
                .write =
                    [place](Scenario& scenario, const std::string& id, const std::string& text) {
                        if (T* object = objectIn<T>(scenario, id))
                            *place(*object) = text;
                    }};
    }

    [[nodiscard]] FlagRow flag(std::string_view name) const
    {
        const NumberRow number = inSi(name);
        return {
            .words = number.words,
            .read = [read = number.read](const Scenario& scenario,
                                         const std::string& id) { return read(scenario, id) != 0; },
            .write = [write = number.write](Scenario& scenario, const std::string& id,
                                            bool on) { write(scenario, id, on ? 1 : 0); }};
    }

    /**
     * Returns the input of an enumeration, with choices in the order of declaration, or of a flag
     * with two choices.
     */
    [[nodiscard]] PickRow choice(std::string_view name, const QStringList& choices) const
    {
        std::vector<PickRow::Option> options;
        for (const QString& choice : choices)
            options.push_back({.value = std::to_string(options.size()), .text = choice});
        const NumberRow number = inSi(name);
        return {.words = number.words,
                .options = [options](const Scenario&) { return options; },
                .read =
                    [read = number.read](const Scenario& scenario, const std::string& id) {
                        return std::to_string(std::lround(read(scenario, id)));
                    },
                .write =
                    [write = number.write](Scenario& scenario, const std::string& id,
                                           const std::string& chosen) {
                        write(scenario, id, std::stoi(chosen));
                    }};
    }

    /**
     * Returns the inputs of consecutive fields, both names included. Enumerations are skipped: they
     * need `choice`.
     */
    [[nodiscard]] std::vector<InspectorRow> rows(std::string_view first,
                                                 std::string_view last) const
    {
        std::vector<InspectorRow> rows;
        for (const Field<T>& field : between(m_fields, first, last)) {
            if (std::holds_alternative<std::string* (*)(T&)>(field.place))
                rows.emplace_back(text(field.name));
            else if (std::holds_alternative<bool* (*)(T&)>(field.place))
                rows.emplace_back(flag(field.name));
            else if (field.quantity != Quantity::Text)
                for (int axis = 0; axis < (isPair(field) ? 2 : 1); ++axis)
                    rows.emplace_back(number(field.name, axis));
        }
        return rows;
    }
    [[nodiscard]] std::vector<InspectorRow> rows(std::string_view name) const
    {
        return rows(name, name);
    }

    /** Returns key, label and help of a field, or of a component of a pair. */
    [[nodiscard]] RowWords words(std::string_view name, int axis = 0) const
    {
        return words(fieldNamed(name), axis);
    }

private:
    [[nodiscard]] const Field<T>& fieldNamed(std::string_view name) const
    {
        return between(m_fields, name, name).front();
    }

    /** Returns the lowest value; it stands for "none" if the field may be missing. */
    [[nodiscard]] static double lowestOf(const Field<T>& field)
    {
        const double low = field.limits ? field.limits->low : 0;
        const bool mayBeNone = field.traits.zeroIsNone ||
                               std::holds_alternative<std::optional<double>* (*)(T&)>(field.place);
        return mayBeNone ? std::min(low, 0.0) : low;
    }

    [[nodiscard]] RowWords words(const Field<T>& field, int axis = 0) const
    {
        const QString label = fieldWords(axis == 0 ? field.label : field.label2);
        QString help = fieldWords(axis == 0 ? field.help : field.help2);
        if (help.contains(QStringLiteral("%1")))
            help = help.arg(heightText(kLayerHeight_m, QLocale()));
        QString key = m_path + QString::fromLatin1(field.name);
        if (isPair(field))
            key += QStringLiteral("[%1]").arg(axis);
        return {.key = key,
                .label = label,
                .toolTip = help,
                .undoText = changeText(label),
                .isShown = m_isShown};
    }

    QString m_path;
    IsShown m_isShown;
    std::span<const Field<T>> m_fields;
};

} // namespace berg
