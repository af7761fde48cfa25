#pragma once

#include "app/dialogs/interaction.h"
#include "app/layout/window_part.h"

#include <functional>

class QMainWindow;

namespace berg {

class Docks;

/** Studies: their dock, their files, and what is asked before one is lost. */
class StudyController : public WindowPart
{
    Q_OBJECT

public:
    StudyController(WindowContext& context, const Docks& docks);

    /** To be done once a study is in its file, by the window that there is then. */
    using AfterStudy = std::function<void(StudyController&)>;

    /** Discard as well when there is nothing that would take long to fly again. */
    [[nodiscard]] Interaction::Unsaved askAboutStudy();
    /** When the program has no time left; the window waits. */
    bool saveStudyNow();
    /** Asks about what would be lost of the study there is. False: not now; `then` follows once
     * the study is in a file, where the user wants that. */
    [[nodiscard]] bool maySettleStudy(AfterStudy then);
    void showStudy();
    void closeWindow();
    /** Takes over the study and the waiting work of another window. */
    void takeOver(StudyController& other);

private:
    void connectPanel();
    void connectFiles();
    void connectKeeper();
    [[nodiscard]] QString studyPath(const QString& extension, const QString& filter);
    void saveStudyPicture();
    bool saveStudy();
    void replaceStudy(const AfterStudy& replace);

    const Docks& m_docks;
    AfterStudy m_afterSaved; ///< runs after the study is saved; may be empty
};

/** Work that took so long and is in no file: the settings say from when on it is asked about. */
[[nodiscard]] bool isWorthSaving(const QSettings& settings, double unsaved_s);

} // namespace berg
