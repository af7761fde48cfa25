#include "widgets/flight/mission_runner.h"

#include "core/base/error.h"
#include "widgets/flight/flight_record.h"
#include "widgets/flight/mission_worker.h"

using namespace Qt::StringLiterals;

namespace berg {

namespace {

/**
 * Returns whether a change concerns one iceberg or UAV, so that the next one may concern another.
 */
bool isOfOne(const Intervention& change)
{
    return change.appears || change.seen || change.removed || change.assigned || change.commanded ||
           change.home;
}

/** Joins waiting interventions: during a drag only the newest value is flown. */
void join(std::vector<Intervention>& waiting, std::vector<Intervention> next)
{
    for (Intervention& change : next) {
        Intervention& last = waiting.back();
        if (isOfOne(last) || isOfOne(change)) {
            waiting.push_back(std::move(change));
            continue;
        }
        last.tau = change.tau ? change.tau : last.tau;
        last.policy = change.policy ? change.policy : last.policy;
        last.wind_mps = change.wind_mps ? change.wind_mps : last.wind_mps;
        last.asset = change.asset ? change.asset : last.asset;
    }
}

} // namespace

QString outdatedExportText()
{
    return MissionRunner::tr("The scenario has changed meanwhile. Nothing was exported.");
}

QString runEndedText()
{
    return MissionRunner::tr("The run has ended. Stop and edit to fly it differently.");
}

MissionRunner::MissionRunner(QObject* parent)
    : QObject(parent), m_worker(new MissionWorker(m_mail)), m_exports(new ExportWorker)
{
    m_thread.setObjectName(u"mission"_s);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &MissionWorker::published, this, &MissionRunner::updated);
    connect(m_worker, &MissionWorker::instantPublished, this, &MissionRunner::instantUpdated);
    connect(m_worker, &MissionWorker::refused, this, &MissionRunner::commandRefused);
    connect(
        m_worker, &MissionWorker::missionsReady, this,
        [this](const std::shared_ptr<const std::vector<UavMission>>& missions, quint64 generation) {
            if (generation == m_generation)
                emit missionsReady(missions);
        });
    connect(m_worker, &MissionWorker::runReady, this, &MissionRunner::runReady);
    connect(m_worker, &MissionWorker::recoveryRunReady, this, &MissionRunner::recoveryRunReady);
    connectExports();
    m_thread.start();
    m_exportThread.start();
}

MissionRunner::~MissionRunner()
{
    m_stop.request_stop();
    m_previewStop.request_stop();
    for (QThread* thread : {&m_thread, &m_exportThread}) {
        thread->quit();
        thread->wait();
    }
}

/** Connects the export thread. Results of earlier generations are dropped. */
void MissionRunner::connectExports()
{
    m_exportThread.setObjectName(u"export"_s);
    m_exports->moveToThread(&m_exportThread);
    connect(&m_exportThread, &QThread::finished, m_exports, &QObject::deleteLater);
    connect(m_worker, &MissionWorker::exportPrepared, m_exports, &ExportWorker::write);
    connect(m_worker, &MissionWorker::previewPrepared, m_exports, &ExportWorker::makePreview);
    connect(m_exports, &ExportWorker::refused, this, &MissionRunner::commandRefused);
    connect(
        m_exports, &ExportWorker::written, this,
        [this](const std::shared_ptr<const std::vector<ExportFile>>& files, quint64 generation) {
            if (generation == m_generation)
                emit exportReady(*files);
            else
                emit commandRefused(outdatedExportText());
        });
    const auto passOn = [this](const std::shared_ptr<const ExportPreview>& preview,
                               quint64 generation) {
        if (generation == m_generation)
            emit exportPreviewReady(preview);
    };
    connect(m_exports, &ExportWorker::previewed, this, passOn);
    connect(m_worker, &MissionWorker::previewRefused, this, passOn);
}

/** Runs `command` on the mission thread, in order. */
template <class Command>
void MissionRunner::post(Command command)
{
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, command] { worker->runGuarded([&] { command(*worker); }); },
        Qt::QueuedConnection);
}

/**
 * Runs `command` unless the worker has begun another scenario by then, for which it was not meant.
 */
template <class Command>
void MissionRunner::postToFlight(Command command)
{
    post([command, generation = m_generation](MissionWorker& worker) {
        if (worker.generation() == generation)
            command(worker);
    });
}

void MissionRunner::setScenario(const Scenario& scenario, const MissionOptions& options)
{
    m_scenario = scenario;
    m_options = options;
    begin();
}

void MissionRunner::setRun(std::shared_ptr<const RunFile> run)
{
    m_scenario = run->scenario;
    m_options = run->options;
    begin({}, std::move(run));
}

void MissionRunner::restart(bool keepsFlight)
{
    begin({.keepsFlight = keepsFlight});
}

