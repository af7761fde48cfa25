#include "widgets/study/study_runner.h"

#include "widgets/study/study_estimate.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr qint64 kBetweenReports_ms = 250;
/** A report takes at most one such part of the time between two reports. */
constexpr qint64 kReportShare = 20;
constexpr double kLeastLearned_s = 0.5;

/** Finds the setting with the lowest zeta in each complete case; the first one wins a tie. */
void findBest(StudyResult& result)
{
    const std::size_t settings = result.summary.settings.size();
    result.bestIn.assign(settings, 0);
    for (const std::size_t k : result.summary.cases) {
        const auto zeta_m2s = [&](std::size_t setting) {
            return result.study.outcomes[k * settings + setting]->metrics.zeta_m2s;
        };
        std::size_t best = 0;
        for (std::size_t s = 1; s < settings; ++s)
            if (zeta_m2s(s) < zeta_m2s(best))
                best = s;
        ++result.bestIn[best];
        result.bestByCase.push_back(best);
    }
}

} // namespace

StudyResult resultOf(Study study, std::size_t reference)
{
    StudyResult result{.study = std::move(study)};
    result.summary = summarise(result.study, reference);
    findBest(result);
    return result;
}

StudyRunner::StudyRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"study"_s,
             {.work = [this](Request& request, const std::stop_token& stop,
                             const Task::Deliver& deliver) { work(request, stop, deliver); },
              .deliver = [this](Outcome outcome) { accept(std::move(outcome)); },
              .end = [this](const std::optional<WorkFailure>& failure) { end(failure); }},
             WorkPriority::Low) // the threads that fly the missions inherit it
{
}

void StudyRunner::start(const StudySpec& spec)
{
    ++m_study;
    m_elapsed_s = 0;
    m_unsaved_s = 0;
    begin({.spec = spec, .outcomes = {}}, usualReference(spec), true);
}

void StudyRunner::carryOn()
{
    if (m_result && !m_running)
        begin(m_result->study, m_result->summary.reference, true);
}

void StudyRunner::show(Study study)
{
    const std::size_t reference = usualReference(study.spec);
    ++m_study;
    m_elapsed_s.reset();
    m_unsaved_s = 0;
    begin(std::move(study), reference, false);
}

void StudyRunner::restore(Study study)
{
    const double share = static_cast<double>(flownCount(study)) /
                         static_cast<double>(std::max<std::size_t>(missionCount(study.spec), 1));
    const double flying_s = share * estimated_s(study.spec);
    show(std::move(study));
    m_unsaved_s = flying_s;
}

void StudyRunner::begin(Study study, std::size_t reference, bool flies)
{
    m_failure.clear();
    m_running = flies;
    m_reference = reference;
    m_count = missionCount(study.spec);
    m_flown = m_flownAtStart = flownCount(study);
    m_sinceStart.start();
    m_task.start({.study = std::move(study), .reference = reference, .flies = flies});
    emit progress();
}

void StudyRunner::cancel()
{
    m_task.stop();
}

void StudyRunner::setReference(std::size_t setting)
{
    if (!m_result || setting == m_reference || setting >= m_result->summary.settings.size())
        return;
    if (m_running)
        m_reference = setting; // the next report uses it
    else
        begin(m_result->study, setting, false);
}

std::optional<double> StudyRunner::timeLeft_s() const
{
    if (!m_running || m_flown <= m_flownAtStart)
        return std::nullopt;
    return sinceStart_s() * static_cast<double>(m_count - m_flown) /
           static_cast<double>(m_flown - m_flownAtStart);
}

double StudyRunner::estimated_s(const StudySpec& spec) const
{
    return m_pace * estimatedTime_s(spec);
}

double StudyRunner::sinceStart_s() const
{
    return static_cast<double>(m_sinceStart.elapsed()) / 1000;
}

double StudyRunner::unsaved_s() const
{
    return m_unsaved_s + (m_running ? sinceStart_s() : 0);
}

StudySavePoint StudyRunner::savePoint() const
{
    return {.study = m_study, .unsaved_s = unsaved_s()};
}

void StudyRunner::noteSaved(const StudySavePoint& point)
{
    if (point.study == m_study)
        m_unsaved_s -= point.unsaved_s;
}

/** Updates the pace by the missions flown just now. */
void StudyRunner::learn(double elapsed_s)
{
    if (!m_result || m_flown <= m_flownAtStart || elapsed_s < kLeastLearned_s)
        return;
    const double share =
        static_cast<double>(m_flown - m_flownAtStart) / static_cast<double>(m_count);
    if (const double estimate_s = share * estimatedTime_s(m_result->study.spec); estimate_s > 0)
        m_pace = elapsed_s / estimate_s;
}

void StudyRunner::work(Request& request, const std::stop_token& stop, const Task::Deliver& deliver)
{
    Outcome outcome;
    const auto fill = [&](const Study& study, std::size_t reference) {
        outcome.result = std::make_shared<const StudyResult>(resultOf(study, reference));
        outcome.flown = flownCount(study);
    };
    QElapsedTimer sinceReport;
    sinceReport.start();
    qint64 pause_ms = 0; // the first case is reported at once
    const auto report = [&](const Study& study, std::size_t, std::size_t) {
        if (sinceReport.elapsed() < pause_ms)
            return;
        sinceReport.restart();
        fill(study, m_reference);
        deliver(outcome);
        pause_ms = std::max(kBetweenReports_ms, kReportShare * sinceReport.elapsed());
        sinceReport.restart();
    };
    const auto noteFailure = [&](const std::optional<WorkFailure>& failure) {
        if (failure && outcome.failure.isEmpty())
            outcome.failure = failure->report;
    };
    if (request.flies)
        noteFailure(failureOf([&] { fly(request.study, {.stop = stop, .onProgress = report}); }));
    noteFailure(failureOf( // of the missions flown so far
        [&] { fill(request.study, request.flies ? m_reference.load() : request.reference); }));
    deliver(std::move(outcome));
}

void StudyRunner::accept(Outcome outcome)
{
    if (outcome.result) {
        m_result = std::move(outcome.result);
        m_flown = outcome.flown;
    }
    m_failure = outcome.failure;
    emit progress();
    emit updated();
}

void StudyRunner::end(const std::optional<WorkFailure>& failure)
{
    if (failure && m_failure.isEmpty())
        m_failure = failure->report;
    const bool wasRunning = std::exchange(m_running, false);
    if (wasRunning) {
        const double elapsed_s = sinceStart_s();
        m_unsaved_s += elapsed_s;
        if (m_elapsed_s)
            *m_elapsed_s += elapsed_s;
        learn(elapsed_s);
        emit progress();
        emit updated();
    }
    if (wasRunning || !m_failure.isEmpty())
        emit finished(m_failure);
}

} // namespace berg
