#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Largest file any reader accepts, bytes. */
inline constexpr std::size_t kLargestFile = 64U << 20U;

/**
 * Whole content of a regular file. Throws `Error` FileNotFound, FileUnreadable (directory, no
 * permission) or FileTooLarge (over `kLargestFile`), subject = path; `Stopped` when asked to stop.
 */
[[nodiscard]] std::string readFile(const std::string& path, const std::stop_token& stop = {});

/**
 * Writes the file so that a reader sees the old or the new content, never a part: temporary file
 * in the same folder, flushed, then renamed over the target (a symbolic link keeps pointing, the
 * file it points to is replaced; permissions of an existing file are kept). Where the folder or the
 * file system refuses the temporary file or the renaming, the file itself is written over, after
 * the room for it was reserved. Devices, pipes and what is open already (/dev/stdout, /dev/fd/3)
 * are written to as they are. Throws `Error{FileUnwritable}`; then the old content is still there
 * (unless a device failed in the middle of writing it over) and no temporary file is left;
 * those that writers of the folder have left that were killed are removed.
 */
void writeFileAtomically(const std::string& path, std::string_view content);

/** Removes from the folder of this file what writers have left there that were killed. */
void removeLeftovers(const std::string& path);

/** The two halves of `writeFileAtomically`, for files that belong together: see `writeFileSet`. */
class StagedFile
{
public:
    /** Writes the content to the disk, beside the file. It must live until `place`. */
    StagedFile(const std::string& path, std::string_view content);
    /** The content is yet to come, by `append`; no more of it is kept in memory than 64 kB. */
    explicit StagedFile(const std::string& path);
    StagedFile(StagedFile&&) noexcept;
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;
    StagedFile& operator=(StagedFile&&) = delete;
    ~StagedFile();

    /** What goes wrong here, `complete` tells: a flight need not end for a disk that is full. */
    void append(std::string_view text);
    /** Then all of it is on the disk. Before `place` and `placeTogether`. */
    void complete();

    /** Puts it in the place of the file, at most once. */
    void place();
    /**
     * The same of several, the first ones as far as nothing is in the way, and even when this
     * program is killed meanwhile. How many; the others are to be placed one by one.
     */
    [[nodiscard]] static std::size_t placeTogether(std::span<StagedFile> files);
    /** Then: through a power cut. Slow, and so apart: those of a set take their places at once. */
    void makeLast() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/** Throws as `writeFileAtomically` would, as far as that can be known before; changes nothing. */
void checkWritable(const std::string& path);

/** Whether the path names what is open already, as /dev/stdout does. */
[[nodiscard]] bool isOpenDescriptor(std::string_view path);

} // namespace berg
