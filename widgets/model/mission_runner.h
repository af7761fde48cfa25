#pragma once

#include "core/io/files/run_json.h"
#include "widgets/model/export_worker.h"
#include "widgets/model/mailbox.h"
#include "widgets/model/mission_snapshot.h"

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** What becomes of the flight under way when another one is asked for. */
struct FlightHandover
{
    bool keepsFlight = false; ///< that of now, to be brought back
    bool bringsBack = false;  ///< the flight that was kept
};

/** Another way from an instant of the flight. */
struct FlyOn
{
    double time_s = 0;
    double seenUntil_s = 0; ///< as far as the flight was known to who asks
};

/** What the worker is to fly next. */
struct MissionRequest
{
    std::uint64_t generation = 0;
    Scenario scenario;
    MissionOptions options;
    std::shared_ptr<const RunFile> run;    ///< to be flown again first; null: none
    std::vector<FlightHandover> handovers; ///< of the requests that this one stands for, in order
    std::stop_token stop;
};

/** What the two threads leave for each other. */
struct MissionMail
{
    Mailbox<MissionRequest> requests;
    Mailbox<std::vector<Intervention>> interventions;
    Mailbox<MissionSnapshot> snapshots;
    Mailbox<double> instantRequests; ///< times, s
    Mailbox<MissionSnapshot> instants;
    Mailbox<ExportOrder> previewRequests;
};

class MissionWorker;

/** Why an export of a scenario that has been replaced meanwhile is not made. */
[[nodiscard]] QString outdatedExportText();
/** Why nothing changes a flight any more. */
[[nodiscard]] QString runEndedText();

/**
 * Plans and flies on a thread of its own; the GUI thread never waits. Commands return at once;
 * what comes of them is taken from the mailbox when `updated` is emitted. Each scenario has a
 * generation, and snapshots of an older one are never handed out. GUI thread.
 */
class MissionRunner : public QObject
{
    Q_OBJECT

public:
    explicit MissionRunner(QObject* parent = nullptr);
    /** Stops a solve or a flight under way and waits for the thread: well under a second. */
    ~MissionRunner() override;

    /** Plans this scenario from its start; ends what was under way. The newest request wins. */
    void setScenario(const Scenario& scenario, const MissionOptions& options = {});
    /** Flies a recorded run again, as far as it went; told when it comes out differently. */
    void setRun(std::shared_ptr<const RunFile> run);
    [[nodiscard]] std::uint64_t generation() const { return m_generation; }

    /** Flies at `rate` simulated seconds a second; 0: as fast as possible. */
    void fly(double rate);
    void pause();
    /** Pauses and advances by `seconds` of simulated time. */
    void stepBy(double seconds);
    /** Back to the start of the same scenario. `keepsFlight`: it can be brought back. */
    void restart(bool keepsFlight = false);
    /** Takes up the flight that was kept last, of this scenario; the one of now is kept for it. */
    void bringBack(const Scenario& scenario, bool keepsFlight);
    /**
     * Pauses and goes back to that time of the flight to fly on from there in another way: what
     * came after is given up, and kept to be brought back.
     */
    void flyOnFrom(const FlyOn& request);
    /** Asks for the mission as it was at `time_s`: `instantUpdated` follows; the newest wins. */
    void requestInstant(double time_s);
    /** Applies the change at the present instant of a flight that has begun. */
    void intervene(const Intervention& intervention);

    using Predictor = std::function<std::optional<ZetaPrediction>()>;
    /** Asked at each export what zeta was predicted before take-off. */
    void setPredictor(const Predictor& predictor);

    /** From now on these exports can be asked for, too. */
    void setExportPaint(const ExportPaint& paint);
    /**
     * Asks for the plan there is, or in flight for the mission as it stands, as files:
     * `exportReady` or `commandRefused` follows, the latter as well when another scenario has come
     * in between. Nothing is solved again, and the mission flies on meanwhile.
     */
    void requestExport(const ExportRequest& request);
    /** Asks how these would begin: `exportPreviewReady` follows; the newest request wins. */
    void requestExportPreview(const ExportRequest& request);
    /** Nobody wants the preview any more. */
    void cancelExportPreview();

    /** The newest snapshot of the present generation, with all samples since the last one taken. */
    [[nodiscard]] std::optional<MissionSnapshot> acceptSnapshot();

    /** The newest instant asked for, if it is of the present generation. */
    [[nodiscard]] std::optional<MissionSnapshot> acceptInstant();

    /** Asks for the run so far, to be saved: `runReady` with the same `path` follows. */
    void requestRun(const QString& path = {});
    /** The same for a recovery: `runNoted` follows. */
    void requestNote();

signals:
    /** Another generation: what was asked of the one before is not answered any more. */
    void begun();
    /** A snapshot waits. */
    void updated();
    /** An instant waits. */
    void instantUpdated();
    /** Something could not be done, or not as asked: why. */
    void commandRefused(const QString& message);
    void exportReady(const std::vector<berg::ExportFile>& files);
    void exportPreviewReady(const std::shared_ptr<const berg::ExportPreview>& preview);
    void runReady(const QString& path, const std::shared_ptr<const berg::RunFile>& run);
    void runNoted(const std::shared_ptr<const berg::RunFile>& run);

private:
    void begin(FlightHandover handover = {}, std::shared_ptr<const RunFile> run = {});
    [[nodiscard]] std::optional<MissionSnapshot>
    ofNow(std::optional<MissionSnapshot> snapshot) const;
    template <class Command>
    void post(Command command);
    void connectExports();
    [[nodiscard]] ExportOrder orderOf(const ExportRequest& request) const;
    template <class Command>
    void postToFlight(Command command);

    MissionMail m_mail;
    QThread m_thread;
    QThread m_exportThread;
    MissionWorker* m_worker; ///< lives on `m_thread`
    ExportWorker* m_exports; ///< lives on `m_exportThread`
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< of the generation under way
    std::stop_source m_previewStop;
    Predictor m_predictor;
    Scenario m_scenario;
    MissionOptions m_options;
};

} // namespace berg
