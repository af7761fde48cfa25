#pragma once

// Private to core/io: reads and writes the fields that `core/scenario/fields.h` lists.

#include "core/io/files/scenario_parts.h"
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
 * Reads the value of a member that is present; limits are those of a number. A faulty one adds a
 * fault; it empties a text, a list or an optional, and leaves other values unchanged.
 */
template <class Value>
void readValue(ObjectReader& reader, const char* name, Value& value,
               const std::optional<Limits>& limits = {})
{
    if constexpr (std::is_same_v<Value, double>)
        value = reader.number(name, value, limits);
    else if constexpr (std::is_same_v<Value, std::optional<double>>)
        value = reader.optionalNumber(name, limits);
    else if constexpr (std::is_same_v<Value, std::int64_t>)
        value = reader.whole(name, value, {.low = 0, .high = kLargestSeed});
    else if constexpr (std::is_same_v<Value, bool>)
        value = reader.boolean(name, value);
    else if constexpr (std::is_same_v<Value, std::string>)
        value = reader.text(name);
    else if constexpr (std::is_same_v<Value, Point>)
        value = reader.point(name, value);
    else if constexpr (std::is_same_v<Value, std::optional<Point>>)
        value = pointOf(*reader.find(name), reader.path(name), reader.faults());
    else if constexpr (std::is_same_v<Value, std::vector<Point>>)
        value = readCorners(reader, name);
    else if constexpr (requires { value.emplace(); })
        readValue(reader, name, value.emplace());
    else
        value = reader.choice(name, value, namesOf(value));
}

/**
 * Reads the member of a field into `value`, which keeps its value if the member is missing. A
 * missing member that is needed adds a fault.
 */
template <class T, class Value>
void readMember(ObjectReader& reader, const Field<T>& field, Value& value)
{
    const char* const name = field.name;
    std::optional<Limits> limits;
    if constexpr (std::is_same_v<Value, double>) {
        if (field.traits.olderName != nullptr)
            value = reader.number(field.traits.olderName, value);
        // A missing member means no limit there, so a file that gives 0 is in error.
        if (field.traits.zeroIsNone)
            limits = {.low = 0, .high = field.limits.value_or(Limits{}).high, .above = true};
    }
    const bool isNeeded = field.traits.presence == Presence::Needed;
    if ((isNeeded ? reader.need(name) : reader.find(name)) == nullptr)
        return;
    readValue(reader, name, value, limits);
    if constexpr (std::is_same_v<Value, std::optional<double>>)
        if (field.traits.zeroIsNone && value == 0.0)
            value.reset();
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
        return value ? memberText(*value) : "null";
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

/** How a member that is not a field of a scenario is read and written. */
struct MemberRule
{
    std::optional<Limits> limits{}; ///< limits of a number
    bool isNeeded = false;          ///< whether a file without it is rejected
    bool isWritten = true;          ///< false for a value that a missing member has as well
};

/** Reads the members that a function names one by one; `MemberWriter` writes the same ones. */
struct MemberReader
{
    ObjectReader& object;

    /** Reads a value, which stays as it is if the member is missing. */
    template <class Value>
    void operator()(const char* name, Value& value, const MemberRule& rule = {})
    {
        if (has(name, rule))
            readValue(object, name, value, rule.limits);
    }
    /** Reads a whole number of any type or an optional one. */
    template <class Whole>
    void whole(const char* name, Whole& value, const WholeLimits& limits,
               const MemberRule& rule = {})
    {
        if (!has(name, rule))
            return;
        if constexpr (requires { value.emplace(limits.low); })
            value.emplace(object.whole(name, limits.low, limits));
        else
            value = static_cast<Whole>(object.whole(name, value, limits));
    }
    /** Reads an object whose members `members(reader, value)` names. */
    template <class Object, class Name>
    void part(const char* name, std::optional<Object>& value, const Name& members)
    {
        const Json* const json = object.find(name);
        if (json == nullptr)
            return;
        ObjectReader inner(*json, object.path(name), object.faults());
        members(MemberReader{inner}, value.emplace());
    }
    /** Reads an object of a scenario file. */
    template <class Object>
    void one(const char* name, Object& held)
    {
        if (const Json* value = object.find(name))
            held = readObject<Object>(*value, object.path(name), object.faults());
    }
    template <class Object>
    void one(const char* name, std::optional<Object>& held)
    {
        if (object.find(name) != nullptr)
            one(name, held.emplace());
    }

private:
    [[nodiscard]] bool has(const char* name, const MemberRule& rule)
    {
        return (rule.isNeeded ? object.need(name) : object.find(name)) != nullptr;
    }
};

/** Writes the members that a function names one by one, except optionals without a value. */
struct MemberWriter
{
    JsonObject& object;

    template <class Value>
    void operator()(const char* name, const Value& value, const MemberRule& rule = {})
    {
        if constexpr (requires { value.has_value(); })
            if (!value)
                return;
        if (rule.isWritten)
            object.addText(name, memberText(value));
    }
    template <class Whole>
    void whole(const char* name, const Whole& value, const WholeLimits& /*limits*/,
               const MemberRule& rule = {})
    {
        (*this)(name, value, rule);
    }
    template <class Object, class Name>
    void part(const char* name, const std::optional<Object>& value, const Name& members)
    {
        if (!value)
            return;
        JsonObject inner;
        members(MemberWriter{inner}, *value);
        object.addText(name, inner.inLine());
    }
    /** Writes an object of a scenario file unless it has its default value. */
    template <class Object>
    void one(const char* name, const Object& held)
    {
        if (held != Object())
            object.addText(name, objectText(held));
    }
    template <class Object>
    void one(const char* name, const std::optional<Object>& held)
    {
        if (held)
            object.addText(name, objectText(*held));
    }
};

} // namespace berg
