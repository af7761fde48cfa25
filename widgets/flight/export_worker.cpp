#include "widgets/flight/export_worker.h"

#include "widgets/tasks/work_failure.h"

namespace berg {

void ExportWorker::write(const std::shared_ptr<const ExportJob>& job)
{
    const auto failure = failureOf([&] {
        emit written(std::make_shared<const std::vector<ExportFile>>(exportedFiles(job->prepared)),
                     job->task.generation);
    });
    if (failure)
        emit refused(failure->report);
}

void ExportWorker::makePreview(const std::shared_ptr<const ExportJob>& job)
{
    const ExportTask& task = job->task;
    std::optional<ExportPreview> preview;
    if (const auto failure =
            failureOf([&] { preview = exportPreview(job->prepared, task.stop); })) {
        preview.emplace();
        preview->request = task.request;
        preview->error = failure->error;
    }
    if (preview && !task.stop.stop_requested())
        emit previewed(std::make_shared<const ExportPreview>(std::move(*preview)), task.generation);
}

} // namespace berg
