#include "app/cli/study/study_file.h"

#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"

#include <algorithm>
#include <sys/stat.h>

namespace berg::cli {

namespace {

constexpr double kRetry_s = 30;

std::optional<FileStamp> stampOf(const std::string& path)
{
    struct stat found = {};
    if (::stat(path.c_str(), &found) != 0)
        return std::nullopt;
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    return FileStamp{.node = static_cast<std::int64_t>(found.st_ino),
                     .bytes = found.st_size,
                     .changed_ns = found.st_mtim.tv_sec * kPerSecond + found.st_mtim.tv_nsec};
}

} // namespace

StudyFile::StudyFile(std::string path, bool mayReplace)
    : m_path(std::move(path)), m_mayReplace(mayReplace)
{
}

Study StudyFile::open(StudySpec spec)
{
    if (!isStored())
        return {.spec = std::move(spec)};
    m_stamp = stampOf(m_path);
    if (!m_stamp)
        return {.spec = std::move(spec)};
    // Not `loadStudy`: a report, which that reads as well, would be replaced by a study file.
    Study found = studyFromJson(readFile(m_path), m_path);
    const std::string member = differingMember(found.spec, spec);
    if (member.empty())
        return found;
    if (!m_mayReplace)
        throw Error(ErrorCode::InvalidInput, m_path,
                    {{Severity::Error, member, {IssueId::FileOfOtherStudy}}});
    return {.spec = std::move(spec)};
}

void StudyFile::save(const Study& study)
{
    if (!isStored())
        return;
    checkUnchanged();
    write(study);
}

void StudyFile::checkUnchanged() const
{
    if (stampOf(m_path) != m_stamp)
        throw Error(ErrorCode::FileUnwritable, m_path, {IssueId::ChangedByOther});
}

void StudyFile::write(const Study& study)
{
    const Stopwatch watch;
    saveStudy(study, m_path);
    m_stamp = stampOf(m_path);
    constexpr double kInterval_s = 5;
    constexpr double kTimesTheCost = 30;
    m_next_s = m_running.elapsed_s() + std::max(kInterval_s, kTimesTheCost * watch.elapsed_s());
}

void StudyFile::saveSometimes(const Study& study)
{
    if (!isStored() || m_running.elapsed_s() < m_next_s)
        return;
    checkUnchanged();
    try {
        write(study);
    } catch (const Error& error) { // a full disk may have room again when the flying ends
        if (error.code() != ErrorCode::FileUnwritable)
            throw;
        m_next_s = m_running.elapsed_s() + kRetry_s;
    }
}

} // namespace berg::cli
