#pragma once

#include "widgets/aircraft/link_monitor.h"
#include "widgets/document/autosaver.h"
#include "widgets/document/document_file.h"
#include "widgets/document/scenario_document.h"
#include "widgets/document/selection.h"
#include "widgets/flight/flight_record.h"
#include "widgets/flight/mission_runner.h"
#include "widgets/forecast/bound_runner.h"
#include "widgets/forecast/curve_runner.h"
#include "widgets/forecast/policy_forecasts.h"
#include "widgets/sightings/import_runner.h"
#include "widgets/study/benchmark_runner.h"
#include "widgets/study/run_list.h"
#include "widgets/study/start_runner.h"
#include "widgets/study/study_autosaver.h"
#include "widgets/study/study_files.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * Data of one window: the scenario, the selection, and the mission planned or flown from it.
 * Decides whether a change is an edit (before take-off) or an intervention (in flight). It outlives
 * the window, which is recreated when the language changes. GUI thread.
 */
class Workspace : public QObject
{
    Q_OBJECT

public:
    explicit Workspace(QObject* parent = nullptr);

    [[nodiscard]] ScenarioDocument& document() { return m_document; }
    [[nodiscard]] DocumentFile& file() { return m_file; }
    [[nodiscard]] Autosaver& autosaver() { return m_autosaver; }
    [[nodiscard]] Selection& selection() { return m_selection; }
    [[nodiscard]] MissionRunner& runner() { return m_runner; }
    /** Returns the live link to real aircraft, which is off at first. */
    [[nodiscard]] LinkMonitor& link() { return m_link; }
    /** Returns the trade-off curve of the plan in force, before take-off and in flight. */
    [[nodiscard]] CurveRunner& curve() { return m_curve; }
    /** Forecasts of the flight from the start, made before take-off. */
    [[nodiscard]] PolicyForecasts& forecasts() { return m_forecasts; }
    /**
     * Returns the predicted zeta for the policy at take-off; nullopt while it is being predicted,
     * or if that takes too long.
     */
    [[nodiscard]] std::optional<ZetaPrediction> predicted() const;
    /** Returns the lower bound on zeta of any flight of the scenario; the record has it too. */
    [[nodiscard]] BoundRunner& bound() { return m_bound; }
    /** Returns the runs flown, added when they end or are discarded. */
    [[nodiscard]] RunList& runs() { return m_runs; }
    [[nodiscard]] BenchmarkRunner& benchmark() { return m_benchmark; }
    /** Returns the comparison of start times. */
    [[nodiscard]] StartRunner& starts() { return m_starts; }
    [[nodiscard]] StudyRunner& study() { return m_study; }
    [[nodiscard]] StudyFiles& studyFiles() { return m_studyFiles; }
    [[nodiscard]] StudyAutosaver& studyAutosaver() { return m_studyAutosaver; }
    [[nodiscard]] ImportRunner& imports() { return m_imports; }
    [[nodiscard]] const FlightRecord& record() const { return m_record; }
    [[nodiscard]] bool inFlight() const { return m_record.inFlight(); }
    /** Returns whether a flight has begun and not ended. */
    [[nodiscard]] bool isMidFlight() const;
    /**
     * Returns whether the flight is in no run file and worth saving: changed in flight, or at least
     * a minute long. A shorter flight, or one of a study, can be repeated exactly.
     */
    [[nodiscard]] bool hasUnsavedRun() const;
    /** Records that the run is in a file. */
    void noteSaved(const RunFile& run);
    /** Returns the settings in force: of the document, or in flight at the instant shown. */
    [[nodiscard]] const PlannerSettings& planner() const;
    /** Returns the wind in force, of the document or at the instant shown. */
    [[nodiscard]] Point wind_mps() const;
    /** Returns the id of the only UAV that may visit the iceberg; empty if any may. */
    [[nodiscard]] std::string assignedUavOf(const std::string& iceberg) const;
    /**
     * Returns whether wind, asset and icebergs can change: the newest instant of an unfinished
     * flight is shown.
     */
    [[nodiscard]] bool mayIntervene() const;
    /** Reports why an intervention is not possible in flight. Returns whether it is refused. */
    [[nodiscard]] bool refuseIntervention();
    /** Returns the ids that are icebergs of the flight, including added ones. */
    [[nodiscard]] std::vector<std::string>
    icebergsInFlight(const std::vector<std::string>& ids) const;

