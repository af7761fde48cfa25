#include "widgets/flight/mission_worker.h"

#include "core/io/export/content/export_flight.h"
#include "core/io/export/missions/mission_upload.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"
#include "widgets/words/report_language.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace berg {

namespace {

constexpr int kSlice_ms = 16;
/** Flying time in one slice, short so that commands take effect at once. */
constexpr int kWork_ms = 8;

/** Joins a waiting update of one type and the next one; indices refer to the whole record. */
template <class Record>
void join(std::size_t waitingFirst, std::vector<Record>& waiting, std::size_t nextFirst,
          std::vector<Record>& next)
{
    if (nextFirst <= waitingFirst)
        return; // the new update repeats everything that waits
    waiting.resize(std::min(waiting.size(), nextFirst - waitingFirst));
    std::move(next.begin(), next.end(), std::back_inserter(waiting));
    next = std::move(waiting);
}

/** Replaces an unread snapshot by a newer one that keeps its unread news. */
void amend(MissionSnapshot& waiting, MissionSnapshot next)
{
    if (waiting.generation == next.generation) {
        HistoryUpdate& old = waiting.news;
        HistoryUpdate& news = next.news;
        join(old.firstSample, old.part.samples, news.firstSample, news.part.samples);
        join(old.firstSample, old.part.rows, news.firstSample, news.part.rows);
        join(old.firstPlan, old.part.plans, news.firstPlan, news.part.plans);
        join(old.firstEvent, old.part.events, news.firstEvent, news.part.events);
        news.firstSample = std::min(news.firstSample, old.firstSample);
        news.firstPlan = std::min(news.firstPlan, old.firstPlan);
        news.firstEvent = std::min(news.firstEvent, old.firstEvent);
    }
    waiting = std::move(next);
}

/**
 * Returns the scope of an upload: paths if plans have aimed legs, because straight legs over the
 * icebergs are not what such a plan means. Interim plans have no legs, so the policy counts, too.
 */
ExportScope uploadScope(const Mission& mission)
{
    bool isAimed = traitsOf(mission.plannerSettings().policy).method == PolicyMethod::PredictedZeta;
    for (int uav = 0; uav < mission.simulation().uavCount(); ++uav)
        if (const PlanPointer last = lastPlanOf(mission.plans(), uav))
            isAimed = isAimed || !last->of(uav)->legs.empty();
    return isAimed ? ExportScope::Path : ExportScope::Order;
}

} // namespace

MissionWorker::MissionWorker(MissionChannels& mail)
    : m_mail(mail), m_timer(this) // a child, so that it moves to the thread with its parent
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, [this] { runGuarded([this] { slice(); }); });
}

void MissionWorker::start()
{
    std::optional<MissionRequest> request = m_mail.requests.take();
    if (!request)
        return; // an earlier call has taken a newer one
    m_timer.stop();
    m_liveZero_s.reset();
    m_request = std::move(*request);
    Flight present{.mission = std::move(m_mission), .phase = m_phase};
    m_error.reset();
    m_published = {};
    m_phase = RunPhase::Planning;
    for (const RestartOptions& restartOptions : m_request.restarts)
        present = nextFlight(std::move(present), restartOptions);
    if (present.mission) {
        resume(std::move(present));
        return;
    }
    if (m_request.run) {
        replayRun(*m_request.run);
        return;
    }
    m_mission = std::make_unique<Mission>(m_request.scenario, m_request.options);
    listenToIncumbents();
    if (m_mission->advance(0, m_request.stop) == AdvanceStatus::Cancelled)
        return; // a newer request waits
    m_phase = RunPhase::Ready;
    publish();
}

MissionWorker::Flight MissionWorker::nextFlight(Flight present,
                                                const RestartOptions& restartOptions)
{
    const bool restoresFlight = restartOptions.restoresFlight && m_discarded.mission;
    Flight next;
    if (restoresFlight)
        next = std::exchange(m_discarded, {});
    // The requester may have seen no more than the flight that was continued from: then that one
    // counts.
    const bool isLess = std::exchange(m_hasContinued, false) && m_discarded.mission &&
                        (!present.mission || present.mission->simulation().time_s() <
                                                 m_discarded.mission->simulation().time_s());
    if (restartOptions.keepsFlight && !isLess)
        m_discarded = std::move(present);
    return next;
}

