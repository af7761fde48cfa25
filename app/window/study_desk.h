#pragma once

#include "app/dialogs/interaction.h"
#include "app/window/window_part.h"

#include <functional>

class QMainWindow;

namespace berg {

class Docks;

/** Studies: their dock, their files, and what is asked before one is lost. */
class StudyDesk : public WindowPart
{
    Q_OBJECT

public:
    StudyDesk(WindowContext& context, const Docks& docks);

    /** To be done once a study is in its file, by the window that there is then. */
    using AfterStudy = std::function<void(StudyDesk&)>;

    /** Discard as well when there is nothing that would take long to fly again. */
    [[nodiscard]] Interaction::Unsaved askAboutStudy();
    /** When the program has no time left; the window waits. */
    bool saveStudyNow();
    /** Asks about what would be lost of the study there is. False: not now; `then` follows once
     * the study is in a file, where the user wants that. */
    [[nodiscard]] bool maySettleStudy(AfterStudy then);
    void showStudy();
    void closeWindow();
    /** What the one of another window shows, and awaits. */
    void takeOver(StudyDesk& other);

private:
    void connectPanel();
    void connectFiles();
    void connectKeeper();
    [[nodiscard]] QString studyPath(const QString& extension, const QString& filter);
    void saveStudyPicture();
    bool saveStudy();
    void replaceStudy(const AfterStudy& replace);

    const Docks& m_docks;
    AfterStudy m_afterSaved; ///< awaited; none: nothing
};

/** Work that took so long and is in no file: the settings say from when on it is asked about. */
[[nodiscard]] bool isWorthSaving(const QSettings& settings, double unsaved_s);

} // namespace berg
