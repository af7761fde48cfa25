#pragma once

#include "widgets/study/study_runner.h"

#include <functional>

namespace berg {

/**
 * Reads and writes studies, their reports and tables on its own thread, also while a study is
 * flown; the GUI thread never waits. GUI thread.
 */
class StudyFiles : public QObject
{
    Q_OBJECT

public:
    explicit StudyFiles(QObject* parent = nullptr);
    /** Waits until pending files are on disk. */
    ~StudyFiles() override;

    /** Opens a study file, or a report that contains a study; `opened` or `failed` follows. */
    void open(const QString& path);
    /** Writes a study file; `saved` with the same `point` or `failed` follows. */
    void save(const StudyPointer& result, const StudySavePoint& point, const QString& path);
    /**
     * Writes a page with images, scenarios, seeds, version and machine. `elapsed_s` is the flying
     * time; nullopt if unknown.
     */
    void writeReport(const StudyPointer& result, std::optional<double> elapsed_s,
                     const QString& path);
    /** Writes a table with a row for each setting. */
    void writeTable(const StudyPointer& result, const QString& path);

signals:
    void opened(const std::shared_ptr<const berg::Study>& study);
    void saved(const QString& path, const berg::StudySavePoint& point);
    /** Emitted when a report or table was written. */
    void written(const QString& path);
    /** Reports to the user why a file could not be read or written. */
    void failed(const QString& report);

private:
    /** Emits the result of a job on the GUI thread. */
    using Notification = std::function<void()>;
    /** Runs a job on the thread, in order; exceptions are reported by `failed`. */
    void post(const std::function<Notification()>& job);
    void write(const QString& path, const std::function<std::string()>& content);

    WorkThread m_thread;
};

} // namespace berg
