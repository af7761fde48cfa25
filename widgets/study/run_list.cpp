#include "widgets/study/run_list.h"

#include "widgets/words/policy_words.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kBetweenReports_ms = 40;

} // namespace

Mission replayedMission(const RunFile& recorded, const std::string& path,
                        const std::stop_token& stop, const std::function<void(double)>& onProgress)
{
    RunFile run = recorded;
    run.options.record = true;
    Mission mission = replay(run, stop, onProgress);
    if (path.empty() || stop.stop_requested())
        return mission;
    RunFile flown = runOf(mission);
    if (!recorded.options.record)
        flown.keyframes.clear();
    if (const std::vector<Issue> differences = compareRun(recorded, flown); !differences.empty())
        throw Error(ErrorCode::ReplayMismatch, path, differences);
    return mission;
}

RunList::RunList(QObject* parent)
    : QObject(parent)
    , m_task(u"runs"_s,
             {.work = fly,
              .deliver = [this](const Result& result) { accept(result); },
              .end = [this](const std::optional<WorkFailure>& failure) { end(failure); }})
{
}

void RunList::add(const FlightRecord& record)
{
    if (record.now.time_s <= 0 || record.history.samples.empty())
        return;
    const RunPointer run = insert(std::make_shared<const ComparedRun>(comparedRun(record)));
    const bool keepsOther = m_other && m_other != run && isComparable(*run, *m_other);
    compare(run, keepsOther ? m_other : newestBeside(run));
}

void RunList::addFlown(const Scenario& scenario, const PlannerSettings& planner)
{
    Job job{.run = {.scenario = scenario, .flownUntil_s = scenario.duration_s}};
    job.run.scenario.planner = planner;
    queue(std::move(job));
}

void RunList::addVariant(const ComparedRun& run, const PlannerSettings& planner)
{
    const auto same = std::find_if(m_runs.begin(), m_runs.end(), [&](const RunPointer& known) {
        return !known->wasChanged && isSamePlanner(known->scenario.planner, planner) &&
               known->flown_s >= run.flown_s && isComparable(*known, run);
    });
    if (same != m_runs.end()) {
        setOther(static_cast<std::size_t>(same - m_runs.begin()));
        return;
    }
    Job job{.run = {.scenario = run.scenario, .flownUntil_s = run.scenario.duration_s}};
    job.run.scenario.planner = planner;
    job.run.interventions = run.worldChanges;
    queue(std::move(job));
}

void RunList::open(const QString& path)
{
    queue({.run = {}, .path = path});
}

void RunList::cancel()
{
    m_task.stop();
    if (m_jobs.size() > 1)
        m_jobs.erase(m_jobs.begin() + 1, m_jobs.end());
}

QString RunList::flying(const QLocale& locale) const
{
    if (m_jobs.empty())
        return {};
    const Job& job = m_jobs.front();
    return job.path.isEmpty() ? shortPolicyText(job.run.scenario.planner, locale)
                              : QFileInfo(job.path).fileName();
}

void RunList::queue(Job job)
{
    m_jobs.push_back(std::move(job));
    if (m_jobs.size() == 1)
        start();
}

void RunList::start()
{
    m_task.start(m_jobs.front());
    emit progress(0, m_jobs.front().run.flownUntil_s);
}

void RunList::fly(const Job& job, const std::stop_token& stop, const Deliver& deliver)
{
    const std::string path = QFile::encodeName(job.path).toStdString();
    const RunFile run = path.empty() ? job.run : loadRun(path, stop);
    ReportPace pace(kBetweenReports_ms);
    const Mission mission = replayedMission(run, path, stop, [&](double flown_s) {
        if (pace.isDue())
            deliver({.flown_s = flown_s, .duration_s = run.flownUntil_s, .run = nullptr});
    });
    if (stop.stop_requested())
        return;
    ComparedRun flown = comparedRun(recordOf(mission));
    flown.file = job.path;
    deliver({.run = std::make_shared<const ComparedRun>(std::move(flown))});
}

void RunList::accept(const Result& result)
{
    if (!result.run) {
        emit progress(result.flown_s, result.duration_s);
        return;
    }
    const RunPointer run = insert(result.run);
    if (m_reference && m_reference != run && isComparable(*m_reference, *run))
        compare(m_reference, run);
    else
        compare(run, newestBeside(run));
}

