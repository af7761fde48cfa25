#pragma once

#include "core/link/message/byte_link.h"

#include <QFile>
#include <QString>

#include <span>
#include <string>

namespace berg {

/** The telemetry log that is written while a link runs. */
struct LogReport
{
    std::string path; ///< empty while nothing is written
    std::uint64_t bytes = 0;
    std::string fault; ///< reason why writing has ended, in the system's words; empty if it has not
    bool isFull = false; ///< writing has ended at `LinkLog::kLargest_bytes`
};

/**
 * Writes every frame sent and received to a telemetry log (tlog), as other ground stations do. The
 * file is created with the first frame. After a failure, such as a full disk, nothing more is
 * written, and the report says why. Used by one thread.
 */
class LinkLog
{
public:
    /** Writes to `path`, behind what is there; its folder is created. */
    explicit LinkLog(const QString& path) : m_file(path) {}

    /** Returns a path in the folder that no file has, named after the present time. */
    [[nodiscard]] static QString newPathIn(const QString& folder);

    void add(LinkTime now, std::span<const std::uint8_t> frame);
    /** Passes what was added to the system. */
    void flush();
    [[nodiscard]] const LogReport& report() const { return m_report; }

    static constexpr std::uint64_t kLargest_bytes = std::uint64_t{1} << 30U;

private:
    [[nodiscard]] bool isEnded() const { return m_report.isFull || !m_report.fault.empty(); }
    void fail();

    QFile m_file;
    LogReport m_report;
};

} // namespace berg
