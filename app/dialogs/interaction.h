#pragma once

#include "core/presets/move_origin.h"
#include "core/sim/intervention.h"
#include "widgets/flight/export_preview.h"
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

/** Content for an export, and the suggested request. */
struct ExportOffer
{
    ExportRequest suggested;                  ///< an unknown format selects the first of the table
    bool flown = false;                       ///< a flight can be exported, besides the plan
    std::shared_ptr<const Scenario> scenario; ///< on screen
    Theme theme;
};

/** A file of sightings, and the scenario that they can be added to. */
struct ImportOffer
{
    QString path;
    std::shared_ptr<const Scenario> present; ///< on screen
    bool intoNew = false;                    ///< preselects a new scenario
    bool inFlight = false; ///< sightings become reports to the flight; `present` is `scenarioNow`
    Theme theme;
};

/** The import that the user chose. */
struct ImportChoice
{
    Scenario scenario;                 ///< result of the import
    bool intoNew = false;              ///< replaces the present scenario instead of changing it
    int icebergs = 0;                  ///< new or updated
    std::vector<Intervention> reports; ///< in flight, these replace the members above
};

/** The scenario whose forecast is chosen. */
struct ForecastOffer
{
    std::shared_ptr<const Scenario> scenario;
    std::function<QString(QWidget*)> openPath; ///< asks for a file; empty if cancelled
};

/** The forecast that the user chose; nullopt removes the present one. */
struct ForecastChoice
{
    std::optional<ForecastField> forecast;
};

/** Unsaved work that is about to be lost. */
struct UnsavedWork
{
    QString name;
    bool endsFlight = false; ///< a flight in progress ends as well
};

/** Unsaved work of a program that ended unexpectedly, as the user sees it. */
struct RecoveryOffer
{
    QString name;
    QString path;   ///< of its file; empty if it has none
    QString edited; ///< time of the last edit, as text
};

/** The user's choice among the recovery offers. */
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

/** New place of a scenario. */
struct OriginChoice
{
    LatLon origin;
    MoveMode mode = MoveMode::KeepLayout;
    bool operator==(const OriginChoice&) const = default;
};

/** All modal dialogs of the window, behind one interface so that tests can answer them. */
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

    /** Reason to end a flight. */
    enum class FlightEnd
    {
        Answer, ///< the flight began while a question was open, and its answer would end it
        Other   ///< another scenario or flight takes its place
    };

    Interaction() = default;
    Interaction(const Interaction&) = delete;
    Interaction& operator=(const Interaction&) = delete;
    virtual ~Interaction() = default;

    [[nodiscard]] virtual Unsaved askUnsaved(QWidget* parent, const UnsavedWork& work) = 0;
    /** Asks whether to save a run before the window closes. */
    [[nodiscard]] virtual Unsaved askUnsavedRun(QWidget* parent, bool isUnderWay) = 0;
    [[nodiscard]] virtual bool askEndFlight(QWidget* parent, FlightEnd why) = 0;
    /** Asks, in flight, whether to remove icebergs from the run. `names` are shown to the user. */
    [[nodiscard]] virtual bool askRemove(QWidget* parent, const QStringList& names) = 0;
    /** Asks whether to discard the flight since a change, in order to undo it. `since` is the time
     * of the change, as text. */
    [[nodiscard]] virtual bool askUndo(QWidget* parent, const QString& change,
                                       const QString& since) = 0;
    /** Returns the chosen path; empty if cancelled. `filter` is that of `QFileDialog`. */
    [[nodiscard]] virtual QString openPath(QWidget* parent, const QString& filter) = 0;
    [[nodiscard]] virtual QString savePath(QWidget* parent, const QString& suggested,
                                           const QString& filter) = 0;
    /** Returns nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<ExportRequest>
    chooseExport(QWidget* parent, MissionRunner& runner, const ExportOffer& offer) = 0;
    /** Returns nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<ImportChoice>
    chooseImport(QWidget* parent, ImportRunner& runner, const ImportOffer& offer) = 0;
    /** Returns a choice that is possible for this scenario; nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<OriginChoice> askOrigin(QWidget* parent,
                                                                const Scenario& scenario,
                                                                const LatLon& suggested,
                                                                const Theme& theme) = 0;
    /** Returns the forecast for a scenario, or that it has none; nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<ForecastChoice> askForecast(QWidget* parent,
                                                                    const ForecastOffer& offer) = 0;
    /** Returns a wind below `airspeed_mps`; nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<Point> askWind(QWidget* parent, const Point& wind_mps,
                                                       double airspeed_mps) = 0;
    /** Magnetic declination in degrees, positive east; nullopt if cancelled. */
    [[nodiscard]] virtual std::optional<double> askDeclination(QWidget* parent,
                                                               double present_deg) = 0;
    /** Asks what to do about a file that another window (`holder`) has open. */
    [[nodiscard]] virtual InUse askInUse(QWidget* parent, const QString& fileName,
                                         const QString& holder) = 0;
    /** Asks whether to overwrite the file; `reason` explains the question. */
    [[nodiscard]] virtual Overwrite askOverwrite(QWidget* parent, const QString& fileName,
                                                 const QString& reason) = 0;
    /** Asks whether to reload a file that another program has changed. Nothing is unsaved here. */
    [[nodiscard]] virtual bool askReload(QWidget* parent, const QString& fileName) = 0;
    /** `offers` is not empty. */
    [[nodiscard]] virtual RecoveryAnswer askRecovery(QWidget* parent,
                                                     const std::vector<RecoveryOffer>& offers) = 0;
    /** Blocks the window until `isDone` returns true or the user stops waiting. */
    virtual void waitUntil(QWidget* parent, const QString& text,
                           const std::function<bool()>& isDone, bool mayCancel) = 0;
    virtual void showError(QWidget* parent, const QString& text) = 0;
    virtual void showInformation(QWidget* parent, const QString& title, const QString& html) = 0;
    virtual void soundAlarm() = 0;

    bool isAwaited = false; ///< a part of the window waits for the answer and must not be deleted
};

/** Interaction by Qt's dialogs. */
class DialogInteraction : public Interaction
{
public:
    /** `settings` store the folder of the last file chosen; null stores nothing. */
    explicit DialogInteraction(QSettings* settings = nullptr) : m_settings(settings) {}

    [[nodiscard]] Unsaved askUnsaved(QWidget* parent, const UnsavedWork& work) override;
    [[nodiscard]] Unsaved askUnsavedRun(QWidget* parent, bool isUnderWay) override;
    [[nodiscard]] bool askEndFlight(QWidget* parent, FlightEnd why) override;
    [[nodiscard]] bool askRemove(QWidget* parent, const QStringList& names) override;
    [[nodiscard]] bool askUndo(QWidget* parent, const QString& change,
                               const QString& since) override;
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
    [[nodiscard]] std::optional<ForecastChoice> askForecast(QWidget* parent,
                                                            const ForecastOffer& offer) override;
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
    /** Sounds the bell of the desktop. */
    void soundAlarm() override;

private:
    [[nodiscard]] QString lastFolder() const;
    void rememberFolder(const QString& path);

    QSettings* m_settings;
};

} // namespace berg
