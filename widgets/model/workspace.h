#pragma once

#include "widgets/model/autosaver.h"
#include "widgets/model/benchmark_runner.h"
#include "widgets/model/bound_runner.h"
#include "widgets/model/curve_runner.h"
#include "widgets/model/document_file.h"
#include "widgets/model/flight_record.h"
#include "widgets/model/import_runner.h"
#include "widgets/model/mission_runner.h"
#include "widgets/model/policy_forecasts.h"
#include "widgets/model/run_list.h"
#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"
#include "widgets/model/study_files.h"
#include "widgets/model/study_keeper.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>

namespace berg {

/**
 * What one window works on: the scenario, what is selected, and the mission planned or flown from
 * it. Decides whether a change is an edit (before take-off) or an intervention (in flight). It
 * outlives the window, which is made anew when the language changes. GUI thread.
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
    /** Of the plan in force, before take-off and in flight. */
    [[nodiscard]] CurveRunner& curve() { return m_curve; }
    /** Of the flight from the start, made before take-off. */
    [[nodiscard]] PolicyForecasts& forecasts() { return m_forecasts; }
    /** Zeta of the flight as it was chosen at take-off; nullopt while it is being predicted, or if
     * that takes too long. */
    [[nodiscard]] std::optional<ZetaPrediction> predicted() const;
    /** Of zeta of every flight of the scenario; the record has it too. */
    [[nodiscard]] BoundRunner& bound() { return m_bound; }
    /** What was flown, at its end or when it was given up. */
    [[nodiscard]] RunList& runs() { return m_runs; }
    [[nodiscard]] BenchmarkRunner& benchmark() { return m_benchmark; }
    [[nodiscard]] StudyRunner& study() { return m_study; }
    [[nodiscard]] StudyFiles& studyFiles() { return m_studyFiles; }
    [[nodiscard]] StudyKeeper& studyKeeper() { return m_studyKeeper; }
    [[nodiscard]] ImportRunner& imports() { return m_imports; }
    [[nodiscard]] const FlightRecord& record() const { return m_record; }
    [[nodiscard]] bool inFlight() const { return m_record.inFlight(); }
    /** Something has been flown, and has not come to its end. */
    [[nodiscard]] bool isMidFlight() const;
    /**
     * What is flown, or was flown to its end, is in no run file and worth keeping: changed in
     * flight, or a minute long. That of a moment is soon flown again, the same, and so is that of
     * a study.
     */
    [[nodiscard]] bool hasUnsavedRun() const;
    /** The run is in a file now. */
    void noteSaved(const RunFile& run);
    /** In force: the document's, or in flight those of the mission at the instant shown. */
    [[nodiscard]] const PlannerSettings& planner() const;
    /** In force, likewise. */
    [[nodiscard]] Point wind_mps() const;
    /** The UAV that alone is to visit the iceberg, in force; empty: any may. */
    [[nodiscard]] std::string assignedUavOf(const std::string& iceberg) const;
    /** The newest of a flight that has not ended is shown: wind, asset and icebergs can change. */
    [[nodiscard]] bool mayIntervene() const;
    /** In flight: says so, and why, when it may not. */
    [[nodiscard]] bool refuseIntervention();
    /** Those that are icebergs of the flight, added ones too. */
    [[nodiscard]] std::vector<std::string> flownAmong(const std::vector<std::string>& ids) const;

    /** In flight at most ten times a second, the last one always: each is a re-plan on record. */
    void setTau(double tau);
    void setPolicy(PolicyKind policy);
    /** In flight: somebody else sees those of them now that are icebergs. */
    void reportSeen(const std::vector<std::string>& ids);
    /** In flight: sightings of others, each an intervention (`reportsOf`). */
    void report(const std::vector<Intervention>& sightings);
    /** In flight: those of them that are icebergs are monitored no more. Returns how many. */
    int remove(const std::vector<std::string>& ids);
    /** They are to be visited by this UAV alone; empty: by any. */
    void assign(const std::vector<std::string>& icebergs, const std::string& uav);
    /** In flight: what those of them that are UAVs are to do. */
    void order(const std::vector<std::string>& ids, FlightOrder order);
    void setWind(const Point& wind_mps);
    /** In flight: what is to be protected is here now. */
    void moveAsset(const Point& position_m);
    /** In flight: it is here now, under an id of its own. */
    void addIceberg(Iceberg iceberg);
    void setBackend(Backend backend);
    void setRoute(Route route);