void MissionRunner::restoreFlight(const Scenario& scenario, bool keepsFlight)
{
    m_scenario = scenario;
    m_options = recordingOf(scenario);
    begin({.keepsFlight = keepsFlight, .restoresFlight = true});
}

void MissionRunner::begin(RestartOptions restartOptions, std::shared_ptr<const RunFile> run)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    ++m_generation;
    (void)m_mail.interventions.take(); // they belong to the flight that ends here
    MissionRequest request{.generation = m_generation,
                           .scenario = m_scenario,
                           .options = m_options,
                           .run = std::move(run),
                           .restarts = {restartOptions},
                           .stop = m_stop.get_token()};
    const bool wasEmpty =
        m_mail.requests.put(std::move(request), [](MissionRequest& waiting, MissionRequest next) {
            next.restarts.insert(next.restarts.begin(), waiting.restarts.begin(),
                                 waiting.restarts.end());
            waiting = std::move(next);
        });
    if (wasEmpty)
        post([](MissionWorker& worker) { worker.start(); });
    cancelExportPreview();
    emit begun();
}

void MissionRunner::fly(FlightRate rate)
{
    require(!rate || *rate > 0, "rate of a flight is not positive");
    postToFlight([rate](MissionWorker& worker) { worker.fly(rate); });
}

void MissionRunner::flyLive(double clock_s)
{
    postToFlight([clock_s](MissionWorker& worker) { worker.flyLive(clock_s); });
}

void MissionRunner::addPoses(const std::vector<LivePose>& poses)
{
    const bool wasEmpty = m_mail.poses.put(
        poses, [](std::vector<LivePose>& waiting, const std::vector<LivePose>& next) {
            waiting.insert(waiting.end(), next.begin(), next.end());
        });
    if (wasEmpty)
        post([](MissionWorker& worker) { worker.addPoses(); });
}

void MissionRunner::requestMissions()
{
    postToFlight([](MissionWorker& worker) { worker.sendMissions(); });
}

void MissionRunner::pause()
{
    postToFlight([](MissionWorker& worker) { worker.pause(); });
}

void MissionRunner::stepBy(double seconds)
{
    postToFlight([seconds](MissionWorker& worker) { worker.stepBy(seconds); });
}

void MissionRunner::continueFrom(const ContinueRequest& request)
{
    postToFlight([request](MissionWorker& worker) { worker.continueFrom(request); });
}

void MissionRunner::requestInstant(double time_s)
{
    if (m_mail.instantRequests.put(time_s))
        post([](MissionWorker& worker) { worker.sendInstant(); });
}

void MissionRunner::intervene(const Intervention& intervention)
{
    const bool wasEmpty = m_mail.interventions.put({intervention}, join);
    if (wasEmpty)
        postToFlight([](MissionWorker& worker) { worker.intervene(); });
}

void MissionRunner::requestRun(const QString& path)
{
    post([path](MissionWorker& worker) { worker.sendRun(path); });
}

void MissionRunner::requestRecoveryRun()
{
    post([](MissionWorker& worker) { worker.sendRecoveryRun(); });
}

void MissionRunner::setExportPaint(const ExportPaint& paint)
{
    post([paint](MissionWorker& worker) { worker.setExportPaint(paint); });
}

void MissionRunner::setPredictor(const Predictor& predictor)
{
    m_predictor = predictor;
}

ExportTask MissionRunner::taskOf(const ExportRequest& request) const
{
    return {.request = request,
            .generation = m_generation,
            .predicted = m_predictor ? m_predictor() : std::nullopt,
            .stop = m_stop.get_token()};
}

void MissionRunner::requestExport(const ExportRequest& request)
{
    post([task = taskOf(request)](MissionWorker& worker) { worker.sendExport(task); });
}

void MissionRunner::requestExportPreview(const ExportRequest& request)
{
    m_previewStop.request_stop();
    m_previewStop = std::stop_source();
    ExportTask task = taskOf(request);
    task.stop = m_previewStop.get_token();
    if (m_mail.previewRequests.put(std::move(task)))
        post([](MissionWorker& worker) { worker.sendExportPreview(); });
}

void MissionRunner::cancelExportPreview()
{
    m_previewStop.request_stop();
}

std::optional<MissionSnapshot> MissionRunner::acceptSnapshot()
{
    return ifCurrent(m_mail.snapshots.take());
}

std::optional<MissionSnapshot> MissionRunner::acceptInstant()
{
    return ifCurrent(m_mail.instants.take());
}

std::optional<MissionSnapshot>
MissionRunner::ifCurrent(std::optional<MissionSnapshot> snapshot) const
{
    if (snapshot && snapshot->generation != m_generation)
        return std::nullopt;
    return snapshot;
}

} // namespace berg
