#include "core/link/message/link_message.h"

#include "core/base/error.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace berg {

namespace {

const MessageSpec& knownSpec(MessageId id)
{
    const MessageSpec* spec = findMessage(static_cast<std::uint32_t>(id));
    require(spec != nullptr, "message in the table");
    return *spec;
}

std::uint64_t littleEndian(std::span<const std::uint8_t> bytes)
{
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
        value = value << 8U | bytes[i];
    return value;
}

void putLittleEndian(std::span<std::uint8_t> bytes, std::uint64_t value)
{
    for (std::uint8_t& byte : bytes) {
        byte = static_cast<std::uint8_t>(value & 0xFFU);
        value >>= 8U;
    }
}

bool isSignedType(FieldType type)
{
    return type == FieldType::I8 || type == FieldType::I16 || type == FieldType::I32 ||
           type == FieldType::I64;
}

/** Returns the bits of the nearest value that `type` can hold. */
std::uint64_t saturated(FieldType type, std::int64_t value)
{
    const std::size_t bits = 8 * bytesOf(type);
    if (bits == 64) // a negative value stands for u64 bits returned by integer()
        return static_cast<std::uint64_t>(value);
    const std::int64_t span = std::int64_t{1} << (isSignedType(type) ? bits - 1 : bits);
    const std::int64_t lowest = isSignedType(type) ? -span : 0;
    return static_cast<std::uint64_t>(std::clamp(value, lowest, span - 1));
}

} // namespace

LinkMessage::LinkMessage(MessageId id) : m_spec(&knownSpec(id)), m_payload(m_spec->fullLength) {}

LinkMessage::LinkMessage(const MessageSpec& spec, std::span<const std::uint8_t> payload)
    : m_spec(&spec), m_payload(spec.fullLength)
{
    std::copy_n(payload.begin(), std::min(payload.size(), m_payload.size()), m_payload.begin());
}

const MessageField& LinkMessage::fieldNamed(std::string_view name) const
{
    const auto found = std::find_if(m_spec->fields.begin(), m_spec->fields.end(),
                                    [&](const MessageField& field) { return field.name == name; });
    require(found != m_spec->fields.end(), m_spec->name + " has no field " + std::string(name));
    return *found;
}

std::size_t LinkMessage::placeOf(const MessageField& field, int index) const
{
    require(index >= 0 && index < std::max(field.count, 1), "index of " + field.name);
    return field.offset + bytesOf(field.type) * static_cast<std::size_t>(index);
}

bool LinkMessage::has(std::string_view field) const
{
    return std::any_of(m_spec->fields.begin(), m_spec->fields.end(),
                       [&](const MessageField& each) { return each.name == field; });
}

std::int64_t LinkMessage::integer(std::string_view field, int index) const
{
    const MessageField& spec = fieldNamed(field);
    require(spec.type != FieldType::F32, "integer field " + spec.name);
    const std::size_t bytes = bytesOf(spec.type);
    std::uint64_t value = littleEndian(std::span(m_payload).subspan(placeOf(spec, index), bytes));
    if (isSignedType(spec.type) && bytes < 8 && (value >> (8 * bytes - 1)) != 0)
        value |= ~std::uint64_t{0} << (8 * bytes); // extends the sign
    return static_cast<std::int64_t>(value);
}

double LinkMessage::real(std::string_view field, int index) const
{
    const MessageField& spec = fieldNamed(field);
    if (spec.type != FieldType::F32)
        return static_cast<double>(integer(field, index));
    const std::uint64_t bits =
        littleEndian(std::span(m_payload).subspan(placeOf(spec, index), bytesOf(spec.type)));
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
}

std::string LinkMessage::text(std::string_view field) const
{
    const MessageField& spec = fieldNamed(field);
    require(spec.type == FieldType::Char, "text field " + spec.name);
    const auto first = m_payload.begin() + static_cast<std::ptrdiff_t>(spec.offset);
    return {first, std::find(first, first + std::max(spec.count, 1), std::uint8_t{0})};
}

LinkMessage& LinkMessage::with(std::string_view field, std::int64_t value, int index)
{
    const MessageField& spec = fieldNamed(field);
    require(spec.type != FieldType::F32, "integer field " + spec.name);
    putLittleEndian(std::span(m_payload).subspan(placeOf(spec, index), bytesOf(spec.type)),
                    saturated(spec.type, value));
    return *this;
}

LinkMessage& LinkMessage::withReal(std::string_view field, double value, int index)
{
    const MessageField& spec = fieldNamed(field);
    require(spec.type == FieldType::F32, "float field " + spec.name);
    putLittleEndian(std::span(m_payload).subspan(placeOf(spec, index), bytesOf(spec.type)),
                    std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    return *this;
}

LinkMessage& LinkMessage::withText(std::string_view field, std::string_view text)
{
    const MessageField& spec = fieldNamed(field);
    require(spec.type == FieldType::Char, "text field " + spec.name);
    const auto room = static_cast<std::size_t>(std::max(spec.count, 1));
    const auto first = m_payload.begin() + static_cast<std::ptrdiff_t>(spec.offset);
    std::fill_n(first, room, std::uint8_t{0});
    std::copy_n(text.begin(), std::min(text.size(), room), first);
    return *this;
}

} // namespace berg
