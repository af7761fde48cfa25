#pragma once

// Private to core/io: a buffer for content that may be larger than memory should hold.

#include "core/io/temporary_file.h"
#include "core/io/text/text_sink.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace berg {

/**
 * Byte buffer that grows at the end and is read at any position. The last 64 kB are in memory and
 * the rest in a temporary file in the folder `TMPDIR`. Every function throws
 * `Error{FileUnwritable}` with that folder as subject if the file cannot be created, written or
 * read.
 */
class FileBackedBuffer
{
public:
    /** Adds the bytes at the end. */
    void append(std::string_view bytes);
    /**
     * Overwrites from `at` on and extends the end if needed. Throws `std::logic_error` if `at` is
     * beyond `size()`.
     */
    void write(std::size_t at, std::string_view bytes);
    [[nodiscard]] std::size_t size() const { return m_inFile + m_tail.size(); }
    /**
     * Copies bytes from `at` on into `into` and returns how many: fewer than its size only at the
     * end.
     */
    std::size_t read(std::size_t at, std::span<char> into) const;
    /** Passes the whole content to `put`, piece by piece. */
    void putAll(const TextSink& put) const;
    /** Empties the buffer; the temporary file is reused. */
    void clear();

private:
    void writeFile(std::size_t at, std::string_view bytes);

    std::unique_ptr<TemporaryFile> m_file;
    std::size_t m_inFile = 0;
    std::string m_tail;
};

} // namespace berg
