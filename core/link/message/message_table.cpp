#include "core/link/message/message_table.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace berg {

namespace {

/** One row of messages.inc. */
struct MessageRow
{
    std::uint32_t id;
    std::string_view name;
    std::uint8_t crcExtra;
    std::size_t baseLength;
    std::size_t fullLength;
    std::string_view fields;
};

constexpr MessageRow kMessageRows[] = {
#include "core/link/message/messages.inc"
};

struct TypeRow
{
    FieldType type;
    std::string_view name;
    std::string_view wireName;
    std::size_t bytes;
};

constexpr std::array<TypeRow, 10> kTypeRows{{
    {FieldType::Char, "char", "char", 1},
    {FieldType::U8, "u8", "uint8_t", 1},
    {FieldType::I8, "i8", "int8_t", 1},
    {FieldType::U16, "u16", "uint16_t", 2},
    {FieldType::I16, "i16", "int16_t", 2},
    {FieldType::U32, "u32", "uint32_t", 4},
    {FieldType::I32, "i32", "int32_t", 4},
    {FieldType::U64, "u64", "uint64_t", 8},
    {FieldType::I64, "i64", "int64_t", 8},
    {FieldType::F32, "f32", "float", 4},
}};

const TypeRow& rowOf(FieldType type)
{
    return kTypeRows.at(static_cast<std::size_t>(type));
}

/** Parses a field such as "u16[10] voltages"; the caller sets its offset. */
MessageField fieldOf(std::string_view text)
{
    const std::size_t blank = text.find(' ');
    const std::string_view type = text.substr(0, blank);
    const std::size_t bracket = std::min(type.find('['), type.size());
    const auto row = std::find_if(kTypeRows.begin(), kTypeRows.end(), [&](const TypeRow& each) {
        return each.name == type.substr(0, bracket);
    });
    require(blank != std::string_view::npos && row != kTypeRows.end(), "field of messages.inc");
    MessageField field{.name = std::string(text.substr(blank + 1)), .type = row->type};
    if (bracket < type.size())
        std::from_chars(type.data() + bracket + 1, type.data() + type.size(), field.count);
    return field;
}

MessageSpec specOf(const MessageRow& row)
{
    MessageSpec spec{.id = row.id,
                     .name = std::string(row.name),
                     .crcExtra = row.crcExtra,
                     .baseLength = row.baseLength,
                     .fullLength = row.fullLength};
    constexpr std::string_view kSeparator = ", ";
    std::size_t offset = 0;
    bool isExtension = false;
    for (std::string_view rest = row.fields; !rest.empty();) {
        const std::size_t end = std::min(rest.find(kSeparator), rest.size());
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(std::min(end + kSeparator.size(), rest.size()));
        if (text == "ext") {
            isExtension = true;
            continue;
        }
        MessageField field = fieldOf(text);
        field.offset = offset;
        field.isExtension = isExtension;
        offset += bytesOf(field.type) * static_cast<std::size_t>(std::max(field.count, 1));
        spec.fields.push_back(std::move(field));
    }
    require(offset == row.fullLength, "length in messages.inc");
    return spec;
}

} // namespace

std::size_t bytesOf(FieldType type)
{
    return rowOf(type).bytes;
}

std::string wireNameOf(FieldType type)
{
    return std::string(rowOf(type).wireName);
}

std::span<const MessageSpec> messageSpecs()
{
    static const std::vector<MessageSpec> specs = [] {
        std::vector<MessageSpec> all;
        for (const MessageRow& row : kMessageRows)
            all.push_back(specOf(row));
        return all;
    }();
    return specs;
}

const MessageSpec* findMessage(std::uint32_t id)
{
    const std::span<const MessageSpec> specs = messageSpecs();
    const auto found = std::lower_bound(
        specs.begin(), specs.end(), id,
        [](const MessageSpec& spec, std::uint32_t wanted) { return spec.id < wanted; });
    return found != specs.end() && found->id == id ? &*found : nullptr;
}

} // namespace berg
