#pragma once

#include "app/window/window_part.h"
#include "widgets/model/autosaver.h"

#include <QDateTime>

namespace berg {

class ResultFiles;
class ScenarioFiles;
class SolveTimeDesk;
class StatusLine;
class StudyDesk;

/** Nothing is lost: recovery, logging out, files that others have changed. */
class WorkSafety : public WindowPart
{
    Q_OBJECT

public:
    /** What is asked before work goes. */
    struct Gates
    {
        ScenarioFiles& files;
        ResultFiles& results;
        StudyDesk& study;
        SolveTimeDesk& solveTimes;
    };
    WorkSafety(WindowContext& context, const Gates& gates, StatusLine& status);

    /** Unsaved work of programs that ended unexpectedly; false, and no question: there is none. */
    bool offerRecoveries();
    /** See `MainWindow`. */
    [[nodiscard]] bool mayEndSession(bool mayAsk);
    /** All that is unsaved is asked about; true: the window may close. */
    [[nodiscard]] bool mayClose();
    void takeOver(const WorkSafety& other) { m_reloadRefused = other.m_reloadRefused; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool mayLeaveScene();
    void connectAutosaver();
    void followEnd(const QEvent& event);
    void restore(FoundRecovery found);
    void showDamaged(const QString& path);
    void checkFile();

    Gates m_gates;
    StatusLine& m_status;
    bool m_endAgreed = false;  ///< the user logs out, and has not come back since
    bool m_ends = false;       ///< all windows are being closed for that
    bool m_asksReload = false; ///< the question is on screen
    QDateTime m_reloadRefused; ///< of this change of the file
};

} // namespace berg
