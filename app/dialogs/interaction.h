#pragma once

#include "core/scenario/move_origin.h"
#include "core/sim/intervention.h"
#include "widgets/model/export_preview.h"
#include "widgets/theme/theme.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QSettings;
class QWidget;

namespace berg {

class ImportRunner;
class MissionRunner;

/** What can be exported, and what to suggest. */
struct ExportOffer
{
    ExportRequest suggested; ///< an unknown format: the first of the table
    bool flown = false;      ///< there is a flight to export, not only the plan from the start
    std::shared_ptr<const Scenario> scenario; ///< on screen
    Theme theme;
};

/** A file of sightings, and what they can be added to. */
struct ImportOffer
{
    QString path;
    std::shared_ptr<const Scenario> present; ///< on screen
    bool intoNew = false;                    ///< chosen at first: a new scenario
    bool inFlight = false;                   ///< they are reports to it; `present` is `scenarioNow`
    Theme theme;
};

/** What the user wants imported. */
struct ImportChoice
{
    Scenario scenario;                 ///< that comes out
    bool intoNew = false;              ///< in place of the present one, not a change of it
    int icebergs = 0;                  ///< new or updated
    std::vector<Intervention> reports; ///< in flight, instead of all that
};

/** What is in no file, and about to be lost. */
struct UnsavedWork
{
    QString name;
    bool endsFlight = false; ///< a flight under way is ended as well
};

/** Unsaved work of a program that ended unexpectedly, as the user sees it. */
struct RecoveryOffer
{
    QString name;
    QString path;   ///< of its file; empty: none yet
    QString edited; ///< when, in words
};

/** What is to be done with which of the offers. */
struct RecoveryAnswer
{
    enum class Action
    {
        Restore,
        Discard,
        Later ///< with all of them
    };
    Action action = Action::Later;
    std::size_t offer = 0;
};

/** Where a scenario is to be moved. */
struct OriginChoice
{
    LatLon origin;
    MoveMode mode = MoveMode::KeepLayout;
    bool operator==(const OriginChoice&) const = default;
};

/** Everything modal the window asks of a person, behind one interface so that tests can answer. */
class Interaction
{
public:
    enum class Unsaved
    {
        Save,
        Discard,
        Cancel
    };
    enum class InUse
    {
        OpenCopy,
        OpenAnyway,
        Cancel
    };
    enum class Overwrite
    {
        Overwrite,
        SaveAs,
        Cancel
    };

    /** Why a flight is about to be ended. */
    enum class FlightEnd
    {
        Answer, ///< it has begun while another question was open, whose answer would end it
        Other   ///< another scenario or flight takes its place
    };

    Interaction() = default;
    Interaction(const Interaction&) = delete;
    Interaction& operator=(const Interaction&) = delete;
    virtual ~Interaction() = default;

