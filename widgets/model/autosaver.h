#pragma once

#include "widgets/model/recovery_store.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <optional>

namespace berg {

class ScenarioDocument;

/** When unsaved changes are written. */
struct AutosaveTimes
{
    int pause_ms = 2000;   ///< after the last change
    int longest_ms = 5000; ///< after the first, however much is changed
};

/**
 * Keeps a recovery of a document as long as it has changes that are in no file, whether it can be
 * flown or not, and of a flight as long as it is under way. Serialises and writes on a thread of
 * its own; does nothing before `start`. GUI thread.
 */
class Autosaver : public QObject
{
    Q_OBJECT

public:
    explicit Autosaver(ScenarioDocument& document, QObject* parent = nullptr);
    /** Removes the recovery, the end having come in order, unless `keep` was called. */
    ~Autosaver() override;

    void start(const QString& folder, const AutosaveTimes& times = {});
    /** Recoveries of programs that are gone; none before `start`. */
    [[nodiscard]] FoundRecoveries abandoned() const;
    /** Carries on with a recovery whose scenario the document has taken over, and its flight. */
    void adopt(HeldRecovery recovery, std::shared_ptr<const RunFile> run = {});
    /** How far a flight is; null: none is under way. */
    void setRun(std::shared_ptr<const RunFile> run);
    /** The program is ended without a chance to ask: writes now, waits, leaves the recovery. */
    void keep();
    /** The user gives up what is unsaved: it is not there any more when this returns. A change
     * made after that is kept again. */
    void discard();

signals:
    // The first two may come from the thread that writes: connect with a context object.
    void autosaved(const QDateTime& time);
    void failed(const QString& report);
    /** Nothing is unsaved any more. */
    void dropped();

private:
    [[nodiscard]] bool hasNothing() const;
    void follow();
    void drop();
    void write();

    ScenarioDocument& m_document;
    std::optional<RecoveryStore> m_store;
    std::optional<HeldRecovery> m_recovery; ///< made at the first change
    std::shared_ptr<const RunFile> m_run;
    bool m_keep = false;
    QTimer m_pause;
    QTimer m_longest;
    QThreadPool m_thread; ///< one thread: jobs end in the order they were begun
};

} // namespace berg
