#pragma once

// Private to core/io: temporary files beside the files that they will replace.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <sys/stat.h>

namespace berg {

/** Returns the folder that holds `file`; "." for a name without a folder. */
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

/** Pending rename of a complete temporary file to its target. */
struct Placing
{
    std::string link; ///< path to link `name` to; empty if `name` already exists
    std::string name;
    std::string target;
};

/**
 * Names the files and renames them to their targets in a child process, so that even the sudden
 * death of this process does not leave a part of them renamed. Returns how many of the first files
 * were renamed: fewer than all if the system refuses one, 0 if the child process cannot be started.
 */
[[nodiscard]] std::size_t placeInChildProcess(std::span<const Placing> placings);

/** Removes the temporary files of `folder` whose writers were killed; see `TemporaryFile`. */
void removeLeftTemporaries(const std::filesystem::path& folder);

/**
 * New file beside the target that is removed again unless `place` renames it to the target. Where
 * the file system allows it, the file has no name until then, so that a killed program leaves
 * nothing behind. A lock marks it as being written; an unlocked one belongs to a killed writer. Its
 * name is `.TARGET.PID-NUMBER.tmp`.
 */
class TemporaryFile
{
    /** When the file gets its name: at `place` where possible, or at once. */
public:
    enum class Name
    {
        Late,
        Early
    };

    /** Creates the file; check `isOpen` for success. */
    explicit TemporaryFile(const std::filesystem::path& target, Name name = Name::Late);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }
    [[nodiscard]] bool isNamed() const { return m_isNamed; }

    /** Returns the descriptor for writing and for reading back what was written. */
    [[nodiscard]] int descriptor() const { return m_fd; }
    /**
     * Flushes all that was written to the disk. Returns false on failure, with the reason in errno.
     */
    [[nodiscard]] bool flush() const;
    /** Gives the file the owner (where permitted) and the permissions of `from`. */
    void copyAttributes(const struct stat& from) const;

    /**
     * Renames the file to its target. Returns false if the folder refuses, or if the file has no
     * name yet and there is no /proc to name it through.
     */
    [[nodiscard]] bool place();
    /** Returns the rename that `place` would do, for `placeInChildProcess`. */
    [[nodiscard]] Placing placing() const;
    /** Records that another process has renamed the file. */
    void notePlaced() { m_isNamed = m_placed = true; }

private:
    [[nodiscard]] std::filesystem::path nameOf(int number) const;
    [[nodiscard]] std::string link() const;
    /**
     * Calls `make` with one free name after another until it succeeds or fails for another reason
     * than an existing file.
     */
    template <class Make>
    bool acceptName(const Make& make);

    std::filesystem::path m_target;
    std::filesystem::path m_path;
    int m_fd = -1;
    bool m_isNamed = false;
    bool m_placed = false;
};

} // namespace berg
