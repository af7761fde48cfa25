#include "widgets/workspace/workspace.h"

#include "core/base/angles.h"
#include "core/link/transport/link_clock.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/words/intervention_text.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <unordered_set>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kTauPause_ms = 100;
constexpr int kFrame_ms = 16;
constexpr int kRecoveryPause_ms = 3000;
constexpr double kWorthKeeping_s = 60;

} // namespace

Workspace::Workspace(QObject* parent) : QObject(parent)
{
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &Workspace::planAgain);
    connect(&m_document, &ScenarioDocument::replaced, &m_selection, &Selection::clear);
    connect(&m_document, &ScenarioDocument::replaced, this, [this] { setDiscarded({}); });
    connect(&m_document, &ScenarioDocument::refused, this,
            [this] { emit refused(lockedInFlightText()); });
    connect(&m_runner, &MissionRunner::updated, this, &Workspace::acceptSnapshot);
    connect(&m_runner, &MissionRunner::commandRefused, this, &Workspace::refused);
    connect(&m_runner, &MissionRunner::instantUpdated, this, &Workspace::acceptInstant);
    m_runner.setPredictor([this] { return predicted(); });
    connect(&m_bound, &BoundRunner::updated, this, [this] { m_record.bound = m_bound.known(); });
    connect(&m_studyFiles, &StudyFiles::saved, &m_study,
            [this](const QString&, const StudySavePoint& point) {
                m_study.noteSaved(point);
                m_studyAutosaver.follow();
            });
    m_playBack.setInterval(kFrame_ms);
    connect(&m_playBack, &QTimer::timeout, this, &Workspace::playBack);
    m_tauPause.setSingleShot(true);
    m_tauPause.setInterval(kTauPause_ms);
    connect(&m_tauPause, &QTimer::timeout, this, &Workspace::flyTau);
    m_recoveryPause.setSingleShot(true);
    m_recoveryPause.setInterval(kRecoveryPause_ms);
    connect(&m_recoveryPause, &QTimer::timeout, &m_runner, &MissionRunner::requestRecoveryRun);
    connect(&m_runner, &MissionRunner::recoveryRunReady, this,
            [this](const std::shared_ptr<const RunFile>& run) {
                if (inFlight())
                    m_autosaver.setRun(run);
            });
}

const PlannerSettings& Workspace::planner() const
{
    return inFlight() ? m_record.shown().planner : m_document.scenario().planner;
}

bool Workspace::isMidFlight() const
{
    return inFlight() && m_record.now.time_s > 0 && m_record.now.phase != RunPhase::Finished;
}

bool Workspace::hasUnsavedRun() const
{
    const MissionSnapshot& now = m_record.now;
    const bool isChanged = std::ranges::any_of(m_record.history.events, [](const auto& event) {
        return event.kind == EventKind::Intervention || event.reported;
    });
    const bool isWorthIt =
        isChanged || (now.time_s >= kWorthKeeping_s && m_runner.generation() != m_studyGeneration);
    return m_isRestoring || (inFlight() && isWorthIt &&
                             m_savedRun != SavedRun{m_record.scenario, now.time_s, now.metrics});
}

void Workspace::noteSaved(const RunFile& run)
{
    m_savedRun = SavedRun{run.scenario, run.flownUntil_s, run.metrics};
}

Point Workspace::wind_mps() const
{
    return inFlight() ? m_record.shown().motions.front().wind_mps : m_document.scenario().wind_mps;
}

std::string Workspace::assignedUavOf(const std::string& iceberg) const
{
    if (!inFlight()) {
        const Iceberg* found = findById(m_document.scenario().icebergs, iceberg);
        return found == nullptr ? std::string() : found->uav;
    }
    const MissionSnapshot& shown = m_record.shown();
    const std::optional<IcebergIndex> index = indexOfId(shown.icebergs, iceberg);
    if (!index)
        return {};
    const std::optional<int>& uav = shown.assigned[toIndex(*index)];
    return uav ? m_record.scenario.uavs[toIndex(*uav)].id : std::string();
}

std::optional<ZetaPrediction> Workspace::predicted() const
{
    const PolicyForecastList& forecasts = m_forecasts.forecasts();
    const auto found = forecasts.find(m_record.scenario.planner.policy);
    return found == forecasts.end() ? std::nullopt : found->second.prediction();
}

bool Workspace::mayIntervene() const
{
    return inFlight() && !m_lookedAt_s && m_record.now.phase != RunPhase::Finished;
}

std::vector<std::string> Workspace::icebergsInFlight(const std::vector<std::string>& ids) const
{
    std::unordered_set<std::string_view> flown;
    for (const Iceberg& iceberg : m_record.now.icebergs)
        flown.insert(iceberg.id);
    std::vector<std::string> found;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(found),
                 [&](const std::string& id) { return flown.contains(id); });
    return found;
}