void RunList::end(const std::optional<WorkFailure>& failure)
{
    m_jobs.pop_front();
    if (failure && m_failure.isEmpty())
        m_failure = failure->report;
    if (!m_jobs.empty())
        start();
    else
        emit finished(std::exchange(m_failure, {}));
}

/**
 * Replaces an equal run and takes over its name, or adds the run as the newest. Returns the run
 * that is listed.
 */
RunPointer RunList::insert(RunPointer run)
{
    const auto equal = std::find_if(m_runs.begin(), m_runs.end(), [&](const RunPointer& known) {
        return isSameRun(*known, *run);
    });
    if (equal == m_runs.end()) {
        m_runs.push_back(run);
        makeRoom();
        return run;
    }
    if (run->name.isEmpty() && !(*equal)->name.isEmpty()) {
        auto named = std::make_shared<ComparedRun>(*run);
        named->name = (*equal)->name;
        run = std::move(named);
    }
    replace(*equal, run);
    return run;
}

void RunList::replace(RunPointer& known, RunPointer run)
{
    for (RunPointer* chosen : {&m_reference, &m_other})
        if (*chosen == known)
            *chosen = run;
    known = std::move(run);
}

void RunList::rename(std::size_t index, const QString& name)
{
    auto named = std::make_shared<ComparedRun>(*m_runs.at(index));
    named->name = name.simplified();
    replace(m_runs[index], std::move(named));
    emit changed();
    emit comparisonChanged();
}

void RunList::makeRoom()
{
    if (m_runs.size() <= kMost)
        return;
    m_runs.erase(std::find_if(m_runs.begin(), m_runs.end(), [&](const RunPointer& run) {
        return run != m_reference && run != m_other;
    }));
}

RunPointer RunList::newestBeside(const RunPointer& run) const
{
    const auto found = std::find_if(m_runs.rbegin(), m_runs.rend(), [&](const RunPointer& other) {
        return other != run && isComparable(*run, *other);
    });
    return found == m_runs.rend() ? nullptr : *found;
}

void RunList::compare(RunPointer reference, RunPointer other)
{
    m_reference = std::move(reference);
    m_other = std::move(other);
    emit changed();
    emit comparisonChanged();
}

void RunList::remove(std::size_t index)
{
    const RunPointer gone = m_runs.at(index);
    m_runs.erase(m_runs.begin() + static_cast<std::ptrdiff_t>(index));
    if (gone == m_other) {
        compare(m_reference, newestBeside(m_reference));
    } else if (gone == m_reference) {
        const RunPointer next = m_other ? m_other : m_runs.empty() ? nullptr : m_runs.back();
        compare(next, next ? newestBeside(next) : nullptr);
    } else {
        emit changed();
    }
}

void RunList::setReference(std::size_t index)
{
    const RunPointer run = m_runs.at(index);
    if (run == m_reference)
        return;
    if (run == m_other)
        compare(m_other, m_reference);
    else
        compare(run, m_other && isComparable(*run, *m_other) ? m_other : newestBeside(run));
}

void RunList::setOther(std::size_t index)
{
    const RunPointer run = m_runs.at(index);
    if (run == m_other || !m_reference || !isComparable(*run, *m_reference))
        return;
    if (run == m_reference) {
        if (m_other)
            compare(m_other, m_reference);
        return;
    }
    compare(m_reference, run);
}

std::optional<RunComparison> RunList::comparison() const
{
    if (!m_reference || !m_other)
        return std::nullopt;
    return RunComparison{.reference = m_reference,
                         .other = m_other,
                         .until_s = std::min(m_reference->flown_s, m_other->flown_s)};
}

void RunList::showWorld(const ScenarioWorld& world)
{
    if (!m_reference || isSameWorld(m_reference->scenario, world))
        return;
    const auto newest = std::find_if(m_runs.rbegin(), m_runs.rend(), [&](const RunPointer& run) {
        return isSameWorld(run->scenario, world);
    });
    if (newest == m_runs.rend())
        compare(nullptr, nullptr);
    else
        compare(*newest, newestBeside(*newest));
}

RunPointer RunList::otherIn(const Scenario& scenario) const
{
    return m_other && isSameWorld(m_other->scenario, scenario) ? m_other : nullptr;
}

} // namespace berg