void MissionWorker::resume(Flight flight)
{
    m_mission = std::move(flight.mission);
    listenToIncumbents();
    m_phase = flight.phase == RunPhase::Finished ? RunPhase::Finished : RunPhase::Paused;
    publish();
}

void MissionWorker::replayRun(const RunFile& run)
{
    m_mission = std::make_unique<Mission>(replay(run, m_request.stop));
    if (m_request.stop.stop_requested())
        return; // a newer request waits
    listenToIncumbents();
    const Simulation& simulation = m_mission->simulation();
    m_phase = simulation.finished()     ? RunPhase::Finished
              : simulation.time_s() > 0 ? RunPhase::Paused
                                        : RunPhase::Ready;
    publish();
    const std::vector<Issue> differences = compareRun(run, runOf(*m_mission));
    if (!differences.empty() && differences.front().severity == Severity::Error)
        emit refused(tr("The replay of this run differs from the recording: %1")
                         .arg(placedIssueText(differences.front())));
}

void MissionWorker::listenToIncumbents()
{
    m_mission->setIncumbentListener(
        [this](PlanPointer plan) { publishIncumbent(std::move(plan)); });
}

void MissionWorker::fly(FlightRate rate)
{
    m_rate = rate;
    if (!m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed)
        return;
    m_phase = RunPhase::Flying;
    m_target_s = m_mission->simulation().time_s();
    m_clock.start();
    m_timer.start(rate || m_liveZero_s ? kSlice_ms : 0); // aircraft set the pace of a live flight
    publish();
}

void MissionWorker::flyLive(double clock_s)
{
    if (!m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed) {
        emit refused(m_phase == RunPhase::Finished
                         ? runEndedText()
                         : tr("This scenario cannot be flown. Fix the reported errors first."));
        return;
    }
    m_liveZero_s = clock_s - m_mission->simulation().time_s();
    fly(1);
}

void MissionWorker::addPoses()
{
    const std::optional<std::vector<LivePose>> poses = m_mail.poses.take();
    if (!poses || !m_mission || !m_liveZero_s)
        return;
    const int uavs = m_mission->simulation().uavCount();
    for (const LivePose& pose : *poses)
        if (pose.uav < uavs) // else it was for an earlier scenario
            m_mission->addFix({.time_s = pose.clock_s - *m_liveZero_s,
                               .uav = pose.uav,
                               .pose = pose.pose,
                               .isMeasured = pose.isMeasured});
}

void MissionWorker::sliceLive()
{
    const World& world = m_mission->simulation().world();
    const std::optional<double> known_s = m_mission->poseTracks().knownUntil_s();
    // Only whole steps: the last one must not end after the last pose.
    const double until_s = std::floor(known_s.value_or(0) / world.dt_s()) * world.dt_s();
    const double before_s = world.time_s();
    QElapsedTimer work;
    work.start();
    while (world.time_s() < until_s - world.dt_s() / 2 && work.elapsed() < kWork_ms &&
           advanceTo(std::min(until_s, world.time_s() + 1))) {
    }
    if (world.time_s() != before_s || m_phase == RunPhase::Finished)
        publish();
}

void MissionWorker::sendMissions()
{
    const auto refuse = [this](const QString& message) {
        emit refused(message);
        emit missionsReady(std::make_shared<const std::vector<UavMission>>(), m_request.generation);
    };
    if (!m_mission || m_mission->plans().empty())
        return refuse(tr("There is no plan to upload."));
    const auto failure = failureOf([&] {
        const ExportSource source{.scenario = m_mission->scenario(),
                                  .plan = *m_mission->plans().front(),
                                  .mission =
                                      m_phase == RunPhase::Ready ? nullptr : m_mission.get()};
        const ExportContent content =
            exportContent(source, {.what = uploadScope(*m_mission), .returnHome = true});
        const MissionSnapshot now = snapshotOf(*m_mission);
        auto missions = std::make_shared<std::vector<UavMission>>();
        for (const ExportUav& uav : content.uavs)
            missions->push_back(
                {.uav = uav.uav.id,
                 .parts = missionParts(content, uav),
                 .order =
                     sortieIcebergs(now, indexOfId(source.scenario.uavs, uav.uav.id).value_or(0))});
        emit missionsReady(missions, m_request.generation);
    });
    if (failure)
        refuse(failure->report);
}

void MissionWorker::pause()
{
    if (m_phase != RunPhase::Flying)
        return;
    m_timer.stop();
    m_phase = RunPhase::Paused;
    publish();
}

