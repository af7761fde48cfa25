#pragma once

#include "core/plan/solve/solver.h"
#include "core/study/study.h"

#include <optional>
#include <string>

namespace berg::cli {

/** Identifies the last known content of a file, to detect changes by other programs. */
struct FileStamp
{
    std::int64_t node = 0;
    std::int64_t bytes = 0;
    std::int64_t changed_ns = 0;
    bool operator==(const FileStamp&) const = default;
};

/** The file of `--study`, in which a sweep stores its outcomes. */
class StudyFile
{
public:
    /** With an empty path nothing is stored. `mayReplace` allows to replace the file of another
     * study. */
    StudyFile(std::string path, bool mayReplace);

    /**
     * Returns the study of `spec` with the outcomes in the file. Throws `Error` if the file is no
     * study, or belongs to another study and must not be replaced.
     */
    [[nodiscard]] Study open(StudySpec spec);

    /** Saves the study. Throws `Error` if another program has written the file in the meantime. */
    void save(const Study& study);
    /** Saves the study if the last save is so long ago that the cost is negligible. A failure to
     * write is ignored and tried again later. */
    void saveSometimes(const Study& study);

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] bool isStored() const { return !m_path.empty(); }

private:
    void checkUnchanged() const;
    void write(const Study& study);

    std::string m_path;
    bool m_mayReplace;
    std::optional<FileStamp> m_stamp; ///< nullopt if there was no file
    Stopwatch m_running;
    double m_next_s = 0;
};

} // namespace berg::cli