void Workspace::planAgain()
{
    m_selection.keepExisting(m_document.scenario());
    m_autosaver.setRun({});
    const bool wasInFlight = inFlight();
    if (wasInFlight) {
        m_runs.add(m_record);
        m_runs.showWorld(m_document.scenario());
    }
    m_record.scenario = m_document.scenario();
    m_record.noteWeather();
    m_tauWanted.reset();
    m_placed.clear();
    m_playBack.stop();
    m_lookedAt_s.reset();
    m_isRestoring = false;
    m_runner.setScenario(m_document.scenario(), recordingOf(m_document.scenario()));
    m_curvePlan.reset();
    m_curve.setScenario(m_document.scenario());
    m_forecasts.setScenario(m_document.scenario());
    m_bound.setScenario(m_document.scenario());
    if (wasInFlight) { // another scenario has replaced the flight
        m_record.begin(m_document.scenario());
        reportInFlight();
        emit flightChanged();
    }
    if (std::exchange(m_isTakeOffAsked, false))
        emit refused(tr("The scenario was changed before take-off: nothing was flown."));
}

void Workspace::acceptSnapshot()
{
    std::optional<MissionSnapshot> snapshot = m_runner.acceptSnapshot();
    if (!snapshot)
        return;
    const bool wasInFlight = inFlight();
    const bool wasFinished = m_record.now.phase == RunPhase::Finished;
    m_record.accept(std::move(*snapshot));
    m_isTakeOffAsked = m_isTakeOffAsked && !inFlight() && m_record.now.phase != RunPhase::Failed;
    updateCurve();
    if (m_record.now.phase == RunPhase::Finished && !wasFinished)
        m_runs.add(m_record);
    if (inFlight() != wasInFlight)
        reportInFlight();
    if (m_discarded && inFlight() && !(m_discarded->scenario == m_record.scenario))
        setDiscarded({}); // the world has changed since
    const RunPhase phase = m_record.now.phase;
    m_isRestoring = m_isRestoring && phase == RunPhase::Planning;
    if (phase == RunPhase::Ready || phase == RunPhase::Failed)
        m_autosaver.setRun({}); // also a restored recovery was not flown
    if (inFlight() && !m_recoveryPause.isActive())
        m_recoveryPause.start();
    emit flightChanged();
}

/** Ends pending edits first: they would change a scenario that is then locked. */
void Workspace::prepareTakeOff()
{
    if (inFlight())
        return;
    m_isTakeOffAsked = false;
    emit aboutToTakeOff();
    m_isTakeOffAsked = m_record.now.phase != RunPhase::Failed;
}

void Workspace::reportInFlight()
{
    m_document.setLocked(inFlight());
    if (!inFlight())
        m_autosaver.setRun({});
    emit inFlightChanged(inFlight());
}

void Workspace::updateCurve()
{
    const MissionSnapshot& shown = m_record.shown();
    const std::pair plan(m_record.history.rewrites, shown.planCount);
    if (!inFlight() || !shown.request || m_curvePlan == plan)
        return;
    m_curvePlan = plan;
    m_curve.setRequest(shown.request, m_record.scenario.planner.route);
}

void Workspace::setPlanner(const QString& text, const std::function<void(PlannerSettings&)>& change,
                           const QString& gesture)
{
    m_document.edit(
        text, [&change](Scenario& scenario) { change(scenario.planner); }, gesture);
}

void Workspace::setBackend(Backend backend)
{
    setPlanner(tr("Change solver"),
               [backend](PlannerSettings& planner) { planner.backend = backend; });
}

void Workspace::setRoute(Route route)
{
    setPlanner(tr("Change route"), [route](PlannerSettings& planner) { planner.route = route; });
}

void Workspace::openFile(const QString& path)
{
    if (QFileInfo(path).suffix().toLower() != u"bergrun"_s) {
        m_document.open(path);
        return;
    }
    openRun(std::make_shared<const RunFile>(loadRun(QFile::encodeName(path).toStdString())));
}

void Workspace::openRun(std::shared_ptr<const RunFile> run)
{
    noteSaved(*run);
    m_document.reset(run->scenario);
    m_runner.setRun(std::move(run));
}

void Workspace::restore(FoundRecovery found)
{
    if (found.run && !(found.run->scenario == found.scenario)) // it dates from before an edit
        found.run.reset();                                     // left from before an edit
    m_document.restore(found.scenario, found.info.originalPath);
    m_autosaver.adopt(std::move(found.held), found.run);
    m_isRestoring = found.run != nullptr;
    if (found.run)
        m_runner.setRun(std::move(found.run));
}

