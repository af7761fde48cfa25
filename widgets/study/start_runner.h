#pragma once

#include "core/scenario/scenario.h"
#include "core/study/start_scan.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>

#include <memory>
#include <optional>

namespace berg {

/**
 * Compares start times of a scenario (`scanStarts`) on threads of its own; the GUI thread never
 * waits. A new scan replaces the one in progress; a cancelled one leaves no result. GUI thread.
 */
class StartRunner : public QObject
{
    Q_OBJECT

public:
    explicit StartRunner(QObject* parent = nullptr);

    /** Starts a scan and drops the result of the last one. */
    void start(const Scenario& scenario, const StartScanSpec& spec);
    void cancel();

    [[nodiscard]] bool isRunning() const { return m_isRunning; }
    /** Returns the result, or nullopt before the first scan, during one, and if one failed. */
    [[nodiscard]] const std::optional<StartScan>& scan() const { return m_scan; }
    /** Returns the scenario of the last scan. */
    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }

signals:
    /** Reports flights done and to do. */
    void progress(qulonglong done, qulonglong count);
    /** Emitted when a scan has begun or ended. `failure` is an error text, or empty. */
    void changed(const QString& failure);

private:
    struct Request
    {
        Scenario scenario;
        StartScanSpec spec;
    };
    struct Report
    {
        std::optional<StartScan> scan;
        std::size_t done = 0;
    };
    static void fly(const Request& request, const std::stop_token& stop,
                    const std::function<void(Report)>& deliver);
    void accept(Report report);

    Scenario m_scenario;
    std::optional<StartScan> m_scan;
    bool m_isRunning = false;
    std::size_t m_count = 0;
    LatestTask<Request, Report> m_task; ///< last member: its thread ends before the others
};

} // namespace berg
