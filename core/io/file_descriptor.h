#pragma once

// Private to core/io: POSIX file descriptors and loops over their system calls.

#include <array>
#include <cerrno>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace berg {

/** A POSIX file descriptor that closes itself. */
class Descriptor
{
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (m_fd >= 0)
            ::close(m_fd);
    }

    [[nodiscard]] int get() const { return m_fd; }
    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }
    /** Closes now. Returns false if the system reports that data were lost. */
    [[nodiscard]] bool close() { return ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd;
};

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
