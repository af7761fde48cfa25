#pragma once

// Private to core/io: what may be longer than memory should hold, between being made and being
// written.

#include "core/io/temporary_file.h"
#include "core/io/text/text_sink.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace berg {

/**
 * Bytes that grow at the end and are read from any place. The last 64 kB are in memory, what came
 * before in a temporary file, which `TMPDIR` tells where to put. Throws `Error{FileUnwritable}`,
 * subject = that folder, where the file cannot be had, written or read.
 */
class Spool
{
public:
    void append(std::string_view bytes);
    /** Over what is there, and on behind it; `at` <= size(). */
    void write(std::size_t at, std::string_view bytes);
    [[nodiscard]] std::size_t size() const { return m_inFile + m_tail.size(); }
    /** How many bytes from `at` on there were, at most as many as there is room for. */
    std::size_t read(std::size_t at, std::span<char> into) const;
    void putAll(const TextSink& put) const;
    void clear();

private:
    void writeFile(std::size_t at, std::string_view bytes);

    std::unique_ptr<TemporaryFile> m_file;
    std::size_t m_inFile = 0;
    std::string m_tail;
};

} // namespace berg
