#pragma once

// Private to core/io: loops over the system calls of file descriptors.

#include "core/base/descriptor.h"

#include <array>
#include <cerrno>
#include <string_view>
#include <unistd.h>

namespace berg {

/** Writes all of `content` to `fd`. Returns false on failure, with the reason in errno. */
[[nodiscard]] inline bool writeAll(int fd, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t written = ::write(fd, content.data(), content.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/**
 * Copies all of `from`, which must be seekable, to `to`. Returns false on failure, with the reason
 * in errno.
 */
[[nodiscard]] inline bool copyAll(int from, int to)
{
    std::array<char, 1U << 16U> piece{};
    for (off_t at = 0;;) {
        const ssize_t got = ::pread(from, piece.data(), piece.size(), at);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return got == 0;
        at += got;
        if (!writeAll(to, {piece.data(), static_cast<std::size_t>(got)}))
            return false;
    }
}

} // namespace berg
