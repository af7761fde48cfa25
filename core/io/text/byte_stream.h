#pragma once

#include "core/base/error.h"

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace berg {

/** Values one after the other as bytes, for another process of this program; not for files. */
class ByteWriter
{
public:
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void add(const T& value)
    {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add(const std::string& text)
    {
        add(text.size());
        m_bytes += text;
    }
    [[nodiscard]] std::string done() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/** Reads what `ByteWriter` wrote, in the same order. Throws `std::logic_error` beyond the end. */
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}

    template <class T>
    requires std::is_trivially_copyable_v<T> T take()
    {
        require(m_bytes.size() >= sizeof(T), "ByteReader: beyond the end");
        T value;
        std::memcpy(&value, m_bytes.data(), sizeof value);
        m_bytes.remove_prefix(sizeof value);
        return value;
    }
    std::string takeText()
    {
        const auto size = take<std::size_t>();
        require(m_bytes.size() >= size, "ByteReader: beyond the end");
        std::string text(m_bytes.substr(0, size));
        m_bytes.remove_prefix(size);
        return text;
    }

private:
    std::string_view m_bytes;
};

} // namespace berg
