#pragma once

#include "widgets/model/study_runner.h"

#include <functional>

namespace berg {

/**
 * Reads and writes studies, their reports and tables on a thread of its own, also while one is
 * being flown; the GUI thread never waits. GUI thread.
 */
class StudyFiles : public QObject
{
    Q_OBJECT

public:
    explicit StudyFiles(QObject* parent = nullptr);
    /** Waits until what is being written is on disk. */
    ~StudyFiles() override;

    /** A study file, or a report that holds one. */
    void open(const QString& path);
    void save(const StudyPointer& result, const StudySavePoint& point, const QString& path);
    /**
     * A page with pictures, scenarios, seeds, version and machine; `elapsed_s` of the flying, none:
     * not known.
     */
    void writeReport(const StudyPointer& result, std::optional<double> elapsed_s,
                     const QString& path);
    /** A row for each setting. */
    void writeTable(const StudyPointer& result, const QString& path);

signals:
    void opened(const std::shared_ptr<const berg::Study>& study);
    void saved(const QString& path, const berg::StudySavePoint& point);
    /** A report or a table. */
    void written(const QString& path);
    /** Why it could not be read or written, in the user's words. */
    void failed(const QString& report);

private:
    /** Tells what came of a job, on the thread of the GUI. */
    using Tell = std::function<void()>;
    /** Does it on the thread, in turn; what it throws is told. */
    void post(const std::function<Tell()>& job);
    void write(const QString& path, const std::function<std::string()>& content);

    WorkThread m_thread;
};

} // namespace berg
