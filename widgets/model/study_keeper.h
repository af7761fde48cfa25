#pragma once

#include "widgets/model/recovery_store.h"
#include "widgets/model/study_runner.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * Keeps what has been flown of a study as long as it is in no file, to be found again after a
 * crash. Reads and writes on a thread of its own; does nothing before `start`. GUI thread.
 */
class StudyKeeper : public QObject
{
    Q_OBJECT

public:
    explicit StudyKeeper(StudyRunner& runner, QObject* parent = nullptr);
    /** Removes what is kept, the end having come in order, unless `keep` was called. */
    ~StudyKeeper() override;

    /** A study is written at most `interval_ms` after something of it was flown. */
    void start(const QString& folder, int interval_ms = 4000);
    /** Looks for what programs left that are gone: `found` may follow. */
    void lookForAbandoned();
    /** After the study was saved. */
    void follow();
    /** The program is ended without a chance to ask: writes now, waits, leaves what is kept. */
    void keep();
    /** What is kept is given up: removes it now. */
    void discard();

signals:
    /** The newest that was left: it is kept on, and to be shown. */
    void found(const std::shared_ptr<const berg::Study>& study);
    void failed(const QString& report);
    /** Something that was left cannot be read. It is kept, here. */
    void damaged(const QString& path);

private:
    void write();
    void drop();
    void read();
    void take(const std::shared_ptr<const Study>& study, const QString& failure);

    StudyRunner& m_runner;
    QString m_folder; ///< empty: not started
    std::optional<HeldRecovery> m_held;
    bool m_isReading = false; ///< what is held then: nobody has seen it, so it is not given up
    bool m_keep = false;
    QTimer m_timer;
    QThreadPool m_thread; ///< one thread: jobs end in the order they were begun
};

} // namespace berg