bool Workspace::isVariant(const Scenario& scenario) const
{
    Scenario present = m_document.scenario();
    present.seed = scenario.seed;
    present.planner = scenario.planner;
    return present == scenario;
}

void Workspace::flyScenario(const Scenario& scenario, const QString& text)
{
    if (inFlight())
        reset();
    emit aboutToTakeOff();
    if (isVariant(scenario))
        m_document.edit(text, [&scenario](Scenario& present) { present = scenario; });
    else
        m_document.reset(scenario);
    fly(kFastestRate);
    m_studyGeneration = m_runner.generation();
}

void Workspace::fly(FlightRate rate)
{
    m_rate = rate;
    if (m_lookedAt_s && rate) {
        m_playClock.start();
        m_playBack.start();
        emit flightChanged();
        return;
    }
    seekLatest();
    prepareTakeOff();
    flyTau(); // settings requested earlier take effect first
    m_runner.fly(rate);
}

void Workspace::flyLive(const std::vector<std::optional<DubinsState>>& starts)
{
    seekLatest();
    if (!inFlight()) {
        emit aboutToTakeOff();
        m_document.edit(tr("Move UAVs to their aircraft"), [&](Scenario& scenario) {
            for (std::size_t i = 0; i < std::min(starts.size(), scenario.uavs.size()); ++i)
                if (starts[i]) {
                    // The aircraft is in the air, while home stays on the ground.
                    scenario.uavs[i].home_m =
                        scenario.uavs[i].home_m.value_or(scenario.uavs[i].position_m);
                    scenario.uavs[i].position_m = starts[i]->position_m;
                    scenario.uavs[i].heading_deg = headingFromPsi(starts[i]->psi_rad);
                }
        });
    }
    prepareTakeOff();
    flyTau();
    const LinkStatus& link = m_link.status();
    m_runner.flyLive(link.replay ? link.now_s : monotonicNow_s());
}

void Workspace::setRate(FlightRate rate)
{
    if (isPlaying())
        fly(rate);
}

void Workspace::pause()
{
    m_playBack.stop();
    m_runner.pause();
    emit flightChanged();
}

bool Workspace::isPlaying() const
{
    return m_playBack.isActive() || m_record.now.phase == RunPhase::Flying;
}

void Workspace::step()
{
    if (m_lookedAt_s) {
        seek(*m_lookedAt_s + 1);
        return;
    }
    prepareTakeOff();
    flyTau();
    m_runner.stepBy(1);
}

void Workspace::reset()
{
    const bool wasInFlight = inFlight();
    if (wasInFlight)
        m_runs.add(m_record);
    m_tauWanted.reset();
    m_isTakeOffAsked = false;
    m_placed.clear();
    m_playBack.stop();
    m_lookedAt_s.reset();
    const std::optional<DiscardedFlight> flight = presentFlight();
    // A stored longer flight is not replaced by a short one.
    const bool keepsFlight = flight && flight->flown_s >= discardedFlight_s().value_or(0);
    m_record.begin(m_document.scenario());
    m_runner.restart(keepsFlight);
    m_curvePlan.reset();
    m_curve.setScenario(m_document.scenario());
    if (wasInFlight)
        reportInFlight();
    if (keepsFlight)
        setDiscarded(flight);
    emit flightChanged();
}

std::optional<double> Workspace::discardedFlight_s() const
{
    return m_discarded ? std::optional(m_discarded->flown_s) : std::nullopt;
}

/** Returns the current flight, or nullopt if nothing has been flown yet. */
std::optional<Workspace::DiscardedFlight> Workspace::presentFlight() const
{
    if (!inFlight() || m_record.now.time_s <= 0)
        return std::nullopt;
    return DiscardedFlight{.scenario = m_record.scenario, .flown_s = m_record.now.time_s};
}

void Workspace::setDiscarded(std::optional<DiscardedFlight> flight)
{
    if (!flight && !m_discarded)
        return;
    m_discarded = std::move(flight);
    emit discardedFlightChanged();
}

void Workspace::restoreFlight()
{
    if (!m_discarded)
        return;
    const Scenario scenario = m_discarded->scenario;
    std::optional<DiscardedFlight> present = presentFlight();
    if (inFlight())
        m_runs.add(m_record);
    emit aboutToTakeOff();
    m_document.edit(tr("Restore flight"), [&](Scenario& s) { s = scenario; });
    m_tauWanted.reset();
    m_playBack.stop();
    m_lookedAt_s.reset();
    m_curvePlan.reset();
    m_runner.restoreFlight(scenario, present.has_value());
    setDiscarded(std::move(present));
}

} // namespace berg
