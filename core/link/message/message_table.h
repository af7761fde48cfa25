#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Type of a field's elements on the wire, little-endian. */
enum class FieldType : std::uint8_t
{
    Char,
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    U64,
    I64,
    F32
};

/** Returns the number of bytes of one element. */
[[nodiscard]] std::size_t bytesOf(FieldType type);

/** Returns the name of the type in MAVLink's XML files, such as "uint8_t". */
[[nodiscard]] std::string wireNameOf(FieldType type);

/** One field of a message. */
struct MessageField
{
    std::string name;
    FieldType type = FieldType::U8;
    int count = 0;          ///< Number of elements of an array; 0 for a single value.
    std::size_t offset = 0; ///< Offset in the payload, in bytes.
    bool isExtension = false;
};

/** One message of the protocol. */
struct MessageSpec
{
    std::uint32_t id = 0;
    std::string name;
    /** Included in the checksum, so that peers with other fields do not match. */
    std::uint8_t crcExtra = 0;
    std::size_t baseLength = 0;
    std::size_t fullLength = 0;       ///< Length with extensions, at most 255 bytes.
    std::vector<MessageField> fields; ///< In the order on the wire.
};

/** Returns every message that Bergwatch knows, by ascending id. May be called from any thread. */
[[nodiscard]] std::span<const MessageSpec> messageSpecs();

/** Returns the message with this id, or null if Bergwatch does not know it. */
[[nodiscard]] const MessageSpec* findMessage(std::uint32_t id);

} // namespace berg
