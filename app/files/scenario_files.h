#pragma once

#include "app/dialogs/interaction.h"
#include "app/layout/window_part.h"

#include <QStringList>

class QMenu;

namespace berg {

/** New, open, save: what the window does with files of scenarios, and all it asks before. */
class ScenarioFiles : public WindowPart
{
    Q_OBJECT

public:
    explicit ScenarioFiles(WindowContext& context);

    /** By its ending. Its results are shown beside the scenario, which stays. */
    [[nodiscard]] static bool isStudyFile(const QString& path);
    [[nodiscard]] static bool isRunFile(const QString& path);
    /** A recorded flight of real aircraft. It is played beside the scenario, which stays. */
    [[nodiscard]] static bool isTelemetryLog(const QString& path);

    /**
     * The gate for all that makes the present scene go away: one question about the changes that
     * are in no file and the flight under way.
     */
    [[nodiscard]] bool confirmDiscardScenario();
    /** Asks about unsaved changes only. `endsFlight` adds that a flight ends as well. */
    [[nodiscard]] bool maySettleChanges(bool endsFlight = false);
    /** A flight that has come to its end is in the list of runs, and nothing is lost. */
    [[nodiscard]] bool mayEndFlight();
    /** False: a flight has begun since the question was asked, and is to go on. */
    [[nodiscard]] bool mayAnswer(bool wasInFlight);

    /** After the question about unsaved changes; false when it was not opened. */
    bool openFile(const QString& path);
    void openExample(const QString& path);
    /** False: the user stays with the scenario there is. */
    bool newScenario();
    void openScenario();
    bool saveScenario();
    bool saveScenarioAs();

    [[nodiscard]] QStringList recent() const;
    void forget(const QString& path);
    void fillRecentMenu(QMenu& menu);
    [[nodiscard]] bool keepsOld() const;
    void setKeepsOld(bool on);

signals:
    void telemetryLogChosen(const QString& path);

private:
    [[nodiscard]] bool openUnlessInUse(const QString& path);
    [[nodiscard]] bool openRun(const QString& path);
    [[nodiscard]] Interaction::Overwrite mayOverwrite(const QString& path);
    bool saveTo(const QString& path);
    void remember(const QString& path);
};

} // namespace berg
