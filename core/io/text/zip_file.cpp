#include "core/io/text/zip_file.h"

#include "core/base/error.h"

#include <cstdint>
#include <limits>
#include <zlib.h>

namespace berg {

namespace {

/** Numbers of zip headers are little-endian. */
void add16(std::string& bytes, unsigned value)
{
    bytes += static_cast<char>(value & 0xFFU);
    bytes += static_cast<char>((value >> 8U) & 0xFFU);
}

void add32(std::string& bytes, std::size_t value)
{
    add16(bytes, static_cast<unsigned>(value & 0xFFFFU));
    add16(bytes, static_cast<unsigned>((value >> 16U) & 0xFFFFU));
}

/** Raw deflate, without the header of zlib. */
std::string deflated(std::string_view content)
{
    z_stream stream{};
    constexpr int kRawWindow = -15;
    constexpr int kMemoryLevel = 8;
    require(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRawWindow, kMemoryLevel,
                         Z_DEFAULT_STRATEGY) == Z_OK,
            "zlib cannot deflate");
    std::string bytes(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
    // zlib reads through a pointer that is not const unless asked otherwise, and does not write.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int ended = deflate(&stream, Z_FINISH);
    bytes.resize(stream.total_out);
    deflateEnd(&stream);
    require(ended == Z_STREAM_END, "zlib did not finish");
    return bytes;
}

/** What the two headers of an entry share. */
std::string entryOf(std::string_view name, std::string_view content, std::size_t packedSize)
{
    constexpr unsigned kVersion = 20; // deflate
    constexpr unsigned kUtf8Names = 1U << 11U;
    constexpr unsigned kDeflated = 8;
    constexpr unsigned kFirstDay = (1U << 5U) | 1U; // 1980-01-01, the earliest there is
    std::string bytes;
    add16(bytes, kVersion);
    add16(bytes, kUtf8Names);
    add16(bytes, kDeflated);
    add16(bytes, 0); // midnight
    add16(bytes, kFirstDay);
    add32(bytes, crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                       static_cast<uInt>(content.size())));
    add32(bytes, packedSize);
    add32(bytes, content.size());
    add16(bytes, static_cast<unsigned>(name.size()));
    add16(bytes, 0); // no extra field
    return bytes;
}

} // namespace

std::string zipFile(std::string_view entryName, std::string_view content)
{
    require(content.size() < std::numeric_limits<std::uint32_t>::max() / 2, "zipFile: too large");
    const std::string packed = deflated(content);
    const std::string entry = entryOf(entryName, content, packed.size());
    std::string file = "PK\x03\x04" + entry;
    (file += entryName) += packed;

    const std::size_t directoryAt = file.size();
    constexpr unsigned kMadeBy = 20;
    file += "PK\x01\x02";
    add16(file, kMadeBy);
    file += entry;
    add16(file, 0); // no comment
    add16(file, 0); // first disk
    add16(file, 0); // no attributes
    add32(file, 0);
    add32(file, 0); // where the entry starts
    file += entryName;
    const std::size_t directorySize = file.size() - directoryAt;

    file += "PK\x05\x06";
    add16(file, 0); // this disk
    add16(file, 0); // that of the directory
    add16(file, 1); // entries here
    add16(file, 1); // and in all
    add32(file, directorySize);
    add32(file, directoryAt);
    add16(file, 0); // no comment
    return file;
}

} // namespace berg
