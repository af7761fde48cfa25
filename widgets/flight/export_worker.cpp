#include "widgets/flight/export_worker.h"

#include "core/base/stopped.h"
#include "core/io/text/stop_scope.h"
#include "widgets/tasks/work_failure.h"

namespace berg {

void ExportWorker::write(const std::shared_ptr<const ExportJob>& job)
try {
    const StopScope scope(job->task.stop);
    const auto failure = failureOf([&] {
        emit written(std::make_shared<const std::vector<ExportFile>>(exportedFiles(job->prepared)),
                     job->task.generation);
    });
    if (failure)
        emit refused(failure->report);
} catch (const Stopped&) { // nobody waits for the files
}

void ExportWorker::makePreview(const std::shared_ptr<const ExportJob>& job)
try {
    const ExportTask& task = job->task;
    const StopScope scope(task.stop);
    std::optional<ExportPreview> preview;
    if (const auto failure =
            failureOf([&] { preview = exportPreview(job->prepared, task.stop); })) {
        preview.emplace();
        preview->request = task.request;
        preview->error = failure->error;
    }
    if (preview && !task.stop.stop_requested())
        emit previewed(std::make_shared<const ExportPreview>(std::move(*preview)), task.generation);
} catch (const Stopped&) { // another preview follows, or none is wanted
}

} // namespace berg
