#pragma once

#include "widgets/document/recovery_store.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <optional>

namespace berg {

class ScenarioDocument;

/** Delays after which unsaved changes are written. */
struct AutosaveTimes
{
    int pause_ms = 2000;   ///< delay after the last change, ms
    int longest_ms = 5000; ///< longest delay after the first unwritten change, ms
};

/**
 * Writes a recovery of a document while it has changes that are in no file, valid or not, and of
 * the current flight. Serialises and writes on its own thread; does nothing before `start`. GUI
 * thread.
 */
class Autosaver : public QObject
{
    Q_OBJECT

public:
    explicit Autosaver(ScenarioDocument& document, QObject* parent = nullptr);
    /** Removes the recovery, because the program ended normally, unless `keep` was called. */
    ~Autosaver() override;

    /** Begins saving into `folder`, which is made if it is missing. */
    void start(const QString& folder, const AutosaveTimes& times = {});
    /** Returns the recoveries of programs that no longer run, or no recoveries before `start`. */
    [[nodiscard]] FoundRecoveries abandoned() const;
    /** Takes over a recovery whose scenario the document has already loaded, and its flight. */
    void adopt(HeldRecovery recovery, std::shared_ptr<const RunFile> run = {});
    /** Sets the current flight that is saved with the scenario; null if there is none. Ignored
     * before `start`. */
    void setRun(std::shared_ptr<const RunFile> run);
    /**
     * Writes at once, waits for the disk and leaves the recovery for the next start. To be called
     * when the program ends without asking the user.
     */
    void keep();
    /**
     * Removes the recovery before it returns, because the user discards unsaved work. Later changes
     * are saved again.
     */
    void discard();

signals:
    // These two may be emitted on the writing thread: connect with a context object.
    void autosaved(const QDateTime& time);
    void failed(const QString& report);
    /** Emitted when there are no unsaved changes any more. */
    void dropped();

private:
    [[nodiscard]] bool hasNothing() const;
    void follow();
    void drop();
    void write();

    ScenarioDocument& m_document;
    std::optional<RecoveryStore> m_store;
    std::optional<HeldRecovery> m_recovery; ///< created at the first change
    std::shared_ptr<const RunFile> m_run;
    bool m_keep = false;
    QTimer m_pause;
    QTimer m_longest;
    QThreadPool m_thread; ///< a single thread, so that jobs finish in the order they were started
};

} // namespace berg