    /**
     * Sets tau. In flight at most ten times a second, the last value always: each is a recorded
     * re-plan.
     */
    void setTau(double tau);
    /** Sets the policy: an edit before take-off, an intervention in flight. */
    void setPolicy(PolicyKind policy);
    /** In flight: reports that others see the icebergs among `ids` now. */
    void reportSeen(const std::vector<std::string>& ids);
    /** In flight: applies sightings of others, each as an intervention (`reportsOf`). */
    void report(const std::vector<Intervention>& sightings);
    /** In flight: stops monitoring the icebergs among `ids`. Returns how many were monitored. */
    int remove(const std::vector<std::string>& ids);
    /** Assigns the icebergs to this UAV; an empty id lets any UAV visit them. */
    void assign(const std::vector<std::string>& icebergs, const std::string& uav);
    /** In flight: sends the order to every UAV in `ids`. */
    void order(const std::vector<std::string>& ids, FlightOrder order);
    /** Sets the wind: an edit before take-off, an intervention in flight. */
    void setWind(const Point& wind_mps);
    /** In flight: moves the asset to its present position. */
    void moveAsset(const Point& position_m);
    /**
     * Sets the present position and the velocity of the asset, before take-off (without an undo
     * step, `ScenarioDocument::follow`) and in flight.
     */
    void setAssetMotion(const Point& position_m, const Point& velocity_mps);
    /**
     * Sets launch and home of each UAV, by UAV, before take-off (without an undo step); in flight
     * only the home. More or fewer places than UAVs change nothing for the rest.
     */
    void setHomes(const std::vector<Point>& homes_m);
    /** Ends `setAssetMotion` or `setHomes`: undo steps have their own places again. */
    void stopAssetMotion();
    void stopHomeMotion();
    /** In flight: adds an iceberg at its present position, under a fresh id. */
    void addIceberg(Iceberg iceberg);
    /** Returns the change that `undoChange` reverts, or nullopt if there is none. */
    [[nodiscard]] std::optional<LastChange> undoableChange() const;
    /**
     * In flight: returns to the instant of the last change and continues from there without it. The
     * flight since then is discarded and can be restored.
     */
    void undoChange();
    void setBackend(Backend backend);
    void setRoute(Route route);

    /**
     * Opens a scenario, or a run by its file extension. Throws `Error` and then changes nothing.
     */
    void openFile(const QString& path);
    /**
     * Flies this scenario to its end as fast as possible. If it differs from the document in seed
     * and planner only, that is an edit named `text`; else it replaces the document.
     */
    void flyScenario(const Scenario& scenario, const QString& text);
    /** Returns whether `flyScenario` would only edit the document. */
    [[nodiscard]] bool isVariant(const Scenario& scenario) const;
    /** Opens a recorded run: loads its scenario and replays it as far as it went. */
    void openRun(std::shared_ptr<const RunFile> run);
    /** Takes over the recovery of a program that no longer runs. */
    void restore(FoundRecovery found);
    /** Takes off or continues. */
    void fly(FlightRate rate);
    /**
     * Flies with real aircraft (`MissionRunner::flyLive`). Before take-off, UAVs are first moved to
     * `starts`, by UAV, which is an edit; an entry without a value leaves its UAV.
     */
    void flyLive(const std::vector<std::optional<DubinsState>>& starts);
    /** Pauses the flight, or the playing of its record. */
    void pause();
    /** Flies one second, or shows the instant one second later if an earlier one is shown. */
    void step();
    /** Ends the flight and returns to the start, where everything can be edited again. */
    void reset();
    /** Returns the flown time of the flight discarded last, s; nullopt if there is none. */
    [[nodiscard]] std::optional<double> discardedFlight_s() const;
    /** Restores the flight discarded last; if its scenario differs, that is an edit as well. */
    void restoreFlight();
    /** Sets a new rate for a flight in progress. */
    void setRate(FlightRate rate);

