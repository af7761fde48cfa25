#pragma once

// Private to core/io: files that are being written, beside those whose place they will take.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <sys/stat.h>

namespace berg {

/** The folder that a file is in, as system calls want it. */
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

/** What is left to be done with a temporary file. */
struct Placing
{
    std::string link; ///< by which it can be given its name; empty: it has it
    std::string name;
    std::string target;
};

/**
 * Gives them their names and puts them in the places of their targets, in a process of its own: the
 * death of this one, however sudden, does not come between. How many have their places, the first
 * ones; less than all when one is refused, none when there is no such process to be had.
 */
[[nodiscard]] std::size_t placeApart(std::span<const Placing> placings);

/** Removes from the folder what writers have left that were killed: see `TemporaryFile`. */
void removeLeftTemporaries(const std::filesystem::path& folder);

/**
 * New file beside the target, removed again unless it was put in the target's place. Where the file
 * system can, it has no name until then: a program that is killed leaves nothing. Locked, which
 * tells it from one whose writer was killed. Its name is `.TARGET.PID-NUMBER.tmp`.
 */
class TemporaryFile
{
public:
    enum class Name
    {
        Late,
        Early
    };

    explicit TemporaryFile(const std::filesystem::path& target, Name name = Name::Late);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }
    [[nodiscard]] bool isNamed() const { return m_isNamed; }

    /** To write to, and to read again what was written. */
    [[nodiscard]] int descriptor() const { return m_fd; }
    /** To the disk, with all that was written; false leaves the reason in errno. */
    [[nodiscard]] bool flush() const;
    void copyAttributes(const struct stat& from) const;

    /** False when the folder refuses; without a name, also where there is no /proc. */
    [[nodiscard]] bool place();
    /** What `place` would do, for somebody else to do it, */
    [[nodiscard]] Placing placing() const;
    /** who has done it. */
    void notePlaced() { m_isNamed = m_placed = true; }

private:
    [[nodiscard]] std::filesystem::path nameOf(int number) const;
    [[nodiscard]] std::string link() const;
    /** The first free name that `make` can use. */
    template <class Make>
    bool acceptName(const Make& make);

    std::filesystem::path m_target;
    std::filesystem::path m_path;
    int m_fd = -1;
    bool m_isNamed = false;
    bool m_placed = false;
};

} // namespace berg