    [[nodiscard]] virtual Unsaved askUnsaved(QWidget* parent, const UnsavedWork& work) = 0;
    /** The window is closed over a run that is in no file. */
    [[nodiscard]] virtual Unsaved askUnsavedRun(QWidget* parent, bool isUnderWay) = 0;
    [[nodiscard]] virtual bool askEndFlight(QWidget* parent, FlightEnd why) = 0;
    /** In flight: icebergs leave the run, `names` for the user. Whether they are to. */
    [[nodiscard]] virtual bool askRemove(QWidget* parent, const QStringList& names) = 0;
    /** Empty: cancelled. `filter` as in `QFileDialog`. */
    [[nodiscard]] virtual QString openPath(QWidget* parent, const QString& filter) = 0;
    [[nodiscard]] virtual QString savePath(QWidget* parent, const QString& suggested,
                                           const QString& filter) = 0;
    /** None: cancelled. */
    [[nodiscard]] virtual std::optional<ExportRequest>
    chooseExport(QWidget* parent, MissionRunner& runner, const ExportOffer& offer) = 0;
    /** None: cancelled. */
    [[nodiscard]] virtual std::optional<ImportChoice>
    chooseImport(QWidget* parent, ImportRunner& runner, const ImportOffer& offer) = 0;
    /** None: cancelled. What is chosen can be done with this scenario. */
    [[nodiscard]] virtual std::optional<OriginChoice> askOrigin(QWidget* parent,
                                                                const Scenario& scenario,
                                                                const LatLon& suggested,
                                                                const Theme& theme) = 0;
    /** None: cancelled. What is chosen is slower than `airspeed_mps`. */
    [[nodiscard]] virtual std::optional<Point> askWind(QWidget* parent, const Point& wind_mps,
                                                       double airspeed_mps) = 0;
    /** Magnetic declination in degrees, positive east; nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<double> askDeclination(QWidget* parent,
                                                               double present_deg) = 0;
    /** Another window has the file open; `holder` says which. */
    [[nodiscard]] virtual InUse askInUse(QWidget* parent, const QString& fileName,
                                         const QString& holder) = 0;
    /** The file must not be overwritten silently; `reason` says why. */
    [[nodiscard]] virtual Overwrite askOverwrite(QWidget* parent, const QString& fileName,
                                                 const QString& reason) = 0;
    /** The file was changed by somebody else, and here nothing is unsaved. */
    [[nodiscard]] virtual bool askReload(QWidget* parent, const QString& fileName) = 0;
    /** `offers` is not empty. */
    [[nodiscard]] virtual RecoveryAnswer askRecovery(QWidget* parent,
                                                     const std::vector<RecoveryOffer>& offers) = 0;
    /** Until it is so, or the user wants to wait no longer; the window takes nothing else. */
    virtual void waitUntil(QWidget* parent, const QString& text,
                           const std::function<bool()>& isDone, bool mayCancel) = 0;
    virtual void showError(QWidget* parent, const QString& text) = 0;
    virtual void showInformation(QWidget* parent, const QString& title, const QString& html) = 0;
    virtual void soundAlarm() = 0;

    bool isAwaited = false; ///< by a part of the window, which must live until then
};

/** The real one: Qt's dialogs. */
class DialogInteraction : public Interaction
{
public:
    /** `settings` keep the folder that files were last chosen in; null: nothing does. */
    explicit DialogInteraction(QSettings* settings = nullptr) : m_settings(settings) {}

    [[nodiscard]] Unsaved askUnsaved(QWidget* parent, const UnsavedWork& work) override;
    [[nodiscard]] Unsaved askUnsavedRun(QWidget* parent, bool isUnderWay) override;
    [[nodiscard]] bool askEndFlight(QWidget* parent, FlightEnd why) override;
    [[nodiscard]] bool askRemove(QWidget* parent, const QStringList& names) override;
    [[nodiscard]] QString openPath(QWidget* parent, const QString& filter) override;
    [[nodiscard]] QString savePath(QWidget* parent, const QString& suggested,
                                   const QString& filter) override;
    [[nodiscard]] std::optional<ExportRequest> chooseExport(QWidget* parent, MissionRunner& runner,
                                                            const ExportOffer& offer) override;
    [[nodiscard]] std::optional<ImportChoice> chooseImport(QWidget* parent, ImportRunner& runner,
                                                           const ImportOffer& offer) override;
    [[nodiscard]] std::optional<OriginChoice> askOrigin(QWidget* parent, const Scenario& scenario,
                                                        const LatLon& suggested,
                                                        const Theme& theme) override;
    [[nodiscard]] std::optional<Point> askWind(QWidget* parent, const Point& wind_mps,
                                               double airspeed_mps) override;
    [[nodiscard]] std::optional<double> askDeclination(QWidget* parent,
                                                       double present_deg) override;
    [[nodiscard]] InUse askInUse(QWidget* parent, const QString& fileName,
                                 const QString& holder) override;
    [[nodiscard]] Overwrite askOverwrite(QWidget* parent, const QString& fileName,
                                         const QString& reason) override;
    [[nodiscard]] bool askReload(QWidget* parent, const QString& fileName) override;
    [[nodiscard]] RecoveryAnswer askRecovery(QWidget* parent,
                                             const std::vector<RecoveryOffer>& offers) override;
    void showError(QWidget* parent, const QString& text) override;
    void waitUntil(QWidget* parent, const QString& text, const std::function<bool()>& isDone,
                   bool mayCancel) override;
    void showInformation(QWidget* parent, const QString& title, const QString& html) override;
    /** The bell of the desktop. */
    void soundAlarm() override;

private:
    [[nodiscard]] QString lastFolder() const;
    void rememberFolder(const QString& path);

    QSettings* m_settings;
};

} // namespace berg