    /** Opens a scenario, or a run by its ending. Throws `Error`; then all stays as it was. */
    void openFile(const QString& path);
    /**
     * Flies this scenario to its end as fast as it goes. Where it differs from the document in seed
     * and planner only, that is an edit under `text`; else it takes the document's place.
     */
    void flyScenario(const Scenario& scenario, const QString& text);
    /** Whether `flyScenario` would only edit the document. */
    [[nodiscard]] bool isVariant(const Scenario& scenario) const;
    /** Opens a recorded run: its scenario, flown again as far as it went. */
    void openRun(std::shared_ptr<const RunFile> run);
    /** Takes over what a program that is gone has left. */
    void restore(FoundRecovery found);
    /** Takes off, or carries on. `rate` simulated seconds a second, 0: as fast as possible. */
    void fly(double rate);
    void pause();
    void step();
    /** Ends the flight: back to the start, where everything can be edited again. */
    void reset();
    /** How far the flight was that was given up last, for another start or way; none: none was. */
    [[nodiscard]] std::optional<double> givenUp_s() const;
    /** Takes that flight up where it was left; of another scenario it is an edit as well. */
    void bringBackFlight();
    /** A new rate for a flight under way. */
    void setRate(double rate);

    /** Pauses and shows this instant of what was flown; at its end the newest is shown again. */
    void seek(double time_s);
    void seekLatest();
    /** The instant looked back at; none: the newest is shown. */
    [[nodiscard]] std::optional<double> lookedAt_s() const { return m_lookedAt_s; }
    /** A second back. */
    void stepBack();
    /** By `ticks` of the simulation; forward beyond what was flown it is flown. */
    void stepTicks(int ticks);
    /** To the next event (`direction` > 0) or the one before. */
    void stepToEvent(int direction);
    /** Gives up what was flown after the instant looked at. */
    void flyOnFromHere();
    /** Flying, or playing what was flown. */
    [[nodiscard]] bool isPlaying() const;

signals:
    /** `record()` is new. */
    void flightChanged();
    /** A flight is about to be asked for: what is half done to the scenario ends now. */
    void takeOffAhead();
    /** Take-off or reset: what may be edited has changed. */
    void inFlightChanged(bool inFlight);
    void refused(const QString& message);
    /** Another flight can be brought back, or none. */
    void givenUpChanged();

private:
    /** What is needed to bring a flight back. */
    struct GivenUpFlight
    {
        Scenario scenario;
        double flown_s = 0;
    };
    /** What tells the run of a file from others. */
    struct SavedRun
    {
        Scenario scenario;
        double flown_s = 0;
        Metrics metrics;
        bool operator==(const SavedRun&) const = default;
    };
    [[nodiscard]] std::optional<GivenUpFlight> presentFlight() const;
    void setGivenUp(std::optional<GivenUpFlight> flight);
    void planAgain();
    void prepareTakeOff();
    void reportInFlight();
    void acceptSnapshot();
    void flyTau();
    void updateCurve();
    void acceptInstant();
    void playBack();
    [[nodiscard]] std::string freshIdInFlight() const;
    void setPlanner(const QString& text, const std::function<void(PlannerSettings&)>& change,
                    const QString& gesture = {});

    ScenarioDocument m_document;
    DocumentFile m_file{m_document};
    Autosaver m_autosaver{m_document};
    Selection m_selection;
    FlightRecord m_record;
    std::optional<double> m_tauWanted; ///< in flight, not yet told to the mission
    QTimer m_tauPause;
    QTimer m_notePause; ///< until a flight that goes on is noted again, for a recovery
    std::vector<std::string> m_placed;  ///< ids of icebergs added in this flight
    std::optional<double> m_lookedAt_s; ///< wanted; the record's instant follows
    QTimer m_playBack;                  ///< runs while what was flown is played
    QElapsedTimer m_playClock;
    double m_rate = 1;
    std::optional<SavedRun> m_savedRun;     ///< the last one that was saved or opened
    std::uint64_t m_studyGeneration = 0;    ///< of the last flight that a study has as well
    std::optional<GivenUpFlight> m_givenUp; ///< the mission thread has it
    bool m_isRestoring = false;             ///< a flight, which is flown again until it is there
    bool m_isTakeOffAsked = false;          ///< and the answer of the mission has not come
    /** In flight, the plan the curve is of: rewrites of the history, number of the plan. */
    std::optional<std::pair<std::uint64_t, std::size_t>> m_curvePlan;
    CurveRunner m_curve;
    PolicyForecasts m_forecasts;
    BoundRunner m_bound;
    BenchmarkRunner m_benchmark;
    StudyRunner m_study;
    StudyKeeper m_studyKeeper{m_study};
    StudyFiles m_studyFiles;
    ImportRunner m_imports;
    RunList m_runs;
    MissionRunner m_runner; ///< last: its thread ends before the rest
};

} // namespace berg
