#pragma once

#include "widgets/document/recovery_store.h"
#include "widgets/study/study_runner.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * Saves the flown part of a study while it is in no file, for recovery after a crash. Reads and
 * writes on its own thread; does nothing before `start`. GUI thread.
 */
class StudyAutosaver : public QObject
{
    Q_OBJECT

public:
    explicit StudyAutosaver(StudyRunner& runner, QObject* parent = nullptr);
    /** Removes the recovery, because the program ended normally, unless `keep` was called. */
    ~StudyAutosaver() override;

    /** Begins saving into `folder`, at most `interval_ms` after new results. */
    void start(const QString& folder, int interval_ms = 4000);
    /** Finds for recoveries of programs that no longer run; `found` may follow. */
    void findAbandoned();
    /** Updates the recovery after the study was saved. */
    void follow();
    /**
     * Writes at once, waits for the disk and leaves the recovery for the next start. To be called
     * when the program ends without asking the user.
     */
    void keep();
    /** Removes the recovery at once, because the user discards it. */
    void discard();

signals:
    /**
     * Emitted with the newest study found; its recovery stays until the study is saved or
     * discarded.
     */
    void found(const std::shared_ptr<const berg::Study>& study);
    void failed(const QString& report);
    /** Emitted with the path of a recovery that cannot be read; the file stays there. */
    void damaged(const QString& path);

private:
    void write();
    void drop();
    void read();
    void accept(const std::shared_ptr<const Study>& study, const QString& failure);

    StudyRunner& m_runner;
    QString m_folder; ///< empty before `start`
    std::optional<HeldRecovery> m_held;
    /** Whether `m_held` is being read; it is not removed, as the user has not seen it. */
    bool m_isReading = false;
    bool m_keep = false;
    QTimer m_timer;
    QThreadPool m_thread; ///< a single thread, so that jobs finish in the order they were started
};

} // namespace berg
