#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg::test {

/** Name and bytes of an entry. */
using StoredEntry = std::pair<std::string, std::string>;

inline std::uint32_t crc32Of(std::string_view bytes)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

/** A zip archive of several entries, not compressed. */
inline std::string storedZip(const std::vector<StoredEntry>& entries)
{
    const auto number = [](std::size_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i, value >>= 8U)
            text += static_cast<char>(value & 0xFFU);
        return text;
    };
    std::string archive;
    std::string directory;
    for (const auto& [name, bytes] : entries) {
        // Version, flags, method, time, date, checksum, sizes, lengths of name and extra field.
        const std::string head = number(20, 2) + number(0, 6) + number(0x21, 2) +
                                 number(crc32Of(bytes), 4) + number(bytes.size(), 4) +
                                 number(bytes.size(), 4) + number(name.size(), 2) + number(0, 2);
        directory +=
            "PK\x01\x02" + number(20, 2) + head + number(0, 10) + number(archive.size(), 4) + name;
        archive += "PK\x03\x04" + head + name + bytes;
    }
    return archive + directory + "PK\x05\x06" + number(0, 4) + number(entries.size(), 2) +
           number(entries.size(), 2) + number(directory.size(), 4) + number(archive.size(), 4) +
           number(0, 2);
}

} // namespace berg::test