void MissionWorker::stepBy(double seconds)
{
    if (m_liveZero_s && (m_phase == RunPhase::Flying || m_phase == RunPhase::Paused)) {
        emit refused(tr("The flight follows real aircraft at their pace: it cannot be stepped."));
        return;
    }
    m_timer.stop();
    if (!m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed)
        return;
    m_phase = RunPhase::Paused;
    const Simulation& simulation = m_mission->simulation();
    advanceTo(simulation.time_s() + std::max(seconds, simulation.world().dt_s()));
    publish();
}

void MissionWorker::slice()
{
    if (m_liveZero_s) {
        sliceLive();
        return;
    }
    if (!m_rate) {
        sliceAsFastAsPossible();
    } else {
        m_target_s += *m_rate * static_cast<double>(m_clock.restart()) / 1000;
        const double before_s = m_mission->simulation().time_s();
        // Flies at most for the work time of one slice: a slow machine slows the flight, not the
        // window.
        QElapsedTimer work;
        work.start();
        bool more = true;
        while (more && m_mission->simulation().time_s() < m_target_s && work.elapsed() < kWork_ms)
            more = advanceTo(std::min(m_target_s, m_mission->simulation().time_s() + 1));
        m_target_s = std::min(m_target_s, m_mission->simulation().time_s() + 1);
        if (m_mission->simulation().time_s() == before_s)
            return;
    }
    publish();
}

void MissionWorker::sliceAsFastAsPossible()
{
    QElapsedTimer work;
    work.start();
    while (work.elapsed() < kWork_ms && advanceTo(m_mission->simulation().time_s() + 1)) {
    }
}

bool MissionWorker::advanceTo(double until_s)
{
    if (m_mission->advance(until_s, m_request.stop) == AdvanceStatus::Reached)
        return true;
    m_timer.stop();
    if (m_mission->simulation().finished())
        m_phase = RunPhase::Finished;
    return false;
}

void MissionWorker::intervene()
{
    const std::optional<std::vector<Intervention>> waiting = m_mail.interventions.take();
    if (!waiting || !m_mission)
        return;
    if (m_phase == RunPhase::Finished || m_phase == RunPhase::Failed) {
        emit refused(runEndedText());
        return;
    }
    for (const Intervention& intervention : *waiting) {
        try {
            m_mission->intervene(intervention);
        } catch (const Error& error) {
            emit refused(errorReport(error));
        }
    }
    advanceTo(m_mission->simulation().time_s()); // replans at this instant
    publish();
}

void MissionWorker::continueFrom(const ContinueRequest& request)
{
    if (!m_mission || m_phase == RunPhase::Failed)
        return;
    // Two requests may come before the first is answered: the flight that was seen is kept.
    constexpr double kRounding_s = 1e-6;
    if (m_mission->simulation().time_s() < request.seenUntil_s - kRounding_s)
        return;
    m_timer.stop();
    m_liveZero_s.reset();
    RunFile run = runOf(*m_mission);
    run.flownUntil_s = std::clamp(request.time_s, 0.0, run.flownUntil_s);
    run.fixes = m_mission->poseTracks().until(run.flownUntil_s);
    std::erase_if(run.interventions,
                  [&run](const Intervention& change) { return change.time_s > run.flownUntil_s; });
    run.interventions.resize(std::min(run.interventions.size(),
                                      request.interventions.value_or(run.interventions.size())));
    m_mission->setIncumbentListener(nullptr);
    m_discarded = {.mission = std::move(m_mission), .phase = m_phase};
    m_hasContinued = true;
    auto again = std::make_unique<Mission>(replay(run, m_request.stop));
    if (m_request.stop.stop_requested())
        return; // a newer request waits
    m_mission = std::move(again);
    listenToIncumbents();
    m_published = {}; // everything is sent again, because the end that was sent is discarded
    m_phase = RunPhase::Paused;
    publish();
}

void MissionWorker::sendInstant()
{
    const std::optional<double> time_s = m_mail.instantRequests.take();
    if (!time_s || !m_mission || m_phase == RunPhase::Failed)
        return;
    MissionSnapshot snapshot = snapshotAt(*m_mission, *time_s);
    snapshot.generation = m_request.generation;
    snapshot.phase = m_phase;
    if (m_mail.instants.put(std::move(snapshot)))
        emit instantPublished();
}

