#pragma once

#include "app/layout/window_part.h"
#include "widgets/document/autosaver.h"

#include <QDateTime>

namespace berg {

class ResultFiles;
class ScenarioFiles;
class BenchmarkController;
class StatusLine;
class StudyController;

/** Nothing is lost: recovery, logging out, files that others have changed. */
class UnsavedWorkGuard : public WindowPart
{
    Q_OBJECT

public:
    /** Questions before work is discarded. */
    struct CloseGuards
    {
        ScenarioFiles& files;
        ResultFiles& results;
        StudyController& study;
        BenchmarkController& solveTimes;
    };
    UnsavedWorkGuard(WindowContext& context, const CloseGuards& gates, StatusLine& status);

    /** Offers the unsaved work of programs that ended unexpectedly; returns false if there is none.
     */
    bool offerRecoveries();
    /** The user logs out; false: not now. Without a question what is unsaved is left to recovery.
     * The answer holds until the window is closed by the end of the program, which follows,
     * or used again. */
    [[nodiscard]] bool mayEndSession(bool mayAsk);
    /** Asks about all unsaved work; returns true if the window may close. */
    [[nodiscard]] bool mayClose();
    void takeOver(const UnsavedWorkGuard& other) { m_reloadRefused = other.m_reloadRefused; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool confirmDiscardScenario();
    void connectAutosaver();
    void followEnd(const QEvent& event);
    void restore(FoundRecovery found);
    void showDamaged(const QString& path);
    void checkFile();

    CloseGuards m_gates;
    StatusLine& m_status;
    bool m_endAgreed = false;  ///< the user logs out, and has not come back since
    bool m_ends = false;       ///< all windows are being closed for that
    bool m_asksReload = false; ///< the question is on screen
    QDateTime m_reloadRefused; ///< of this change of the file
};

} // namespace berg