    /** Pauses and shows this instant of the flight; at its end, the newest instant. */
    void seek(double time_s);
    /** Shows the newest instant. */
    void seekLatest();
    /** Returns the instant looked back at, s, or nullopt if the newest is shown. */
    [[nodiscard]] std::optional<double> lookedAt_s() const { return m_lookedAt_s; }
    /** Goes back by one second. */
    void stepBack();
    /** Moves by `ticks` simulation steps; beyond the flown part the flight continues. */
    void stepTicks(int ticks);
    /**
     * Goes to the next event (`direction` > 0), or to the newest instant if there is none; else to
     * the event before, if there is one.
     */
    void stepToEvent(int direction);
    /** Discards what was flown after the instant looked at and continues from there. */
    void continueFromHere();
    /** Returns whether the flight is flying, or its record is being played. */
    [[nodiscard]] bool isPlaying() const;

signals:
    /** Emitted when `record()` has changed. */
    void flightChanged();
    /** Emitted before a flight is requested: pending edits of the scenario end now. */
    void aboutToTakeOff();
    /** Emitted at take-off and reset, which change what may be edited. */
    void inFlightChanged(bool inFlight);
    void refused(const QString& message);
    /** Emitted when the flight that can be restored has changed, also to none. */
    void discardedFlightChanged();

private:
    /** Data for restoring a flight. */
    struct DiscardedFlight
    {
        Scenario scenario;
        double flown_s = 0;
    };
    /** Data that identify the run of a file. */
    struct SavedRun
    {
        Scenario scenario;
        double flown_s = 0;
        Metrics metrics;
        bool operator==(const SavedRun&) const = default;
    };
    [[nodiscard]] std::optional<DiscardedFlight> presentFlight() const;
    void setDiscarded(std::optional<DiscardedFlight> flight);
    void planAgain();
    void prepareTakeOff();
    void reportInFlight();
    void acceptSnapshot();
    void flyTau();
    void updateCurve();
    void acceptInstant();
    void playBack();
    void goBackTo(const ContinueRequest& request);
    [[nodiscard]] std::string freshIdInFlight() const;
    void setPlanner(const QString& text, const std::function<void(PlannerSettings&)>& change,
                    const QString& gesture = {});

    LinkMonitor m_link;
    ScenarioDocument m_document;
    DocumentFile m_file{m_document};
    Autosaver m_autosaver{m_document};
    Selection m_selection;
    FlightRecord m_record;
    std::optional<double> m_tauWanted; ///< in flight, not yet sent to the mission
    QTimer m_tauPause;
    QTimer m_recoveryPause;            ///< delay until a current flight is saved for recovery again
    std::vector<std::string> m_placed; ///< ids of icebergs added in this flight
    std::optional<double> m_lookedAt_s; ///< requested instant; the record's instant follows
    QTimer m_playBack;                  ///< runs while the record is played
    QElapsedTimer m_playClock;
    FlightRate m_rate = 1;
    std::optional<SavedRun> m_savedRun;  ///< the run saved or opened last
    std::uint64_t m_studyGeneration = 0; ///< generation of the last flight that is also in a study
    std::optional<DiscardedFlight> m_discarded; ///< its mission is held by the mission thread
    bool m_isRestoring = false;                 ///< whether a recovered flight is being replayed
    bool m_isTakeOffAsked = false; ///< whether the mission has not yet answered a take-off
    /** Plan of the curve in flight: rewrites of the history and number of the plan. */
    std::optional<std::pair<std::uint64_t, std::size_t>> m_curvePlan;
    CurveRunner m_curve;
    PolicyForecasts m_forecasts;
    BoundRunner m_bound;
    BenchmarkRunner m_benchmark;
    StartRunner m_starts;
    StudyRunner m_study;
    StudyAutosaver m_studyAutosaver{m_study};
    StudyFiles m_studyFiles;
    ImportRunner m_imports;
    RunList m_runs;
    MissionRunner m_runner; ///< last member: its thread ends before the others are destroyed
};

} // namespace berg
