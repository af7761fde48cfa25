#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Largest file that any reader accepts, in bytes, before `readLimit` multiplies it. */
inline constexpr std::size_t kLargestFile = 64U << 20U;

/**
 * Reads the whole content of a regular file or an open descriptor (/dev/stdin). Throws `Error`
 * FileNotFound, FileUnreadable (directory, pipe, no permission) or FileTooLarge (over
 * `readLimit(kLargestFile)`) with the path as subject, and `Stopped` if `stop` is requested.
 */
[[nodiscard]] std::string readFile(const std::string& path, const std::stop_token& stop = {});
/**
 * Passes the content of a file to `use` in pieces of at most 64 KiB and returns its size. Throws as
 * `readFile`, but FileTooLarge over `readLimit(most)` bytes, and what `use` throws.
 */
std::size_t readPieces(const std::string& path, std::size_t most,
                       const std::function<void(std::string_view)>& use,
                       const std::stop_token& stop = {});

/**
 * Writes the file so that a reader sees either the old or the new content, never a part. The
 * content goes to a temporary file in the same folder, is flushed and then renamed over the target.
 * A symbolic link keeps pointing: the file it points to is replaced. Permissions of an existing
 * file are kept. Where the folder or the file system refuses the temporary file or the rename, the
 * file itself is overwritten after the disk space was reserved. Devices, pipes and open descriptors
 * (/dev/stdout, /dev/fd/3) are written to directly.
 * Throws `Error{FileUnwritable}`; the old content is then still there (unless a device failed while
 * being overwritten) and no temporary file is left. Also removes temporary files of killed writers
 * from the folder.
 */
void writeFileAtomically(const std::string& path, std::string_view content);

/**
 * Removes temporary files of killed writers from the folder of `path`. Throws
 * `Error{FileUnwritable}` if its symbolic links form a loop.
 */
void removeLeftovers(const std::string& path);

/**
 * Splits `writeFileAtomically` into writing and renaming, for files that belong together; see
 * `writeFileSet`.
 */
class StagedFile
{
public:
    /**
     * Writes the content to the disk, beside the file. `content` must live until `place`. Throws
     * `Error{FileUnwritable}`.
     */
    StagedFile(const std::string& path, std::string_view content);
    /**
     * Starts a file whose content follows through `append`; about 64 kB of it are in memory. Throws
     * `Error{FileUnwritable}` if the path cannot be written.
     */
    explicit StagedFile(const std::string& path);
    StagedFile(StagedFile&&) noexcept;
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;
    StagedFile& operator=(StagedFile&&) = delete;
    ~StagedFile();

    /**
     * Adds to the content. Errors are thrown by `complete` only, so a full disk does not end a
     * flight.
     */
    void append(std::string_view text);
    /**
     * Flushes the content to the disk, before `place` or `placeTogether`. Throws
     * `Error{FileUnwritable}`.
     */
    void complete();

    /**
     * Renames the staged file to its target, or overwrites the target where that is refused. It may
     * be called once. Throws `Error{FileUnwritable}`.
     */
    void place();
    /**
     * Renames several staged files, in order, up to the first that is refused or cannot be renamed;
     * the renames continue even if this program is killed meanwhile. Returns how many were renamed;
     * call `place` for each of the others.
     */
    [[nodiscard]] static std::size_t placeTogether(std::span<StagedFile> files);
    /**
     * Flushes the folder after `place`, so that the rename survives a power cut. This is slow, so a
     * set of files is renamed first and flushed afterwards.
     */
    void makeDurable() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/**
 * Checks whether the path can be written, as far as that can be known in advance, and changes
 * nothing. Throws `Error{FileUnwritable}` as `writeFileAtomically` would.
 */
void checkWritable(const std::string& path);

/** Returns true if the path names a descriptor that is open already, such as /dev/stdout. */
[[nodiscard]] bool isOpenDescriptor(std::string_view path);

} // namespace berg
