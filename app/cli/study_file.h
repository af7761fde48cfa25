#pragma once

#include "core/plan/solve/solver.h"
#include "core/study/study.h"

#include <optional>
#include <string>

namespace berg::cli {

/** Which content of a file was last seen, so that a change by another program is noticed. */
struct FileStamp
{
    std::int64_t node = 0;
    std::int64_t bytes = 0;
    std::int64_t changed_ns = 0;
    bool operator==(const FileStamp&) const = default;
};

/** The file of `--study`, in which a sweep keeps what it has flown. */
class StudyFile
{
public:
    /** An empty path keeps nothing. `mayReplace`: a file of another study. */
    StudyFile(std::string path, bool mayReplace);

    /**
     * The study of `spec` with what the file has of it. Throws `Error` when the file is no study,
     * or of another one and that is not to be replaced.
     */
    [[nodiscard]] Study open(StudySpec spec);

    /** Saves; throws `Error` when another program has written the file in the meantime. */
    void save(const Study& study);
    /** The same when the last time is so long ago that saving costs next to nothing; what cannot
     * be written is tried again later. */
    void saveSometimes(const Study& study);

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] bool isStored() const { return !m_path.empty(); }

private:
    void checkUnchanged() const;
    void write(const Study& study);

    std::string m_path;
    bool m_mayReplace;
    std::optional<FileStamp> m_stamp; ///< none: there was no file
    Stopwatch m_running;
    double m_next_s = 0;
};

} // namespace berg::cli
