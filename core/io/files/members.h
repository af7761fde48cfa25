#pragma once

// Private to core/io: reads and writes the fields that `core/scenario/fields.h` lists.

#include "core/io/text/json_reader.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/fields.h"

#include <span>
#include <string>
#include <type_traits>

namespace berg {

/**
 * Reads the corners of a polygon, from 3 to `kMostAreaCorners`. Returns no corners if the member is
 * missing, and none after adding a fault if they cannot be read.
 */
[[nodiscard]] std::vector<Point> readCorners(ObjectReader& reader, const char* name);

/**
 * Reads a member into `value`, which keeps its value if the member is missing. A missing member
 * that is needed adds a fault; a faulty one adds a fault and empties a text, a list or an optional.
 */
template <class T, class Value>
void readMember(ObjectReader& reader, const Field<T>& field, Value& value)
{
    const char* const name = field.name;
    if constexpr (std::is_same_v<Value, double>)
        if (field.traits.olderName != nullptr)
            value = reader.number(field.traits.olderName, value);
    const Json* const json =
        field.traits.presence == Presence::Needed ? reader.need(name) : reader.find(name);
    if (json == nullptr)
        return;
    if constexpr (std::is_same_v<Value, double>) {
        // A missing member means no limit there, so a file that gives 0 is in error.
        const Limits above{.low = 0, .high = field.limits.value_or(Limits{}).high, .above = true};
        value = reader.number(name, value,
                              field.traits.zeroIsNone ? std::optional(above) : std::nullopt);
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
        value = reader.optionalNumber(name);
        if (field.traits.zeroIsNone && value == 0.0)
            value.reset();
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
        value = reader.whole(name, value, {.low = 0, .high = kLargestSeed});
    } else if constexpr (std::is_same_v<Value, bool>) {
        value = reader.boolean(name, value);
    } else if constexpr (std::is_same_v<Value, std::string>) {
        value = reader.text(name);
    } else if constexpr (std::is_same_v<Value, Point>) {
        value = reader.point(name, value);
    } else if constexpr (std::is_same_v<Value, std::optional<Point>>) {
        value = pointOf(*json, reader.path(name), reader.faults());
    } else if constexpr (std::is_same_v<Value, std::vector<Point>>) {
        value = readCorners(reader, name);
    } else {
        value = reader.choice(name, value, namesOf(value));
    }
}

/** Reads all of `fields` into `object`. */
template <class T>
void readFields(ObjectReader& reader, std::span<const Field<T>> fields, T& object)
{
    for (const Field<T>& field : fields)
        withField(field, object, [&](auto& value) { readMember(reader, field, value); });
}

/** Returns the JSON text of the value of a field; "null" for an optional without a value. */
template <class Value>
[[nodiscard]] std::string memberText(const Value& value)
{
    if constexpr (std::is_enum_v<Value>)
        return jsonText(nameOf(namesOf(value), value));
    else if constexpr (std::is_same_v<Value, std::vector<Point>>)
        return jsonArrayOf(value);
    else if constexpr (requires { value.has_value(); })
        return value ? jsonText(*value) : "null";
    else
        return jsonText(value);
}

/** Adds all of `fields` to `object`; optional ones with the value of `T()` are left out. */
template <class T>
void writeFields(JsonObject& object, std::span<const Field<T>> fields, const T& from)
{
    static const T standard;
    for (const Field<T>& field : fields)
        if (field.traits.presence != Presence::UnlessDefault || !isEqual(field, from, standard))
            withField(field, from,
                      [&](const auto& value) { object.addText(field.name, memberText(value)); });
}

} // namespace berg
