#include "widgets/study/start_runner.h"

using namespace Qt::StringLiterals;

namespace berg {

StartRunner::StartRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"start times"_s,
             {.work = fly,
              .deliver = [this](Report report) { accept(std::move(report)); },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      m_isRunning = false;
                      emit changed(failure ? failure->report : QString());
                  }},
             WorkPriority::Low)
{
}

void StartRunner::fly(const Request& request, const std::stop_token& stop,
                      const std::function<void(Report)>& deliver)
{
    Report report;
    report.scan = scanStarts(request.scenario, request.spec,
                             {.stop = stop, .onProgress = [&](std::size_t done) {
                                  deliver({.scan = {}, .done = done});
                              }});
    if (report.scan) {
        report.done = report.scan->starts.size();
        deliver(std::move(report));
    }
}

void StartRunner::start(const Scenario& scenario, const StartScanSpec& spec)
{
    m_scenario = scenario;
    m_scan.reset();
    m_isRunning = true;
    m_count = static_cast<std::size_t>(spec.span_s / spec.every_s + 1e-9) + 1;
    m_task.start({.scenario = scenario, .spec = spec});
    emit progress(0, m_count);
    emit changed({});
}

void StartRunner::cancel()
{
    m_task.stop();
}

void StartRunner::accept(Report report)
{
    if (report.scan)
        m_scan = std::move(report.scan);
    emit progress(report.done, m_count);
}

} // namespace berg