void MissionWorker::sendRun(const QString& path)
{
    if (m_mission)
        emit runReady(path, std::make_shared<const RunFile>(runOf(*m_mission)));
    else
        emit refused(tr("There is no run to save: the scenario cannot be planned."));
}

void MissionWorker::sendRecoveryRun()
{
    if (!m_mission)
        return;
    // A flight does not fail because its recovery cannot be written.
    static_cast<void>(failureOf(
        [&] { emit recoveryRunReady(std::make_shared<const RunFile>(runOf(*m_mission))); }));
}

std::shared_ptr<const ExportJob> MissionWorker::prepared(const ExportTask& task) const
{
    if (!m_mission || m_mission->plans().empty())
        throw Error(ErrorCode::InvalidInput, "plan", {IssueId::NotPlannable});
    const ExportSource source{.scenario = m_mission->scenario(),
                              .plan = *m_mission->plans().front(),
                              .mission = m_phase == RunPhase::Ready ? nullptr : m_mission.get(),
                              .predicted = task.predicted,
                              .words = reportLanguage()};
    return std::make_shared<const ExportJob>(
        ExportJob{.task = task, .prepared = prepareExport(source, task.request, m_paint)});
}

void MissionWorker::sendExport(const ExportTask& task)
{
    if (task.generation != m_request.generation) {
        emit refused(outdatedExportText());
        return;
    }
    const auto failure = failureOf([&] { emit exportPrepared(prepared(task)); });
    if (failure)
        emit refused(failure->report);
}

void MissionWorker::sendExportPreview()
{
    const std::optional<ExportTask> task = m_mail.previewRequests.take();
    if (!task || task->generation != m_request.generation || task->stop.stop_requested())
        return; // an earlier call has taken a newer one, or the preview was cancelled
    const auto failure = failureOf([&] { emit previewPrepared(prepared(*task)); });
    if (!failure)
        return;
    ExportPreview preview;
    preview.request = task->request;
    preview.error = failure->error;
    emit previewRefused(std::make_shared<const ExportPreview>(std::move(preview)),
                        task->generation);
}

/** After an internal error the mission may be half changed and is dropped. */
void MissionWorker::fail(const WorkFailure& failure)
{
    m_timer.stop();
    m_phase = RunPhase::Failed;
    m_error = failure.error;
    if (!failure.isExpected)
        m_mission.reset();
    if (!failureOf([this] { publish(); }))
        return;
    m_mission.reset(); // frees memory for the message
    publish();
}

HistoryUpdate MissionWorker::takeNewRecords()
{
    const Recorder& recorder = m_mission->recorder();
    HistoryUpdate news = m_published;
    const auto take = [](const auto& all, std::size_t& published, auto& part) {
        // A flight that was continued from an earlier instant has fewer records than were sent.
        published = std::min(published, all.size());
        part.assign(all.begin() + static_cast<std::ptrdiff_t>(published), all.end());
    };
    take(recorder.samples(), news.firstSample, news.part.samples);
    IcebergReader rows = recorder.reader();
    for (std::size_t row = news.firstSample; row < recorder.samples().size(); ++row)
        news.part.rows.push_back(rows.at(row));
    take(m_mission->plans(), news.firstPlan, news.part.plans);
    take(m_mission->events(), news.firstEvent, news.part.events);
    m_published.firstSample = recorder.samples().size();
    m_published.firstPlan = m_mission->plans().size();
    m_published.firstEvent = m_mission->events().size();
    return news;
}

void MissionWorker::publishIncumbent(PlanPointer plan)
{
    if (m_phase != RunPhase::Planning)
        return; // in flight the last plan stays shown until the next one is complete
    MissionSnapshot snapshot = present();
    for (const UavPlan& own : plan->uavs)
        snapshot.plans.at(static_cast<std::size_t>(own.uav)) = plan;
    snapshot.plan = std::move(plan);
    if (m_mail.snapshots.put(std::move(snapshot), amend))
        emit published();
}

void MissionWorker::publish()
{
    if (m_mail.snapshots.put(present(), amend))
        emit published();
}

MissionSnapshot MissionWorker::present()
{
    MissionSnapshot snapshot;
    if (m_mission) {
        snapshot = snapshotOf(*m_mission);
        snapshot.news = takeNewRecords();
    }
    snapshot.generation = m_request.generation;
    snapshot.phase = m_phase;
    snapshot.isLive = m_liveZero_s.has_value();
    snapshot.error = m_error;
    return snapshot;
}

} // namespace berg
